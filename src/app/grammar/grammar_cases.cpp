// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/grammar.h"

namespace rigor {

void add_cases(Grammar& grammar) {
  const auto cases = std::make_shared<CasesCommand>();
  CLI::App& app = grammar.command("cases", "Check notes and write what became of each step, for test runners",
                                  {"cases notes.tex --into notes.json"},
                                  [cases]() -> CommandLine { return {.cases = std::move(*cases)}; });
  app.add_option("FILE", cases->file, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  app.add_option("--into", cases->results, "Where to write it, as JSON")->required()->type_name("FILE");
  app.add_option_function<std::string>(
         "--name", [cases](const std::string& name) { cases->name = name; },
         "What the name of each case begins with (default: FILE without its extension)")
      ->type_name("NAME");
  add_sidecar(app, cases->sidecar);
  app.add_flag("--strict", cases->strict, "Count warnings as errors");
  app.add_option_function<std::string>(
         "--ctest", [cases](const std::string& path) { cases->ctest = path; },
         "Write a listing of the cases, too, as a script that ctest includes")
      ->type_name("FILE");
}

void add_case(Grammar& grammar) {
  const auto one = std::make_shared<CaseCommand>();
  CLI::App& app =
      grammar.command("case", "Tell what became of one step; the exit code is that of a check of it alone",
                      {"case notes.json 'notes (6) step 2'"},
                      [one]() -> CommandLine { return {.one_case = std::move(*one)}; });
  app.add_option("RESULTS", one->results, "What `rigor cases` wrote")->required()->type_name("");
  app.add_option("NAME", one->name, "The case, by its name")->required()->type_name("");
}

}  // namespace rigor
