// SPDX-License-Identifier: GPL-3.0-or-later
// Lints: what each finds, and what it leaves alone. tests/notes/fail has one note for each as well.
#include "check/lint/lint.h"

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

/// The places and kinds of all warnings, of steps and of the file, in the order of the report.
std::string warnings(const std::string& text) {
  const Checked checked(text);
  Diagnostics found;
  const auto take = [&](const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.severity() == Severity::warning) found.push_back(diagnostic);
    }
  };
  for (const Step& step : checked.report.steps) take(step.diagnostics);
  take(checked.report.diagnostics);
  return found.empty() ? "" : checked.places(found).substr(1);
}

std::string display(const std::string& statement) { return "$$" + statement + "$$\n"; }

}  // namespace

TEST_CASE("a letter that is a number here and a length there has two meanings") {
  const std::string vectors = rigor_says("vector \\mathbf{r}, \\mathbf{n}");
  const std::string length = display("r^2 = \\mathbf{r}\\cdot\\mathbf{r}");
  const std::string local = rigor_says("where r := |\\mathbf{n}\\times\\mathbf{r}|") + display("r \\ge 0");
  CHECK(warnings(vectors + local + length) == "4:3 two-meanings");
  CHECK(warnings(vectors + length + local) == "3:19 two-meanings");
  CHECK(warnings(vectors + length + length).empty());
}

TEST_CASE("a length that is set equal to something else made of its vector has two meanings") {
  CHECK(warnings(display("r_\\alpha = |\\mathbf{n}\\times\\mathbf{r}_\\alpha|")) == "1:3 two-meanings");
  CHECK(warnings(display("r_\\alpha = |\\mathbf{r}_\\alpha|")).empty());
  CHECK(
      warnings(display("\\mathbf{r} = a\\mathbf{n}") + display("r = \\frac{p}{1 + e\\cos\\theta}")).empty());
  CHECK(warnings(display("v = \\mathbf{v}\\cdot\\hat{\\mathbf{v}}")).empty());
  CHECK(warnings(display("\\mathbf{v} = \\dot{\\mathbf{r}}") + display("v = r\\omega")).empty());
}

TEST_CASE("the rate of a length and a component have the vector's one meaning") {
  CHECK(warnings(display("\\frac{d}{dt}\\omega^2 = 2\\omega\\dot\\omega") +
                 display("\\omega_i\\omega_i = |\\boldsymbol{\\omega}|^2"))
            .empty());
}

TEST_CASE("a number and a tensor of one letter share it unless the number is defined") {
  CHECK(warnings(display("S_{ij}n_j = Sn_i")) == "1:15 shared-letter");
  CHECK(warnings(display("S = S_{kk}") + display("S_{ij}n_j = Sn_i")).empty());
  CHECK(warnings(rigor_says("let S = 2a") + display("S_{ij}n_j = Sn_i")).empty());
  CHECK(warnings(display("S_{ij}n_j = sn_i")).empty());
  CHECK(warnings(display("A_iA_i = A^2")).empty());
}

TEST_CASE("two signs for epsilon are one symbol only with like subscripts") {
  const std::string rounded = display("\\varepsilon_{ijk}A_iA_j = 0");
  CHECK(warnings(rounded + display("\\epsilon_{ijk}A_iA_k = 0")) == "2:3 mixed-spelling");
  CHECK(warnings(rounded + display("\\epsilon_0 = 2a")).empty());
  CHECK(warnings(rounded + display("ε_{ijk}A_iA_k = 0")).empty());
}

TEST_CASE("a vector that is declared by a plain letter is reported beside a bold one") {
  const std::string both = rigor_says("vector u, \\mathbf{A}");
  CHECK(warnings(both + display("u\\times\\mathbf{A} = -\\mathbf{A}\\times u")) == "2:3 plain-vector");
  CHECK(warnings(rigor_says("vector u, v") + display("u\\times v = -v\\times u")).empty());
  CHECK(warnings(both + display("u_iA_i = A_iu_i") + display("\\mathbf{A}\\cdot\\mathbf{A} = A^2")).empty());
}

TEST_CASE("an index behind a word in one run of letters is hidden where it is an index elsewhere") {
  CHECK(warnings(display("v_{CMi} = A_i")) == "1:3 hidden-index");
  CHECK(warnings(display("v_{\\text{maxi}} = A_i")) == "1:3 hidden-index");
  CHECK(warnings(display("v_{\\text{max}i} = A_i")).empty());
  CHECK(warnings(display("v_{CM} = A")).empty());
  CHECK(warnings(display("v_{min} = aA_nA_n")).empty());
}

TEST_CASE("a sum is idle over an index that its terms do not have, unless it counts") {
  CHECK(warnings(display("\\sum_i A_jB_j = 3A_jB_j")) == "1:8 idle-sum");
  CHECK(warnings(display("\\sum_{i,j} A_iB_i = 3A_jB_j")) == "1:11 idle-sum");
  CHECK(warnings(display("\\sum_i 1 = 3")).empty());
  CHECK(warnings(display("\\sum_i\\sum_j A_iB_jA_iB_j = A^2B^2")).empty());
  CHECK(warnings(display("\\sum_i \\mathbf{e}_i\\cdot\\mathbf{e}_i = 3")).empty());
}

TEST_CASE("a name that differs from another one by a slip is reported where it stands alone") {
  const std::string known = display("2T_{rot} = I\\omega^2") + display("T_{rot} = K");
  CHECK(warnings(known + display("aT_{rto} = b")) == "3:4 near-name");
  CHECK(warnings(known + display("aT_{rat} = b")) == "3:4 near-name");
  CHECK(warnings(known + display("aT_{kin} = b")).empty());
  CHECK(warnings(known + display("aE_{rto} = b")).empty());
  CHECK(warnings(known + display("aT_{rto} = T_{rot}")).empty());
  CHECK(warnings(known + display("aT_{rto} = b") + display("cT_{rto} = b")).empty());
  CHECK(warnings(known + "<!-- rigor: scalar T_{rto} -->\n\n" + display("aT_{rto} = b")).empty());
  CHECK(warnings(display("a\\omega_p = b") + display("c\\omega_c = d")).empty());
}

TEST_CASE("a step of a chain that repeats its left side is reported at the right one") {
  CHECK(warnings(display("(a + b)^2 = (a + b)(a + b) = (a + b)(a + b)")) == "1:32 repeated-side");
  CHECK(warnings(display("a b = ab = ba")) == "1:9 repeated-side");
  CHECK(warnings(display("c = 2\\bigl(a\\bigr) = 2(a)")) == "1:24 repeated-side");
  CHECK(warnings(display("a + b &= a + b\\\\ &= b + a")) == "1:12 repeated-side");
  CHECK(warnings(display("a\\,\\sin\\theta\\approx a\\sin\\theta = a\\sin\\theta")) ==
        "1:24 repeated-side, 1:38 repeated-side");
}

TEST_CASE("a side is not repeated in another spelling, by numbers, alone or farther on") {
  CHECK(warnings(display("\\mathbf{A}\\cdot\\mathbf{B} = A_iB_i = A_jB_j")).empty());
  CHECK(warnings(display("x^{12} = x^12 = 2x")).empty());
  CHECK(warnings(display("a - a = 0 = 0")).empty());
  CHECK(warnings(display("a\\omega = a\\omega")).empty());
  CHECK(warnings(display("a = a, \\qquad b = b")).empty());
  CHECK(warnings(display("a + b = b + a = a + b")).empty());
}

TEST_CASE("components of two vectors along two sets of axes are not added") {
  const std::string axes = rigor_says("rotation \\lambda") + rigor_says("vector \\mathbf{A}, \\mathbf{B}");
  CHECK(warnings(axes + display("A_1 + B_{1'} = B_{1'} + A_1")) == "3:9 mixed-frames, 3:27 mixed-frames");
  CHECK(warnings(axes + display("A_1 - A_{1'} = -(A_{1'} - A_1)")).empty());
  CHECK(
      warnings(axes + display("A_{1'} = \\lambda_{1'1}A_1 + \\lambda_{1'2}A_2 + \\lambda_{1'3}A_3")).empty());
}

TEST_CASE("a zero is plain beside a vector only for those who write it otherwise, or ask") {
  const std::string plain = display("\\mathbf{A}\\times\\mathbf{A} = 0");
  CHECK(warnings(plain).empty());
  CHECK(warnings(rigor_says("warn scalar-zero") + plain) == "2:32 scalar-zero");
  CHECK(warnings(plain + display("\\mathbf{B}\\times\\mathbf{B} = \\vec{0}")) == "1:32 scalar-zero");
  CHECK(warnings(rigor_says("warn scalar-zero") + display("\\mathbf{A}\\cdot\\mathbf{B} - A_iB_i = 0"))
            .empty());
}

TEST_CASE("what is axial by one equation is not polar by another") {
  const std::string asked = rigor_says("warn mixed-parity");
  const std::string spin = display("\\mathbf{L} = \\mathbf{r}\\times\\dot{\\mathbf{r}}");
  CHECK(warnings(asked + spin + display("\\mathbf{M} = \\mathbf{L} + \\mathbf{r}")) == "3:14 mixed-parity");
  CHECK(warnings(asked + spin + display("\\mathbf{M} = \\mathbf{L} + h\\mathbf{r}")).empty());
  CHECK(
      warnings(asked + spin + display("\\mathbf{M} = \\mathbf{L}\\times\\mathbf{r} + \\mathbf{r}")).empty());
  CHECK(warnings(asked + display("\\mathbf{B} = \\nabla\\times\\mathbf{a}") +
                 display("\\mathbf{G} = \\mathbf{B} + \\mathbf{a}")) == "3:14 mixed-parity");
  CHECK(warnings(spin + display("\\mathbf{M} = \\mathbf{L} + \\mathbf{r}")).empty());
}

TEST_CASE("what is declared polar or axial is mirrored so") {
  const std::string asked = rigor_says("warn mixed-parity") + rigor_says("axial vector \\mathbf{B}") +
                            rigor_says("polar vector \\mathbf{E}");
  CHECK(warnings(asked + display("\\mathbf{E} = \\mathbf{B}")) == "4:14 mixed-parity");
  CHECK(warnings(asked + display("\\mathbf{E} = \\mathbf{v}\\times\\mathbf{B}")).empty());
  CHECK(lines_of(rigor_says("axial scalar h") + display("h = h")).starts_with("proved\n1:"));
}

TEST_CASE("a definition is unused if no other equation mentions its symbol or a rate of it") {
  const std::string asked = rigor_says("warn unused-definition");
  const std::string sum = display("\\mathbf{s} = \\mathbf{A} + \\mathbf{B}");
  CHECK(warnings(asked + sum) == "2:3 unused-definition");
  CHECK(warnings(asked + sum + display("\\dot{\\mathbf{s}} = \\dot{\\mathbf{A}} + \\dot{\\mathbf{B}}"))
            .empty());
}
