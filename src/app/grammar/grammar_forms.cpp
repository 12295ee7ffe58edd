// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/grammar.h"

namespace rigor {
namespace {

void add_forms(CLI::App& to, FormsCommand& forms) {
  to.add_option("FILE", forms.file, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  to.add_option("--body", forms.bodies,
                "A sample body: its name, its file, or a folder of such files; may be repeated")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false);
  to.add_option("--at", forms.places, "Only the equations with this tag or in this section; may be repeated")
      ->type_name("TAG|HEADING")
      ->allow_extra_args(false);
  add_sidecar(to, forms.sidecar);
  add_color(to, forms.color);
}

}  // namespace

void add_eval(Grammar& grammar) {
  const auto eval = std::make_shared<EvalCommand>();
  CLI::App& app = grammar.command(
      "eval", "Evaluate every written form: value, error, condition, time",
      {"eval notes/rigid-bodies.md --at '(6)'", "eval notes/rigid-bodies.md --body book.toml"},
      [eval]() -> CommandLine { return {.eval = std::move(*eval)}; });
  add_forms(app, eval->forms);
  app.add_option("--with", eval->values,
                 "Evaluate with these numbers only, as `x = 1e-9, \\mathbf{A} = (1, 0, 2)`")
      ->type_name("VALUES");
  app.add_flag("--json", eval->json, "Print one JSON object instead of text");
  app.add_flag("!--no-times", eval->times, "Measure no time, so that two runs print the same bytes");
}

void add_bench(Grammar& grammar) {
  const auto bench = std::make_shared<BenchCommand>();
  CLI::App& app =
      grammar.command("bench", "Draw time against error for all forms of a chain in all precisions",
                      {"bench notes/rigid-bodies.md --at '(6)' --into pictures"},
                      [bench]() -> CommandLine { return {.bench = std::move(*bench)}; });
  add_forms(app, bench->forms);
  app.add_option("--into", bench->folder, "Write the pictures and a table in Markdown into a folder")
      ->type_name("FOLDER");
}

void add_scene(Grammar& grammar) {
  const auto scene = std::make_shared<SceneCommand>();
  CLI::App& app = grammar.command("scene", "Compute the quantities that a scene asks of a body",
                                  {"scene book.toml", "scene book.toml --explain"},
                                  [scene]() -> CommandLine { return {.scene = std::move(*scene)}; });
  app.add_option("FILE", scene->files, "A scene in TOML")->required()->type_name("");
  app.add_flag("--json", scene->json, "Print one JSON object instead of text");
  app.add_flag("--explain", scene->explain, "Say what was computed, what was not, and how long it took");
  add_color(app, scene->color);
}

}  // namespace rigor
