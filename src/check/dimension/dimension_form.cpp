// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimension_form.h"

#include <algorithm>
#include <array>
#include <utility>

#include "elaborate/name/symbols.h"

namespace rigor {
namespace {

/// A matrix or column that is no vector of a space, or an entry of one: place and momentum may stand in one
/// column.
bool stands_in_columns(const ExprTree& tree, const ExprNode& node) {
  const AxisSpaces axes = node.op == Op::symbol ? tree.symbols[node.symbol].axes : node.axes;
  const int rank = node.op == Op::symbol ? tree.symbols[node.symbol].rank : node.rank;
  for (int axis = 0; axis < rank; ++axis) {
    if (axes[axis].id == space_of_columns) return true;
  }
  return false;
}

/// 2 of `2 + t`, which may have lost its unit; 1 of `1 + v^2/c^2` is a number.
bool may_lack_a_unit(const ExprTree& tree, ExprId id) {
  if (tree[id].op == Op::negate) return may_lack_a_unit(tree, tree.children(id)[0]);
  return tree[id].op == Op::number && !tree.is_zero_literal(id) && tree.digits(id) != "1";
}

bool has_a_unit(const ExprTree& tree, ExprId id) {
  return std::ranges::any_of(symbols_in(tree, id),
                             [&](SymbolId each) { return tree.symbols[each].unit_of_measure.has_value(); });
}

}  // namespace

bool DimensionForm::is_valid() const {
  return fixed.is_valid() &&
         std::ranges::all_of(unknowns, [](const auto& entry) { return entry.second.is_valid(); });
}

void DimensionForm::add(Unknown unknown, const SmallRational& factor) {
  const auto [entry, is_new] = unknowns.try_emplace(unknown, factor);
  if (!is_new) entry->second = entry->second + factor;
  if (entry->second.is_zero()) unknowns.erase(entry);
}

void DimensionForm::add(const DimensionForm& other, const SmallRational& factor) {
  for (const auto& [unknown, own] : other.unknowns) add(unknown, own * factor);
  fixed += other.fixed * factor;
  any = any || other.any;
}

void demand(std::vector<DimensionEquation>& equations, DimensionEquation equation) {
  if (equation.left.any || equation.right.any) return;
  DimensionForm difference = equation.left;
  difference.add(equation.right, -1);
  if (!difference.is_none()) equations.push_back(std::move(equation));
}

DimensionForm DimensionReader::read(ExprId id) {
  const auto key = static_cast<std::uint32_t>(id);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  DimensionForm form = compute(id);
  known_.emplace(key, form);
  return form;
}

DimensionForm DimensionReader::compute(ExprId id) {
  const ExprNode& node = tree_[id];
  DimensionForm form;
  if (stands_in_columns(tree_, node)) {
    for (const ExprId child : tree_.children(id)) static_cast<void>(read(child));
    form.any = true;
    return form;
  }
  switch (node.op) {
    case Op::number:
      form.any = tree_.is_zero_literal(id);
      return form;
    case Op::basis:
    case Op::delta:
    case Op::epsilon:
    case Op::imaginary_unit:
      return form;
    case Op::symbol:
      return form_of_symbol_(id);
    case Op::add:
      return common(id, Alike::terms);
    case Op::tuple:
    case Op::table:
      return common(id, Alike::components);
    case Op::multiply:
    case Op::divide:
    case Op::dot:
    case Op::cross:
      return product(id);
    case Op::power:
      form.add(read(tree_.children(id)[0]), node.exponent);
      return form;
    case Op::real_power: {
      const ExprId exponent = tree_.children(id)[1];
      const Span span = tree_[exponent].span;
      demand(equations_, {read(exponent), {}, span, span, Alike::argument});
      form.any = true;  // a power of a dimension that no number says
      return form;
    }
    case Op::root:
      form.add(read(tree_.children(id)[0]), SmallRational(1, 2));
      return form;
    case Op::negate:
    case Op::length:
    case Op::absolute:
    case Op::component:
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
    case Op::index_sum:
    case Op::particle_sum:
    case Op::transpose:
    case Op::trace:
      return read(tree_.children(id)[0]);
    case Op::matrix_determinant:
      form.any = true;  // a power that the unknown size says
      return form;
    case Op::determinant:
      return determinant(id);
    case Op::function:
      return function(id);
  }
  return form;
}

DimensionForm DimensionReader::product(ExprId id) {
  const bool quotient = tree_[id].op == Op::divide;
  DimensionForm form;
  for (std::size_t k = 0; k < tree_.children(id).size(); ++k)
    form.add(read(tree_.children(id)[k]), quotient && k == 1 ? -1 : 1);
  return form;
}

/// The dimension of all children. Each is compared with the first one that is no written 0.
DimensionForm DimensionReader::common(ExprId id, Alike alike) {
  DimensionForm first;
  first.any = true;
  Span place{};
  const bool lenient = alike == Alike::terms && !has_a_unit(tree_, id);
  for (const ExprId child : tree_.children(id)) {
    if (lenient && may_lack_a_unit(tree_, child)) continue;
    DimensionForm form = read(child);
    if (first.any) {
      first = std::move(form);
      place = tree_[child].span;
    } else {
      demand(equations_, {first, std::move(form), place, tree_[child].span, alike});
    }
  }
  return first;
}

/// Each row and each column may have a dimension of its own, as long as every product has the same.
DimensionForm DimensionReader::determinant(ExprId id) {
  std::array<Unknown, 3> rows{};
  std::array<Unknown, 3> columns{};
  DimensionForm whole;
  for (std::size_t k = 0; k < 3; ++k) {
    whole.add(rows[k] = fresh_(), 1);
    whole.add(columns[k] = fresh_(), 1);
  }
  const Span span = tree_[id].span;
  for (std::size_t k = 0; k < 9; ++k) {
    const ExprId entry = tree_.children(id)[k];
    DimensionForm place;
    place.add(rows[k / 3], 1);
    place.add(columns[k % 3], 1);
    demand(equations_, {read(entry), std::move(place), tree_[entry].span, span, Alike::components});
  }
  return whole;
}

DimensionForm DimensionReader::function(ExprId id) {
  // `\ln V_2 - \ln V_1` is the usual way to write the logarithm of a ratio.
  if (tree_[id].function == Function::log) return {};
  const ExprId argument = tree_.children(id)[0];
  const Span span = tree_[argument].span;
  demand(equations_, {read(argument), {}, span, span, Alike::argument});
  return {};
}

}  // namespace rigor
