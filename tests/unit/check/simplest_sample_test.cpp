// SPDX-License-Identifier: GPL-3.0-or-later
// The sample of a refutation is the one that a lecturer would write on a blackboard.
#include <array>
#include <string>
#include <utility>

#include "catch.h"
#include "check/entry/check.h"
#include "report/wording/sample.h"

namespace rigor {
namespace {

struct Refuted {
  std::string before;  // directives
  std::string statement;
  std::string sample;  // as printed, its lines joined
};

/// What is printed for the last step.
std::string sample_of(const std::string& before, const std::string& statement) {
  SourceMap sources;
  std::string text;
  if (!before.empty()) text = "<!-- rigor:\n" + before + "\n-->\n";
  const FileReport report = check_text(sources, "notes.md", text + "$$" + statement + "$$\n");
  if (report.steps.empty() || !report.steps.back().counterexample) return "no sample";
  std::string printed = print_sample(*report.steps.back().counterexample);
  printed.pop_back();
  for (char& each : printed) {
    if (each == '\n') each = ';';
  }
  return printed;
}

const std::array statements{
    // numbers: 1 before 2, positive before negative, integers before fractions
    Refuted{"scalar a, b", "(a+b)^2 = a^2 + b^2", "sample: a = 1, b = 1; left 4, right 2"},
    Refuted{"for all x", "x^2 = x", "sample: x = 2; left 4, right 2"},
    Refuted{"for all x", "x^3 = x", "sample: x = 2; left 8, right 2"},
    Refuted{"for all x", "\\sqrt{x^2} = x", "sample: x = -1; left 1, right -1"},
    Refuted{"scalar x, y", "\\frac{1}{x+y} = \\frac1x + \\frac1y", "sample: x = 1, y = 1; left 1/2, right 2"},
    // angles: a quarter turn, not a multiple of something else
    Refuted{"for all x", "\\cos x = 1", "sample: x = 2*arctan(1); left 0, right 1"},
    Refuted{"constant \\nu", "\\partial_t\\cos(\\nu t) = \\nu\\sin(\\nu t)",
            "sample: \\nu = 1, t = 2*arctan(1); left -1, right 1"},
    // vectors: along axes, the first axes first
    Refuted{"", "\\mathbf A\\times\\mathbf B = \\mathbf B\\times\\mathbf A",
            "sample: \\mathbf{A} = (1, 0, 0), \\mathbf{B} = (0, 1, 0); component 3: left 1, right -1"},
    Refuted{"", "\\mathbf A\\cdot\\mathbf B = |\\mathbf A||\\mathbf B|",
            "sample: \\mathbf{A} = (1, 0, 0), \\mathbf{B} = (0, 1, 0); left 0, right 1"},
    Refuted{"", "|\\mathbf A + \\mathbf B| = |\\mathbf A| + |\\mathbf B|",
            "sample: \\mathbf{A} = (1, 0, 0), \\mathbf{B} = (-1, 0, 0); left 0, right 2"},
    Refuted{"",
            "\\mathbf A\\cdot(\\mathbf B\\times\\mathbf C) = \\mathbf B\\cdot(\\mathbf A\\times\\mathbf C)",
            "sample: \\mathbf{A} = (1, 0, 0), \\mathbf{B} = (0, 1, 0), \\mathbf{C} = (0, 0, 1); left 1, "
            "right -1"},
    Refuted{"", "A_iB_j = A_jB_i",
            "sample: A = (1, 0, 0), B = (0, 1, 0); component i = 1, j = 2: left 1, right 0"},
    Refuted{"unit vector \\mathbf{n}", "\\mathbf{n}\\cdot\\mathbf{n} = 3",
            "sample: \\mathbf{n} = (1, 0, 0); left 1, right 3"},
    // tensors: on the diagonal if that will do; the order of two matrices needs two numbers off it
    Refuted{"symmetric tensor S_{ij}\nfor all S_{ij}", "S_{ii} = 0",
            "sample: S = ((1, 0, 0), (0, 0, 0), (0, 0, 0)); left 1, right 0"},
    Refuted{"tensor A, B", "A_{ij}B_{jk} = B_{ij}A_{jk}",
            "sample: A = ((1, 0, 0), (0, 0, 0), (0, 0, 0)), B = ((0, 1, 0), (0, 0, 0), (0, 0, 0)); "
            "component i = 1, k = 2: left 1, right 0"},
    // rotations: a right-angle turn about an axis before any other
    Refuted{
        "rotation \\lambda_{i'j}", "\\lambda_{i'j} = \\lambda_{j'i}",
        "sample: \\lambda = ((0, -1, 0), (1, 0, 0), (0, 0, 1)); component i = 1, j = 2: left -1, right 1"},
    Refuted{"rotation U_{ij}, W_{ij}", "U_{ij}W_{jk} = W_{ij}U_{jk}",
            "sample: U = ((0, -1, 0), (1, 0, 0), (0, 0, 1)), W = ((1, 0, 0), (0, 0, -1), (0, 1, 0)); "
            "component i = 1, k = 2: left 0, right -1"},
    // one particle before two, and equal masses
    Refuted{"particles \\alpha\nscalar m_\\alpha",
            "\\sum_\\alpha m_\\alpha^2 = \\Bigl(\\sum_\\alpha m_\\alpha\\Bigr)^2",
            "sample: 2 particles;  particle 1: m = 1;  particle 2: m = 1;  left 2, right 4"},
    Refuted{"particles \\alpha\nfor all m_\\alpha, \\mathbf{r}_\\alpha\ngiven \\sum_\\alpha "
            "m_\\alpha\\mathbf{r}_\\alpha = 0",
            "\\sum_\\alpha m_\\alpha r_\\alpha^2 = 0",
            "sample: 2 particles;  particle 1: m = 1, \\mathbf{r} = (1, 0, 0);  particle 2: m = 1, "
            "\\mathbf{r} = (-1, 0, 0);  left 2, right 0"},
};

TEST_CASE("the sample of a refutation is the simplest") {
  for (const Refuted& each : statements) {
    INFO(each.statement);
    CHECK(sample_of(each.before, each.statement) == each.sample);
  }
}

TEST_CASE("what defined symbols in the step are worth is said, as far as the notes have them") {
  CHECK(
      sample_of("for all m, \\mathbf{v}\nlet \\mathbf{p} = m\\mathbf{v}", "\\mathbf{p} = \\mathbf{v}") ==
      "sample: m = 0, \\mathbf{v} = (1, 0, 0); hence \\mathbf{p} = (0, 0, 0); component 1: left 0, right 1");
  const std::string frame =
      "vector \\mathbf{r}, \\boldsymbol{\\omega}\nframe rot rotates with \\boldsymbol{\\omega} in in";
  const std::string sample = sample_of(frame,
                                       "\\left(\\frac{d\\mathbf{r}}{dt}\\right)_{\\text{in}} = "
                                       "\\left(\\frac{d\\mathbf{r}}{dt}\\right)_{\\text{rot}}");
  CHECK(sample.starts_with("sample: "));
  CHECK(sample.find("R_") == std::string::npos);
}

TEST_CASE("derivatives that only derivatives of an assumption speak of are not printed") {
  const std::string law = "for all x, k\nconstant k\ngiven \\ddot{x} = -k^2x";
  CHECK(sample_of(law, "\\dot{x} = kx") == "sample: \\dot{x} = 1, k = 0, x = 0; left 1, right 0");
}

/// Numbers that are not 0, and those of them that are not 1 or -1.
std::pair<std::size_t, std::size_t> count_numbers(const Counterexample& example) {
  std::pair<std::size_t, std::size_t> counts{0, 0};
  for (const Counterexample::Value& value : example.values) {
    for (const std::string& component : value.components) {
      if (component == "0") continue;
      ++counts.first;
      if (component != "1" && component != "-1") ++counts.second;
    }
  }
  return counts;
}

TEST_CASE("samples of several partial differential equations have few numbers, all of them 1") {
  SourceMap sources;
  const FileReport report = check_file(sources, "tests/notes/fail/waves.tex");
  int fields = 0;
  for (const Step& step : report.steps) {
    if (!step.counterexample || step.counterexample->values.size() < 10) continue;
    INFO(step.source);
    const auto [not_zero, not_one] = count_numbers(*step.counterexample);
    CHECK(not_zero <= 8);
    CHECK(not_one == 0);
    ++fields;
  }
  CHECK(fields == 3);
}

}  // namespace
}  // namespace rigor
