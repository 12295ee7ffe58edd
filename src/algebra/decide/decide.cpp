// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the attempts: a quick look at samples, then proofs (definitions opaque before unfolded, few
// assumptions before all of them), then the search for a sample in earnest.
#include "algebra/decide/decide.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "algebra/decide/prove.h"
#include "algebra/decide/sign_cases.h"
#include "algebra/parts/complex_sample.h"
#include "algebra/rough/rough_screen.h"
#include "algebra/sample/refute.h"
#include "algebra/words/operator_question.h"
#include "algebra/words/sized_question.h"

namespace rigor {
namespace {

[[nodiscard]] Decision undecided(std::string reason) {
  Decision decision;
  decision.reason = std::move(reason);
  return decision;
}

constexpr std::uint32_t cheap_terms = 3000;

/// Why an equation is not even tried, if so.
[[nodiscard]] std::optional<std::string> too_large(const Scope& scope, const Equation& equation) {
  const Reach reached = reach(scope, equation);
  if (reached.too_large) return reached.too_large;
  const std::size_t axes = equation.indices.size() + scope.tree()[equation.left].rank;
  if (axes <= largest_free_indices) return std::nullopt;
  return fmt::format("it has {} free indices, more than the {} that are evaluated", axes,
                     largest_free_indices);
}

/// Is there a quotient in the claim or in what it unfolds to, but by a written number? Then a proof says
/// nothing where a denominator is zero for all values. Under assumptions a logarithm is the same: `\ln x`
/// where x < 0.
[[nodiscard]] bool may_have_no_value(const Scope& scope) {
  const ExprTree& tree = scope.tree();
  std::vector<ExprId> roots{scope.question().claim.left, scope.question().claim.right};
  for (const Definition& definition : scope.question().definitions) roots.push_back(definition.body);
  return std::ranges::any_of(nodes_below(tree, roots), [&](ExprId id) {
    if (tree[id].op == Op::power) return tree[id].exponent < 0;
    if (tree[id].op == Op::function)
      return tree[id].function == Function::log && !scope.question().assumptions.empty();
    if (tree[id].op != Op::divide) return false;
    const ExprId divisor = tree.children(id)[1];
    return tree[divisor].op != Op::number || tree.is_zero_literal(divisor);
  });
}

/// Does the statement, or an assumption, ask for more of its numbers than that they can be added and
/// multiplied: for an order, or a root? A name that is defined by its square is such a number only if the
/// square is not negative, so it is not taken for one.
[[nodiscard]] bool speaks_of_real_numbers(const Scope& scope) {
  const auto speaks = [&](const Equation& equation) {
    return equation.relation == Relation::less || equation.relation == Relation::less_or_equal ||
           reach(scope, equation).roots;
  };
  return speaks(scope.question().claim) || std::ranges::any_of(scope.question().assumptions, speaks);
}

/// How the names of a question are taken while their definitions are not needed.
[[nodiscard]] Scope::Definitions while_opaque(const Question& question) {
  const bool squares = std::ranges::any_of(question.definitions, &Definition::by_square);
  if (!squares) return Scope::Definitions::opaque;
  return speaks_of_real_numbers(Scope(question, Scope::Definitions::opaque))
             ? Scope::Definitions::opaque_but_squares
             : Scope::Definitions::opaque;
}

/// A proof, and under what it was found.
struct Found {
  Trial trial;
  Attempt under;
  bool unfolded = false;  // with definitions unfolded
  Work cost;
};

/// One decision: what is known so far, and the steps.
class Decider {
 public:
  Decider(const Question& question, const Limits& limits)
      : limits_(limits),
        unfolded_(question, Scope::Definitions::unfolded),
        opaque_(question, while_opaque(question)),
        refuter_(unfolded_, limits) {}

  [[nodiscard]] Decision decide();

 private:
  [[nodiscard]] std::optional<std::string> why_not_tried() const;
  template <class Search>
  [[nodiscard]] std::optional<Refuter::Counterexample> look(const Search& search);
  [[nodiscard]] bool fails_roughly(std::span<const std::size_t> assumptions);
  [[nodiscard]] bool has_values_roughly(std::span<const std::size_t> assumptions);
  [[nodiscard]] bool needs_definitions();
  [[nodiscard]] std::vector<std::vector<std::size_t>> choices_of_assumptions();
  [[nodiscard]] std::optional<Found> try_all_proofs(Effort effort);
  [[nodiscard]] std::optional<Found> try_proof(const Attempt& attempt, bool unfolded);
  [[nodiscard]] std::optional<Found> try_cases_of_signs();
  [[nodiscard]] std::optional<Found> try_cheap_proof(const Attempt& attempt, bool& finished);
  void drop_needless_assumptions(Found& found);
  [[nodiscard]] Decision proved(Found found) const;
  [[nodiscard]] Decision proved_by_value();
  [[nodiscard]] Decision refuted(const Refuter::Counterexample& counterexample);
  [[nodiscard]] std::string why_open() const;

  Limits limits_;
  Scope unfolded_;
  Scope opaque_;
  Refuter refuter_;
  Work work_;
  std::optional<RoughScreen> rough_;  // under the assumptions that bear on the claim
  std::optional<bool> needs_definitions_;
  std::string gave_up_;         // the reason why the last proof was broken off
  bool no_real_value_ = false;  // a proof met a root of what is negative
  Trial last_trial_;            // the last one that was finished and does not hold
};

std::optional<std::string> Decider::why_not_tried() const {
  const Question& question = unfolded_.question();
  if (auto reason = too_large(unfolded_, question.claim)) return reason;
  for (const std::size_t position : refuter_.assumptions()) {
    if (auto reason = too_large(unfolded_, question.assumptions[position])) return reason;
  }
  return std::nullopt;
}

std::optional<Found> Decider::try_proof(const Attempt& attempt, bool unfolded) {
  const Work before = work_;
  try {
    Trial trial = prove(unfolded ? unfolded_ : opaque_, attempt, limits_, work_);
    const Work cost{work_.terms - before.terms, work_.steps - before.steps};
    if (trial.holds) return Found{std::move(trial), attempt, unfolded, cost};
    last_trial_ = std::move(trial);
  } catch (const NoRealValue& reason) {
    gave_up_ = reason.what();
    no_real_value_ = true;
  } catch (const Undecidable& reason) {
    gave_up_ = reason.what();
  }
  return std::nullopt;
}

/// With definitions opaque, and broken off early: if the definitions are needed, this cannot succeed.
std::optional<Found> Decider::try_cheap_proof(const Attempt& attempt, bool& finished) {
  Limits limits = limits_;
  limits.expanded_terms = std::min(limits.expanded_terms, cheap_terms);
  Work work;
  try {
    Trial trial = prove(opaque_, attempt, limits, work);
    finished = true;
    if (trial.holds) return Found{std::move(trial), attempt, false, work};
    last_trial_ = std::move(trial);
  } catch (const Undecidable&) {
    // tried again with the full limits, if need be
  }
  return std::nullopt;
}

/// Is the claim, its definitions opaque, refuted by a sample? Then it has no proof with them opaque.
bool Decider::needs_definitions() {
  if (!needs_definitions_) {
    Refuter refuter(opaque_, limits_);
    needs_definitions_ = look([&] { return refuter.quick_look(); }).has_value();
  }
  return *needs_definitions_;
}

/// Does the claim clearly fail where these of its assumptions hold? Then a proof from them is not worth
/// trying.
bool Decider::fails_roughly(std::span<const std::size_t> assumptions) {
  if (!rough_) rough_.emplace(unfolded_, refuter_.assumptions(), limits_.budget);
  return rough_->fails_under(assumptions);
}

/// `e^{-\beta E_s}`: exact samples of exponentials and logarithms are few.
bool Decider::has_values_roughly(std::span<const std::size_t> assumptions) {
  if (!rough_) rough_.emplace(unfolded_, refuter_.assumptions(), limits_.budget);
  return rough_->has_values_under(assumptions);
}

/// Which assumptions are tried together, the fewest first.
std::vector<std::vector<std::size_t>> Decider::choices_of_assumptions() {
  std::vector<std::vector<std::size_t>> choices;
  const std::vector<std::size_t>& all = refuter_.assumptions();
  if (all.empty() || !refuter_.fails_without_assumptions()) choices.emplace_back();
  if (all.empty()) return choices;
  std::vector<std::size_t> core = core_assumptions(unfolded_, all);
  if (!core.empty() && core.size() < all.size()) choices.push_back(std::move(core));
  choices.push_back(all);
  return choices;
}

std::optional<Found> Decider::try_all_proofs(Effort effort) {
  const bool has_definitions = !refuter_.reach().unfolded.empty();
  for (const std::vector<std::size_t>& assumptions : choices_of_assumptions()) {
    const bool fewer = !assumptions.empty() && assumptions.size() < refuter_.assumptions().size();
    if (fewer && fails_roughly(assumptions)) continue;
    const Attempt attempt{.effort = effort, .assumptions = assumptions};
    const bool opaque = !has_definitions || !needs_definitions();
    bool finished = !opaque;
    if (opaque && has_definitions) {
      if (auto found = try_cheap_proof(attempt, finished)) return found;
    }
    if (has_definitions) {
      if (auto found = try_proof(attempt, true)) return found;
    }
    if (finished) continue;
    if (auto found = try_proof(attempt, false)) return found;
  }
  return std::nullopt;
}

/// A case in which a root has no real value says nothing, if not all of them are such cases.
std::optional<Found> Decider::try_cases_of_signs() {
  Attempt attempt{.effort = Effort::factored, .assumptions = refuter_.assumptions()};
  std::optional<Found> found;
  std::set<std::size_t> used;
  bool vanishes = true;
  bool skipped = false;  // by what is assumed, or by a root
  for (std::vector<KnownSign>& signs : sign_cases(unfolded_, attempt)) {
    attempt.signs = std::move(signs);
    try {
      Trial trial = prove(unfolded_, attempt, limits_, work_);
      if (!trial.holds) return std::nullopt;
      used.insert(trial.used.begin(), trial.used.end());
      vanishes = vanishes && trial.proof.vanishes;
      found =
          Found{std::move(trial), {.effort = attempt.effort, .assumptions = attempt.assumptions}, true, {}};
    } catch (const NoRealValue&) {
      skipped = true;
    } catch (const Contradiction&) {
      skipped = true;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }
  if (!found) return std::nullopt;
  if (skipped) used.insert(attempt.assumptions.begin(), attempt.assumptions.end());
  found->trial.used.assign(used.begin(), used.end());
  found->trial.proof.vanishes = vanishes;
  found->trial.proof.in_force.clear();
  found->trial.proof.equations.clear();
  found->trial.proof.nonzero.clear();
  found->trial.proof.steps = {{.kind = ProofStep::Kind::cases, .assumptions = found->trial.used}};
  return found;
}

/// First all that the proof has not used, then one after the other, for no more work than the proof took.
void Decider::drop_needless_assumptions(Found& found) {
  constexpr std::uint64_t least_steps = 2'000;
  constexpr std::uint32_t least_terms = 2'000;
  Limits limits = limits_;
  limits.steps = std::min(limits.steps, found.cost.steps + least_steps);
  limits.expanded_terms =
      std::min(limits.expanded_terms, static_cast<std::uint32_t>(found.cost.terms) + least_terms);
  Work work;
  const auto keep = [&](std::vector<std::size_t> assumptions) {
    if (fails_roughly(assumptions)) return false;
    const Attempt fewer{.effort = found.under.effort, .assumptions = std::move(assumptions)};
    try {
      Trial trial = prove(found.unfolded ? unfolded_ : opaque_, fewer, limits, work);
      if (!trial.holds) return false;
      found.trial = std::move(trial);
      found.under = fewer;
      return true;
    } catch (const Undecidable&) {
      return false;
    }
  };
  const std::vector<std::size_t>& kept = found.under.assumptions;
  if (kept.size() < 2) return;  // without any it was tried already
  if (found.trial.used.size() < kept.size()) keep(found.trial.used);
  for (std::size_t i = 0; i < kept.size() && kept.size() > 1;) {
    std::vector<std::size_t> fewer = kept;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!keep(std::move(fewer))) ++i;
  }
}

Decision Decider::proved(Found found) const {
  Proof& proof = found.trial.proof;
  proof.unfolded = reach_of_sample(found.unfolded ? unfolded_ : opaque_, found.under.assumptions).unfolded;
  return proved_by(std::move(proof));
}

/// A claim without symbols holds if its numbers are equal.
Decision Decider::proved_by_value() {
  Proof proof{.method = Proof::Method::value, .vanishes = refuter_.left_vanishes()};
  proof.unfolded = refuter_.reach().unfolded;
  return proved_by(std::move(proof));
}

/// What is printed is put into the question again first, as its reader would do it.
Decision Decider::refuted(const Refuter::Counterexample& counterexample) {
  Decision decision;
  decision.outcome = Outcome::refuted;
  decision.route = "exact sample";
  decision.unfolded = refuter_.reach().unfolded;
  decision.assumptions = refuter_.assumptions();
  decision.sample = limits_.simplest_sample && !limits_.only_proofs ? refuter_.simplest(counterexample)
                                                                    : refuter_.to_sample(counterexample);
  const Replay again = replay_closely(unfolded_.question(), *decision.sample);
  const bool confirmed = again.fault == Replay::Fault::none && again.differ &&
                         again.sides.left == decision.sample->left &&
                         again.sides.right == decision.sample->right;
  return confirmed ? decision
                   : undecided("a counterexample was found, but putting it in again did not confirm it");
}

std::string Decider::why_open() const {
  if (!gave_up_.empty()) return gave_up_;
  const std::uint32_t tried = refuter_.points_tried();
  if (refuter_.points_compared() == 0) {
    const bool free = refuter_.assumptions().empty();
    return fmt::format("no proof, and none of {} exact samples {}", tried,
                       free ? "gives both sides a rational value" : "is known to satisfy the assumptions");
  }
  std::string reason = "no proof";
  if (last_trial_.radicals) reason = "no proof, since its roots may depend on each other";
  if (last_trial_.unsolved_assumptions) reason = "no proof, since its assumptions have no unique solution";
  return fmt::format("{}; it holds on all of {} exact samples on which both sides have a rational value",
                     reason, refuter_.points_compared());
}

/// Samples that are too much work are not the end: a proof may be less.
template <class Search>
std::optional<Refuter::Counterexample> Decider::look(const Search& search) {
  try {
    return search();
  } catch (const Undecidable& reason) {
    if (gave_up_.empty()) gave_up_ = reason.what();
    return std::nullopt;
  }
}

Decision Decider::decide() {
  if (auto reason = why_not_tried()) return undecided(*std::move(reason));
  if (limits_.only_proofs && !refuter_.assumptions().empty() && fails_roughly(refuter_.assumptions()))
    return undecided("it fails where its assumptions hold");
  if (const auto differs = look([this] { return refuter_.quick_look(); })) return refuted(*differs);
  if (refuter_.is_constant() && refuter_.points_compared() > 0) return proved_by_value();
  // The reason why a proof failed is told beside a sample only.
  const bool hopeless = !limits_.simplest_sample && !refuter_.assumptions().empty() &&
                        refuter_.points_compared() == 0 && fails_roughly(refuter_.assumptions());
  auto found = hopeless ? std::nullopt : try_all_proofs(Effort::plain);
  if (!found && last_trial_.radicals) found = try_all_proofs(Effort::factored);
  const bool by_cases = !found && last_trial_.radicals && limits_.sign_cases;
  if (by_cases) found = try_cases_of_signs();
  if (found && !found->trial.radicals && may_have_no_value(unfolded_) && refuter_.points_compared() == 0) {
    bool has_value = false;
    static_cast<void>(look([&] {
      has_value = refuter_.finds_a_point();
      return std::optional<Refuter::Counterexample>();
    }));
    if (!has_value && !has_values_roughly(refuter_.assumptions()))
      return undecided("no sample was found at which both sides have a value");
  }
  if (found) {
    if (limits_.fewest_assumptions && !by_cases) drop_needless_assumptions(*found);
    return proved(*std::move(found));
  }
  if (limits_.only_proofs) return undecided("no proof");
  if (const auto differs = look([this] { return refuter_.search(); })) return refuted(*differs);
  Decision open = undecided(why_open());
  open.no_real_value = no_real_value_ && refuter_.points_compared() == 0;
  return open;
}

}  // namespace

namespace {

/// The sample's numbers are put in again, as anybody can.
[[nodiscard]] Decision confirmed(const Question& question, Decision decision) {
  const auto sides = replay(question, *decision.sample);
  if (!sides) return undecided("a counterexample was found, but putting it in again did not confirm it");
  decision.sample->left = sides->left;
  decision.sample->right = sides->right;
  return decision;
}

/// The answer to the question about both parts, with complex values in its sample.
Decision decide_in_parts(const Question& question, const Limits& limits) {
  const RealQuestion real = in_real_parts(question);
  Limits of_parts = limits;
  of_parts.sign_cases = false;
  Decision decision = decide(real.question, of_parts);
  if (!decision.sample) return decision;
  decision.sample = without_part(with_complex_values(*std::move(decision.sample), real), real);
  return confirmed(question, std::move(decision));
}

/// A statement about matrices of any size, by those of two rows. One that fails for these and holds for three
/// may be meant for three, and the other way round: it has to fail for both, if the notes do not say which.
[[nodiscard]] std::optional<Decision> refuted_at_sizes(const Question& question, const Limits& limits) {
  if (limits.only_proofs || question.claim.relation != Relation::equal) return std::nullopt;
  Limits cheap = limits;
  cheap.expanded_terms = 5 * cheap_terms;
  std::optional<Decision> refutation;
  const int stated = stated_rows(question);
  const std::vector<int> sizes = stated == 0 ? std::vector{3, 2} : std::vector{stated};
  for (const int rows : sizes) {
    const auto at = at_size(question, rows);
    if (!at || at->sized.empty()) return std::nullopt;
    cheap.simplest_sample = limits.simplest_sample && rows == sizes.back();
    Decision decision = decide(at->question, cheap);
    if (decision.outcome != Outcome::refuted) return std::nullopt;
    decision.sample = unsized(*std::move(decision.sample), *at);
    refutation = std::move(decision);
  }
  return confirmed(question, *std::move(refutation));
}

/// Of 2×2 matrices it is a statement about four numbers each.
[[nodiscard]] std::optional<Decision> proved_at_stated_size(const Question& question, const Limits& limits) {
  const int rows = stated_rows(question);
  const auto at = rows == 0 ? std::nullopt : at_size(question, rows);
  if (!at || at->sized.empty()) return std::nullopt;
  Decision decision = decide(at->question, limits);
  if (decision.outcome != Outcome::proved) return std::nullopt;
  decision.unfolded.insert(decision.unfolded.end(), at->unfolded.begin(), at->unfolded.end());
  decision.proof.reset();  // it speaks of letters that the question does not have
  return decision;
}

[[nodiscard]] Decision decide_about_operators(const Question& question, const Limits& limits) {
  try {
    return decide_operators(question, limits, [](const Question& numbers, const Limits& most) {
      return rigor::decide(numbers, most);
    });
  } catch (const Undecidable& reason) {
    if (auto proof = proved_at_stated_size(question, limits)) return *std::move(proof);
    if (auto refutation = refuted_at_sizes(question, limits)) return *std::move(refutation);
    return undecided(reason.what());
  }
}

}  // namespace

Decision decide(const Question& question, const Limits& limits) {
  Budget own;
  Limits counted = limits;
  if (counted.budget == nullptr) counted.budget = &own;
  try {
    if (is_about_operators(question)) return decide_about_operators(question, counted);
    if (is_about_complex(question)) return decide_in_parts(question, counted);
    return Decider(question, counted).decide();
  } catch (const Undecidable& reason) {
    return undecided(reason.what());
  }
}

}  // namespace rigor
