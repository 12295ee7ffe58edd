// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/junit.h"

#include "catch.h"
#include "hostile_report.h"

namespace rigor {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_CASE("a step is a test case, and a refutation its failure with sample and place") {
  SourceMap sources;
  const Report report = example_report(sources);
  const std::string text = to_junit(report, sources, {});
  CHECK(text.find("<testsuites name=\"rigor\" tests=\"2\" failures=\"1\" errors=\"0\" time=") !=
        std::string::npos);
  CHECK(text.find("<testcase classname=\"notes/products.md: Products\" name=\"(1) "
                  "\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}\" "
                  "file=\"notes/products.md\" line=\"2\"") != std::string::npos);
  CHECK(
      text.find("<failure message=\"the sides differ\" type=\"refuted\">notes/products.md:3:30: refuted: the "
                "sides differ [refuted]&#10;sample: ") != std::string::npos);
}

TEST_CASE("an expected refutation passes, and what is skipped is skipped") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].steps[0].verdict = Verdict::skipped;
  report.files[0].steps[1].expected_refuted = true;
  const std::string text = to_junit(report, sources, {});
  CHECK(count(text, "<failure") == 0);
  CHECK(count(text, "<skipped message=") == 1);
  CHECK(text.find("refuted, as expected") != std::string::npos);
}

TEST_CASE("there is a failure exactly where the exit code is not 0") {
  SourceMap sources;
  for (const Verdict verdict : {Verdict::proved, Verdict::refuted, Verdict::given, Verdict::definition,
                                Verdict::undecided, Verdict::not_understood, Verdict::skipped}) {
    for (const bool strict : {false, true}) {
      Report report = example_report(sources);
      report.files[0].steps.resize(1);
      Step& step = report.files[0].steps[0];
      step.verdict = verdict;
      step.diagnostics.push_back({DiagnosticKind::bold_index, step.span, "bold", {}, {}});
      const Tally found = tally(report, strict);
      CHECK((count(to_junit(report, sources, {.rule = usual_rule(strict)}), "<failure") > 0) ==
            (found.wrong || found.open));
    }
  }
}

TEST_CASE("a file that was not checked is an error") {
  SourceMap sources;
  Report report = hostile_report(sources);
  const std::string text = to_junit(report, sources, {});
  CHECK(count(text, "<error ") == 1);
  CHECK(count(text, "<failure ") == 3);
  CHECK(count(text, "#2\"") == 1);  // the same step again
  for (const char c : text) CHECK((c == '\n' || c < 0 || c >= 0x20));
}

}  // namespace
}  // namespace rigor
