// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/constant_units.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "check/meaning/measured.h"

namespace rigor {
namespace {

/// A side taken apart: what is a number or of units, and what is a constant in their place.
struct UnitsAndConstants {
  std::vector<ExprId> plain;
  std::vector<ExprId> over;   // constants that are multiplied
  std::vector<ExprId> under;  // and divided by
};

bool is_constant_unit(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  if (node.op == Op::power) return is_constant_unit(tree, tree.children(id)[0]);
  if (node.op != Op::symbol || node.rank != 0 || node.slot_count != 0) return false;
  const std::string& name = tree.symbols[node.symbol].name;
  return name == "c" || name == "\\mathrm{u}";
}

/// `1.008\,\mathrm u`
bool is_mass_unit(const ExprTree& tree, const std::vector<ExprId>& over) {
  return over.size() == 1 && tree[over[0]].op == Op::symbol &&
         tree.symbols[tree[over[0]].symbol].name == "\\mathrm{u}";
}

bool take_factors_apart(const ExprTree& tree, ExprId id, UnitsAndConstants& parts) {
  const std::span<const ExprId> children = tree.children(id);
  if (is_constant_unit(tree, id)) {
    parts.over.push_back(id);
    return true;
  }
  if (is_measured(tree, id)) {
    parts.plain.push_back(id);
    return true;
  }
  if (tree[id].op == Op::multiply)
    return std::ranges::all_of(children, [&](ExprId each) { return take_factors_apart(tree, each, parts); });
  if (tree[id].op == Op::divide && is_constant_unit(tree, children[1])) {
    parts.under.push_back(children[1]);
    return take_factors_apart(tree, children[0], parts);
  }
  return false;
}

ExprId product_of(ExprTree& tree, const std::vector<ExprId>& factors) {
  if (factors.size() == 1) return factors[0];
  return tree.add({.op = Op::multiply, .span = tree[factors[0]].span}, factors);
}

/// The numbers of products in products side by side, the first one in front.
std::vector<ExprId> flat(const ExprTree& tree, const std::vector<ExprId>& factors) {
  std::vector<ExprId> all;
  for (const ExprId each : factors) {
    if (tree[each].op == Op::multiply) {
      all.insert(all.end(), tree.children(each).begin(), tree.children(each).end());
    } else {
      all.push_back(each);
    }
  }
  return all;
}

/// The plain side and the other one.
std::optional<std::array<ExprId, 2>> moved(ExprTree& tree, ExprId side, ExprId other) {
  UnitsAndConstants parts;
  const bool negative = tree[side].op == Op::negate;
  const ExprId inside = negative ? tree.children(side)[0] : side;
  if (!take_factors_apart(tree, inside, parts) || parts.plain.empty() ||
      parts.over.size() + parts.under.size() == 0)
    return std::nullopt;
  const std::vector<ExprId> factors = flat(tree, parts.plain);
  const bool of_units = std::ranges::any_of(
      factors, [&](ExprId each) { return !symbols_in(tree, each).empty(); });  // `2c` is a letter twice
  if (tree[factors[0]].op != Op::number || (!of_units && !is_mass_unit(tree, parts.over)))
    return std::nullopt;
  ExprId plain = product_of(tree, factors);
  if (negative) plain = tree.add({.op = Op::negate, .span = tree[side].span}, std::span(&plain, 1));
  parts.under.push_back(other);
  ExprId rest = product_of(tree, parts.under);
  if (!parts.over.empty()) {
    const std::array quotient{rest, product_of(tree, parts.over)};
    rest = tree.add({.op = Op::divide, .span = tree[other].span}, quotient);
  }
  return std::array{plain, rest};
}

/// `\frac{1}{137}`
std::optional<std::array<ExprId, 2>> turned_over(ExprTree& tree, ExprId side, ExprId other) {
  if (tree[side].op != Op::divide || symbols_in(tree, other).empty()) return std::nullopt;
  const std::span<const ExprId> parts = tree.children(side);
  if (tree[parts[0]].op != Op::number || tree.digits(parts[0]) != "1" || tree[parts[1]].op != Op::number)
    return std::nullopt;
  const ExprId number = parts[1];
  const std::array quotient{parts[0], other};
  return std::array{number, tree.add({.op = Op::divide, .span = tree[other].span}, quotient)};
}

}  // namespace

Claim with_plain_number(ExprTree& tree, const Claim& claim) {
  Claim plain = claim;
  Equation& equation = plain.equation;
  if (tree[equation.left].rank != 0 || tree[equation.right].rank != 0) return plain;
  for (const bool swap : {false, true}) {
    const ExprId side = swap ? equation.left : equation.right;
    const ExprId other = swap ? equation.right : equation.left;
    auto found = moved(tree, side, other);
    if (!found && claim.nearly) found = turned_over(tree, side, other);
    if (!found) continue;
    equation.left = swap ? (*found)[0] : (*found)[1];
    equation.right = swap ? (*found)[1] : (*found)[0];
    return plain;
  }
  return plain;
}

}  // namespace rigor
