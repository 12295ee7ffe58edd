// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/suspicion.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "check/average/average_value.h"
#include "check/law/bearing.h"
#include "check/law/from_set.h"
#include "check/law/restated.h"
#include "check/law/solves.h"
#include "check/law/states.h"
#include "check/meaning/identity_reading.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/repair/missing_condition.h"
#include "check/repair/trivial_statement.h"
#include "elaborate/name/family.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// Of the work that a step may take. Words that may restrict a row are rare, and take more to be overruled.
constexpr std::uint64_t most_work = 250'000;
constexpr std::uint64_t most_work_despite_words = 4'000'000;
constexpr std::uint64_t most_work_of_offers = 250'000;
constexpr std::uint64_t most_work_of_states = 2'000'000;  // of differentials, and where letters are held

/// The letter is another one than was written, so that another quantity may be meant.
bool changes_a_letter(Slip slip) {
  return slip == Slip::letter || slip == Slip::prime || slip == Slip::rate || slip == Slip::index;
}

bool changes_the_terms(Slip slip) { return slip == Slip::term_missing || slip == Slip::term_extra; }

class Suspecting {
 public:
  Suspecting(const ExprTree& tree, const Names& names, const OpenRow& row, DecisionCache& cache)
      : tree_(tree), names_(names), row_(row), cache_(cache), wrong_(row.wrong) {
    wrong_.proved_with = &names_;
  }

  std::optional<Suspicion> run() {
    if (may_be_near_an_identity() || holds_letters(tree_, names_.scope, row_.claim.equation)) {
      if (auto identity = nearest({}, {})) return identity;
    }
    const Laws bearing = laws_that_bear(tree_, names_.scope, row_.claim.equation, row_.available);
    if (auto solution = nearest_solution()) return solution;
    std::vector<Laws> sets = sets_of(tree_, bearing);
    sets.erase(sets.begin());  // of no laws
    if (holds_letters(tree_, names_.scope, row_.claim.equation)) sets = sets_of_states(bearing);
    // What follows from some laws holds wherever all of them do, so the samples meet as many as can be met.
    while (!sets.empty() && !cache_.budget().exhausted()) {
      const Laws largest = sets.back();
      if (auto found = nearest(largest, sets)) return found;
      if (can_be_met(largest)) return std::nullopt;
      sets.pop_back();
    }
    return std::nullopt;
  }

  /// Whatever the slip, and whatever else may be meant.
  std::vector<TrueNeighbour> all(const NeighbourProof& follows) {
    const NeighbourProof proof = [&](ExprTree& tree, const Names& names, const Claim& claim,
                                     Slip slip) -> std::optional<std::vector<std::string>> {
      if (repeats(tree, claim.equation) || calls_zero(tree, claim.equation, slip)) return std::nullopt;
      return follows(tree, names, claim, slip);
    };
    auto solutions = solutions_near(row_.available, [](Slip) { return true; });
    if (!solutions.empty()) return solutions;
    const Laws bearing = laws_that_bear(tree_, names_.scope, row_.claim.equation, row_.available);
    std::vector<Laws> sets = holds_letters(tree_, names_.scope, row_.claim.equation)
                                 ? sets_of_states(bearing)
                                 : sets_of(tree_, bearing);
    if (sets.empty() || !sets.front().empty()) sets.insert(sets.begin(), Laws{});
    std::vector<TrueNeighbour> found;
    while (found.empty() && !sets.empty() && !cache_.budget().exhausted()) {
      ExprTree grown = tree_;
      const Names met = with_laws_and_constants({grown, names_, row_.claim, &cache_}, sets.back());
      found = true_neighbours(grown, met, wrong_, proof, &cache_, {}, NotCompared::few);
      if (can_be_met(sets.back())) break;
      sets.pop_back();
    }
    return found;
  }

 private:
  bool is_limited() const { return row_.restricted || row_.of_a_case; }

  /// Says nothing, or says the row in another order.
  bool repeats(ExprTree& tree, const Equation& candidate) const {
    const Equation& own = row_.claim.equation;
    return is_trivial_up_to_order(tree, candidate.left, candidate.right) ||
           (!row_.unread && is_trivial_up_to_order(tree, candidate.left, own.left) &&
            is_trivial_up_to_order(tree, candidate.right, own.right));
  }

  /// `x - 1 = 0`: that `x - x` is 0 says nothing, and a side that becomes 0 was meant to be something.
  bool calls_zero(const ExprTree& tree, const Equation& candidate, Slip slip) const {
    if (row_.unread) return false;
    const Equation& own = row_.claim.equation;
    const auto is_zero = [&](ExprId now) { return tree.is_zero_literal(now); };
    const bool becomes_zero = (is_zero(candidate.left) && !tree_.is_zero_literal(own.left)) ||
                              (is_zero(candidate.right) && !tree_.is_zero_literal(own.right));
    return becomes_zero ||
           (slip == Slip::term_missing && (is_zero(candidate.left) || is_zero(candidate.right)));
  }

  /// What was read, without the laws that the samples met.
  Names without_laws(Names names) const {
    replace(names.scope, held(names_.scope));
    names.scope.constants = names_.scope.constants;
    return names;
  }

  /// Of `x = A\cos 2\omega t` beside `\ddot x = -\omega^2x`: each that solves it. `likely`: is it worth
  /// asking?
  template <class Likely>
  std::vector<TrueNeighbour> solutions_near(const Laws& laws, const Likely& likely) {
    const Laws bearing = laws_that_bear(tree_, names_.scope, row_.claim.equation, laws);
    ExprTree grown = tree_;
    const auto solved = solved_equation({grown, names_, row_.claim, &cache_}, bearing);
    if (!solved) return {};
    const Asked asked = [&](ExprTree& tree, const Names& names,
                            const Equation& row) -> std::optional<Equation> {
      if (!same_expression(tree, row.left, tree_, row_.claim.equation.left)) return std::nullopt;
      return put_in(tree, names, solved->of, row.right);
    };
    const NeighbourProof proof = [&](ExprTree& tree, const Names& names, const Claim& claim,
                                     Slip slip) -> std::optional<std::vector<std::string>> {
      const Equation& own_row = row_.claim.equation;
      if (!likely(slip) ||
          (!row_.unread && is_trivial_up_to_order(tree, claim.equation.right, own_row.right)))
        return std::nullopt;
      const Names without = without_laws(names);
      auto found = solves({tree, without, claim, &cache_}, bearing, laws);
      return found ? std::optional(std::move(found->uses)) : std::nullopt;
    };
    Claim solution = row_.claim;
    const auto own = put_in(grown, names_, solved->of, solution.equation.right);
    if (!own) return {};
    solution.equation = *own;
    const Names constant = with_constants_of_solution({grown, names_, solution, &cache_}, solved->of.by);
    return true_neighbours(grown, constant, row_.wrong, proof, &cache_, asked);
  }

  std::optional<Suspicion> nearest_solution() {
    auto found = solutions_near(row_.to_be_solved, [](Slip slip) {
      const bool of_another = changes_a_letter(slip) || changes_the_terms(slip) ||
                              slip == Slip::factor_missing || slip == Slip::factor_extra;
      return !of_another;
    });
    if (found.empty()) return std::nullopt;
    return Suspicion{std::move(found.front().repair), std::move(found.front().uses), found.front().slip};
  }

  /// `\langle xy\rangle = \langle x\rangle\langle y\rangle` says something of a distribution, and so does
  /// `\langle x\rangle = \langle -x\rangle`: what holds for all of them is not what was meant.
  bool speaks_of_averages(const Equation& equation) const {
    const auto is_it = [&](SymbolId symbol) { return is_average(tree_, symbol); };
    return std::ranges::any_of(symbols_in(tree_, equation.left), is_it) ||
           std::ranges::any_of(symbols_in(tree_, equation.right), is_it);
  }

  /// A slip exchanges one letter for another: the sides of an identity lead to the same letters. Beside
  /// operators their factors do not count: `\hat p = i\sqrt{m\hbar\omega/2}\,(a - a^\dagger)`.
  bool may_be_near_an_identity() const {
    const Equation& own = row_.claim.equation;
    if (speaks_of_averages(own)) return false;
    const bool operators = has_operators(tree_, own.left) && has_operators(tree_, own.right);
    const auto letters_of = [&](ExprId side) {
      auto letters = base_letters(tree_, names_.scope, Equation{.left = side, .right = side});
      std::erase_if(letters, [&](SymbolId each) {
        const Symbol& symbol = tree_.symbols[each];
        return symbol.integral.has_value() || (operators && !symbol.noncommuting) ||
               (definition_of(names_.scope, each) != nullptr && membership_of(names_, each));
      });
      return letters;
    };
    const std::set<SymbolId> left = letters_of(row_.claim.equation.left);
    const std::set<SymbolId> right = letters_of(row_.claim.equation.right);
    std::vector<SymbolId> apart;
    std::ranges::set_symmetric_difference(left, right, std::back_inserter(apart));
    const std::size_t all = (left.size() + right.size() + apart.size()) / 2;
    return (apart.size() <= 2 && (all > 1 || calculates())) || leads_to_the_same_letters();
  }

  /// `\sigma_z\sigma_x = -i\sigma_y` of matrices that the page gives: each side is known in the end.
  bool leads_to_the_same_letters() const {
    const auto ends_of = [&](ExprId side) -> std::optional<std::set<SymbolId>> {
      const std::vector<SymbolId> written = symbols_in(tree_, side);
      const auto is_defined = [&](SymbolId each) { return definition_of(names_.scope, each) != nullptr; };
      if (std::ranges::none_of(written, is_defined)) return std::nullopt;
      std::vector<SymbolId> ends = symbols_reached(tree_, names_.scope, {side});
      std::erase_if(ends, is_defined);
      return std::set<SymbolId>(ends.begin(), ends.end());
    };
    const auto left = ends_of(row_.claim.equation.left);
    return left && left == ends_of(row_.claim.equation.right);
  }

  /// Functions, derivatives, integrals, vectors: more than a polynomial, whose values at a root are a
  /// condition.
  bool calculates() const {
    const Equation& own = row_.claim.equation;
    return std::ranges::any_of(nodes_below(tree_, {own.left, own.right}), [&](ExprId id) {
      const ExprNode& node = tree_[id];
      if (node.op != Op::symbol) return node.op == Op::function || node.rank > 0;
      const Symbol& symbol = tree_.symbols[node.symbol];
      return node.rank > 0 || symbol.derivation || symbol.integral;
    });
  }

  bool can_be_met(const Laws& laws) const {
    ExprTree tree = tree_;
    Names assuming = names_;
    for (const PageLaw* law : laws)
      assume(assuming.scope, {law->equation, Origin{law->name, {}, std::nullopt}, 0, law->at_instant});
    return sample_of_assumptions(tree, assuming, {}, limits_of_guesses, &cache_).has_value();
  }

  /// The nearest neighbour that holds wherever `met` do, and is proved from one of the sets, the smallest
  /// first.
  std::optional<Suspicion> nearest(const Laws& met, const std::vector<Laws>& sets) {
    const NeighbourProof proof = [&](ExprTree& tree, const Names& names, const Claim& claim, Slip slip) {
      if (row_.of_a_case && !sets.empty() && !excludes_the_other(slip))
        return std::optional<std::vector<std::string>>{};
      auto uses = is_likely(tree, claim, slip) ? proved(tree, names, claim, slip, sets) : std::nullopt;
      const bool doubtful = uses && (is_limited() || changes_a_letter(slip)) && slip != Slip::factor;
      if (doubtful && may_hold_under_a_usual_condition()) uses.reset();
      if (uses && chooses_a_root(slip, *uses)) uses.reset();
      return uses;
    };
    ExprTree grown = tree_;
    const Names assuming = with_laws_and_constants({grown, names_, row_.claim, &cache_}, met);
    if (judge(grown, assuming, row_.claim, limits_of_guesses, &cache_).verdict == Verdict::proved)
      return std::nullopt;  // it may follow as it stands
    std::vector<TrueNeighbour> found = true_neighbours(grown, assuming, wrong_, proof, &cache_);
    const auto likely = std::ranges::find_if(
        found, [](const TrueNeighbour& each) { return !adds_an_unusual_term(each.repair); });
    if (likely == found.end()) return std::nullopt;
    return Suspicion{std::move(likely->repair), std::move(likely->uses), likely->slip};
  }

  /// What the statement rests on; nothing if it is not proved, or says nothing. No sets: an identity.
  std::optional<std::vector<std::string>> proved(ExprTree& tree, const Names& names, const Claim& claim,
                                                 Slip slip, const std::vector<Laws>& sets) {
    if (repeats(tree, claim.equation)) return std::nullopt;
    if (claim.equation.relation != Relation::equal || adds_letters(tree, claim.equation) ||
        repeats_a_term(tree, claim.equation))
      return std::nullopt;
    const Names without = without_laws(names);
    const bool may_repeat = row_.announced && !changes_a_letter(slip);
    if (!may_repeat && is_said_already(tree, without, claim.equation, sets)) return std::nullopt;
    if (!sets.empty() && holds_by_itself(tree, without, claim)) return std::nullopt;
    for (const Laws& set : sets) {
      auto found = prove_from({tree, without, claim, &cache_}, set);
      if (found && !differentiates_a_constant(tree, claim.equation, found->uses))
        return std::move(found->uses);
    }
    if (!sets.empty()) return std::nullopt;
    if (changes_the_terms(slip) && has_idle_letters(tree, claim.equation)) return std::nullopt;
    if (tree.is_zero_literal(claim.equation.left) || tree.is_zero_literal(claim.equation.right))
      return std::nullopt;  // `x - x = 0` near `x - 1 = 0`
    Judgement judgement = judge(tree, without, claim, limits_of_candidates, &cache_);
    if (judgement.verdict == Verdict::proved && judgement.diagnostics.empty())
      return std::move(judgement.uses);
    auto found = prove_from({tree, without, claim, &cache_}, {});
    if (!found || differentiates_a_constant(tree, claim.equation, found->uses)) return std::nullopt;
    return std::move(found->uses);
  }

  /// `a + \nabla\cdot\mathbf j = a + \nabla\cdot(\mathbf j + \nabla\times\mathbf m)`: one side speaks of m
  /// alone, which was put in for something.
  bool has_idle_letters(const ExprTree& tree, const Equation& equation) const {
    const auto letters_of = [&](ExprId side) {
      return base_letters(tree, names_.scope, {.left = side, .right = side});
    };
    return letters_of(equation.left) != letters_of(equation.right);
  }

  /// Where laws are needed, what holds without them says nothing.
  bool holds_by_itself(ExprTree& tree, const Names& names, const Claim& claim) {
    return judge(tree, names, claim, limits_of_candidates, &cache_).verdict == Verdict::proved;
  }

  /// `\cosh^2x + \cosh^2x = 2\cosh^2x`: nobody writes one term twice.
  static bool repeats_a_term(const ExprTree& tree, const Equation& equation) {
    return std::ranges::any_of(std::array{equation.left, equation.right}, [&](ExprId side) {
      std::set<std::string> terms;
      return std::ranges::any_of(signed_terms(tree, side), [&](const SignedTerm& term) {
        return !terms.insert((term.negative ? "-" : "") + dump(tree, term.id)).second;
      });
    });
  }

  /// Both sides of the row are the same but for a number, and no condition changes that.
  bool scales_a_side(const ExprTree& tree, const Equation& candidate) const {
    const Equation& own = row_.claim.equation;
    const bool left_stays = same_expression(tree, candidate.left, tree_, own.left);
    if (!left_stays && !same_expression(tree, candidate.right, tree_, own.right)) return false;
    return tree_[left_stays ? own.right : own.left].op != Op::add;
  }

  /// Letters that stand nowhere above and are no longer there were meant: a new quantity is no slip.
  bool adds_letters(const ExprTree& tree, const Equation& candidate) const {
    const std::set<SymbolId> own = written_letters(tree, row_.claim.equation);
    const std::set<SymbolId> now = written_letters(tree, candidate);
    return std::ranges::any_of(own, [&](SymbolId letter) {
      return !now.contains(letter) && !seen_in_equation(names_.scope, letter) &&
             definition_of(names_.scope, letter) == nullptr;
    });
  }

  bool is_said_already(ExprTree& tree, const Names& names, const Equation& equation,
                       const std::vector<Laws>& sets) {
    std::optional<Sample> fails;
    bool holds = false;  // or it cannot be compared
    const auto said = [&](const Equation& known) {
      if (!fails && !holds) fails = where_it_fails(tree, equation, &cache_);
      holds = !fails;
      return fails && restates(tree, equation, *fails, known, &cache_);
    };
    const Laws laws = sets.empty() ? Laws{} : sets.back();
    if (std::ranges::any_of(laws, [&](const PageLaw* law) { return said(law->equation); })) return true;
    const std::set<SymbolId> letters = written_letters(tree, equation);
    return std::ranges::any_of(names.scope.definitions, [&](const NamedDefinition& named) {
      return letters.contains(named.definition.symbol) && said(as_equation(tree, named.definition));
    });
  }

  /// Then the prose may say that `R` is a rotation, and all letters are right.
  bool may_hold_under_a_usual_condition() {
    if (!usual_)
      usual_ = !missing_conditions(tree_, names_, row_.wrong, &cache_, true).empty() ||
               cache_.budget().exhausted();
    return *usual_;
  }

  static std::size_t symbols_of(const ExprTree& tree, const Equation& equation) {
    std::set<SymbolId> symbols;
    for (const ExprId side : {equation.left, equation.right}) {
      for (const SymbolId symbol : symbols_in(tree, side)) symbols.insert(symbol);
    }
    return symbols.size();
  }

  bool is_likely(const ExprTree& tree, const Claim& claim, Slip slip) {
    const Equation& own = row_.claim.equation;
    const auto becomes = [&](ExprId now, ExprId before) {
      return tree.is_zero_literal(now) && !tree_.is_zero_literal(before);
    };
    const bool becomes_zero =
        becomes(claim.equation.left, own.left) || becomes(claim.equation.right, own.right);
    if (becomes_zero) return false;
    if (slip == Slip::factor_missing || slip == Slip::factor_extra) return false;  // another quantity
    const bool changes_what_is_said = changes_a_letter(slip) || changes_the_terms(slip) ||
                                      slip == Slip::letters_exchanged ||
                                      (slip == Slip::factor && !scales_a_side(tree, claim.equation));
    if (is_limited() && changes_what_is_said) return false;
    if (changes_a_letter(slip) || slip == Slip::letters_exchanged) {
      // `\frac{dy}{dy}\frac{dp}{dx}` for `\frac{dp}{dy}\frac{dy}{dx}`: what becomes a number was meant.
      if (symbols_of(tree, claim.equation) < symbols_of(tree_, own)) return false;
    }
    if (!changes_the_terms(slip)) return true;
    if (written_letters(tree, claim.equation) != written_letters(tree_, own))
      return false;  // of another quantity
    const std::set<SymbolId> letters = written_letters(tree_, own);
    return row_.announced && std::ranges::all_of(letters, [&](SymbolId letter) {
             return seen_in_equation(names_.scope, letter) || definition_of(names_.scope, letter) != nullptr;
           });
  }

  const ExprTree& tree_;
  const Names& names_;
  const OpenRow& row_;
  DecisionCache& cache_;
  WrongStep wrong_;            // proved without what is constant on samples: \frac{d}{dt}(uw) is not u\dot w
  std::optional<bool> usual_;  // does a usual condition make the row true?
};

bool is_of_states(const ExprTree& tree, const Names& names, const Equation& equation) {
  return speaks_of_states(tree, equation) || holds_letters(tree, names.scope, equation);
}

}  // namespace

bool excludes_the_other(Slip slip) {
  static constexpr std::array slips{Slip::sign, Slip::factor, Slip::power, Slip::inverted, Slip::function};
  return std::ranges::find(slips, slip) != slips.end();
}

bool chooses_a_root(Slip slip, const std::vector<std::string>& uses) {
  return slip == Slip::sign && std::ranges::any_of(uses, [](const std::string& use) {
           return use.find("is not negative") != std::string::npos;
         });
}

std::optional<Suspicion> suspicion(const ExprTree& tree, const Names& names, const OpenRow& row,
                                   DecisionCache& cache) {
  if (row.claim.nearly || row.claim.equation.relation != Relation::equal) return std::nullopt;
  if (cache.budget().exhausted()) return std::nullopt;
  const ShareOfWork share(cache, is_of_states(tree, names, row.claim.equation) ? most_work_of_states
                                 : row.restricted                              ? most_work_despite_words
                                                                               : most_work);
  return Suspecting(tree, names, row, cache).run();
}

std::vector<TrueNeighbour> statements_near(const ExprTree& tree, const Names& names, const OpenRow& row,
                                           const NeighbourProof& follows, DecisionCache& cache) {
  if (cache.budget().exhausted()) return {};
  const bool states = is_of_states(tree, names, row.claim.equation);
  const ShareOfWork share(cache, states ? most_work_of_states : most_work_of_offers);
  return Suspecting(tree, names, row, cache).all(follows);
}

}  // namespace rigor
