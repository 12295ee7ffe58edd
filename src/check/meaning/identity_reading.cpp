// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/identity_reading.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "algebra/words/operator_question.h"
#include "check/question/decision_cache.h"
#include "expr/tree/same_expression.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

using Degrees = std::map<SymbolId, int>;

Degrees without_zeros(Degrees degrees) {
  std::erase_if(degrees, [](const auto& entry) { return entry.second == 0; });
  return degrees;
}

void add_to(Degrees& into, const Degrees& from, int factor) {
  for (const auto& [symbol, degree] : from) into[symbol] += factor * degree;
}

/// The degree of an expression in each symbol, if every term has the same. Definitions count as symbols of
/// their own.
std::optional<Degrees> degrees_of(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  Degrees total;
  if (node.op == Op::symbol) total[node.symbol] = 1;
  bool first = true;
  for (const ExprId child : tree.children(id)) {
    const auto degrees = degrees_of(tree, child);
    if (!degrees) return std::nullopt;
    const bool alternatives = node.op == Op::add || node.op == Op::tuple || node.op == Op::table;
    if (alternatives && !first && *degrees != total) return std::nullopt;
    if (alternatives && first) total = *degrees;
    if (!alternatives)
      add_to(total, *degrees,
             node.op == Op::power ? node.exponent : (node.op == Op::divide && !first ? -1 : 1));
    first = false;
  }
  if (node.op == Op::root) {
    for (auto& [symbol, degree] : total) {
      if (degree % 2 != 0) return std::nullopt;
      degree /= 2;
    }
  }
  return without_zeros(total);
}

/// The terms of a sum, through signs and index sums.
std::size_t term_count(const ExprTree& tree, ExprId id) {
  while (tree[id].op == Op::negate || tree[id].op == Op::component || tree[id].op == Op::index_sum)
    id = tree.children(id)[0];
  return tree[id].op == Op::add ? tree.children(id).size() : 1;
}

std::vector<SymbolId> symbols_not_for_all(const ExprTree& tree, const NameScope& scope,
                                          const std::set<SymbolId>& symbols) {
  std::vector<SymbolId> open;  // numbers and axes are no claim
  std::copy_if(symbols.begin(), symbols.end(), std::back_inserter(open), [&](SymbolId symbol) {
    const SymbolId base = base_of(tree.symbols, symbol);
    const Symbol& known = tree.symbols[base];
    return !is_for_all(scope, base) && !known.is_fixed() && !known.rotation;
  });
  return open;
}

std::set<SymbolId> as_set(const std::vector<SymbolId>& symbols) { return {symbols.begin(), symbols.end()}; }

bool holds_without(const Question& question, const std::vector<SymbolId>& symbols, DecisionCache* cache) {
  Question reduced = question;
  reduced.zeroed = symbols;
  const Decision decision = decide(cache, reduced);
  return decision.outcome == Outcome::proved && !decision.vanishes;
}

/// The terms of a sum without their signs.
std::vector<ExprId> bare_terms(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::add) return {};
  std::vector<ExprId> terms;
  for (ExprId term : tree.children(id)) {
    while (tree[term].op == Op::negate) term = tree.children(term)[0];
    terms.push_back(term);
  }
  return terms;
}

void add_terms(const ExprTree& tree, ExprId id, bool negative, std::vector<SignedTerm>& terms) {
  while (tree[id].op == Op::negate) {
    id = tree.children(id)[0];
    negative = !negative;
  }
  if (tree[id].op != Op::add) return terms.push_back({negative, id});
  for (const ExprId term : tree.children(id)) add_terms(tree, term, negative, terms);
}

}  // namespace

std::vector<SignedTerm> signed_terms(const ExprTree& tree, ExprId side) {
  std::vector<SignedTerm> terms;
  add_terms(tree, side, false, terms);
  return terms;
}

int order_shown(const ExprTree& tree, const NameScope& scope, const Equation& equation) {
  const auto is_small = [&](ExprId id) {
    return tree[id].op == Op::symbol && std::ranges::any_of(scope.small, [&](const SmallQuantity& small) {
             return tree[small.quantity].symbol == tree[id].symbol;
           });
  };
  int highest = 1;
  const auto look = [&](const auto& self, ExprId id) -> void {
    const std::span<const ExprId> children = tree.children(id);
    const Op op = tree[id].op;
    if (op == Op::power && is_small(children[0]))
      highest = std::max(highest, static_cast<int>(tree[id].exponent));
    if (op == Op::negate || op == Op::multiply) {
      for (const ExprId child : children) self(self, child);
    }
    if (op == Op::divide) self(self, children[0]);
  };
  for (const SignedTerm& term : signed_terms(tree, equation.right)) look(look, term.id);
  return highest;
}

namespace {

/// `H + \partial_tF = H`: all terms of one side are on the other. That the rest vanishes is a condition.
bool says_that_terms_vanish(const ExprTree& tree, const Equation& claim) {
  std::vector<SignedTerm> more = signed_terms(tree, claim.left);
  std::vector<SignedTerm> fewer = signed_terms(tree, claim.right);
  if (more.size() < fewer.size()) std::swap(more, fewer);
  return std::ranges::all_of(fewer, [&](const SignedTerm& term) {
    const auto same = std::ranges::find_if(more, [&](const SignedTerm& other) {
      return other.negative == term.negative && same_expression(tree, other.id, tree, term.id);
    });
    if (same == more.end()) return false;
    more.erase(same);
    return true;
  });
}

/// `\sigma_x\sigma_y + \sigma_y\sigma_x = 0`, `F_{ij} + F_{ji} = 0`: one term, said twice, is to vanish; or
/// one symbol is to have a property.
bool is_condition_on_zero(const Question& question, ExprId side, const Degrees& degrees,
                          DecisionCache* cache) {
  if (degrees.size() == 1 && degrees.begin()->second == 1) return true;
  const std::vector<ExprId> terms = bare_terms(*question.tree, side);
  return !terms.empty() && std::ranges::all_of(terms, [&](ExprId term) {
    Question same = question;
    same.claim.left = term;
    same.claim.right = terms.front();
    return decide(cache, same).outcome == Outcome::proved;
  });
}

std::vector<SymbolId> law_against_zero(const Question& question, ExprId side,
                                       const std::vector<SymbolId>& open, DecisionCache* cache) {
  const auto degrees = degrees_of(*question.tree, side);
  const bool identity = term_count(*question.tree, side) > 1 && degrees &&
                        !is_condition_on_zero(question, side, *degrees, cache);
  return identity ? std::vector<SymbolId>{} : open;
}

/// What an order relation among the assumptions bounds is meant for all values within the bounds.
std::vector<SymbolId> without_bounds(const Question& question, std::vector<SymbolId> open) {
  for (const Equation& assumption : question.assumptions) {
    if (assumption.relation == Relation::equal) continue;
    for (const ExprId side : {assumption.left, assumption.right}) {
      for (const SymbolId bounded : primitive_symbols(question, side)) std::erase(open, bounded);
    }
  }
  return open;
}

}  // namespace

namespace {

std::vector<SymbolId> with_integrals_open(const Question& question, std::vector<SymbolId> symbols,
                                          const std::set<SymbolId>& kept);

/// `kept`: what is not unfolded, nor its derivatives.
std::vector<SymbolId> symbols_below(const Question& question, ExprId root, const std::set<SymbolId>& kept) {
  std::vector<SymbolId> reached = symbols_reached(*question.tree, {root}, [&](SymbolId symbol) {
    const Definition* definition = definition_in(question, symbol);
    const bool unfolds = definition != nullptr && !kept.contains(base_of(question.tree->symbols, symbol));
    return unfolds ? std::optional(definition->body) : std::nullopt;
  });
  std::erase_if(reached, [&](SymbolId symbol) { return definition_in(question, symbol) != nullptr; });
  return with_integrals_open(question, std::move(reached), kept);
}

/// An integral whose value is not known is about what is integrated, and about its limits.
std::vector<SymbolId> with_integrals_open(const Question& question, std::vector<SymbolId> symbols,
                                          const std::set<SymbolId>& kept) {
  std::set<SymbolId> all;
  for (const SymbolId symbol : symbols) {
    const std::optional<Integral>& integral = question.tree->symbols[symbol].integral;
    if (!integral) {
      all.insert(symbol);
      continue;
    }
    std::vector<SymbolId> inside = symbols_below(question, integral->integrand, kept);
    std::erase(inside, integral->variable);
    for (const auto& limit : {integral->lower, integral->upper}) {
      if (!limit || !limit->at) continue;
      const std::vector<SymbolId> end = symbols_below(question, *limit->at, kept);
      inside.insert(inside.end(), end.begin(), end.end());
    }
    all.insert(inside.begin(), inside.end());
  }
  return {all.begin(), all.end()};
}

/// What is on one side only.
struct OwnSymbols {
  std::set<SymbolId> left;
  std::set<SymbolId> right;

  [[nodiscard]] std::set<SymbolId> all() const {
    std::set<SymbolId> both = left;
    both.insert(right.begin(), right.end());
    return both;
  }
};

OwnSymbols own_symbols(const std::set<SymbolId>& left, const std::set<SymbolId>& right) {
  OwnSymbols own;
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(),
                      std::inserter(own.left, own.left.end()));
  std::set_difference(right.begin(), right.end(), left.begin(), left.end(),
                      std::inserter(own.right, own.right.end()));
  return own;
}

/// `a^2 + b^2 + c` for own c, `a_1b_1 + a_2b_2`: what holds them can be dropped, once, and the rest stays. In
/// `(x - a)^2 + y^2` and `(p + p')(V - V')` it cannot: they are coordinates, or changes of what is there.
bool are_a_term_of_their_own(const Question& question, ExprId side, const std::set<SymbolId>& own) {
  const ExprTree& tree = *question.tree;
  const auto holds_own = [&](ExprId id) {
    return std::ranges::any_of(symbols_in(tree, id), [&](SymbolId each) { return own.contains(each); });
  };
  if (!holds_own(side)) return true;  // a definition brings them in
  if (std::ranges::any_of(own, [&](SymbolId each) { return tree.symbols[each].derivation.has_value(); }))
    return true;  // a derivative of a product does
  while (tree[side].op == Op::component || tree[side].op == Op::index_sum) side = tree.children(side)[0];
  const std::vector<SignedTerm> terms = signed_terms(tree, side);
  const auto holding =
      std::ranges::count_if(terms, [&](const SignedTerm& term) { return holds_own(term.id); });
  return terms.size() > 1 && holding == 1;
}

}  // namespace

namespace {

/// Of a product or a sum: `(AB)^\dagger`, `\det(A + B)`.
bool turns_a_whole(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  const bool power = node.op == Op::power && (node.exponent < 0 || is_unsized(tree, id));
  const bool turns = power || node.op == Op::conjugate || node.op == Op::transpose || node.op == Op::trace ||
                     node.op == Op::matrix_determinant;
  return turns && tree[tree.children(id)[0]].op != Op::symbol;
}

/// `(AB)^T = AB`: it says of what it turns that this stays.
bool says_that_it_stays(const ExprTree& tree, const Equation& claim) {
  const auto stays = [&](ExprId side, ExprId other) {
    return is_unsized(tree, side) && turns_a_whole(tree, side) &&
           same_expression(tree, tree.children(side)[0], tree, other);
  };
  return stays(claim.left, claim.right) || stays(claim.right, claim.left);
}

/// `[A, B] = 0`, `AB = BA` and `P^2 = P` say something of their letters; `(A + B)^2 = A^2 + 2AB + B^2` is
/// meant for all. An identity of operators has more terms than those of one commutator, or turns a whole and
/// has operators on both sides.
bool is_condition_on_operators(const Question& question) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  const bool both = has_operators(tree, claim.left) && has_operators(tree, claim.right);
  if (says_that_it_stays(tree, claim)) return true;
  const bool turns = both && std::ranges::any_of(nodes_below(tree, {claim.left, claim.right}),
                                                 [&](ExprId id) { return turns_a_whole(tree, id); });
  std::size_t terms = turns ? 3 : 0;
  for (const ExprId side : {claim.left, claim.right})
    terms += tree.is_zero_literal(side) ? 0 : signed_terms(tree, side).size();
  if (turns && (is_unsized(tree, claim.left) || is_unsized(tree, claim.right))) return false;
  return terms <= 2 || differs_in_several_degrees(question);
}

}  // namespace

std::vector<SymbolId> primitive_symbols(const Question& question, ExprId root) {
  return symbols_below(question, root, {});
}

std::vector<SymbolId> law_symbols(const Question& question, const NameScope& scope, bool restates,
                                  DecisionCache* cache) {
  const ExprTree& tree = *question.tree;
  std::set<SymbolId> frames;  // the rotations
  for (const Frame& frame : *scope.frames) frames.insert(frame.rotation);
  const std::set<SymbolId> left = as_set(primitive_symbols(question, question.claim.left));
  const std::set<SymbolId> right = as_set(primitive_symbols(question, question.claim.right));
  std::set<SymbolId> all = left;
  all.insert(right.begin(), right.end());
  const std::vector<SymbolId> open = symbols_not_for_all(tree, scope, all);
  if (open.empty()) return {};
  if (question.claim.relation != Relation::equal) return without_bounds(question, open);
  const bool operators =
      std::ranges::any_of(all, [&](SymbolId symbol) { return tree.symbols[symbol].noncommuting; });
  if (operators && (left.empty() || right.empty() || left == right)) {
    return is_condition_on_operators(question) ? open : std::vector<SymbolId>{};
  }
  if (tree.is_zero_literal(question.claim.right))
    return law_against_zero(question, question.claim.left, open, cache);
  if (tree.is_zero_literal(question.claim.left))
    return law_against_zero(question, question.claim.right, open, cache);

  const bool defines = std::ranges::any_of(question.definitions, [&](const Definition& each) {
    return !frames.contains(base_of(tree.symbols, each.symbol));
  });
  if (!frames.empty() && !defines) {
    const OwnSymbols written = own_symbols(as_set(symbols_below(question, question.claim.left, frames)),
                                           as_set(symbols_below(question, question.claim.right, frames)));
    const std::vector<SymbolId> open_written = symbols_not_for_all(tree, scope, written.all());
    if (!written.left.empty() && !written.right.empty() && !open_written.empty()) return open_written;
  }
  const auto [only_left, only_right] = own_symbols(left, right);
  const std::set<SymbolId> own = OwnSymbols{only_left, only_right}.all();
  const std::vector<SymbolId> open_own = symbols_not_for_all(tree, scope, own);
  if (!open_own.empty()) {
    const bool one_sided = only_left.empty() || only_right.empty();
    const ExprId longer = only_left.empty() ? question.claim.right : question.claim.left;
    const bool term_too_many = one_sided && open_own.size() == own.size() &&
                               !says_that_terms_vanish(tree, question.claim) &&
                               (!frames.empty() || are_a_term_of_their_own(question, longer, own)) &&
                               holds_without(question, open_own, cache);
    return term_too_many ? std::vector<SymbolId>{} : open_own;
  }
  if (all.size() == 1 && !restates && !tree.symbols[*all.begin()].per_particle) {
    const auto left_degrees = degrees_of(tree, question.claim.left);
    const auto right_degrees = degrees_of(tree, question.claim.right);
    const Degrees once{{*all.begin(), 1}};
    if (left_degrees == once && right_degrees == once) return open;
    if (tree.symbols[*all.begin()].rank == 0 && !holds_without(question, open, cache))
      return open;  // an equation to be solved
  }
  return {};
}

bool relates_the_same_letters(const Question& question) {
  const auto letters_of = [&](ExprId side) {
    const std::vector<SymbolId> letters = primitive_symbols(question, side);
    return std::set<SymbolId>(letters.begin(), letters.end());
  };
  return letters_of(question.claim.left) == letters_of(question.claim.right);
}

}  // namespace rigor
