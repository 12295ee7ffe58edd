// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/chain_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "numeric/advice/advise_forms.h"
#include "numeric/body/body_letters.h"
#include "numeric/family/families.h"
#include "numeric/measure/assumptions.h"

namespace rigor {
namespace {

constexpr std::size_t fewest_samples = 16;
constexpr std::size_t digits_over_double = 40;  // by so much many digits cost more operations
constexpr std::size_t particles_without_body = 8;
constexpr double uncertainty = 16 * 0x1p-53;  // of numbers that meet assumptions to rounding

/// The forms of a chain as programs, and what is drawn for them.
class ChainMeasurement {
 public:
  ChainMeasurement(const WrittenForms& forms, const WrittenFormChain& chain, const TrialOptions& options)
      : forms_(forms), chain_(chain), options_(options) {}

  ChainResult measure(std::span<const Body> bodies) {
    for (std::size_t side = 0; side < chain_.forms.size(); ++side) compile(side);
    if (programs_.empty()) return std::move(result_);
    find_incomparable();
    for (const Program& program : programs_) pointers_.push_back(&program);
    symbols_ = symbols_read(pointers_);
    compile_assumptions();
    if (!options_.values.empty()) {
      result_.at_given_numbers = true;
      try_values();
      return std::move(result_);
    }
    const bool of_particles = std::ranges::any_of(
        symbols_, [&](SymbolId symbol) { return forms_.tree.symbols[symbol].per_particle; });
    if (bodies.empty() || !of_particles) {
      for (const InputFamily& family : input_families()) try_family(family, nullptr);
      search();
      return std::move(result_);
    }
    const auto letters = body_letters(forms_.tree, pointers_);
    if (!letters) {
      result_.no_trials = letters.error().reason;
      return std::move(result_);
    }
    letters_ = *letters;
    const auto take = [&](const std::optional<SymbolId>& symbol, const char* what) {
      if (!symbol) return;
      if (!result_.taken_for.empty()) result_.taken_for += ", ";
      result_.taken_for += fmt::format("`{}` for the {}", forms_.tree.symbols[*symbol].name, what);
    };
    take(letters_.mass, "masses");
    take(letters_.position, "positions");
    for (const Body& body : bodies) {
      for (const FamilyKind kind : {FamilyKind::random, FamilyKind::thin_axis}) try_family({kind, 0}, &body);
    }
    return std::move(result_);
  }

 private:
  /// A name of the next form would be the same program again.
  void compile(std::size_t side) {
    const auto& expr = chain_.forms[side].expr;
    const bool names_next = side < chain_.steps.size() && chain_.steps[side].defines;
    if (names_next) return;
    if (!expr) {
      result_.left_out.push_back(
          {side, chain_.forms[side].other_space
                     ? "matrices and vectors of another size than three are not evaluated yet"
                     : "it is not understood"});
      return;
    }
    const ProgramRoot root{*expr, chain_.indices};
    auto program = Program::compile(forms_.tree, chain_.definitions, std::span(&root, 1));
    if (!program) {
      result_.left_out.push_back({side, program.error().reason});
      return;
    }
    const ProgramCounts counts = program->counts();
    if (counts.once + counts.per_particle == 0) return;
    result_.forms.push_back({side, counts.once, counts.per_particle});
    programs_.push_back(std::move(*program));
  }

  /// Between the first form that was evaluated and the last one, every step is an equality that is proved.
  void find_incomparable() {
    for (std::size_t k = result_.forms.front().side; k < result_.forms.back().side; ++k) {
      const WrittenStep& step = chain_.steps[k];
      const bool equality =
          !step.nearly && (!step.question || step.question->claim.relation == Relation::equal);
      if (equality && (step.defines || step.outcome == Outcome::proved)) continue;
      const char* why = "undecided";
      if (!step.outcome) why = "not decided";
      if (step.outcome == Outcome::refuted) why = "refuted";
      if (!equality) why = "no equality";
      result_.not_comparable =
          fmt::format("`{} {} {}` is {}", chain_.forms[k].source, step.kind, chain_.forms[k + 1].source, why);
      return;
    }
  }

  /// Do the assumptions only speak of what the forms read?
  [[nodiscard]] bool has_all_letters(const Samples& samples) const {
    return std::ranges::all_of(assumed_, [&](const ProgramInput& input) {
      return samples.find(input.symbol, input.component) != nullptr;
    });
  }

  /// What the assumptions read; one that cannot be compiled counts as not met.
  void compile_assumptions() {
    for (const Equation& assumption : chain_.assumptions) {
      for (const ExprId side : {assumption.left, assumption.right}) {
        const ProgramRoot root{side, assumption.indices};
        const auto program = Program::compile(forms_.tree, chain_.definitions, std::span(&root, 1));
        if (program) assumed_.insert(assumed_.end(), program->inputs().begin(), program->inputs().end());
      }
    }
  }

  void try_family(const InputFamily& family, const Body* body) {
    if (!applies(family, forms_.tree, symbols_, body)) return;
    const std::size_t particles = body != nullptr ? body->size() : particles_without_body;
    std::size_t work = 1;
    for (const Program& program : programs_) work = std::max(work, work_of(program, particles));
    const std::size_t affordable = options_.operations / digits_over_double / work;
    const std::size_t samples =
        std::clamp(affordable, fewest_samples, std::max(fewest_samples, options_.samples));
    const auto drawn = draw_samples(forms_.tree, symbols_, family,
                                    {.samples = samples,
                                     .particles = particles,
                                     .seed = options_.seed,
                                     .body = body,
                                     .letters = letters_});
    if (!drawn) {
      result_.no_trials = drawn.error().reason;
      return;
    }
    TrialResult trial{.name = name_of(family),
                      .what = std::string(description_of(family.kind)),
                      .samples = drawn->samples(),
                      .particles = drawn->particles(),
                      .forms = {}};
    if (body != nullptr) {
      const bool plain = family.kind == FamilyKind::random;
      trial.name = plain ? body->name : fmt::format("{}, {}", body->name, trial.name);
    }
    trial.met = has_all_letters(*drawn) &&
                meets_all(forms_.tree, chain_.definitions, chain_.assumptions, *drawn, uncertainty);
    for (const Program& program : programs_) trial.forms.push_back(run(program, *drawn, options_.times));
    result_.trials.push_back(std::move(trial));
  }

  /// One sample, of numbers that somebody gives.
  void try_values() {
    Samples samples(1, 1);
    std::map<SymbolId, std::vector<std::uint32_t>> read;
    for (const Program& program : programs_) {
      for (const ProgramInput& input : program.inputs()) {
        std::vector<std::uint32_t>& components = read[input.symbol];
        if (std::ranges::find(components, input.component) == components.end())
          components.push_back(input.component);
      }
    }
    for (const auto& [id, components] : read) {
      const Symbol& symbol = forms_.tree.symbols[id];
      if (symbol.per_particle) {
        result_.no_trials = fmt::format("`{}` belongs to particles, which only a body gives", symbol.name);
        return;
      }
      const auto given = options_.values.find(symbol.name);
      const bool has_all = given != options_.values.end() && given->second.size() == component_count(symbol);
      if (!symbol.unit_of_measure && !has_all) {
        result_.no_trials = given == options_.values.end()
                                ? fmt::format("`{}` has no value", symbol.name)
                                : fmt::format("`{}` has {} components", symbol.name, component_count(symbol));
        return;
      }
      for (const std::uint32_t component : components)
        samples.set(id, component, symbol.unit_of_measure ? 1.0 : given->second[component]);
    }
    TrialResult trial{.name = "given", .what = "the numbers that were given", .samples = 1, .forms = {}};
    trial.met = has_all_letters(samples) &&
                meets_all(forms_.tree, chain_.definitions, chain_.assumptions, samples, uncertainty);
    for (const Program& program : programs_) trial.forms.push_back(run(program, samples, options_.times));
    result_.trials.push_back(std::move(trial));
  }

  void search() {
    if (programs_.size() < 2 || result_.trials.empty() || !result_.not_comparable.empty()) return;
    const auto space = search_space(forms_, chain_, programs_, options_.seed);
    if (!space) return;
    std::vector<double> costs;
    for (std::size_t form = 0; form < programs_.size(); ++form) costs.push_back(cost_of(result_, form));
    const auto advice = advise_forms(*space, forms_.tree, costs, options_.seed);
    if (!advice) return;
    SearchResult found;
    for (const AdvisedForm& part : advice->parts)
      found.ranges.push_back({part.form, text_of(forms_.tree, *space, part.range), {}});
    for (std::size_t k = 0; k < found.ranges.size(); ++k)
      found.ranges[k].losing = worst_points(*space, advice->parts[k].others);
    found.losing = worst_points(*space, advice->others);
    result_.search = std::move(found);
  }

  [[nodiscard]] std::vector<WorstPoint> worst_points(const SearchSpace& space,
                                                     const std::vector<OtherForm>& others) const {
    std::vector<WorstPoint> points;
    for (const OtherForm& other : others) {
      WorstPoint point{.form = other.form,
                       .at = text_of(forms_.tree, space, other.worst.point),
                       .values = {},
                       .forms = {}};
      for (const SearchedLetter& letter : space.letters)
        point.values[forms_.tree.symbols[letter.symbol].name] =
            values_of(forms_.tree, letter, other.worst.point);
      const Samples there = samples_at(space, std::span(&other.worst.point, 1));
      for (const Program& program : programs_) point.forms.push_back(run(program, there, false));
      points.push_back(std::move(point));
    }
    return points;
  }

  [[nodiscard]] FormResult run(const Program& program, const Samples& samples, bool times) const {
    std::vector<std::uint32_t> at;
    for (std::size_t k = 0; k < program.free_particles().size(); ++k)
      at.push_back(static_cast<std::uint32_t>(k % samples.particles()));
    MeasureOptions options{.operations = options_.operations};
    if (!times) options.milliseconds = 0;
    FormResult form;
    form.measure = rigor::measure(program, samples, options, at);
    const std::vector<double> values = evaluate(program, samples, Arithmetic::plain, at);
    for (std::size_t output = 0; output < program.outputs(); ++output)
      form.first.push_back(values[output * samples.samples()]);
    return form;
  }

  const WrittenForms& forms_;
  const WrittenFormChain& chain_;
  TrialOptions options_;
  ChainResult result_;
  std::vector<Program> programs_;
  std::vector<const Program*> pointers_;
  std::vector<SymbolId> symbols_;
  std::vector<ProgramInput> assumed_;
  BodyLetters letters_;
};

}  // namespace

double cost_of(const ChainResult& result, std::size_t form) {
  std::vector<double> times;
  for (const TrialResult& trial : result.trials) times.push_back(in_double(trial.forms[form]).nanoseconds);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  const double median = times[times.size() / 2];
  if (median > 0) return median;
  const ChainResult::Form& counted = result.forms[form];
  return static_cast<double>(counted.operations + counted.operations_per_particle);
}

bool has_times(const ChainResult& result) { return in_double(result.trials[0].forms[0]).nanoseconds > 0; }

ChainResult measure_chain(const WrittenForms& forms, const WrittenFormChain& chain,
                          std::span<const Body> bodies, const TrialOptions& options) {
  return ChainMeasurement(forms, chain, options).measure(bodies);
}

}  // namespace rigor
