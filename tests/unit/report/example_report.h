// SPDX-License-Identifier: GPL-3.0-or-later
// A small report that the tests of the reporters share: one step proved, one refuted.
#pragma once

#include <string>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

inline const std::string example_text =
    "# Products\n"
    "$$\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A} \\tag{1}$$\n"
    "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n";

inline Span example_span(std::string_view part) {
  const auto begin = static_cast<std::uint32_t>(example_text.find(part));
  return {0, begin, begin + static_cast<std::uint32_t>(part.size())};
}

inline Step example_step(std::string left, std::string right, Verdict verdict) {
  Step step;
  step.source = left + " = " + right;
  step.span = example_span(step.source);
  const auto relation = step.span.begin + static_cast<std::uint32_t>(left.size()) + 1;
  step.relation_span = {0, relation, relation + 1};
  step.left = std::move(left);
  step.relation = "=";
  step.right = std::move(right);
  step.section = "Products";
  step.verdict = verdict;
  return step;
}

inline Report example_report(SourceMap& sources) {
  FileReport file;
  file.path = "notes/products.md";
  file.file = sources.add(file.path, example_text);
  file.steps.push_back(
      example_step("\\mathbf{A}\\cdot\\mathbf{B}", "\\mathbf{B}\\cdot\\mathbf{A}", Verdict::proved));
  file.steps[0].tag = "1";
  file.steps[0].route = "component normal form";
  file.steps[0].uses = {"definition A (1)"};
  file.steps[0].milliseconds = 0.12345;
  file.steps.push_back(
      example_step("\\mathbf{A}\\times\\mathbf{B}", "\\mathbf{B}\\times\\mathbf{A}", Verdict::refuted));
  Step& wrong = file.steps[1];
  wrong.counterexample = {0,
                          {{"\\mathbf{A}", 0, 1, {"1", "0", "0"}}, {"\\mathbf{B}", 0, 1, {"0", "1", "0"}}},
                          {{"", 3}},
                          "1",
                          "-1"};
  wrong.diagnostics.push_back({DiagnosticKind::refuted, wrong.relation_span, "the sides differ", {}, {}});
  file.counts = {1, 1, 0, 0, 0, 0, 0};
  Report report;
  report.counts = file.counts;
  report.files.push_back(std::move(file));
  report.milliseconds = 12.4;
  return report;
}

}  // namespace rigor
