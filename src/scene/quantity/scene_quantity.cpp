// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities of a scene: at the time 0, over the time, and how constant they stay.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/among.h"
#include "numeric/measure/bounds.h"
#include "numeric/measure/evaluate.h"
#include "scene/file/quantity_text.h"
#include "scene/quantity/quantity_dimension.h"
#include "scene/quantity/scene_evaluation.h"

namespace rigor {
namespace {

/// Rows times particles for one quantity: seconds of work.
constexpr double most_work = 1e9;

/// Steps of the integration err by its tolerance; there are thousands. More than this is no constant, however
/// coarse the integration.
constexpr double steps_allowed_for = 1e4;
constexpr double most_change = 1e-4;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Rows = std::vector<std::vector<double>>;

/// The greatest change of any component, over the greatest size; of rows that are finite. The sizes are
/// halved so that no difference overflows.
double relative_change(const Rows& rows) {
  double size = 0;
  double change = 0;
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      size = std::max(size, std::abs(row[c]) / 2);
      change = std::max(change, std::abs(row[c] / 2 - rows[0][c] / 2));
    }
  }
  return size > 0 ? change / size : 0;
}

Rows by_row(const std::vector<double>& columns, std::size_t rows) {
  const std::size_t components = columns.size() / rows;
  Rows table(rows, std::vector<double>(components));
  for (std::size_t c = 0; c < components; ++c) {
    for (std::size_t row = 0; row < rows; ++row) table[row][c] = columns[c * rows + row];
  }
  return table;
}

/// Of moments whose low parts are not shown.
std::vector<double> own_errors(const Position& errors, const SharpPosition& moments) {
  std::vector<double> all;
  for (std::size_t k = 0; k < 3; ++k) all.push_back((errors[k] + std::abs(moments[k].low)) * (1 + 0x1p-50));
  return all;
}

}  // namespace

void SceneEvaluation::evaluate_one(Asked& asked) {
  if (asked.failed) return;
  if (asked.form == nullptr) return evaluate_own_part(asked);
  const std::string& name = asked.ask->name.text;
  const bool over_time = asked.ask->kind == SceneAskKind::over_time;
  if (const auto missing = values_.provide(*asked.program))
    return fail(asked, missing->message, missing->help);
  if (reads(*asked.program, rate_symbols_) && !law_of_spin_)
    return fail(asked, "the rates of the spin are not known");
  if (over_time && !result_.motion) return fail(asked, "there is no motion");
  if (over_time && reads_time(*asked.program))
    return fail(asked, "it reads the time `t` itself, which is not followed along a motion");

  const auto dimension = quantity_dimension(forms_.tree, definitions_, asked.form->expr,
                                            [this](SymbolId symbol) { return values_.dimension_of(symbol); });
  if (!dimension.clash.empty()) {
    report(DiagnosticKind::wrong_unit, asked.ask->name.span,
           fmt::format("in `{}` {}", name, dimension.clash));
  }
  SceneQuantity quantity{
      .source = name,
      .axes = static_cast<int>(asked.form->indices.size()) + forms_.tree[asked.form->expr].rank,
      .dimension = dimension.dimension};
  if (!law_of_spin_ && reads(*asked.program, spin_symbols_)) {
    if (const auto spin = values_.spin()) start_ = *spin;
  }
  const Samples samples = samples_for(*asked.program, {&start_, 1});
  quantity.value = ledger_.compute(name, over_time ? "asked for over the time" : "asked for", [&] {
    return evaluate(*asked.program, samples, arithmetic_for(*asked.program));
  });
  if (!are_finite(quantity.value)) {
    report(DiagnosticKind::bad_scene, asked.ask->name.span, fmt::format("`{}` is not finite", name));
  }
  if (scene_.errors || have_digits(*asked.program, samples)) {
    BoundedResults enclosed =
        ledger_.compute((scene_.errors ? "rounding errors of " : "all digits of ") + name,
                        scene_.errors ? "asked for by `errors`" : "moments have more than 100 bits",
                        [&] { return enclosures(*asked.program, samples, std::move(quantity.value)); });
    quantity.value = std::move(enclosed.values);
    if (scene_.errors) quantity.error = std::move(enclosed.bounds);
  }
  const bool moves = over_time || reads(*asked.program, spin_symbols_);
  if (result_.motion && moves && !reads_time(*asked.program)) follow_motion(asked, quantity);
  result_.quantities.push_back(std::move(quantity));
}

bool SceneEvaluation::reads_time(const Program& program) const {
  return std::ranges::any_of(program.inputs(), [&](const ProgramInput& input) {
    const Symbol& symbol = forms_.tree.symbols[input.symbol];
    return symbol.name == "t" && symbol.rank == 0;
  });
}

Samples SceneEvaluation::samples_for(const Program& program, std::span<const Vector3> spins) {
  std::vector<SymbolId> moving = spin_symbols_;
  moving.insert(moving.end(), rate_symbols_.begin(), rate_symbols_.end());
  Samples samples(spins.size(), body_.body().size());
  const auto fill = [&] { return values_.values().fill(program, samples, moving); };
  const bool of_particles = program.sums_over_particles();
  if (of_particles) (void)ledger_.compute(SceneBody::particles_node, "their masses or places are read", fill);
  if (!of_particles) (void)fill();
  std::vector<Vector3> rates;
  if (reads(program, rate_symbols_)) {
    for (const Vector3& spin : spins) rates.push_back(law_of_spin_->rates(spin));
  }
  for (const ProgramInput& input : program.inputs()) {
    if (!is_one_of(input.symbol, moving)) continue;
    const SceneLetter* letter = letters_.find(input.symbol);
    const auto source = letter->role == SceneRole::spin ? spins : std::span<const Vector3>(rates);
    std::vector<double> column;
    for (const Vector3& each : source) column.push_back(each[input.component]);
    samples.set_each(input.symbol, input.component, std::move(column));
    if (!scene_.errors) continue;
    const bool is_spin = letter->role == SceneRole::spin;  // of rates no bound is known
    const auto given =
        is_spin ? values_.spin_value() : LetterValue{{}, {}, {}, {infinity, infinity, infinity}};
    if (given && !given->errors.empty())
      samples.set_errors(input.symbol, input.component, {given->errors[input.component]});
  }
  return samples;
}

/// Differences of moments keep their digits in double-double. Sums over particles would take ten times as
/// long.
Arithmetic SceneEvaluation::arithmetic_for(const Program& program) const {
  const bool sharply = values_.values().are_sharp(program) && !program.sums_over_particles();
  return sharply ? Arithmetic::double_double : Arithmetic::plain;
}

/// results[output · spins + which].
std::vector<double> SceneEvaluation::run_program(const Program& program, std::span<const Vector3> spins) {
  return evaluate(program, samples_for(program, spins), arithmetic_for(program));
}

void SceneEvaluation::follow_motion(const Asked& asked, SceneQuantity& quantity) {
  const Motion& motion = *result_.motion;
  if (motion.times.empty()) return;  // and the motion's diagnostic says why
  const std::size_t particles = asked.program->sums_over_particles() ? body_.body().size() : 1;
  if (static_cast<double>(motion.times.size()) * static_cast<double>(particles) > most_work) {
    return report(DiagnosticKind::bad_scene, asked.ask->name.span,
                  fmt::format("`{}` for {} rows and {} particles is too much work", quantity.source,
                              motion.times.size(), particles),
                  "ask for fewer `rows` under [motion]");
  }
  Rows rows = ledger_.compute(quantity.source, "asked for, and followed along the motion", [&] {
    return by_row(run_program(*asked.program, motion.spins), motion.times.size());
  });
  note_drift(asked.ask->name, quantity, rows);
  if (asked.ask->kind == SceneAskKind::over_time) quantity.rows = std::move(rows);
}

/// A vector that is not constant along the body's axes may rest in space.
void SceneEvaluation::note_drift(const SceneText& name, const SceneQuantity& quantity, const Rows& rows) {
  if (rows.size() < 2) return;  // nothing moved
  const auto bad = std::ranges::find_if_not(rows, are_finite);
  if (bad != rows.end()) {
    result_.drifts.push_back({quantity.source, std::numeric_limits<double>::quiet_NaN(), false, false});
    if (bad == rows.begin()) return;  // it has been said
    const double time = result_.motion->times[static_cast<std::size_t>(bad - rows.begin())];
    return report(DiagnosticKind::bad_scene, name.span,
                  fmt::format("`{}` is not finite at {:.6g} s", quantity.source, time));
  }
  const double allowed = std::min(steps_allowed_for * scene_.motion->tolerance, most_change);
  const double change = relative_change(rows);
  SceneDrift drift{quantity.source, change, change <= allowed, false};
  if (quantity.axes == 1 && !drift.constant) {
    Rows fixed = rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const Vector3 in_space =
          turned(result_.motion->orientations[row], {rows[row][0], rows[row][1], rows[row][2]});
      fixed[row].assign(in_space.begin(), in_space.end());
    }
    const double in_space = relative_change(fixed);
    if (in_space <= allowed) drift = {quantity.source, in_space, true, true};
  }
  result_.drifts.push_back(std::move(drift));
}

/// Principal moments and axes, which are asked of the body and not of the notes.
void SceneEvaluation::evaluate_own_part(Asked& asked) {
  SceneQuantity quantity{.source = asked.ask->name.text, .axes = 1};
  if (asked.ask->kind == SceneAskKind::principal_moments) {
    const auto& moments = body_.moments();
    if (!moments) return fail(asked, moments.error().reason);
    for (const HighLow& moment : *moments) quantity.value.push_back(moment.high);
    if (scene_.errors) quantity.error = own_errors(body_.moment_errors(), *moments);
    quantity.dimension = inertia_dimension();
  } else {
    const auto& axes = body_.axes();
    if (!axes) return fail(asked, axes.error().reason);
    quantity.axes = 2;
    for (const Position& axis : *axes) quantity.value.insert(quantity.value.end(), axis.begin(), axis.end());
    if (scene_.errors) {
      for (const double error : body_.axis_errors()) quantity.error.insert(quantity.error.end(), 3, error);
    }
    quantity.dimension = Dimension();
  }
  result_.quantities.push_back(std::move(quantity));
}

}  // namespace rigor
