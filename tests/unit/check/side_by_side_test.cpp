// SPDX-License-Identifier: GPL-3.0-or-later
// What is offered beside wrong steps does not depend on how many processes look for it.
#include <string>

#include "catch.h"
#include "check/entry/check.h"
#include "report/data/json.h"
#include "report/text/terminal.h"

using namespace rigor;

namespace {

/// As JSON and for people, without times.
std::string reported(const std::string& text, std::size_t processes) {
  SourceMap sources;
  CheckOptions options;
  options.repairs = Repairs::of_all;
  options.processes = processes;
  Report report;
  report.files.push_back(check_text(sources, "notes.md", text, options));
  for (Step& step : report.files[0].steps) step.milliseconds = step.repair_milliseconds = 0;
  std::string all = to_json(report, sources) + print_report(report, sources, {});
  for (const Step& step : report.files[0].steps) all += " " + std::to_string(step.work);
  return all;
}

}  // namespace

TEST_CASE("several processes for one file give the same bytes") {
  std::string text = "<!-- rigor: for all a, b, x, y, \\mathbf{A}, \\mathbf{B} -->\n";
  for (const char* row :
       {"(x+y)^2 = x^2 + 2xy - y^2", "(x-y)(x+y) = x^2 + y^2", "\\sin 2x = \\sin x\\cos x",
        "\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}",
        "\\frac{a}{b}\\frac{x}{y} = \\frac{ay}{bx}", "\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{A}",
        "(\\mathbf A\\times\\mathbf B)^2 = A^2B^2 + (\\mathbf A\\cdot\\mathbf B)^2"})
    text += std::string("$$") + row + "$$\n\n";
  const std::string by_one = reported(text, 1);
  CHECK(by_one.find("\"repairs\"") != std::string::npos);
  for (const std::size_t processes : {0, 2, 4, 20}) CHECK(reported(text, processes) == by_one);
}
