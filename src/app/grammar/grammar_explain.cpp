// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that help to understand a verdict: why a step holds, how a row was read, what would settle it.
#include "app/grammar/grammar.h"

namespace rigor {

void add_explain(Grammar& grammar) {
  const auto explain = std::make_shared<ExplainCommand>();
  CLI::App& app = grammar.command(
      "explain", "Derive one form of a chain from the other in small steps, each with its rule",
      {"explain notes/rigid-bodies.md --at '(6)'", "explain notes/rigid-bodies.md --at 120 --format latex",
       R"(explain '|\mathbf A\times\mathbf B|^2 = A^2B^2 - (\mathbf A\cdot\mathbf B)^2')"},
      [explain]() -> CommandLine { return {.explain = std::move(*explain)}; });
  app.add_option("FILE|STATEMENT", explain->file,
                 "Notes: LaTeX (.tex) or Markdown; or a statement in LaTeX with a relation in it")
      ->required()
      ->type_name("");
  app.add_option(
         "--at", explain->places,
         "Only the equations with this tag or label, in this section or on this line; may be repeated")
      ->type_name("TAG|HEADING|LINE")
      ->allow_extra_args(false);
  app.add_option_function<std::string>(
         "--format",
         [explain](const std::string& name) {
           explain->format = name == "latex"    ? MathFormat::latex
                             : name == "mathml" ? MathFormat::mathml
                                                : MathFormat::text;
         },
         "How mathematics is written: text (the default), latex or mathml")
      ->type_name("FORMAT")
      ->check(one_of("format", {"text", "latex", "mathml"}));
  add_sidecar(app, explain->sidecar);
  add_color(app, explain->color);
}

void add_read(Grammar& grammar) {
  const auto read = std::make_shared<ReadCommand>();
  CLI::App& app = grammar.command(
      "read", "Show how each row was read: its sums, its letters, its role, and what it would rest on",
      {"read notes/rigid-bodies.md --at '(6)'", "read notes/rigid-bodies.md --at 120 --json"},
      [read]() -> CommandLine { return {.read = std::move(*read)}; });
  app.add_option("FILE", read->file, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  app.add_option("--at", read->places,
                 "Only the rows with this tag or label, in this section or on this line; may be repeated")
      ->type_name("TAG|HEADING|LINE")
      ->allow_extra_args(false);
  app.add_flag("--json", read->json, "Print one JSON object instead of text");
  add_sidecar(app, read->sidecar);
  add_color(app, read->color);
}

void add_suggest(Grammar& grammar) {
  const auto suggest = std::make_shared<SuggestCommand>();
  CLI::App& app = grammar.command(
      "suggest",
      "Find the few directives that would settle the most open rows, and write them into a sidecar",
      {"suggest notes.tex", "suggest notes.tex --write", "suggest notes.tex --write shared.rigor --all"},
      [suggest]() -> CommandLine { return {.suggest = std::move(*suggest)}; });
  app.add_option("FILE", suggest->file, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  app.add_option_function<std::vector<std::string>>(
         "--write",
         [suggest](const std::vector<std::string>& words) {
           suggest->write = true;
           if (!words.empty() && !words.front().empty()) suggest->into = words.front();
         },
         "Add them to a sidecar (default: the one that is read, or NAME.rigor)")
      ->type_name("FILE")
      ->expected(0, 1);
  app.add_flag("--all", suggest->all, "Also those that make a row refuted, suspect or wrong");
  add_sidecar(app, suggest->sidecar);
  add_color(app, suggest->color);
}

}  // namespace rigor
