// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/from_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <ranges>
#include <set>

#include "algebra/rough/rough_screen.h"
#include "base/among.h"
#include "check/law/bearing.h"
#include "check/law/states.h"
#include "check/law/witness.h"
#include "check/meaning/identity_reading.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/question/granted.h"
#include "check/question/question.h"
#include "check/question/question_names.h"
#include "check/verdict/law_diagnostic.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/isolated_letter.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

/// Most rows follow from one or two laws near them, so a set gets less work than a step has.
constexpr Limits limits_of_sets{
    .expanded_terms = 20'000, .steps = 200'000, .sample_attempts = 24, .simplest_sample = false};
/// Whether a set proves the row is asked with hardly a look at samples: most sets do not, and a sample that
/// meets a set is dear.
constexpr Limits limits_of_proofs{
    .expanded_terms = 20'000, .steps = 200'000, .sample_attempts = 1, .only_proofs = true};
/// More letters that must not vanish would only slow the proof down.
constexpr std::size_t most_not_zero = 6;

/// What the terms hold when products of sums are multiplied out, as they are differentiated if everything
/// changes. A letter alone beside a number is no such term: that is the rate of `h - y`, the variable and
/// what does not change with it. Recursion: as deep as the tree.
class MultipliedOut {
 public:
  MultipliedOut(const ExprTree& tree, const std::function<bool(const std::set<SymbolId>&)>& found)
      : tree_(tree), found_(found) {}

  /// Is there such a term? `beside`: what it is multiplied with.
  [[nodiscard]] bool any(ExprId id, const std::set<SymbolId>& beside = {}) const {
    const std::span<const ExprId> children = tree_.children(id);
    const auto any_of_child = [&](ExprId each) { return any(each, beside); };
    switch (tree_[id].op) {
      case Op::negate:
      case Op::tuple:
      case Op::component:
      case Op::index_sum:
      case Op::particle_sum:
        return std::ranges::any_of(children, any_of_child);
      case Op::add: {
        const auto is_number = [&](ExprId each) { return symbols_in(tree_, each).empty(); };
        const bool of_variable = std::ranges::any_of(children, is_number);
        return std::ranges::any_of(children, [&](ExprId each) {
          const bool alone = symbols_in(tree_, each).size() == 1 && !holds_sum(each);
          return !(of_variable && (alone || is_number(each))) && any(each, beside);
        });
      }
      case Op::divide:
        return any(children[0], with(beside, children, 0));
      case Op::multiply:
      case Op::dot:
      case Op::cross:
        for (std::size_t k = 0; k < children.size(); ++k) {
          if (holds_sum(children[k])) return any(children[k], with(beside, children, k));
        }
        break;
      default:
        break;
    }
    std::set<SymbolId> all = beside;
    add(all, id);
    return found_(all);
  }

 private:
  [[nodiscard]] bool holds_sum(ExprId id) const {
    return std::ranges::any_of(nodes_below(tree_, {id}),
                               [&](ExprId each) { return tree_[each].op == Op::add; });
  }
  void add(std::set<SymbolId>& all, ExprId id) const {
    const std::vector<SymbolId> own = symbols_in(tree_, id);
    all.insert(own.begin(), own.end());
  }
  [[nodiscard]] std::set<SymbolId> with(std::set<SymbolId> beside, std::span<const ExprId> factors,
                                        std::size_t without) const {
    for (std::size_t k = 0; k < factors.size(); ++k) {
      if (k != without) add(beside, factors[k]);
    }
    return beside;
  }

  const ExprTree& tree_;
  const std::function<bool(const std::set<SymbolId>&)>& found_;
};

/// Is there a derivative of one of the constants, and nothing else that changes? An initial value, `x_0`, is
/// one.
bool differentiates_only(const RowUnderLaws& row, const std::set<SymbolId>& term,
                         const std::vector<SymbolId>& constants, const Names& names) {
  const SymbolTable& symbols = row.tree.symbols;
  bool differentiates = false;
  for (const SymbolId symbol : term) {
    const SymbolId base = base_of(symbols, symbol);
    if (is_one_of(base, constants)) {
      differentiates =
          differentiates || (symbols[symbol].derivation.has_value() && !symbols[base].name.ends_with("_{0}"));
    } else if (change(names, row.tree, base, By::time).dependence.kind != Dependence::Kind::constant) {
      return false;
    }
  }
  return differentiates;
}

/// The constants, and what is defined by them alone: \omega of `\omega = \sqrt{k/m}`.
std::vector<SymbolId> with_what_they_define(const RowUnderLaws& row, const Prepared& prepared,
                                            const Names& names, std::vector<SymbolId> constants) {
  const std::vector<SymbolId> given = constants;
  const auto rests = [&](SymbolId letter) {
    const SymbolId base = base_of(row.tree.symbols, letter);
    return is_one_of(base, given) || definition_of(names.scope, base) != nullptr ||
           change(names, row.tree, base, By::time).dependence.kind == Dependence::Kind::constant;
  };
  for (const Definition& definition : prepared.question.definitions) {
    if (row.tree.symbols[definition.symbol].derivation) continue;
    if (std::ranges::all_of(symbols_reached(row.tree, names.scope, {definition.body}), rests))
      constants.push_back(definition.symbol);
  }
  return constants;
}

/// The sides of the row, and of what it leads to; not the rates of what does not change.
std::vector<ExprId> sides_of(const RowUnderLaws& row, const Prepared& prepared,
                             const std::vector<SymbolId>& constants) {
  std::vector<ExprId> sides{row.claim.equation.left, row.claim.equation.right};
  for (const Definition& definition : prepared.question.definitions) {
    const bool rests = row.tree.symbols[definition.symbol].derivation.has_value() &&
                       is_one_of(base_of(row.tree.symbols, definition.symbol), constants);
    if (!rests) sides.push_back(definition.body);
  }
  for (const Equation& assumption : prepared.question.assumptions)
    sides.insert(sides.end(), {assumption.left, assumption.right});
  return sides;
}

/// `(\partial U/\partial T)_S` of `U = aVT^4`: what is held is not written, so that any other letter may
/// change with T. The same if something else that changes is left: U of `G = U - TS + pV`.
bool holds_what_it_has_not(const RowUnderLaws& row, const Names& names) {
  const ExprTree& tree = row.tree;
  for (const SymbolId symbol :
       symbols_reached(tree, names.scope, {row.claim.equation.left, row.claim.equation.right})) {
    const auto& derivation = tree.symbols[symbol].derivation;
    if (!derivation) continue;
    for (const Variable& by : derivation->by) {
      if (!by.held) continue;
      const NamedDefinition* definition = definition_of(names.scope, derivation->base);
      if (definition == nullptr) return true;
      bool written = false;
      for (const SymbolId letter : symbols_reached(tree, names.scope, {definition->definition.body})) {
        const NameKey* key = key_of(names.symbols, base_of(tree.symbols, letter));
        const bool own = letter == by.letter || letter == *by.held;
        written = written || letter == *by.held;
        const bool defined = definition_of(names.scope, letter) != nullptr;
        if (!own && !defined && (key == nullptr || may_be_changing(*names.symbols.evidence, key->base)))
          return true;
      }
      if (!written) return true;
    }
  }
  return false;
}

Budget* budget_of(const RowUnderLaws& row) { return row.cache == nullptr ? nullptr : &row.cache->budget(); }

/// Where letters hang together by long definitions, preparing takes more work than deciding: it is counted.
Prepared prepare(const RowUnderLaws& row, const Names& names, int slack = 0) {
  Prepared prepared = rigor::prepare(row.tree, names, row.claim.equation, slack);
  if (Budget* budget = budget_of(row);
      budget != nullptr && !budget->takes(price::derived_node * prepared.made) && !prepared.too_large)
    prepared.too_large = "the derivatives in these laws take too much work";
  return prepared;
}

/// Numbers of which nothing says whether they change with a variable: nothing on the page differentiates
/// them.
std::vector<SymbolId> never_differentiated(const RowUnderLaws& row, const Names& names,
                                           const Prepared& prepared, std::optional<Variable> by = {}) {
  std::vector<SymbolId> unknown = prepared.unknown_changes;
  const std::vector<SymbolId>& written = row.claim.reading->found.unknown_changes;
  unknown.insert(unknown.end(), written.begin(), written.end());
  unknown = bases_of(row.tree, unknown);
  // `l = mr^2\dot\theta` of another section shows that \theta changes.
  std::set<SymbolId> differentiated;
  for (const SymbolId each :
       symbols_reached(row.tree, names.scope, {row.claim.equation.left, row.claim.equation.right})) {
    const auto body = body_of_definition(names.scope, base_of(row.tree.symbols, each));
    if (!body) continue;
    for (const SymbolId inside : symbols_in(row.tree, *body)) {
      if (row.tree.symbols[inside].derivation) differentiated.insert(base_of(row.tree.symbols, inside));
    }
  }
  std::erase_if(unknown, [&](SymbolId symbol) { return differentiated.contains(symbol); });
  std::erase_if(unknown, [&](SymbolId symbol) {
    const NameKey* key = key_of(names.symbols, symbol);
    const auto may_change = by == Variable(By::time) ? may_be_changing_in_time : may_be_changing;
    return row.tree.symbols[symbol].rank > 0 || key == nullptr ||
           may_change(*names.symbols.evidence, key->base);
  });
  return unknown;
}

/// These, where they can be meant to be constant.
std::vector<SymbolId> constants_by_evidence(const RowUnderLaws& row, const Names& names) {
  const Prepared prepared = prepare(row, names);
  const std::vector<SymbolId> unknown = never_differentiated(row, names, prepared);
  if (holds_what_it_has_not(row, names)) return {};
  // Who differentiates a whole term means it to change: g of `\nabla(f + g)`.
  const std::vector<SymbolId> constants = with_what_they_define(row, prepared, names, unknown);
  const std::function only = [&](const std::set<SymbolId>& term) {
    return differentiates_only(row, term, constants, names);
  };
  const MultipliedOut terms(row.tree, only);
  const bool any =
      std::ranges::any_of(sides_of(row, prepared, constants), [&](ExprId side) { return terms.any(side); });
  return any ? std::vector<SymbolId>{} : unknown;
}

/// The letters of the row that may vanish: all of them, but of `E = \rho r/3` only that on the left side. The
/// law `r^2E = \rho r^3/3` says so for every other r.
std::set<SymbolId> letters_that_may_vanish(const RowUnderLaws& row) {
  Equation own = row.claim.equation;
  const ExprNode& left = row.tree[own.left];
  const bool says_what_it_is = own.relation == Relation::equal && left.op == Op::symbol &&
                               left.slot_count == 0 && !row.tree.symbols[left.symbol].derivation;
  if (says_what_it_is) own.right = own.left;
  return base_letters(row.tree, row.names.scope, own);
}

/// t of `a\cos\omega t`: that it is not 0 helps nobody to divide, and leaves no exact sample.
std::set<SymbolId> letters_of_angles_alone(const ExprTree& tree, const Equation& law) {
  std::set<SymbolId> inside;
  std::set<SymbolId> outside;
  const std::function<void(ExprId, std::set<SymbolId>&)> look = [&](ExprId id, std::set<SymbolId>& letters) {
    if (tree[id].op == Op::symbol) letters.insert(base_of(tree.symbols, tree[id].symbol));
    std::set<SymbolId>& below = tree[id].op == Op::function ? inside : letters;
    for (const ExprId child : tree.children(id)) look(child, below);
  };
  look(law.left, outside);
  look(law.right, outside);
  std::erase_if(inside, [&](SymbolId each) { return outside.contains(each); });
  return inside;
}

/// `m`, and `r` where it is the length of `\mathbf r`: what may stand below a line.
std::vector<ExprId> divisors_of(ExprTree& tree, const NameScope& scope, const Equation& law,
                                const std::set<SymbolId>& without) {
  const auto is_free = [&](SymbolId letter, int rank) {
    const Symbol& symbol = tree.symbols[letter];
    return symbol.rank == rank && !symbol.per_particle && !symbol.is_fixed() && !without.contains(letter) &&
           definition_of(scope, letter) == nullptr;
  };
  std::vector<ExprId> divisors;
  for (const ExprId each : nodes_below(tree, {law.left, law.right})) {
    if (tree[each].op != Op::length) continue;
    const ExprNode& vector = tree[tree.children(each)[0]];
    if (vector.op == Op::symbol && vector.slot_count == 0 && is_free(vector.symbol, 1))
      divisors.push_back(each);
  }
  const std::set<SymbolId> of_angles = letters_of_angles_alone(tree, law);
  for (const SymbolId letter : base_letters(tree, scope, law)) {
    if (is_free(letter, 0) && !of_angles.contains(letter))
      divisors.push_back(tree.add({.op = Op::symbol, .span = tree[law.left].span, .symbol = letter}));
  }
  return divisors;
}

/// `x = Ae^{\lambda t}` beside an equation that differentiates x: who tries that means no A = 0.
bool is_ansatz(const ExprTree& tree, const PageLaw& law, const Laws& set) {
  const ExprNode& left = tree[law.equation.left];
  if (left.op != Op::symbol || tree.symbols[left.symbol].derivation) return false;
  return std::ranges::any_of(set, [&](const PageLaw* other) {
    const std::array sides{other->equation.left, other->equation.right};
    return std::ranges::any_of(sides, [&](ExprId side) {
      return std::ranges::any_of(symbols_in(tree, side), [&](SymbolId each) {
        return tree.symbols[each].derivation && base_of(tree.symbols, each) == left.symbol;
      });
    });
  });
}

/// The row may stay open in a letter that vanishes only where it has not that letter itself.
std::vector<ExprId> not_zero(const RowUnderLaws& row, const Laws& set) {
  std::set<SymbolId> own = letters_that_may_vanish(row);
  // `ab = 0` may say that a vanishes, and that b does.
  const auto vanishes = [&](const Equation& equation) {
    return row.tree.is_zero_literal(equation.left) || row.tree.is_zero_literal(equation.right);
  };
  const bool row_vanishes = vanishes(row.claim.equation);
  // `m\ddot x + kx = 0` is divided by m; `ax - bx = 0` may say that x vanishes.
  const auto is_equation_of_motion = [&](const Equation& equation) {
    return std::ranges::any_of(std::array{equation.left, equation.right}, [&](ExprId side) {
      return std::ranges::any_of(symbols_in(row.tree, side), [&](SymbolId each) {
        return row.tree.symbols[each].derivation.has_value();
      });
    });
  };
  const auto is_coefficient = [&](SymbolId letter) {
    const NameKey* key = key_of(row.names.symbols, letter);
    return key != nullptr && !may_be_changing(*row.names.symbols.evidence, key->base);
  };
  for (const PageLaw* law : set) {
    if (vanishes(law->equation)) {
      std::set<SymbolId> letters = base_letters(row.tree, row.names.scope, law->equation);
      if (is_equation_of_motion(law->equation)) std::erase_if(letters, is_coefficient);
      own.merge(std::move(letters));
    }
    const ExprNode& left = row.tree[law->equation.left];
    if (left.op == Op::symbol) own.insert(left.symbol);  // the law says what it is
  }
  std::map<std::string, ExprId> divisors;
  for (const PageLaw* law : set) {
    if ((vanishes(law->equation) && !is_equation_of_motion(law->equation)) ||
        (row_vanishes && !is_ansatz(row.tree, *law, set)))
      continue;
    for (const ExprId divisor : divisors_of(row.tree, row.names.scope, law->equation, own)) {
      if (divisors.size() < most_not_zero) divisors.try_emplace(dump(row.tree, divisor), divisor);
    }
  }
  const auto found = std::views::values(divisors);
  return {found.begin(), found.end()};
}

Names with_constants(Names names, const std::vector<SymbolId>& constants) {
  for (const SymbolId constant : constants) declare_constant(names.scope, constant, std::nullopt);
  return names;
}

std::string says_not_zero(const ExprTree& tree, ExprId divisor) {
  return fmt::format("convention: `{}` is not 0", print_latex(tree, divisor));
}

Names with_not_zero(const RowUnderLaws& row, Names names, const std::vector<ExprId>& divisors) {
  for (const ExprId divisor : divisors) {
    Equation nonzero;
    nonzero.left = divisor;
    nonzero.right = row.tree.add_number(row.claim.relation, "0");
    nonzero.relation = Relation::unequal;
    assume(names.scope, {std::move(nonzero), Origin{says_not_zero(row.tree, divisor), {}, std::nullopt}, 0});
  }
  return names;
}

/// What holds at one moment says nothing of rates, so nothing is concluded of what is constant there.
std::vector<SymbolId> constants_under(const RowUnderLaws& row, const Names& names, const Laws& set) {
  const bool momentary = std::ranges::any_of(set, [](const PageLaw* law) { return law->at_instant; });
  return momentary ? std::vector<SymbolId>{} : constants_by_evidence(row, names);
}

/// The names of the definitions and assumptions that a proof needs; nothing: there is no proof. What a
/// derivative of a law shows is looked for only if the law itself does not prove it.
std::optional<std::vector<std::string>> named_in_proof(const RowUnderLaws& row, const Names& names) {
  for (const int slack : {0, 1}) {
    const Prepared prepared = prepare(row, names, slack);
    if (prepared.too_large) return std::nullopt;
    const Decision decision = decide(row.cache, prepared.question, limits_of_proofs);
    if (decision.outcome == Outcome::proved) {
      std::vector<std::string> used;
      for (const Origin* each : origins_of(prepared, decision.unfolded)) used.push_back(each->text);
      for (const std::size_t which : decision.assumptions) {
        if (const NamedAssumption* named = prepared.assumptions[which]) used.push_back(named->origin.text);
      }
      return used;
    }
    if (!speaks_of_derivatives(prepared)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

Names with_laws(const ExprTree& tree, Names names, const Laws& laws) {
  for (const PageLaw* law : laws)
    take_for_granted(tree, names, law->equation, Origin{law->name, {}, std::nullopt}, law->at_instant);
  return names;
}

Names with_laws_and_constants(const RowUnderLaws& row, const Laws& laws) {
  Names assumed = with_laws(row.tree, row.names, laws);
  const std::vector<SymbolId> constants = constants_under(row, assumed, laws);
  return with_constants(std::move(assumed), constants);
}

Names with_constants_of_solution(const RowUnderLaws& row, Variable by) {
  return with_constants(row.names, never_differentiated(row, row.names, prepare(row, row.names), by));
}

namespace {

/// The laws taken for granted, in one way or another.
using Granting = std::function<Names(const Laws&)>;

std::optional<Judgement> prove_by(const RowUnderLaws& row, const Laws& set, const Granting& granted) {
  if (row.cache != nullptr && row.cache->budget().exhausted()) return std::nullopt;
  const Names assumed = granted(set);
  const std::vector<SymbolId> constants = constants_under(row, assumed, set);
  if (set.empty() && constants.empty()) return std::nullopt;
  const std::vector<ExprId> divisors = not_zero(row, set);
  const Names all = with_not_zero(row, with_constants(assumed, constants), divisors);
  const auto named = named_in_proof(row, all);
  if (!named) return std::nullopt;
  const auto is_named = [&](const std::string& name) { return is_one_of(name, *named); };
  Laws used;
  std::copy_if(set.begin(), set.end(), std::back_inserter(used),
               [&](const PageLaw* law) { return is_named(law->name); });
  if (!set.empty() && used.empty() && constants.empty()) return std::nullopt;
  std::vector<ExprId> divided;
  std::ranges::copy_if(divisors, std::back_inserter(divided),
                       [&](ExprId divisor) { return is_named(says_not_zero(row.tree, divisor)); });
  const Names from_used = with_not_zero(row, granted(used), divided);
  const std::vector<SymbolId> needed = constants_under(row, from_used, used);
  const Names from = with_constants(from_used, needed);
  Judgement judgement = judge(row.tree, from, row.claim, limits_of_sets, row.cache);
  if (judgement.verdict != Verdict::proved) return std::nullopt;
  // That letters are constant contradicts nothing.
  if (!used.empty() && !is_met_without_zeros(row.tree, from, row.claim.equation, used, row.cache))
    return std::nullopt;
  for (const SymbolId constant : needed) judgement.uses.push_back(convention_of_constant(row.tree, constant));
  return judgement;
}

/// With its letters and derivatives as they stand.
std::optional<Judgement> prove_as_it_stands(const RowUnderLaws& row, const Laws& set) {
  return prove_by(row, set, [&](const Laws& laws) { return with_laws(row.tree, row.names, laws); });
}

/// Letters where no assumption reaches them: in an integrand, a logarithm, an exponent or an angle.
struct HiddenLetters {
  std::set<SymbolId> all;
  std::set<SymbolId> in_logarithms;  // whose argument is not 0
};

HiddenLetters hidden_letters(const RowUnderLaws& row) {
  const ExprTree& tree = row.tree;
  HiddenLetters hidden;
  const Equation& own = row.claim.equation;
  for (const ExprId id : nodes_reached(tree, row.names.scope, {own.left, own.right})) {
    const ExprNode& node = tree[id];
    if (node.op == Op::function || node.op == Op::real_power) {
      const std::vector<SymbolId> inside = symbols_in(tree, id);
      hidden.all.insert(inside.begin(), inside.end());
      if (node.op == Op::function && node.function == Function::log)
        hidden.in_logarithms.insert(inside.begin(), inside.end());
    }
    if (node.op != Op::symbol) continue;
    const auto& integral = tree.symbols[node.symbol].integral;
    if (!integral || integral->average || integral->sum) continue;
    for (const SymbolId each : letters_in(tree, integral->integrand)) {
      if (each != integral->variable) hidden.all.insert(each);
    }
  }
  return hidden;
}

/// `pV = nRT` says what p is below an integral. Nothing where none of these letters can be told so.
std::optional<Definition> solved_for_one_of(const RowUnderLaws& row, const Names& names, const PageLaw& law,
                                            const HiddenLetters& hidden) {
  const Equation& own = law.equation;
  const bool plain = own.relation == Relation::equal && own.indices.empty() && own.particles.empty();
  if (!plain || law.at_instant || row.tree.is_zero_literal(own.left) || row.tree.is_zero_literal(own.right))
    return std::nullopt;
  const std::set<SymbolId> may_vanish = base_letters(row.tree, names.scope, row.claim.equation);
  for (const SymbolId letter : hidden.all) {
    const Symbol& symbol = row.tree.symbols[letter];
    const bool free = symbol.rank == 0 && !symbol.per_particle && !symbol.is_fixed() && !symbol.derivation &&
                      !symbol.integral && definition_of(names.scope, letter) == nullptr;
    const auto found = free ? isolated_letter(row.tree, own.left, own.right, letter) : std::nullopt;
    if (!found || is_one_of(letter, symbols_reached(row.tree, names.scope, {found->value}))) continue;
    const bool divides = std::ranges::none_of(found->divided_by, [&](ExprId divisor) {
      return std::ranges::any_of(symbols_in(row.tree, divisor), [&](SymbolId each) {
        return may_vanish.contains(each) && !hidden.in_logarithms.contains(each) &&
               !row.tree.symbols[each].is_fixed();
      });
    });
    if (divides) return Definition{letter, {}, no_particle, found->value};
  }
  return std::nullopt;
}

/// The laws taken for granted, solved for letters that are hidden in functions and integrals; nothing where
/// none can be.
std::optional<Names> with_letters_solved(const RowUnderLaws& row, const Laws& laws,
                                         const HiddenLetters& hidden) {
  Names names = row.names;
  bool any = false;
  for (const PageLaw* law : laws) {
    Origin origin{law->name, {}, std::nullopt};
    const bool says_a_letter = row.tree[law->equation.left].op == Op::symbol;
    const auto solved = says_a_letter ? std::nullopt : solved_for_one_of(row, names, *law, hidden);
    any = any || solved.has_value();
    if (solved) {
      define(names.scope, {*solved, std::move(origin)});
    } else {
      take_for_granted(row.tree, names, law->equation, std::move(origin), law->at_instant);
    }
  }
  return any ? std::optional(std::move(names)) : std::nullopt;
}

std::optional<Judgement> prove_with_letters_solved(const RowUnderLaws& row, const Laws& set) {
  const HiddenLetters hidden = set.empty() ? HiddenLetters{} : hidden_letters(row);
  if (hidden.all.empty() || !with_letters_solved(row, set, hidden)) return std::nullopt;
  return prove_by(row, set, [&](const Laws& laws) {
    auto solved = with_letters_solved(row, laws, hidden);
    return solved ? *std::move(solved) : with_laws(row.tree, row.names, laws);
  });
}

}  // namespace

std::string convention_of_constant(const ExprTree& tree, SymbolId letter) {
  return fmt::format("convention: `{}` is constant, since nothing differentiates it",
                     tree.symbols[letter].name);
}

bool differentiates_a_constant(const ExprTree& tree, const Equation& row,
                               const std::vector<std::string>& uses) {
  return std::ranges::any_of(std::array{row.left, row.right}, [&](ExprId side) {
    return std::ranges::any_of(symbols_in(tree, side), [&](SymbolId each) {
      const SymbolId base = base_of(tree.symbols, each);
      return base != each && is_one_of(convention_of_constant(tree, base), uses);
    });
  });
}

std::optional<Judgement> prove_from(const RowUnderLaws& row, const Laws& set) {
  auto found = prove_as_it_stands(row, set);
  if (!found) found = prove_with_letters_solved(row, set);
  return found ? found : prove_of_states(row, set);
}

bool fails_under(const RowUnderLaws& row, const Laws& set) {
  // On a sample, derivatives that hold other letters are numbers of their own.
  const bool of_states =
      speaks_of_states(row.tree, row.claim.equation) ||
      std::ranges::any_of(set, [&](const PageLaw* law) { return speaks_of_states(row.tree, law->equation); });
  if (of_states) return false;
  if (std::ranges::any_of(set, [](const PageLaw* law) { return law->at_instant; })) return false;
  const auto solved = with_letters_solved(row, set, hidden_letters(row));  // p is nRT/V below an integral
  const Names assumed = solved ? *solved : with_laws(row.tree, row.names, set);
  const Names all =
      with_not_zero(row, with_constants(assumed, constants_by_evidence(row, assumed)), not_zero(row, set));
  const Prepared prepared = prepare(row, all, 1);
  if (prepared.too_large || !prepared.unknown_changes.empty()) return false;
  return fails_at_rough_points(prepared.question, budget_of(row));
}

}  // namespace rigor
