// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/terminal.h"

#include "catch.h"
#include "example_report.h"

namespace rigor {
namespace {

TEST_CASE("a report has a line for each step, then the refutation with its sample, then the counts") {
  SourceMap sources;
  const Report report = example_report(sources);
  CHECK(print_report(report, sources) ==
        R"(notes/products.md
    2  (1)  \mathbf{A}\cdot\mathbf{B} = \mathbf{B}\cdot\mathbf{A}    proved
    3       \mathbf{A}\times\mathbf{B} = \mathbf{B}\times\mathbf{A}  refuted

notes/products.md:3:30: refuted: the sides differ [refuted]
    3 | $$\mathbf{A}\times\mathbf{B} = \mathbf{B}\times\mathbf{A}$$
      |                              ^
sample: \mathbf{A} = (1, 0, 0), \mathbf{B} = (0, 1, 0); component 3: left 1, right -1

2 steps: 1 proved, 0 definitions, 0 given, 1 refuted; 0 undecided, 0 not understood, 0 skipped; 12 ms
)");
}

TEST_CASE("a refutation that is expected keeps its sample and is counted as expected") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].steps[1].expected_refuted = true;
  const std::string text = print_report(report, sources);
  CHECK(text.find("  refuted, as expected\n") != std::string::npos);
  CHECK(text.find("sample: ") != std::string::npos);
  CHECK(text.find("1 refuted (1 as expected);") != std::string::npos);
}

TEST_CASE("a step is cut so that its line has the width that was asked for") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].steps[1].source = std::string(10'000'000, 'x');
  const std::string text = print_report(report, sources, {false, 60});
  CHECK(text.find("    3       " + std::string(38, 'x') + "…  refuted\n") != std::string::npos);
  const std::string narrow = print_report(report, sources, {false, 0});
  CHECK(narrow.find("    3       " + std::string(19, 'x') + "…  refuted\n") != std::string::npos);
}

TEST_CASE("the source line of a diagnostic has the width that was asked for") {
  SourceMap sources;
  const Report report = example_report(sources);
  CHECK(print_report(report, sources, {false, 50}).find("\n    3 | …") != std::string::npos);
  CHECK(print_report(report, sources, {false, 70}).find("…\n      |") == std::string::npos);
}

TEST_CASE("steps of an included file stand below its path") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].steps[0].span = {sources.add("notes/part.md", "a\n\nb = c"), 3, 8};
  const std::string text = print_report(report, sources);
  CHECK(text.starts_with("notes/products.md\nnotes/part.md\n    3  (1)  "));
  CHECK(text.find("\nnotes/products.md\n    3       ") != std::string::npos);
}

TEST_CASE("diagnostics of steps and of the file stand in the order of their places") {
  SourceMap sources;
  Report report = example_report(sources);
  FileReport& file = report.files[0];
  file.diagnostics.push_back({DiagnosticKind::unbalanced, Span{0, 150, 150}, "third", {}, {}});
  file.diagnostics.push_back({DiagnosticKind::unused_directive, Span{0, 0, 1}, "first", {}, {}});
  const std::string text = print_report(report, sources);
  CHECK(text.find("first [") < text.find("differ ["));
  CHECK(text.find("differ [") < text.find("third ["));
  CHECK(text.find("0 skipped; 2 errors; 12 ms\n") != std::string::npos);
}

TEST_CASE("the summary counts files, errors and warnings where there are any, each in its number") {
  CHECK(print_summary({}) ==
        "0 steps: 0 proved, 0 definitions, 0 given, 0 refuted; 0 undecided, 0 not understood, 0 skipped; 0.0 "
        "ms");
  Report report;
  report.files.resize(2);
  report.files[0].steps.resize(1);
  report.files[0].steps[0].verdict = Verdict::definition;
  report.files[1].diagnostics.push_back({DiagnosticKind::no_equations, {}, "", {}, {}});
  report.counts[static_cast<std::size_t>(Verdict::definition)] = 1;
  report.milliseconds = 9.96;
  CHECK(print_summary(report) ==
        "1 step in 2 files: 0 proved, 1 definition, 0 given, 0 refuted; 0 undecided, 0 not understood, 0 "
        "skipped; "
        "1 warning; 10.0 ms");
}

TEST_CASE("colour is added only when asked for") {
  SourceMap sources;
  const Report report = example_report(sources);
  CHECK(print_report(report, sources).find('\x1b') == std::string::npos);
  const std::string text = print_report(report, sources, {true, 110});
  CHECK(text.find("\x1b[32mproved\x1b[0m\n") != std::string::npos);
  CHECK(text.find("\x1b[1;31mrefuted\x1b[0m\n") != std::string::npos);
}

}  // namespace
}  // namespace rigor
