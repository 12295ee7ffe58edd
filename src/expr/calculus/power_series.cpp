// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/power_series.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/among.h"

namespace rigor {

std::optional<PowerSeries> PowerSeriesExpansion::of(ExprId id) {
  if (!depends(id)) return constant(id);
  const Span before = std::exchange(span_, tree_[id].span);
  const Maybe series = [&]() -> Maybe {
    switch (tree_[id].op) {
      case Op::symbol: {  // the symbol itself
        PowerSeries own{.first = 1, .terms = std::vector<Term>(static_cast<std::size_t>(count_))};
        own.terms[0] = number(1);
        return own;
      }
      case Op::add:
        return sum(id);
      case Op::negate:
      case Op::component:
      case Op::index_sum:
        return linear(id);
      case Op::multiply:
      case Op::dot:
      case Op::cross:
        return bilinear(id);
      case Op::tuple:
        return entries(id);
      case Op::divide:
        return quotient(id);
      case Op::power:
        return power(id);
      case Op::real_power:
        return real_power(id);
      case Op::root:
        return root(id);
      case Op::function:
        return function(id);
      default:
        return std::nullopt;
    }
  }();
  span_ = before;
  return series;
}

bool PowerSeriesExpansion::depends(ExprId id) const {
  const std::vector<SymbolId> symbols = symbols_in(tree_, id);
  return is_one_of(symbol_, symbols);
}

PowerSeries PowerSeriesExpansion::constant(ExprId id) const {
  PowerSeries series{.first = 0, .terms = std::vector<Term>(static_cast<std::size_t>(count_))};
  if (!tree_.is_zero_literal(id)) series.terms[0] = id;
  return series;
}

ExprId PowerSeriesExpansion::make(ExprNode node, std::vector<ExprId> children) {
  node.span = span_;
  return tree_.add(node, children);
}

ExprId PowerSeriesExpansion::number(int value) { return tree_.add_number(span_, std::to_string(value)); }

/// `like` says which product it is, and its rank.
std::optional<ExprId> PowerSeriesExpansion::times(Term a, Term b, ExprNode like) {
  if (!a || !b) return std::nullopt;
  const auto is_one = [&](ExprId id) { return tree_[id].op == Op::number && tree_.digits(id) == "1"; };
  if (like.op == Op::multiply && is_one(*a)) return b;
  if (like.op == Op::multiply && is_one(*b)) return a;
  const auto rank =
      like.op == Op::multiply ? static_cast<std::uint8_t>(tree_[*a].rank + tree_[*b].rank) : like.rank;
  return make({.op = like.op, .rank = rank}, {*a, *b});
}

std::optional<ExprId> PowerSeriesExpansion::scalar_times(Term a, Term b) {
  return times(a, b, {.op = Op::multiply});
}

std::optional<ExprId> PowerSeriesExpansion::added(std::vector<ExprId> terms, std::uint8_t rank) {
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms[0] : make({.op = Op::add, .rank = rank}, std::move(terms));
}

std::optional<ExprId> PowerSeriesExpansion::over(Term above, ExprId below) {
  if (!above) return std::nullopt;
  if (tree_[below].op == Op::number && tree_.digits(below) == "1") return above;
  return make({.op = Op::divide, .rank = tree_[*above].rank}, {*above, below});
}

ExprId PowerSeriesExpansion::scaled(int numerator, int denominator, ExprId value) {
  const Term above = scalar_times(number(numerator), value);
  return *over(above, number(denominator));
}

std::optional<PowerSeries> PowerSeriesExpansion::sum(ExprId id) {
  std::vector<PowerSeries> all;
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  for (const ExprId child : children) {
    Maybe each = of(child);
    if (!each) return each;
    all.push_back(*std::move(each));
  }
  int first = all[0].first;
  int end = all[0].end();
  for (const PowerSeries& each : all) {
    first = std::min(first, each.first);
    end = std::min(end, each.end());
  }
  PowerSeries total{.first = first, .terms = {}};
  for (int order = first; order < end; ++order) {
    std::vector<ExprId> terms;
    for (const PowerSeries& each : all) {
      if (order < each.first) continue;
      if (const Term term = each.terms[static_cast<std::size_t>(order - each.first)]) terms.push_back(*term);
    }
    total.terms.push_back(added(std::move(terms), tree_[id].rank));
  }
  return total;
}

PowerSeries PowerSeriesExpansion::product(const PowerSeries& a, const PowerSeries& b, ExprId like) {
  const ExprNode node = tree_[like];
  PowerSeries result{.first = a.first + b.first, .terms = {}};
  for (std::size_t k = 0; k < std::min(a.terms.size(), b.terms.size()); ++k) {
    std::vector<ExprId> terms;
    for (std::size_t i = 0; i <= k; ++i) {
      if (const Term term = times(a.terms[i], b.terms[k - i], node)) terms.push_back(*term);
    }
    const std::uint8_t rank = terms.empty() ? std::uint8_t{0} : tree_[terms[0]].rank;
    result.terms.push_back(added(std::move(terms), rank));
  }
  return result;
}

std::optional<PowerSeries> PowerSeriesExpansion::bilinear(ExprId id) {
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  Maybe result = of(children[0]);
  for (std::size_t k = 1; result && k < children.size(); ++k) {
    const Maybe next = of(children[k]);
    if (!next) return next;
    result = product(*result, *next, id);
  }
  return result;
}

std::optional<PowerSeries> PowerSeriesExpansion::linear(ExprId id) {
  Maybe series = of(tree_.children(id)[0]);
  if (!series) return series;
  const ExprNode node = tree_[id];
  const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
  for (Term& term : series->terms) {
    if (term) term = tree_.add(node, std::span(&*term, 1), slots);
  }
  return series;
}

std::optional<PowerSeries> PowerSeriesExpansion::entries(ExprId id) {
  std::vector<PowerSeries> all;
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  for (const ExprId child : children) {
    Maybe each = from_zero(of(child));
    if (!each || tree_[child].rank != 0) return std::nullopt;
    all.push_back(*std::move(each));
  }
  PowerSeries result;
  for (int order = 0; order < count_; ++order) {
    std::vector<ExprId> terms;
    for (const PowerSeries& each : all)
      terms.push_back(each.terms[static_cast<std::size_t>(order)].value_or(number(0)));
    result.terms.emplace_back(
        make({.op = Op::tuple, .rank = tree_[id].rank, .axes = tree_[id].axes}, std::move(terms)));
  }
  return result;
}

bool PowerSeriesExpansion::strip_zeros(PowerSeries& series) {
  while (!series.terms.empty()) {
    const Term term = series.terms.front();
    if (term) {
      const std::optional<bool> zero = is_zero_(*term);
      if (!zero) return false;
      if (!*zero) return true;
    }
    series.terms.erase(series.terms.begin());
    ++series.first;
  }
  return false;
}

/// Beginning with x^0 and with as many terms as all have.
std::optional<PowerSeries> PowerSeriesExpansion::from_zero(Maybe series) {
  if (!series) return series;
  while (series->first < 0) {
    const Term term = series->terms.front();
    if (term && is_zero_(*term) != true) return std::nullopt;
    series->terms.erase(series->terms.begin());
    ++series->first;
    if (series->terms.empty()) return std::nullopt;
  }
  series->terms.insert(series->terms.begin(), static_cast<std::size_t>(series->first), std::nullopt);
  series->first = 0;
  if (series->terms.size() < static_cast<std::size_t>(count_)) return std::nullopt;
  series->terms.resize(static_cast<std::size_t>(count_));
  return series;
}

/// q = a/b: q_k = (a_k − Σ_{i<k} q_i b_{k−i}) / b_0.
std::optional<PowerSeries> PowerSeriesExpansion::divided(const PowerSeries& above, PowerSeries below,
                                                         std::uint8_t rank) {
  if (!strip_zeros(below)) return std::nullopt;
  const ExprId leading = *below.terms[0];
  PowerSeries result{.first = above.first - below.first, .terms = {}};
  for (std::size_t k = 0; k < std::min(above.terms.size(), below.terms.size()); ++k) {
    std::vector<ExprId> terms;
    if (above.terms[k]) terms.push_back(*above.terms[k]);
    for (std::size_t i = 0; i < k; ++i) {
      if (const Term term = scalar_times(below.terms[k - i], result.terms[i]))
        terms.push_back(make({.op = Op::negate, .rank = rank}, {*term}));
    }
    result.terms.push_back(over(added(std::move(terms), rank), leading));
  }
  return result;
}

std::optional<PowerSeries> PowerSeriesExpansion::quotient(ExprId id) {
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  const Maybe above = of(children[0]);
  Maybe below = of(children[1]);
  if (!above || !below) return std::nullopt;
  return divided(*above, *std::move(below), tree_[id].rank);
}

std::optional<PowerSeries> PowerSeriesExpansion::power(ExprId id) {
  constexpr int most = 16;
  const std::int32_t exponent = tree_[id].exponent;
  const ExprId child = tree_.children(id)[0];
  if (exponent == 0 || std::abs(exponent) > most) return std::nullopt;
  const Maybe base = of(child);
  if (!base) return base;
  const ExprId like = make({.op = Op::multiply}, {child, child});
  PowerSeries result = *base;
  for (int k = 1; k < std::abs(exponent); ++k) result = product(result, *base, like);
  if (exponent > 0) return result;
  return divided(constant(number(1)), std::move(result), 0);
}

/// r = √u with u_0 ≠ 0: r_k = (u_k − Σ_{0<i<k} r_i r_{k−i}) / (2 r_0).
std::optional<PowerSeries> PowerSeriesExpansion::root(ExprId id) {
  Maybe inside = from_zero(of(tree_.children(id)[0]));
  if (!inside || !inside->terms[0] || is_zero_(*inside->terms[0]) != false) return std::nullopt;
  const std::vector<Term>& u = inside->terms;
  PowerSeries result;
  const ExprId leading = make({.op = Op::root}, {*u[0]});
  result.terms.emplace_back(leading);
  const ExprId twice = *scalar_times(number(2), leading);
  for (std::size_t k = 1; k < u.size(); ++k) {
    std::vector<ExprId> terms;
    if (u[k]) terms.push_back(*u[k]);
    for (std::size_t i = 1; i < k; ++i) {
      if (const Term term = scalar_times(result.terms[i], result.terms[k - i]))
        terms.push_back(make({.op = Op::negate}, {*term}));
    }
    result.terms.push_back(over(added(std::move(terms), 0), twice));
  }
  return result;
}

/// f = b^y with y constant and b_0 ≠ 0: k b_0 f_k = Σ_{0<i≤k} (i y − (k − i)) b_i f_{k−i}.
std::optional<PowerSeries> PowerSeriesExpansion::real_power(ExprId id) {
  const ExprId exponent = tree_.children(id)[1];
  Maybe inside = from_zero(of(tree_.children(id)[0]));
  if (depends(exponent) || !inside || !inside->terms[0] || is_zero_(*inside->terms[0]) != false)
    return std::nullopt;
  const std::vector<Term>& b = inside->terms;
  PowerSeries result;
  result.terms.emplace_back(make({.op = Op::real_power}, {*b[0], exponent}));
  for (std::size_t k = 1; k < b.size(); ++k) {
    std::vector<ExprId> terms;
    for (std::size_t i = 1; i <= k; ++i) {
      const int order = static_cast<int>(k);
      const int power = static_cast<int>(i);
      ExprId weight = scaled(power, order, exponent);
      if (power < order)
        weight = make({.op = Op::add},
                      {weight, make({.op = Op::negate}, {scaled(order - power, order, number(1))})});
      if (const Term term = scalar_times(weight, scalar_times(b[i], result.terms[k - i])))
        terms.push_back(*term);
    }
    result.terms.push_back(over(added(std::move(terms), 0), *b[0]));
  }
  return result;
}

/// Of f with f' = u'/w: f_k = (u_k − Σ_{0<i<k} (i/k) f_i w_{k−i}) / w_0, where w is u for the logarithm,
/// 1 + u² for the arc tangent and √(1 − u²) for the arc sine.
std::optional<PowerSeries> PowerSeriesExpansion::inverse_function(ExprId id) {
  const Function function = tree_[id].function;
  const ExprId argument = tree_.children(id)[0];
  const auto rate = [&] {
    if (function == Function::log) return argument;
    const ExprId square = make({.op = Op::power, .exponent = 2}, {argument});
    if (function == Function::arctan) return make({.op = Op::add}, {number(1), square});
    return make({.op = Op::root}, {make({.op = Op::add}, {number(1), make({.op = Op::negate}, {square})})});
  };
  const Maybe inside = from_zero(of(argument));
  const Maybe below = from_zero(of(rate()));
  if (!inside || !below || !below->terms[0] || is_zero_(*below->terms[0]) != false) return std::nullopt;
  const std::vector<Term>& u = inside->terms;
  const std::vector<Term>& w = below->terms;
  const bool falls = function == Function::arccos;
  PowerSeries result;
  result.terms.emplace_back(make({.op = Op::function, .function = function}, {u[0].value_or(number(0))}));
  for (std::size_t k = 1; k < u.size(); ++k) {
    std::vector<ExprId> terms;
    if (u[k]) terms.push_back(falls ? make({.op = Op::negate}, {*u[k]}) : *u[k]);
    for (std::size_t i = 1; i < k; ++i) {
      const Term share = scalar_times(result.terms[i], w[k - i]);
      if (share)
        terms.push_back(make({.op = Op::negate}, {scaled(static_cast<int>(i), static_cast<int>(k), *share)}));
    }
    result.terms.push_back(over(added(std::move(terms), 0), *w[0]));
  }
  return result;
}

/// With f' = g u': k f_k = Σ_{0<i≤k} i u_i g_{k−i}, where g is f for exp, cos for sin and −sin for cos.
std::optional<PowerSeries> PowerSeriesExpansion::function(ExprId id) {
  const Function function = tree_[id].function;
  if (function > Function::exp) return inverse_function(id);
  const Maybe inside = from_zero(of(tree_.children(id)[0]));
  if (!inside) return inside;
  const std::vector<Term>& u = inside->terms;
  const bool at_zero = !u[0] || is_zero_(*u[0]) == true;
  const auto at = [&](Function which) -> Term {
    if (at_zero) return which == Function::sin ? Term() : Term(number(1));
    return make({.op = Op::function, .function = which}, {*u[0]});
  };
  const bool exponential = function == Function::exp;
  std::vector<Term> first{at(exponential ? Function::exp : Function::sin)};
  std::vector<Term> second{exponential ? first[0] : at(Function::cos)};
  for (std::size_t k = 1; k < u.size(); ++k) {
    std::vector<ExprId> of_first;
    std::vector<ExprId> of_second;
    for (std::size_t i = 1; i <= k; ++i) {
      if (!u[i]) continue;
      const ExprId weighted = scaled(static_cast<int>(i), static_cast<int>(k), *u[i]);
      if (const Term term = scalar_times(weighted, second[k - i])) of_first.push_back(*term);
      if (const Term term = scalar_times(weighted, first[k - i]))
        of_second.push_back(exponential ? *term : make({.op = Op::negate}, {*term}));
    }
    first.push_back(added(std::move(of_first), 0));
    second.push_back(added(std::move(of_second), 0));
  }
  return PowerSeries{.first = 0, .terms = function == Function::cos ? second : first};
}

}  // namespace rigor
