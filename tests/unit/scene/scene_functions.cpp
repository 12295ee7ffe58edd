// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_functions.h"

#include <memory>

#include "scene/quantity/scene_evaluation.h"

namespace rigor {
namespace {

class FunctionsOfScene : public SceneEvaluation {
 public:
  using SceneEvaluation::SceneEvaluation;
  /// Instead of `run`; they keep the evaluation alive.
  [[nodiscard]] SceneFunctions functions(const std::shared_ptr<FunctionsOfScene>& self);
};

SceneFunctions FunctionsOfScene::functions(const std::shared_ptr<FunctionsOfScene>& self) {
  SceneFunctions functions;
  needs_law_ = scene_.motion.has_value();
  if (const auto valid = check_body(body_.body()); !valid) {
    report(DiagnosticKind::bad_body, scene_.body.span, valid.error().reason);
  } else if (compile_all()) {
    if (needs_law_) make_law();
    if (law_of_spin_)
      functions.rates = [self](const Vector3& spin) { return self->law_of_spin_->rates(spin); };
    for (Asked& asked : asked_) {
      SpinFunction function;
      const bool scalar = asked.form != nullptr && !asked.failed && asked.program->outputs() == 1;
      if (scalar) {
        if (const auto missing = values_.provide(*asked.program)) {
          fail(asked, missing->message, missing->help);
        } else if (!law_of_spin_ && reads(*asked.program, rate_symbols_)) {
          fail(asked, "the rates of the spin are not known");
        } else {
          function = [self, program = *asked.program](const Vector3& spin) {
            return self->run_program(program, {&spin, 1})[0];
          };
        }
      }
      functions.asked.push_back(std::move(function));
    }
  }
  functions.diagnostics = result_.diagnostics;
  return functions;
}

}  // namespace

SceneFunctions scene_functions(const SceneFile& scene, const Body& body, const WrittenForms& forms) {
  const auto evaluation = std::make_shared<FunctionsOfScene>(scene, body, forms);
  return evaluation->functions(evaluation);
}

std::vector<BodyStability> measure_stability(const SceneFile& scene, std::span<const Body> bodies,
                                             const WrittenForms& forms, double spin,
                                             std::span<const double> pushes) {
  std::vector<BodyStability> all;
  for (const Body& body : bodies) {
    const SceneFunctions functions = scene_functions(scene, body, forms);
    BodyStability result{body.name, {}, functions.diagnostics};
    for (std::size_t axis = 0; axis < functions.asked.size() && axis < 3; ++axis) {
      if (!functions.rates || !functions.asked[axis]) continue;
      result.axes.push_back(measure_stability(functions.rates, functions.asked[axis], axis, spin, pushes));
    }
    all.push_back(std::move(result));
  }
  return all;
}

}  // namespace rigor
