// SPDX-License-Identifier: GPL-3.0-or-later
// The law of motion of a scene, out of the equations that it names, and the motion.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/motion/free_motion.h"
#include "scene/motion/split_motion.h"
#include "scene/quantity/scene_evaluation.h"

namespace rigor {
namespace {

constexpr const char* add_spin = "add a spin, as `spin = [\"1 rad/s\", 0, 0]`";

bool is_equality(const WrittenStep& step) {
  return !step.expected_refuted && (step.kind == "=" || step.kind == "\\equiv" || step.kind == ":=");
}

}  // namespace

/// The equations with the tag or heading that the scene names, and what their letters are.
void SceneEvaluation::collect_law(std::set<SceneRole>& read) {
  read.insert(SceneRole::spin);
  if (!scene_.motion) return;
  const std::string& wanted = scene_.motion->equations.text;
  for (const WrittenFormChain& chain : forms_.chains) {
    if (!stands_at(chain, wanted)) continue;
    ++chains_of_law_;
    for (std::size_t step = 0; step + 1 < chain.forms.size(); ++step) {
      if (is_equality(chain.steps[step])) add_to_law(chain, step, read);
    }
  }
}

/// If it has a rate of the spin.
void SceneEvaluation::add_to_law(const WrittenFormChain& chain, std::size_t step, std::set<SceneRole>& read) {
  const auto& left = chain.forms[step].expr;
  const auto& right = chain.forms[step + 1].expr;
  if (!left || !right) return;
  LawEquation equation{*left, *right, chain.indices,
                       without_definitions_of(letters_.overriding(), chain.definitions)};
  const ProgramRoot roots[]{{*left, chain.indices}, {*right, chain.indices}};
  const auto program = Program::compile(forms_.tree, equation.definitions, roots);
  if (!program || !reads(*program, rate_symbols_)) return;
  note_roles(*program, read);
  law_.push_back(std::move(equation));
  law_programs_.push_back(*program);
}

void SceneEvaluation::make_law() {
  if (!scene_.motion) {
    return report(DiagnosticKind::bad_scene, scene_.span,
                  "the rates of the spin are needed, but the scene has no motion",
                  "add [motion] with `equations` and `duration`");
  }
  const SceneText& name = scene_.motion->equations;
  if (chains_of_law_ == 0) {
    return report(DiagnosticKind::bad_scene, name.span,
                  fmt::format("no equation of the notes has the tag or heading `{}`", name.text));
  }
  if (std::ranges::any_of(law_programs_, [this](const Program& each) { return reads_time(each); })) {
    return report(
        DiagnosticKind::bad_scene, name.span,
        fmt::format("`{}` depends on the time `t` itself: such motions are not followed", name.text));
  }
  const auto spin = values_.spin();
  if (!spin) return report(DiagnosticKind::bad_scene, scene_.motion->span, spin.error().reason, add_spin);
  std::string help;
  for (const Program& program : law_programs_) {
    const auto missing = values_.provide(program);
    if (missing && help.empty()) help = missing->help;
  }
  auto law = ledger_.compute(law_node, fmt::format("equations of `{}`", name.text), [&] {
    return SpinLaw::make(forms_.tree, law_, spin_symbols_, values_.values(), body_.body().size(), *spin);
  });
  if (!law) {
    return report(DiagnosticKind::bad_scene, name.span,
                  fmt::format("`{}` gives no law of motion: {}", name.text, law.error().reason), help);
  }
  law_of_spin_ = *law;
  start_ = *spin;
}

/// False: that cannot be done.
bool SceneEvaluation::split(const SpinRates& rates, const MotionRequest& request) {
  const auto& sharp = body_.moments();
  if (!values_.along_principal_axes() || !sharp) {
    report(DiagnosticKind::bad_scene, scene_.motion->span,
           "`split` needs a body with moments, and the spin along its principal axes",
           "add `axes = \"principal\"` at the top");
    return false;
  }
  const Position moments = {(*sharp)[0].high, (*sharp)[1].high, (*sharp)[2].high};
  result_.motion = ledger_.compute(motion_node, "in split steps", [&] {
    return split_motion(rates, moments, request, scene_.motion->split);
  });
  return true;
}

void SceneEvaluation::move() {
  const auto orientation = values_.orientation();
  if (!orientation) {
    return report(DiagnosticKind::bad_scene, scene_.motion->span, orientation.error().reason);
  }
  const MotionRequest request{.spin = start_,
                              .duration = scene_.motion->duration,
                              .rows = scene_.motion->rows,
                              .tolerance = scene_.motion->tolerance,
                              .orientation = *orientation};
  std::string fault;  // the first one on the way
  const SpinRates rates = [&](const Vector3& spin) {
    const Vector3 found = law_of_spin_->rates(spin);
    if (std::isnan(found[0]) && fault.empty()) fault = ": " + law_of_spin_->fault_at(spin);
    return found;
  };
  if (scene_.motion->split > 0 && !split(rates, request)) return;
  if (!result_.motion && values_.along_principal_axes()) {
    const auto& sharp = body_.moments();
    if (sharp && high_parts_suffice(*sharp, request)) {
      const Position moments = {(*sharp)[0].high, (*sharp)[1].high, (*sharp)[2].high};
      result_.motion = ledger_.compute(motion_node, "in closed form: the equations are a free rigid body's",
                                       [&] { return free_motion(rates, moments, request); });
      fault.clear();
    }
  }
  if (!result_.motion) {
    result_.motion = ledger_.compute(motion_node, "something is asked over the time",
                                     [&] { return integrate(rates, request); });
  }
  if (result_.motion->stopped.empty()) return;
  report(DiagnosticKind::bad_scene, scene_.motion->span,
         fmt::format("the motion ends early: {}{}", result_.motion->stopped, fault));
}

}  // namespace rigor
