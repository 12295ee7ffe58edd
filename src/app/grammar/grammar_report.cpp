// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/grammar/grammar.h"

namespace rigor {

void add_report(Grammar& grammar) {
  const auto report = std::make_shared<ReportCommand>();
  CLI::App& app = grammar.command(
      "report", "Write the equations with their verdicts as a page or as a document",
      {"report notes/rigid-bodies.md --html rigid-bodies.html",
       "report notes/rigid-bodies.md --latex rigid-bodies.tex"},
      [report]() -> CommandLine {
        if (!report->html && !report->latex)
          return usage_error("nothing says what to write: `--html FILE` or `--latex FILE`", "report");
        if (report->html && report->latex && *report->html == *report->latex)
          return usage_error(fmt::format("`--html` and `--latex` both write `{}`", *report->html), "report");
        if (report->sidecar && report->files.size() > 1)
          return usage_error(
              fmt::format("`--sidecar` belongs to one file, and {} are given", report->files.size()),
              "report");
        return {.report = std::move(*report)};
      });
  app.add_option("FILE", report->files, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  app.add_option("--html", report->html, "Write one self-contained page; `-` is the output")
      ->type_name("FILE");
  app.add_option("--latex", report->latex, "Write a document for pdflatex; `-` is the output")
      ->type_name("FILE");
  app.add_flag("!--no-forms", report->forms,
               "Leave out the cost and error of each form, which take long to measure");
  add_sidecar(app, report->sidecar);
}

}  // namespace rigor
