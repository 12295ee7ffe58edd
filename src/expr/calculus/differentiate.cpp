// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/differentiate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rigor {

std::optional<ExprId> Differentiator::derivative(ExprId id) {
  if (gave_up()) return std::nullopt;
  const auto key = static_cast<std::uint32_t>(id);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const Span before = std::exchange(span_, tree_[id].span);
  const Maybe result = compute(id);
  span_ = before;
  if (result && !gave_up() && tree_[*result].weight > most_terms)
    give_up(fmt::format("derivatives of more than {} terms and factors are not decided", most_terms));
  if (gave_up()) return std::nullopt;  // and it is not known
  known_.emplace(key, result);
  return result;
}

ExprId Differentiator::derivative_or_zero(ExprId id) {
  if (const Maybe result = derivative(id)) return *result;
  return zero_of_rank(tree_, tree_[id].span, tree_[id].rank, tree_[id].axes);
}

std::optional<ExprId> Differentiator::compute(ExprId id) {
  switch (tree_[id].op) {
    case Op::number:
    case Op::basis:
    case Op::delta:
    case Op::epsilon:
    case Op::imaginary_unit:
      return std::nullopt;
    case Op::symbol:
      return rule_ ? rule_(id) : of_symbol(id);
    case Op::add:
      return of_sum(id);
    case Op::negate:
    case Op::component:
    case Op::index_sum:
    case Op::particle_sum:
    case Op::transpose:
    case Op::trace:
      return of_linear(id);
    case Op::multiply:
    case Op::dot:
    case Op::cross:
      return of_product(id);
    case Op::divide:
      return of_quotient(id);
    case Op::power:
      return of_power(id);
    case Op::real_power:
      return of_real_power(id);
    case Op::root:
      return of_root(id);
    case Op::length:
    case Op::absolute:
      return of_length(id);
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
      return of_part(id);
    case Op::function:
      return of_function(id);
    case Op::tuple:
    case Op::table:
      return of_entries(id);
    case Op::determinant:
      return of_determinant(id);
    case Op::matrix_determinant:
      give_up("the derivative of the determinant of a matrix of unknown size is not decided");
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<ExprId> Differentiator::of_symbol(ExprId id) {
  const ExprNode node = tree_[id];
  if (tree_.symbols[node.symbol].circle_number) return std::nullopt;
  const Dependence dependence = dependence_of_(node.symbol);
  if (dependence.kind == Dependence::Kind::constant) return std::nullopt;
  const std::span<const Slot> written = tree_.slots(id);
  std::vector<Slot> slots(written.begin(), written.end());
  if (dependence.kind == Dependence::Kind::variable) {
    if (by_ != By::space) return number("1");
    if (dependence.axis != 0) slots.push_back({dependence.axis, {}});
    if (slots.empty())
      return tree_.add({.op = Op::basis, .rank = 1, .span = span_}, {}, std::span(&axis_, 1));
    slots.push_back(axis_);
    return tree_.add({.op = Op::delta, .span = span_}, {}, slots);  // ∂x_i/∂x_s
  }
  const int most = by_ == By::space ? most_axes : most_rates;
  if (tree_.symbols[node.symbol].order(by_) >= most) {
    give_up(fmt::format("derivatives of an order above {}{} are not decided", most,
                        by_ == By::space ? " by coordinates" : ""));
    return std::nullopt;
  }
  return of_symbol_at(node, tree_.symbols.derivative(node.symbol, by_), std::move(slots));
}

/// ∂_s of a whole vector is the tuple of its components' derivatives, since the axis s comes last.
ExprId Differentiator::of_symbol_at(const ExprNode& node, SymbolId derivative, std::vector<Slot> slots) {
  const auto rank = static_cast<std::size_t>(tree_.symbols[node.symbol].rank);
  ExprNode made{.op = Op::symbol, .span = span_, .symbol = derivative, .particle = node.particle};
  if (by_ != By::space) {
    made.rank = node.rank;
    return tree_.add(made, {}, slots);
  }
  if (slots.size() == rank) {
    slots.push_back(axis_);
    return tree_.add(made, {}, slots);
  }
  const Space space = tree_.symbols[node.symbol].axes[static_cast<int>(slots.size())];
  std::vector<ExprId> entries;
  for (std::uint8_t axis = 1; axis <= space.dimension; ++axis) {
    slots.push_back({axis, {}});
    entries.push_back(of_symbol_at(node, derivative, slots));
    slots.pop_back();
  }
  spend(entries.size());
  return tree_.add({.op = Op::tuple,
                    .rank = static_cast<std::uint8_t>(rank - slots.size()),
                    .span = span_,
                    .axes = AxisSpaces::of(space, 1)},
                   entries);
}

std::optional<ExprId> Differentiator::of_sum(ExprId id) {
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  std::vector<ExprId> terms;
  for (const ExprId each : children) {
    if (const Maybe term = derivative(each)) terms.push_back(*term);
  }
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms[0] : make(Op::add, tree_[id].rank, terms);
}

std::optional<ExprId> Differentiator::of_linear(ExprId id) {
  const Maybe inner = derivative(child(id));
  if (!inner) return std::nullopt;
  if (tree_[id].op == Op::trace && tree_[id].count == 2) return copy(id, {*inner, child(id, 1)});
  if (tree_[id].op != Op::component) return copy(id, {*inner});
  const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
  return component_of(tree_, *inner, slots);
}

std::optional<ExprId> Differentiator::of_product(ExprId id) {
  if (by_.by == By::letter && tree_.symbols[by_.letter].noncommuting) {
    give_up("a derivative by an operator is not decided");
    return std::nullopt;
  }
  const std::vector<ExprId> factors(tree_.children(id).begin(), tree_.children(id).end());
  std::vector<ExprId> terms;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const Maybe changed = derivative(factors[k]);
    if (gave_up()) return std::nullopt;
    if (!changed) continue;
    std::vector<ExprId> others = factors;
    others[k] = *changed;
    terms.push_back(copy(id, std::move(others)));
  }
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms[0] : make(Op::add, tree_[id].rank, terms);
}

/// (a/b)' = a'/b − a b'/b²
std::optional<ExprId> Differentiator::of_quotient(ExprId id) {
  const std::uint8_t rank = tree_[id].rank;
  const ExprId dividend = child(id, 0);
  const ExprId divisor = child(id, 1);
  if (has_operators(tree_, divisor)) {
    give_up("the derivative of a quotient by an operator is not decided");
    return std::nullopt;
  }
  const Maybe above = derivative(dividend);
  const Maybe below = derivative(divisor);
  std::vector<ExprId> terms;
  if (above) terms.push_back(make(Op::divide, rank, {*above, divisor}));
  if (below) {
    const ExprId quotient =
        make(Op::divide, rank, {scaled(*below, dividend), make(Op::power, 0, {divisor}, 2)});
    terms.push_back(make(Op::negate, rank, {quotient}));
  }
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms[0] : make(Op::add, rank, terms);
}

std::optional<ExprId> Differentiator::of_power(ExprId id) {
  const std::int32_t exponent = tree_[id].exponent;
  const ExprId base = child(id);
  if (has_operators(tree_, base)) return of_power_of_operator(id);
  if (exponent % 2 == 0 && tree_[base].op == Op::symbol) {
    if (const auto square = dependence_of_(tree_[base].symbol).square)
      return derivative(exponent == 2 ? *square : make(Op::power, 0, {*square}, exponent / 2));
  }
  const Maybe inner = derivative(base);
  if (!inner || exponent == 0) return std::nullopt;
  if (exponent == 1) return inner;
  ExprId factor = number(std::to_string(std::abs(exponent)).c_str());
  if (exponent < 0) factor = make(Op::negate, 0, {factor});
  return make(Op::multiply, 0, {factor, make(Op::power, 0, {base}, exponent - 1), *inner});
}

/// (A²)' = A'A + AA'
std::optional<ExprId> Differentiator::of_power_of_operator(ExprId id) {
  const std::int32_t exponent = tree_[id].exponent;
  constexpr std::int32_t most_factors = 16;
  if (exponent < 0 || exponent > most_factors) {
    give_up("the derivative of such a power of an operator is not decided");
    return std::nullopt;
  }
  if (exponent < 2) return exponent == 1 ? derivative(child(id)) : std::nullopt;
  return of_product(make(Op::multiply, 0, std::vector(static_cast<std::size_t>(exponent), child(id))));
}

/// (b^y)' = y b^(y−1) b' + b^y ln b y'
std::optional<ExprId> Differentiator::of_real_power(ExprId id) {
  const ExprId base = child(id, 0);
  const ExprId exponent = child(id, 1);
  const Maybe of_base = derivative(base);
  const Maybe of_exponent = derivative(exponent);
  std::vector<ExprId> terms;
  if (of_base) {
    const ExprId less = make(Op::add, 0, {exponent, make(Op::negate, 0, {number("1")})});
    terms.push_back(make(Op::multiply, 0, {exponent, make(Op::real_power, 0, {base, less}), *of_base}));
  }
  if (of_exponent) terms.push_back(make(Op::multiply, 0, {id, applied(Function::log, base), *of_exponent}));
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms[0] : make(Op::add, 0, terms);
}

std::optional<ExprId> Differentiator::of_root(ExprId id) {
  const Maybe inner = derivative(child(id));
  if (!inner) return std::nullopt;
  return make(Op::divide, 0, {*inner, make(Op::multiply, 0, {number("2"), id})});
}

/// |v|' = v·v'/|v|, for numbers as for vectors; of complex ones Re(v*·v')/|v|.
std::optional<ExprId> Differentiator::of_length(ExprId id) {
  const ExprId inside = child(id);
  const Maybe inner = derivative(inside);
  if (!inner || refuses_complex_variable()) return std::nullopt;
  const Op product = tree_[id].op == Op::length ? Op::dot : Op::multiply;
  const bool complex = has_complex_numbers(tree_, inside);
  const ExprId first = complex ? make(Op::conjugate, tree_[inside].rank, {inside}) : inside;
  ExprId above = make(product, 0, {first, *inner});
  if (complex) above = make(Op::real_part, 0, {above});
  return make(Op::divide, 0, {above, id});
}

/// (z*)' = (z')*, Re(z)' = Re(z'), for a real variable.
std::optional<ExprId> Differentiator::of_part(ExprId id) {
  const Maybe inner = derivative(child(id));
  if (!inner || refuses_complex_variable()) return std::nullopt;
  return copy(id, {*inner});
}

/// z* has no derivative by z.
bool Differentiator::refuses_complex_variable() {
  const bool complex = by_.by == By::letter && tree_.symbols[by_.letter].complex;
  if (complex) give_up("a conjugate or a modulus has no derivative by a complex variable");
  return complex;
}

std::optional<ExprId> Differentiator::of_function(ExprId id) {
  const ExprId argument = child(id);
  const Maybe inner = derivative(argument);
  if (!inner) return std::nullopt;
  const auto times = [&](ExprId outer) { return make(Op::multiply, 0, {outer, *inner}); };
  const auto over = [&](ExprId below) { return make(Op::divide, 0, {*inner, below}); };
  const auto opposite = [&](ExprId of) { return make(Op::negate, 0, {of}); };
  const auto square = [&] { return make(Op::power, 0, {argument}, 2); };
  const auto cosine_of_arcsine = [&] {  // √(1 − u²)
    return make(Op::root, 0, {make(Op::add, 0, {number("1"), opposite(square())})});
  };
  switch (tree_[id].function) {
    case Function::sin:
      return times(applied(Function::cos, argument));
    case Function::cos:
      return opposite(times(applied(Function::sin, argument)));
    case Function::exp:
      return times(id);
    case Function::log:
      return over(argument);
    case Function::arcsin:
      return over(cosine_of_arcsine());
    case Function::arccos:
      return opposite(over(cosine_of_arcsine()));
    case Function::arctan:
      return over(make(Op::add, 0, {number("1"), square()}));
  }
  return std::nullopt;
}

std::optional<ExprId> Differentiator::of_entries(ExprId id) {
  const std::vector<ExprId> entries(tree_.children(id).begin(), tree_.children(id).end());
  const bool any = std::any_of(entries.begin(), entries.end(),
                               [this](ExprId each) { return derivative(each).has_value(); });
  if (!any) return std::nullopt;
  std::vector<ExprId> changed;
  for (const ExprId each : entries) changed.push_back(derivative_or_zero(each));
  if (tree_[id].op == Op::tuple) return copy(id, std::move(changed));
  const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
  return tree_.add_table(span_, changed, slots, Table(tree_.table(id)));
}

std::optional<ExprId> Differentiator::of_determinant(ExprId id) {
  const std::vector<ExprId> entries(tree_.children(id).begin(), tree_.children(id).end());
  std::vector<ExprId> terms;
  for (std::size_t row = 0; row < 9; row += 3) {
    std::vector<ExprId> changed = entries;
    bool any = false;
    for (std::size_t k = row; k < row + 3; ++k) {
      any = derivative(entries[k]).has_value() || any;
      changed[k] = derivative_or_zero(entries[k]);
    }
    if (any) terms.push_back(make(Op::determinant, tree_[id].rank, changed));
  }
  if (terms.empty()) return std::nullopt;
  return terms.size() == 1 ? terms[0] : make(Op::add, tree_[id].rank, terms);
}

void Differentiator::spend(std::size_t children) {
  const std::size_t cost = children + 1;
  if (cost <= budget_.nodes) {
    budget_.nodes -= cost;
  } else if (!gave_up()) {
    give_up("the derivatives in this statement are too large together to be decided");
  }
}

/// The node with other children.
ExprId Differentiator::copy(ExprId like, std::vector<ExprId> children) {
  ExprNode node = tree_[like];
  node.span = span_;
  spend(children.size());
  return tree_.add(node, children);
}

ExprId Differentiator::make(Op op, std::uint8_t rank, std::vector<ExprId> children, std::int32_t exponent) {
  spend(children.size());
  return tree_.add({.op = op, .rank = rank, .span = span_, .exponent = exponent}, children);
}

ExprId Differentiator::applied(Function function, ExprId argument) {
  spend(1);
  return tree_.add({.op = Op::function, .span = span_, .function = function}, std::span(&argument, 1));
}

ExprId Differentiator::scaled(ExprId scalar, ExprId value) {
  return make(Op::multiply, tree_[value].rank, {scalar, value});
}

ExprId replaced(ExprTree& tree, ExprId root, const std::function<std::optional<ExprId>(ExprId)>& by) {
  ExprNode node = tree[root];
  if (node.op == Op::symbol) return by(root).value_or(root);
  const std::vector<ExprId> before(tree.children(root).begin(), tree.children(root).end());
  std::vector<ExprId> after;
  for (const ExprId child : before) after.push_back(replaced(tree, child, by));
  if (after == before) return root;
  const std::vector<Slot> slots(tree.slots(root).begin(), tree.slots(root).end());
  if (node.op == Op::table) return tree.add_table(node.span, after, slots, Table(tree.table(root)));
  return tree.add(node, after, slots);
}

ExprId component_of(ExprTree& tree, ExprId id, std::span<const Slot> slots) {
  const Span span = tree[id].span;
  while (!slots.empty() && tree[id].op == Op::tuple && slots[0].axis != 0) {
    id = tree.children(id)[slots[0].axis - 1u];
    slots = slots.subspan(1);
  }
  if (slots.empty()) return id;
  if (tree[id].op == Op::symbol) {
    ExprNode node = tree[id];
    node.rank = 0;
    return tree.add(node, {}, slots);
  }
  return tree.add({.op = Op::component, .span = span}, std::span(&id, 1), slots);
}

ExprId filled(ExprTree& tree, ExprId number, int rank, AxisSpaces axes) {
  const Span span = tree[number].span;
  for (int axis = rank - 1; axis >= 0; --axis) {
    const std::vector<ExprId> entries(axes[axis].dimension, number);
    number = tree.add({.op = Op::tuple,
                       .rank = static_cast<std::uint8_t>(rank - axis),
                       .span = span,
                       .axes = AxisSpaces::of(axes[axis], 1)},
                      entries);
  }
  return number;
}

ExprId zero_of_rank(ExprTree& tree, Span span, int rank, AxisSpaces axes) {
  return filled(tree, tree.add_number(span, "0"), rank, axes);
}

}  // namespace rigor
