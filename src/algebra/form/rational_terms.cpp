// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/form/rational_terms.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "algebra/engine/exact_number.h"
#include "algebra/engine/term_estimate.h"
#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

constexpr std::uint32_t largest_weight = 4000;
constexpr int largest_power = 16;
constexpr double most_terms_of_divisor = 4'000;  // multiplied out, before equal ones are gathered

GiNaC::ex normal_form(const GiNaC::ex& value) {
  if (most_terms_over_one_denominator(value) > most_terms_of_divisor)
    throw Undecidable("a divisor has too many terms");
  return value.normal();
}

}  // namespace

GiNaC::ex RationalAtoms::value_of(ExprId id) {
  const ExprNode node = tree_[id];
  if (node.weight > largest_weight) throw Undecidable("the expression is too large");
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  switch (node.op) {
    case Op::number:
      return GiNaC::numeric(from_digits(tree_.digits(id)));
    case Op::add: {
      GiNaC::ex sum = 0;
      for (const ExprId child : children) sum += value_of(child);
      return sum;
    }
    case Op::negate:
      return -value_of(children[0]);
    case Op::multiply:
      return product_of(id);
    case Op::divide: {
      const GiNaC::ex divisor = normal_form(value_of(children[1]));
      if (divisor.is_zero()) throw Undecidable("it divides by zero");
      return value_of(children[0]) / divisor;
    }
    case Op::power: {
      const ExprNode base = tree_[children[0]];
      if (std::abs(node.exponent) > largest_power) throw Undecidable("a power is too large");
      const bool even = node.exponent % 2 == 0;
      if (base.op == Op::root && even)
        return GiNaC::pow(value_of(tree_.children(children[0])[0]), node.exponent / 2);
      if (base.op == Op::absolute && even && !has_complex_numbers(tree_, children[0]))
        return GiNaC::pow(value_of(tree_.children(children[0])[0]), node.exponent);
      const GiNaC::ex value = value_of(children[0]);
      if (node.exponent < 0 && normal_form(value).is_zero()) throw Undecidable("it divides by zero");
      return GiNaC::pow(value, node.exponent);
    }
    case Op::dot: {
      const bool vectors = tree_[children[0]].rank == 1 && tree_[children[1]].rank == 1;
      if (!vectors) return atom(id);
      const std::string first = dump(tree_, children[0]);
      const std::string second = dump(tree_, children[1]);
      if (first == second && !has_complex_numbers(tree_, children[0])) return length_squared(children[0]);
      return second < first ? atom(make(Op::dot, {children[1], children[0]})) : atom(id);
    }
    default:
      return atom(id);
  }
}

/// At most one factor has a rank; otherwise the order of the factors matters.
GiNaC::ex RationalAtoms::product_of(ExprId id) {
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  const auto ranked = std::ranges::count_if(children, [&](ExprId child) { return tree_[child].rank > 0; });
  if (ranked > 1) return atom(id);
  GiNaC::ex product = 1;
  for (const ExprId child : children) product *= value_of(child);
  return product;
}

GiNaC::ex RationalAtoms::length_squared(ExprId vector) {
  return GiNaC::pow(atom(make(Op::length, {vector})), 2);
}

GiNaC::ex RationalAtoms::atom(ExprId id) {
  std::string text = dump(tree_, id);
  const auto known = by_text_.find(text);
  if (known != by_text_.end()) return atoms_[known->second].symbol;
  if (atoms_.size() == 60) throw Undecidable("the expression has too many parts");
  by_text_.emplace(std::move(text), atoms_.size());
  atoms_.push_back({GiNaC::symbol(), id});
  return atoms_.back().symbol;
}

std::optional<std::size_t> RationalAtoms::position_of(ExprId id) {
  if (tree_[id].op == Op::dot && dump(tree_, tree_.children(id)[1]) < dump(tree_, tree_.children(id)[0]))
    id = make(Op::dot, {tree_.children(id)[1], tree_.children(id)[0]});
  const auto known = by_text_.find(dump(tree_, id));
  return known == by_text_.end() ? std::nullopt : std::optional(known->second);
}

std::vector<RationalTerm> RationalAtoms::terms_of_polynomial(const GiNaC::ex& expanded) const {
  std::vector<RationalTerm> terms;
  if (expanded.is_zero()) return terms;
  for (const GiNaC::ex& each : terms_of(expanded)) {
    RationalTerm term{.exponents = std::vector<int>(atoms_.size(), 0), .coefficient = coefficient_of(each)};
    for (std::size_t k = 0; k < atoms_.size(); ++k) term.exponents[k] = each.degree(atoms_[k].symbol);
    terms.push_back(std::move(term));
  }
  const std::vector<std::size_t> positions = order();
  std::ranges::sort(terms, [&](const RationalTerm& a, const RationalTerm& b) {
    for (const std::size_t k : positions) {
      if (a.exponents[k] != b.exponents[k]) return a.exponents[k] > b.exponents[k];
    }
    return false;
  });
  return terms;
}

/// As they were met, but components of one symbol side by side, by their axes.
std::vector<std::size_t> RationalAtoms::order() const {
  struct Place {
    std::size_t group;
    std::vector<int> axes;
    std::size_t position;
  };
  std::map<SymbolId, std::size_t> groups;
  std::vector<Place> places;
  for (std::size_t k = 0; k < atoms_.size(); ++k) {
    Place place{k, {}, k};
    const ExprNode& node = tree_[atoms_[k].id];
    if (node.op == Op::symbol && node.slot_count > 0) {
      place.group = groups.emplace(node.symbol, k).first->second;
      for (const Slot& slot : tree_.slots(atoms_[k].id)) place.axes.push_back(slot.axis);
    }
    places.push_back(std::move(place));
  }
  std::ranges::sort(places, [](const Place& a, const Place& b) {
    return std::tie(a.group, a.axes, a.position) < std::tie(b.group, b.axes, b.position);
  });
  std::vector<std::size_t> positions;
  for (const Place& place : places) positions.push_back(place.position);
  return positions;
}

ExprId RationalAtoms::make(Op op, std::vector<ExprId> children, int exponent) {
  int rank = tree_[children[0]].rank;
  if (op == Op::multiply) {
    rank = 0;
    for (const ExprId child : children) rank += tree_[child].rank;
  }
  if (op == Op::length || op == Op::power || op == Op::root) rank = 0;
  if (op == Op::dot) rank = tree_[children[0]].rank + tree_[children[1]].rank - 2;
  return tree_.add({.op = op,
                    .rank = static_cast<std::uint8_t>(rank),
                    .span = tree_[children[0]].span,
                    .exponent = exponent},
                   children);
}

ExprId RationalAtoms::product(std::vector<ExprId> factors) {
  return factors.size() == 1 ? factors[0] : make(Op::multiply, std::move(factors));
}

ExprId RationalAtoms::number(const GiNaC::numeric& value) {
  const auto digits = [&](const GiNaC::numeric& whole) {
    return tree_.add_number({}, to_text(cln::the<cln::cl_RA>(GiNaC::abs(whole).to_cl_N())));
  };
  ExprId result = digits(value.numer());
  if (!value.denom().is_equal(1)) result = make(Op::divide, {result, digits(value.denom())});
  return value.is_negative() ? make(Op::negate, {result}) : result;
}

/// The positive number, the scalars, then what has a rank.
ExprId RationalAtoms::monomial(const RationalTerm& term) {
  std::vector<ExprId> factors;
  std::vector<ExprId> ranked;
  const GiNaC::numeric size = GiNaC::abs(term.coefficient);
  for (const std::size_t k : order()) {
    if (k >= term.exponents.size() || term.exponents[k] == 0) continue;
    const ExprId id = atoms_[k].id;
    if (tree_[id].rank > 0) {
      ranked.push_back(id);
    } else {
      factors.push_back(term.exponents[k] == 1 ? id : make(Op::power, {id}, term.exponents[k]));
    }
  }
  factors.insert(factors.end(), ranked.begin(), ranked.end());
  if (factors.empty() || !size.is_equal(1)) factors.insert(factors.begin(), number(size));
  const ExprId result = product(std::move(factors));
  return term.coefficient.is_negative() ? make(Op::negate, {result}) : result;
}

ExprId RationalAtoms::expression_of(const std::vector<RationalTerm>& terms) {
  if (terms.empty()) return tree_.add_number({}, "0");
  std::vector<ExprId> addends;
  for (const RationalTerm& term : terms) addends.push_back(monomial(term));
  const auto positive =
      std::ranges::find_if(terms, [](const RationalTerm& term) { return term.coefficient.is_positive(); });
  if (positive != terms.end()) {  // b - a, not -a + b
    const auto first = addends.begin() + (positive - terms.begin());
    std::rotate(addends.begin(), first, first + 1);
  }
  return addends.size() == 1 ? addends[0] : make(Op::add, addends);
}

}  // namespace rigor
