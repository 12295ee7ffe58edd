// SPDX-License-Identifier: GPL-3.0-or-later
// What a sum over whole numbers is. Between numbers it is written out. Else each term is F(b + 1) − F(a),
// where F(k + 1) − F(k) is the term, which is checked exactly; a term without such an F keeps an unknown K_f
// in the place of F, which makes sums linear in what is added. K_f(b + 1) is K_f(b) + f(b), so terms can be
// split off and the letter that counts be shifted.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/among.h"
#include "check/question/integral_value.h"
#include "check/question/running_letters.h"
#include "check/question/whole_number.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/antidifference.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

constexpr int most_written_out = 40;
constexpr int farthest_shift = 3;

/// u of e^u, and of a product of such powers.
std::optional<ExprId> exponent_of(ExprTree& tree, ExprId id) {
  const ExprNode node = tree[id];
  const std::vector<ExprId> children(tree.children(id).begin(), tree.children(id).end());
  if (node.op == Op::function && node.function == Function::exp) return children[0];
  if (node.op != Op::multiply) return std::nullopt;
  std::vector<ExprId> exponents;
  for (const ExprId child : children) {
    const auto exponent = exponent_of(tree, child);
    if (!exponent) return std::nullopt;
    exponents.push_back(*exponent);
  }
  return tree.add({.op = Op::add, .span = node.span}, exponents);
}

}  // namespace

ExprId IntegralValues::plus(ExprId id, int number, Span span) {
  if (number == 0) return id;
  const ExprId size = tree_.add_number(span, std::to_string(std::abs(number)));
  if (const auto known = whole_number_of(tree_, id)) {
    const int total = *known + number;
    const ExprId value = tree_.add_number(span, std::to_string(std::abs(total)));
    return total < 0 ? negative(value, span) : value;
  }
  const std::array terms{id, number < 0 ? negative(size, span) : size};
  return tree_.add({.op = Op::add, .span = span}, terms);
}

Running IntegralValues::counting_over(const Integral& sum) const {
  const auto changes = [this, sum](SymbolId each) {
    const Symbol& known = tree_.symbols[each];
    const bool plain = !known.integral && !known.derivation && known.rank == 0 && !known.per_particle &&
                       !names_.symbols.function_values.contains(each) && !sources_.contains(each) &&
                       key_of(names_.symbols, each) != nullptr;
    if (each == sum.variable || !plain) return changes_with(sum.variable, each, true);
    if (known.is_fixed() || is_declared_constant(names_.scope, each)) return false;
    return counts_along(names_, each, sum.variable);
  };
  return {
      .variable = sum.variable, .changes = changes, .antiderivative = [](ExprId) { return std::nullopt; }};
}

ExprId IntegralValues::total(const std::vector<ExprId>& parts, Span span) {
  if (parts.empty()) return tree_.add_number(span, "0");
  return parts.size() == 1 ? parts[0] : tree_.add({.op = Op::add, .span = span}, parts);
}

/// f(first) + f(first + 1) + … of so many terms.
std::optional<ExprId> IntegralValues::written_out(ExprId summand, const Running& running, ExprId first,
                                                  int count, Span span) {
  std::vector<ExprId> terms;
  for (int k = 0; k < count; ++k) {
    const auto term = at(summand, running, plus(first, k, span));
    if (!term) return std::nullopt;
    terms.push_back(*term);
  }
  return total(terms, span);
}

/// By how much a is larger than b, if that is a small whole number.
std::optional<int> IntegralValues::shift_between(ExprId a, ExprId b, Span span) {
  if (same_expression(tree_, a, tree_, b)) return 0;
  const auto first = whole_number_of(tree_, a);
  const auto second = whole_number_of(tree_, b);
  if (first && second)
    return std::abs(*first - *second) <= 2 * farthest_shift ? std::optional(*first - *second) : std::nullopt;
  if (first || second) return std::nullopt;
  for (int shift = -farthest_shift; shift <= farthest_shift; ++shift) {
    if (are_equal(a, plus(b, shift, span))) return shift;
  }
  return std::nullopt;
}

/// K_f before the limit, through the first one that is known of the same f, if that is near.
std::optional<ExprId> IntegralValues::unknown_sum_before(ExprId summand, const Running& running,
                                                         const Limit& limit, Span span) {
  if (!bound_) bound_ = tree_.symbols.add({.name = "\\xi", .first_seen = span});
  const ExprId bound = tree_.add({.op = Op::symbol, .span = span, .symbol = *bound_});
  const auto inside = at(summand, running, bound);
  if (!inside) return std::nullopt;
  const Running over{.variable = *bound_,
                     .changes = [this](SymbolId each) { return sources_.contains(each); },
                     .antiderivative = [](ExprId) { return std::nullopt; }};
  const auto symbol_node = [&](SymbolId symbol) {
    return tree_.add({.op = Op::symbol, .span = span, .symbol = symbol});
  };
  for (std::size_t k = 0; k < unknown_.size(); ++k) {
    const SymbolId symbol = unknown_[k];
    const Integral known = *tree_.symbols[symbol].integral;
    if (!known.sum) continue;
    for (const int shift : {0, 1, -1, 2, -2}) {  // is f(ξ) the known one at ξ + shift?
      const auto shifted = at(known.integrand, over, plus(bound, shift, span));
      if (!shifted || !are_equal(*shifted, *inside)) continue;
      if (!limit.at || !known.upper->at) {
        if (limit.at.has_value() != known.upper->at.has_value()) break;
        return symbol_node(symbol);
      }
      const ExprId end = plus(*limit.at, shift, span);
      const auto beyond = shift_between(end, *known.upper->at, span);
      if (!beyond) break;
      std::vector<ExprId> parts{symbol_node(symbol)};
      const ExprId first = *beyond > 0 ? *known.upper->at : end;
      const auto between = written_out(known.integrand, over, first, std::abs(*beyond), span);
      if (!between) return std::nullopt;
      if (*beyond != 0) parts.push_back(*beyond > 0 ? *between : negative(*between, span));
      return total(parts, span);
    }
  }
  const std::string end = limit.at ? print_latex(tree_, *limit.at) : "\\infty";
  unknown_.push_back(
      tree_.symbols.add({.name = fmt::format("\\sum_{{\\xi<{}}} {}", end, print_latex(tree_, *inside)),
                         .first_seen = span,
                         .integral = Integral{.integrand = *inside,
                                              .variable = *bound_,
                                              .by = {By::letter, *bound_},
                                              .upper = limit,
                                              .sum = true}}));
  return symbol_node(unknown_.back());
}

/// Is F(k + 1) − F(k) what is added, but for what has no F?
bool IntegralValues::is_antidifference(const Integral& sum, const Running& running, ExprId found, ExprId rest,
                                       Span span) {
  const ExprId counter = tree_.add({.op = Op::symbol, .span = span, .symbol = sum.variable});
  const auto next = at(found, running, plus(counter, 1, span));
  if (!next) return false;
  const std::array parts{*next, negative(found, span), rest};
  Equation claim;
  claim.left = tree_.add({.op = Op::add, .span = span}, parts);
  claim.right = sum.integrand;
  return holds(claim);
}

/// `q^2 < 1`: with it a geometric sum has the value that it is given.
void IntegralValues::require(const Equation& condition, IntegralValue& result) {
  result.said.push_back(fmt::format("`{} {} {}`", print_latex(tree_, condition.left),
                                    condition.relation == Relation::less ? "<" : "\\ne",
                                    print_latex(tree_, condition.right)));
  result.conditions.push_back(condition);
}

/// Where r is 1, the closed form has no value.
bool IntegralValues::differs_from_one(ExprId ratio, Span span, IntegralValue& result) {
  Equation different;
  different.left = ratio;
  different.right = tree_.add_number(span, "1");
  different.relation = Relation::unequal;
  if (holds(different)) return true;
  Equation same = different;
  same.relation = Relation::equal;
  if (holds(same)) return false;
  require(different, result);
  return true;
}

/// Does r^k vanish at infinity? That |r| < 1 is a condition, unless it is known or cannot be.
bool IntegralValues::falls(ExprId ratio, Span span, IntegralValue& result) {
  if (has_complex_numbers(tree_, ratio)) return false;
  if (const auto exponent = exponent_of(tree_, ratio)) {  // e^u < 1
    Equation negative;
    negative.left = *exponent;
    negative.right = tree_.add_number(span, "0");
    negative.relation = Relation::less;
    Equation other = negative;
    std::swap(other.left, other.right);
    other.relation = Relation::less_or_equal;
    if (holds(negative)) return true;
    if (holds(other)) return false;
    require(negative, result);
    return true;
  }
  const ExprId one = tree_.add_number(span, "1");
  Equation near;  // as notes write it
  near.left = tree_.add({.op = Op::absolute, .span = span}, std::span(&ratio, 1));
  near.right = one;
  near.relation = Relation::less;
  Equation below = near;
  below.left = tree_.add({.op = Op::power, .span = span, .exponent = 2}, std::span(&ratio, 1));
  Equation above = below;
  std::swap(above.left, above.right);
  above.relation = Relation::less_or_equal;
  if (holds(near) || holds(below)) return true;
  if (holds(above)) return false;
  require(below, result);
  return true;
}

std::optional<IntegralValue> IntegralValues::sum(const Integral& sum, Span span) {
  IntegralValue result;
  knows_values_ = true;
  const auto finish = [&](ExprId value) {
    result.value = value;
    if (!knows_values_) result.open = "a value of a function is not known";
    return result;
  };
  if (!sum.lower->at || sum.upper->infinity < 0) return std::nullopt;
  const Running running = counting_over(sum);
  const auto first = whole_number_of(tree_, *sum.lower->at);
  const auto last = sum.upper->at ? whole_number_of(tree_, *sum.upper->at) : std::nullopt;
  if (first && last && *last - *first < most_written_out) {
    const auto value =
        written_out(sum.integrand, running, *sum.lower->at, std::max(0, *last - *first + 1), span);
    return value ? std::optional(finish(*value)) : std::nullopt;
  }
  const std::vector<SymbolId> inside = symbols_in(tree_, sum.integrand);
  if (std::ranges::none_of(inside, running.changes)) {
    for (const SymbolId each : inside) {
      const bool said = tree_.symbols[each].is_fixed() || is_declared_constant(names_.scope, each) ||
                        is_function_value(names_, tree_, each);
      if (!said) result.taken_constant.push_back(each);
    }
  }
  const auto terms = summand_terms(tree_, sum.integrand, running, span);
  if (!terms) return std::nullopt;
  const bool endless = !sum.upper->at;
  const auto is_between = [&](ExprId limit, const std::optional<int>& whole) {
    return !whole && symbols_in(tree_, limit).empty();  // `\sum_{k=1}^{5/2}`
  };
  if (is_between(*sum.lower->at, first) || (!endless && is_between(*sum.upper->at, last)))
    return std::nullopt;
  if (!endless && !last)
    result.said.push_back(fmt::format("`{}` is a whole number, and not below `{}`",
                                      print_latex(tree_, *sum.upper->at),
                                      print_latex(tree_, *sum.lower->at)));
  const Limit beyond = endless ? *sum.upper : Limit{.at = plus(*sum.upper->at, 1, span)};
  std::vector<ExprId> found;
  std::vector<ExprId> rest;
  std::vector<ExprId> values;
  for (const SummandTerm& term : *terms) {
    const ExprId constant = product_of(tree_, term.constant, span);
    const auto known = antidifference(tree_, term, running, span);
    if (known && !endless && !term.ratios.empty() &&
        !differs_from_one(product_of(tree_, term.ratios, span), span, result))
      return std::nullopt;
    if (known && endless) {
      if (term.ratios.empty() || !falls(product_of(tree_, term.ratios, span), span, result))
        return std::nullopt;
    }
    if (known) {
      const auto lower = at(*known, running, *sum.lower->at);
      const auto upper =
          endless ? std::optional(tree_.add_number(span, "0")) : at(*known, running, *beyond.at);
      if (!lower || !upper) return std::nullopt;
      found.push_back(product_of(tree_, {constant, *known}, span));
      values.push_back(product_of(tree_, {constant, difference(*upper, *lower, span)}, span));
      continue;
    }
    std::vector<ExprId> factors = term.geometric;
    factors.insert(factors.end(), term.others.begin(), term.others.end());
    const ExprId counter = tree_.add({.op = Op::symbol, .span = span, .symbol = sum.variable});
    for (int k = 0; k < term.power; ++k) factors.push_back(counter);
    const ExprId open = product_of(tree_, factors, span);
    if (endless && terms->size() > 1) return std::nullopt;  // each alone need not exist
    const auto lower = unknown_sum_before(open, running, *sum.lower, span);
    const auto upper = unknown_sum_before(open, running, beyond, span);
    if (!lower || !upper) return std::nullopt;
    rest.push_back(product_of(tree_, {constant, open}, span));
    values.push_back(product_of(tree_, {constant, difference(*upper, *lower, span)}, span));
    result.open = "it is not known in closed form";
  }
  if (!is_antidifference(sum, running, total(found, span), total(rest, span), span)) return std::nullopt;
  return finish(total(values, span));
}

}  // namespace rigor
