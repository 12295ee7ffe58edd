// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/among.h"
#include "scene/quantity/scene_evaluation.h"

namespace rigor {

SceneEvaluation::SceneEvaluation(const SceneFile& scene, Body body, const WrittenForms& forms)
    : scene_(scene),
      forms_(forms),
      body_(std::move(body), scene.errors, ledger_),
      letters_(scene, forms, result_.diagnostics),
      values_(scene, forms.tree, letters_, body_),
      spin_symbols_(letters_.with_role(SceneRole::spin)),
      rate_symbols_(letters_.with_role(SceneRole::spin_rate)),
      definitions_(without_definitions_of(letters_.overriding(), forms.definitions)) {}

SceneResult SceneEvaluation::run() {
  result_.title = scene_.title;
  result_.body = body_.body().name;
  ledger_.expect(law_node, "nothing that was asked needs it");
  ledger_.expect(motion_node, "nothing is asked over the time");
  if (body_.body().size() == 0) {  // what else a body must be is seen to where it is made
    report(DiagnosticKind::bad_body, scene_.body.span, "the body has no particles");
  } else if (compile_all()) {
    if (needs_law_) make_law();
    if (needs_motion_ && law_of_spin_) move();
    for (Asked& asked : asked_) evaluate_one(asked);
  }
  result_.along_principal_axes = values_.along_principal_axes();
  if (result_.along_principal_axes && result_.motion) {
    if (const auto& moments = body_.moments())
      result_.moments = Vector3{(*moments)[0].high, (*moments)[1].high, (*moments)[2].high};
  }
  result_.nodes = ledger_.nodes();
  return std::move(result_);
}

void SceneEvaluation::report(DiagnosticKind kind, Span span, std::string message, const std::string& help) {
  Diagnostic diagnostic{kind, span, std::move(message)};
  if (!help.empty()) diagnostic.help.push_back(help);
  result_.diagnostics.push_back(std::move(diagnostic));
}

void SceneEvaluation::fail(Asked& asked, const std::string& message, const std::string& help) {
  const SceneText& name = asked.ask->name;
  asked.failed = true;
  ledger_.skip(name.text, message);
  report(DiagnosticKind::bad_scene, name.span, fmt::format("`{}` is not evaluated: {}", name.text, message),
         help);
}

/// False where nothing can be evaluated.
bool SceneEvaluation::compile_all() {
  std::set<SceneRole> read;
  for (const SceneAsk& ask : scene_.asked) {
    asked_.push_back({&ask, nullptr, std::nullopt, false});
    if (!ask.latex.empty()) compile(asked_.back(), read);
  }
  needs_motion_ = std::ranges::any_of(
      asked_, [](const Asked& asked) { return !asked.failed && asked.ask->kind == SceneAskKind::over_time; });
  needs_law_ = needs_law_ || needs_motion_ || read.contains(SceneRole::spin_rate);
  if (needs_law_) collect_law(read);
  const auto open = values_.settle_axes(read);
  if (open) report(DiagnosticKind::bad_scene, scene_.body.span, open->message, open->help);
  return !open;
}

void SceneEvaluation::compile(Asked& asked, std::set<SceneRole>& read) {
  const auto form = std::ranges::find(forms_.asked, asked.ask->latex, &AskedForm::source);
  if (form == forms_.asked.end()) {
    asked.failed = true;  // the diagnostic of the notes says why
    ledger_.skip(asked.ask->name.text, "the notes do not give it");
    return;
  }
  asked.form = &*form;
  const ProgramRoot root{form->expr, form->indices};
  auto program = Program::compile(forms_.tree, definitions_, std::span(&root, 1));
  if (!program) return fail(asked, program.error().reason);
  if (!program->free_particles().empty())
    return fail(asked, "it belongs to single particles, not to the body");
  note_roles(*program, read);
  asked.program = std::move(*program);
}

void SceneEvaluation::note_roles(const Program& program, std::set<SceneRole>& read) const {
  for (const ProgramInput& input : program.inputs()) {
    const SceneLetter* letter = letters_.find(input.symbol);
    if (letter == nullptr) continue;
    const bool is_number =
        letter->role == SceneRole::value && scene_.values[letter->which].components.size() == 1;
    if (!is_number) read.insert(letter->role);  // a number is the same along any axes
  }
}

bool SceneEvaluation::reads(const Program& program, const std::vector<SymbolId>& symbols) const {
  return std::ranges::any_of(program.inputs(),
                             [&](const ProgramInput& input) { return is_one_of(input.symbol, symbols); });
}

bool has_open_sign(const SceneQuantity& quantity) {
  if (quantity.value.size() != 1 || quantity.error.empty()) return false;
  return quantity.error[0] > 0 && !(quantity.error[0] < std::abs(quantity.value[0]));
}

SceneCounts SceneResult::counts() const {
  SceneCounts counts;
  for (const SceneNode& node : nodes) ++(node.computed ? counts.computed : counts.skipped);
  return counts;
}

SceneResult evaluate_scene(const SceneFile& scene, Body body, const WrittenForms& forms) {
  return SceneEvaluation(scene, std::move(body), forms).run();
}

}  // namespace rigor
