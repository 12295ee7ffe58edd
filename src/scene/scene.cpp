// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "numeric/evaluate.h"
#include "scene/quantity_dimension.h"
#include "scene/scene_values.h"
#include "scene/spin_law.h"

namespace rigor {
namespace {

constexpr const char* law_node = "law of motion";
constexpr const char* motion_node = "motion";
/// Rows times particles of one quantity: some seconds of work.
constexpr double most_work = 1e9;

/// Something asked for, with its program.
struct Asked {
  const SceneAsk* ask = nullptr;
  const AskedForm* form = nullptr;   // null: a part of the scene itself
  std::optional<Program> program{};  // nothing: it could not be compiled
  bool failed = false;
};

std::string without_brackets(const std::string& tag) {
  return tag.size() > 2 && tag.front() == '(' && tag.back() == ')' ? tag.substr(1, tag.size() - 2) : tag;
}

/// One scene while it is evaluated.
class Evaluation {
 public:
  Evaluation(const SceneFile& scene, const Body& body, const WrittenForms& forms)
      : scene_(scene),
        forms_(forms),
        body_(body, ledger_),
        letters_(scene, forms, result_.diagnostics),
        values_(scene, forms.tree, letters_, body_, ledger_),
        spin_symbols_(letters_.with_role(SceneRole::spin)),
        rate_symbols_(letters_.with_role(SceneRole::spin_rate)),
        definitions_(without_definitions_of(letters_.overriding(), forms.definitions)) {
    left_out_ = spin_symbols_;
    left_out_.insert(left_out_.end(), rate_symbols_.begin(), rate_symbols_.end());
  }

  SceneResult run() {
    result_.title = scene_.title;
    result_.body = body_.body().name;
    ledger_.expect(law_node, "nothing that was asked needs it");
    ledger_.expect(motion_node, "nothing is asked over the time");
    if (const auto valid = check_body(body_.body()); !valid) {
      report(DiagnosticKind::bad_body, scene_.body.span, valid.error().reason);
    } else if (compile_all()) {
      make_motion();
      for (Asked& asked : asked_) evaluate_one(asked);
    }
    result_.along_principal_axes = values_.along_principal_axes();
    result_.nodes = ledger_.nodes();
    return std::move(result_);
  }

 private:
  void report(DiagnosticKind kind, Span span, std::string message, const std::string& help = {}) {
    std::vector<std::string> all;
    if (!help.empty()) all.push_back(help);
    result_.diagnostics.push_back({kind, span, std::move(message), {}, std::move(all)});
  }
  void fail(Asked& asked, const std::string& message, const std::string& help = {}) {
    asked.failed = true;
    ledger_.skip(asked.ask->name.text, message);
    report(DiagnosticKind::bad_scene, asked.ask->name.span,
           fmt::format("`{}`: {}", asked.ask->name.text, message), help);
  }

  /// False where nothing can be evaluated.
  bool compile_all() {
    std::set<SceneRole> read;
    for (const SceneAsk& ask : scene_.asked) {
      asked_.push_back({&ask, nullptr, std::nullopt, false});
      if (!ask.latex.empty()) compile(asked_.back(), read);
    }
    needs_motion_ = std::any_of(asked_.begin(), asked_.end(), [](const Asked& asked) {
      return !asked.failed && asked.ask->kind == SceneAskKind::over_time;
    });
    needs_law_ = needs_motion_ || read.contains(SceneRole::spin_rate);
    if (needs_law_) collect_law(read);
    const auto open = values_.settle_axes(read);
    if (open) report(DiagnosticKind::bad_scene, scene_.span, open->message, open->help);
    return !open;
  }

  void compile(Asked& asked, std::set<SceneRole>& read) {
    const auto form = std::find_if(forms_.asked.begin(), forms_.asked.end(),
                                   [&](const AskedForm& each) { return each.source == asked.ask->latex; });
    if (form == forms_.asked.end()) {
      asked.failed = true;  // the notes' own diagnostic says why
      ledger_.skip(asked.ask->name.text, "the notes do not have it");
      return;
    }
    asked.form = &*form;
    const ProgramRoot root{form->expr, form->indices};
    auto program = Program::compile(forms_.tree, definitions_, std::span(&root, 1));
    if (!program) return fail(asked, program.error().reason);
    if (!program->free_particles().empty())
      return fail(asked, "it is a quantity of single particles, not of the body");
    note_roles(*program, read);
    asked.program = std::move(*program);
  }

  void note_roles(const Program& program, std::set<SceneRole>& read) const {
    for (const ProgramInput& input : program.inputs()) {
      if (const SceneLetter* letter = letters_.find(input.symbol)) read.insert(letter->role);
    }
  }

  /// Equations of the notes with the tag or heading that the scene names; and the roles of their letters.
  void collect_law(std::set<SceneRole>& read) {
    read.insert(SceneRole::spin);
    if (!scene_.motion) return;
    const std::string& wanted = scene_.motion->equations.text;
    for (const WrittenFormChain& chain : forms_.chains) {
      const bool named = without_brackets(chain.tag) == without_brackets(wanted) || chain.section == wanted;
      if (!named || chain.forms.empty()) continue;
      ++chains_of_law_;
      for (std::size_t i = 0; i + 1 < chain.forms.size(); ++i) {
        if (chain.steps[i].expected_refuted || !chain.forms[i].expr || !chain.forms[i + 1].expr) continue;
        if (chain.steps[i].kind != "=" && chain.steps[i].kind != "\\equiv" && chain.steps[i].kind != ":=")
          continue;
        law_.push_back({*chain.forms[i].expr, *chain.forms[i + 1].expr, chain.indices,
                        without_definitions_of(letters_.overriding(), chain.definitions)});
        const ProgramRoot roots[]{{law_.back().left, law_.back().indices},
                                  {law_.back().right, law_.back().indices}};
        const auto program = Program::compile(forms_.tree, law_.back().definitions, roots);
        const bool turns =
            program &&
            std::any_of(program->inputs().begin(), program->inputs().end(), [&](const auto& input) {
              const SceneLetter* letter = letters_.find(input.symbol);
              return letter != nullptr && letter->role == SceneRole::spin_rate;
            });
        if (!turns) {
          law_.pop_back();
          continue;
        }
        note_roles(*program, read);
        law_programs_.push_back(*program);
      }
    }
  }

  void make_motion() {
    if (!needs_law_) return;
    if (!scene_.motion) {
      report(DiagnosticKind::bad_scene, scene_.span,
             "the rates of the spin are needed, and the scene has no law of motion",
             "add [motion] with `equations` and `duration`");
      return;
    }
    const SceneText& name = scene_.motion->equations;
    if (chains_of_law_ == 0) {
      return report(DiagnosticKind::bad_scene, name.span,
                    fmt::format("no equation of the notes has the tag or heading `{}`", name.text));
    }
    const auto spin = values_.spin();
    if (!spin) {
      return report(DiagnosticKind::bad_scene, scene_.motion->span, spin.error().reason,
                    "add `spin = [\"1 rad/s\", 0, 0]`, say");
    }
    std::string help;
    for (const Program& program : law_programs_) {
      const auto missing = values_.provide(program);
      if (missing && help.empty()) help = missing->message + "; " + missing->help;
    }
    auto law = ledger_.compute(law_node, fmt::format("from {}", name.text), [&] {
      return SpinLaw::make(forms_.tree, law_, spin_symbols_, values_.values(), body_.body().size(), *spin);
    });
    if (!law) {
      return report(DiagnosticKind::bad_scene, name.span,
                    fmt::format("`{}` is no law of motion: {}", name.text, law.error().reason), help);
    }
    law_of_spin_ = *law;
    start_ = *spin;
    if (needs_motion_) move();
  }

  void move() {
    MotionRequest request{.spin = start_,
                          .duration = scene_.motion->duration,
                          .rows = scene_.motion->rows,
                          .tolerance = scene_.motion->tolerance,
                          .orientation = scene_.orientation.value_or(Quaternion{1, 0, 0, 0})};
    const SpinRates rates = [&](const Vector3& spin) { return law_of_spin_->rates(spin); };
    result_.motion = ledger_.compute(motion_node, "something is asked over the time",
                                     [&] { return integrate(rates, request); });
    if (!result_.motion->stopped.empty()) {
      report(DiagnosticKind::bad_scene, scene_.motion->span,
             fmt::format("the motion ends early: {}", result_.motion->stopped));
    }
  }

  void evaluate_one(Asked& asked) {
    if (asked.failed) return;
    if (asked.form == nullptr) return own_part(asked);
    const auto missing = values_.provide(*asked.program);
    if (missing) return fail(asked, missing->message, missing->help);
    SceneQuantity quantity{
        .source = asked.ask->name.text,
        .axes = static_cast<int>(asked.form->indices.size()) + forms_.tree[asked.form->expr].rank};
    const auto dimension = quantity_dimension(forms_.tree, definitions_, asked.form->expr,
                                              [&](SymbolId symbol) { return values_.dimension_of(symbol); });
    if (!dimension.clash.empty()) {
      report(DiagnosticKind::wrong_unit, asked.ask->name.span,
             fmt::format("`{}`: {}", quantity.source, dimension.clash));
    }
    quantity.dimension = dimension.dimension;
    if (reads_rates(*asked.program) && !law_of_spin_)
      return fail(asked, "it needs the rates of the spin, which are not known");
    const bool over_time = asked.ask->kind == SceneAskKind::over_time;
    if (over_time && !result_.motion) return fail(asked, "there is no motion");
    const std::string_view how = over_time ? "asked for over the time" : "asked for";
    const auto at_start = ledger_.compute(quantity.source, std::string(how), [&] {
      return run(*asked.program, {&start_spin(), 1});
    });
    quantity.value = at_start;
    if (result_.motion && (over_time || reads(*asked.program, spin_symbols_)))
      along_motion(asked, quantity, over_time);
    if (std::any_of(quantity.value.begin(), quantity.value.end(),
                    [](double each) { return !std::isfinite(each); })) {
      report(DiagnosticKind::bad_scene, asked.ask->name.span,
             fmt::format("`{}` is not finite", quantity.source));
    }
    result_.quantities.push_back(std::move(quantity));
  }

  [[nodiscard]] const Vector3& start_spin() {
    if (!law_of_spin_) {
      if (const auto spin = scene_.spin ? values_.spin() : tl::unexpected(Error{})) start_ = *spin;
    }
    return start_;
  }

  [[nodiscard]] bool reads(const Program& program, const std::vector<SymbolId>& symbols) const {
    return std::any_of(program.inputs().begin(), program.inputs().end(), [&](const ProgramInput& input) {
      return std::find(symbols.begin(), symbols.end(), input.symbol) != symbols.end();
    });
  }
  [[nodiscard]] bool reads_rates(const Program& program) const { return reads(program, rate_symbols_); }

  /// results[output · spins + which], all else being the same.
  [[nodiscard]] std::vector<double> run(const Program& program, std::span<const Vector3> spins) {
    Samples samples(spins.size(), body_.body().size());
    (void)values_.values().fill(program, samples, left_out_);
    std::vector<Vector3> rates;
    if (reads_rates(program)) {
      for (const Vector3& spin : spins) rates.push_back(law_of_spin_->rates(spin));
    }
    for (const ProgramInput& input : program.inputs()) {
      const bool is_rate =
          std::find(rate_symbols_.begin(), rate_symbols_.end(), input.symbol) != rate_symbols_.end();
      const bool is_spin =
          std::find(spin_symbols_.begin(), spin_symbols_.end(), input.symbol) != spin_symbols_.end();
      if (!is_rate && !is_spin) continue;
      std::vector<double> column;
      for (std::size_t i = 0; i < spins.size(); ++i)
        column.push_back((is_rate ? rates : std::vector(spins.begin(), spins.end()))[i][input.component]);
      samples.set_each(input.symbol, input.component, std::move(column));
    }
    return evaluate(program, samples);
  }

  void along_motion(Asked& asked, SceneQuantity& quantity, bool keep) {
    const Motion& motion = *result_.motion;
    const double work = static_cast<double>(motion.times.size()) * static_cast<double>(body_.body().size());
    if (asked.program->sums_over_particles() && work > most_work) {
      return report(DiagnosticKind::bad_scene, asked.ask->name.span,
                    fmt::format("`{}` over {} rows of {} particles is too much", quantity.source,
                                motion.times.size(), body_.body().size()),
                    "ask for fewer `rows` under [motion]");
    }
    const auto values = ledger_.compute(quantity.source, "along the motion",
                                        [&] { return run(*asked.program, motion.spins); });
    const std::size_t rows = motion.times.size();
    const std::size_t components = values.size() / rows;
    std::vector<std::vector<double>> table(rows, std::vector<double>(components));
    for (std::size_t c = 0; c < components; ++c) {
      for (std::size_t row = 0; row < rows; ++row) table[row][c] = values[c * rows + row];
    }
    result_.drifts.push_back(drift_of(quantity.source, table, false));
    if (quantity.axes == 1 && !result_.drifts.back().constant) {
      std::vector<std::vector<double>> in_space = table;
      for (std::size_t row = 0; row < rows; ++row) {
        const Vector3 fixed = turned(motion.orientations[row], {table[row][0], table[row][1], table[row][2]});
        in_space[row].assign(fixed.begin(), fixed.end());
      }
      const SceneDrift drift = drift_of(quantity.source, in_space, true);
      if (drift.constant) result_.drifts.back() = drift;
    }
    if (keep) quantity.rows = std::move(table);
  }

  [[nodiscard]] SceneDrift drift_of(const std::string& source, const std::vector<std::vector<double>>& rows,
                                    bool in_space) const {
    double size = 0;
    double change = 0;
    for (const auto& row : rows) {
      for (std::size_t c = 0; c < row.size(); ++c) {
        size = std::max(size, std::abs(row[c]));
        change = std::max(change, std::abs(row[c] - rows[0][c]));
      }
    }
    const double relative = size > 0 ? change / size : 0;
    return {source, relative, relative <= 1e4 * scene_.motion->tolerance, in_space};
  }

  /// Principal moments and axes, which no expression of the notes is asked for.
  void own_part(Asked& asked) {
    SceneQuantity quantity{.source = asked.ask->name.text};
    if (asked.ask->kind == SceneAskKind::principal_moments) {
      const auto& moments = body_.moments();
      if (!moments) return fail(asked, moments.error().reason);
      quantity.axes = 1;
      quantity.value.assign(moments->begin(), moments->end());
      quantity.dimension = Dimension::of(BaseQuantity::mass) + Dimension::of(BaseQuantity::length) * 2;
    } else {
      const auto& axes = body_.axes();
      if (!axes) return fail(asked, axes.error().reason);
      quantity.axes = 2;
      for (const Position& axis : axes->axes)
        quantity.value.insert(quantity.value.end(), axis.begin(), axis.end());
      quantity.dimension = Dimension();
    }
    result_.quantities.push_back(std::move(quantity));
  }

  const SceneFile& scene_;
  const WrittenForms& forms_;
  SceneResult result_;
  SceneLedger ledger_;
  SceneBody body_;
  SceneLetters letters_;
  SceneValues values_;
  std::vector<SymbolId> spin_symbols_;
  std::vector<SymbolId> rate_symbols_;
  std::vector<SymbolId> left_out_;
  std::vector<Definition> definitions_;
  std::vector<Asked> asked_;
  std::vector<LawEquation> law_;
  std::vector<Program> law_programs_;
  std::size_t chains_of_law_ = 0;
  bool needs_motion_ = false;
  bool needs_law_ = false;
  std::optional<SpinLaw> law_of_spin_;
  Vector3 start_{};
};

}  // namespace

SceneCounts SceneResult::counts() const {
  SceneCounts counts;
  for (const SceneNode& node : nodes) ++(node.computed ? counts.computed : counts.skipped);
  return counts;
}

SceneResult evaluate_scene(const SceneFile& scene, const Body& body, const WrittenForms& forms) {
  return Evaluation(scene, body, forms).run();
}

}  // namespace rigor
