// SPDX-License-Identifier: GPL-3.0-or-later
// A report whose path, text and messages hold what formats give a meaning to.
#pragma once

#include "example_report.h"
#include "report/wording/check_format.h"

namespace rigor {

inline const std::string hostile = "]]> & <x y=\"z\"> ::error::\n%0A\x01\xff,:";

inline Report hostile_report(SourceMap& sources) {
  FileReport file;
  file.path = "a b/" + hostile + ".md";
  file.file = sources.add(file.path, "$$a = b$$\n$$a = c$$\n");
  Step step;
  step.span = {file.file, 2, 7};
  step.relation_span = {file.file, 4, 5};
  step.tag = step.section = step.source = hostile;
  step.verdict = Verdict::undecided;
  step.diagnostics.push_back(
      {DiagnosticKind::undecided, step.relation_span, hostile, {{step.span, hostile}}, {hostile}});
  file.steps = {step, step};
  file.diagnostics.push_back({DiagnosticKind::unused_directive, {file.file, 0, 1}, hostile, {}, {}});
  file.failure = hostile;
  Report report;
  report.files.push_back(std::move(file));
  return report;
}

}  // namespace rigor
