// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/from_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/among.h"
#include "check/law/restated.h"
#include "check/law/witness.h"
#include "check/meaning/identity_reading.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/verdict/law_diagnostic.h"

namespace rigor {
namespace {

using Laws = std::vector<const PageLaw*>;

/// Most rows follow from one or two laws near them, so a set gets less work than a step has.
constexpr std::uint64_t most_work = 600'000;  // on all sets together, of the work that a step may take
constexpr Limits limits_of_sets{
    .expanded_terms = 20'000, .steps = 200'000, .sample_attempts = 24, .simplest_sample = false};

class Following {
 public:
  Following(ExprTree& tree, const Names& names, const Claim& claim, DecisionCache* cache)
      : tree_(tree), names_(names), claim_(claim), cache_(cache) {}

  std::optional<FromLaws> run(const Laws& available) {
    const Laws bearing = laws_that_bear(available);
    if (const PageLaw* said = restated(bearing)) {
      FromLaws found{{}, said};
      found.judgement.verdict = Verdict::law;
      found.judgement.restates = true;
      found.judgement.route = fmt::format("restates {}", said->name);
      found.judgement.uses = {said->name};
      return found;
    }
    for (const Laws& set : sets_of(bearing)) {
      if (auto found = prove_with(set)) return found;
    }
    return std::nullopt;
  }

 private:
  /// The letters that it leads to, definitions unfolded.
  [[nodiscard]] std::set<SymbolId> letters_of(const Equation& equation) const {
    std::set<SymbolId> letters;
    for (const SymbolId symbol : symbols_reached(tree_, names_.scope, {equation.left, equation.right}))
      letters.insert(base_of(tree_.symbols, symbol));
    return letters;
  }

  /// Those that share a letter with the claim, then those that share one with these. The first of each kind
  /// bring in the fewest other letters; of such with equally many the nearest is first.
  [[nodiscard]] Laws laws_that_bear(const Laws& available) const {
    struct Bearing {
      const PageLaw* law;
      std::size_t foreign;
    };
    std::set<SymbolId> reached = letters_of(claim_.equation);
    Laws bearing;
    for (bool grew = true; grew;) {
      std::vector<Bearing> round;
      std::set<SymbolId> more;
      for (auto law = available.rbegin(); law != available.rend(); ++law) {
        if (is_one_of(*law, bearing)) continue;
        const std::set<SymbolId> letters = letters_of((*law)->equation);
        const auto shared =
            std::ranges::count_if(letters, [&](SymbolId each) { return reached.contains(each); });
        if (shared == 0) continue;
        round.push_back({*law, letters.size() - static_cast<std::size_t>(shared)});
        more.insert(letters.begin(), letters.end());
      }
      std::ranges::stable_sort(round, {}, &Bearing::foreign);
      for (const Bearing& each : round) bearing.push_back(each.law);
      reached.merge(more);
      grew = !round.empty();
    }
    return bearing;
  }

  [[nodiscard]] const PageLaw* restated(const Laws& bearing) {
    const auto letters_of_row = [&](const Equation& equation) {
      std::set<SymbolId> letters;
      for (const ExprId side : {equation.left, equation.right}) {
        const std::vector<SymbolId> own = symbols_in(tree_, side);
        letters.insert(own.begin(), own.end());
      }
      return letters;
    };
    const std::set<SymbolId> own = letters_of_row(claim_.equation);
    const auto said = std::ranges::find_if(bearing, [&](const PageLaw* law) {
      return letters_of_row(law->equation) == own && restates(tree_, claim_.equation, law->equation, cache_);
    });
    return said == bearing.end() ? nullptr : *said;
  }

  /// None (it may only lack that something is constant), each of the nearest alone, and more and more
  /// together.
  [[nodiscard]] static std::vector<Laws> sets_of(const Laws& bearing) {
    std::vector<Laws> sets{{}};
    constexpr std::size_t most_alone = 3;
    for (std::size_t k = 0; k < std::min(most_alone, bearing.size()); ++k) sets.push_back({bearing[k]});
    for (const std::size_t count : {2, 3, 5, 8}) {
      const std::size_t taken = std::min(count, bearing.size());
      if (taken > 1 && sets.back().size() < taken)
        sets.emplace_back(bearing.begin(), bearing.begin() + taken);
    }
    return sets;
  }

  [[nodiscard]] static Names with(Names names, const Laws& laws, const std::vector<SymbolId>& constants) {
    for (const PageLaw* law : laws)
      assume(names.scope, {law->equation, Origin{law->name, {}, std::nullopt}, 0, law->at_instant});
    for (const SymbolId constant : constants) declare_constant(names.scope, constant, std::nullopt);
    return names;
  }

  /// Numbers of which nothing says whether they change: nothing on the page differentiates them.
  [[nodiscard]] std::vector<SymbolId> constants_by_evidence(const Names& names) {
    const Prepared prepared = prepare(tree_, names, claim_.equation);
    std::vector<SymbolId> unknown = prepared.unknown_changes;
    const std::vector<SymbolId>& written = claim_.reading->found.unknown_changes;
    unknown.insert(unknown.end(), written.begin(), written.end());
    unknown = bases_of(tree_, unknown);
    std::erase_if(unknown, [&](SymbolId symbol) {
      const NameKey* key = key_of(names.symbols, symbol);
      return tree_.symbols[symbol].rank > 0 || key == nullptr ||
             may_be_changing(*names.symbols.evidence, key->base);
    });
    // Who differentiates a whole term means it to change: g of `\nabla(f + g)`.
    for (const ExprId term : terms_of(prepared)) {
      if (differentiates_only(term, unknown, names)) return {};
    }
    return unknown;
  }

  /// All terms of all sums in it, and its sides, as they are differentiated if everything changes.
  [[nodiscard]] std::vector<ExprId> terms_of(const Prepared& prepared) const {
    std::vector<ExprId> roots{claim_.equation.left, claim_.equation.right};
    for (const Definition& definition : prepared.question.definitions) roots.push_back(definition.body);
    for (const Equation& assumption : prepared.question.assumptions)
      roots.insert(roots.end(), {assumption.left, assumption.right});
    std::vector<ExprId> terms = roots;
    for (const ExprId id : nodes_below(tree_, roots)) {
      if (tree_[id].op != Op::add) continue;
      const std::span<const ExprId> children = tree_.children(id);
      terms.insert(terms.end(), children.begin(), children.end());
    }
    std::erase_if(terms, [&](ExprId id) { return signed_terms(tree_, id).size() > 1; });
    return terms;
  }

  /// Is there a derivative of one of the constants, and nothing else that changes? An initial value, `x_0`,
  /// is one.
  [[nodiscard]] bool differentiates_only(ExprId term, const std::vector<SymbolId>& constants,
                                         const Names& names) const {
    bool differentiates = false;
    for (const SymbolId symbol : symbols_in(tree_, term)) {
      const SymbolId base = base_of(tree_.symbols, symbol);
      if (is_one_of(base, constants)) {
        differentiates = differentiates || (tree_.symbols[symbol].derivation.has_value() &&
                                            !tree_.symbols[base].name.ends_with("_{0}"));
      } else if (change(names, tree_, base, By::time).dependence.kind != Dependence::Kind::constant) {
        return false;
      }
    }
    return differentiates;
  }

  /// What a derivative of a law shows is looked for only if the law itself does not prove it.
  [[nodiscard]] std::optional<std::vector<std::string>> named_in_proof(const Names& names) {
    for (const int slack : {0, 1}) {
      const Prepared prepared = prepare(tree_, names, claim_.equation, slack);
      if (prepared.too_large) return std::nullopt;
      const Decision decision = decide(cache_, prepared.question, limits_of_sets);
      if (decision.outcome == Outcome::proved) {
        std::vector<std::string> used;
        for (const std::size_t which : decision.assumptions) {
          if (const NamedAssumption* named = prepared.assumptions[which]) used.push_back(named->origin.text);
        }
        return used;
      }
      if (!speaks_of_derivatives(prepared)) return std::nullopt;
    }
    return std::nullopt;
  }

  std::optional<FromLaws> prove_with(const Laws& set) {
    // What holds at one moment says nothing of rates, so nothing is concluded of what is constant there.
    const bool momentary = std::ranges::any_of(set, [](const PageLaw* law) { return law->at_instant; });
    const std::vector<SymbolId> constants =
        momentary ? std::vector<SymbolId>{} : constants_by_evidence(with(names_, set, {}));
    if (set.empty() && constants.empty()) return std::nullopt;
    const auto named = named_in_proof(with(names_, set, constants));
    if (!named) return std::nullopt;
    Laws used;
    std::copy_if(set.begin(), set.end(), std::back_inserter(used),
                 [&](const PageLaw* law) { return is_one_of(law->name, *named); });
    if (used.size() < set.size() && used.empty() && constants.empty()) return std::nullopt;
    const std::vector<SymbolId> needed =
        momentary ? std::vector<SymbolId>{} : constants_by_evidence(with(names_, used, {}));
    const Names from = with(names_, used, needed);
    FromLaws found{judge(tree_, from, claim_, limits_of_sets, cache_)};
    if (found.judgement.verdict != Verdict::proved) return std::nullopt;
    if (!is_met_without_zeros(tree_, from, claim_.equation, used, cache_)) return std::nullopt;
    for (const SymbolId constant : needed)
      found.judgement.uses.push_back(fmt::format(
          "convention: `{}` is constant, since nothing differentiates it", tree_.symbols[constant].name));
    return found;
  }

  ExprTree& tree_;
  const Names& names_;
  const Claim& claim_;
  DecisionCache* cache_;
};

}  // namespace

std::optional<FromLaws> follow_from_laws(ExprTree& tree, const Names& names, const Claim& claim,
                                         const std::vector<const PageLaw*>& available, DecisionCache& cache) {
  if (claim.nearly || claim.for_all || claim.recorded != nullptr) return std::nullopt;
  Budget& budget = cache.budget();
  if (budget.exhausted()) return std::nullopt;
  Budget of_step = budget;
  budget = Budget(std::min(of_step.left(), most_work));
  auto found = Following(tree, names, claim, &cache).run(available);
  of_step.count(std::min(budget.used(), of_step.left()));
  budget = of_step;
  return found;
}

}  // namespace rigor
