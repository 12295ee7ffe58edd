// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/natural_units.h"

#include <algorithm>
#include <vector>

#include "base/ascii.h"
#include "check/constant/measured_value.h"
#include "check/question/base_letters.h"

namespace rigor {
namespace {

bool has_electronvolt(const ExprTree& tree, const Names& names, const Equation& equation) {
  constexpr std::string_view digits = "1602176634";  // as the unit is converted
  return std::ranges::any_of(
      nodes_reached(tree, names.scope, {equation.left, equation.right}),
      [&](ExprId id) { return tree[id].op == Op::number && tree.digits(id) == digits; });
}

}  // namespace

bool mentions_electronvolts(std::string_view text) {
  if (text.find("electronvolt") != std::string_view::npos) return true;
  for (std::size_t at = text.find("eV"); at != std::string_view::npos; at = text.find("eV", at + 1)) {
    const bool ends = at + 2 == text.size() || !is_letter(text[at + 2]);
    if (ends) return true;
  }
  return false;
}

bool may_have_natural_units(const ExprTree& tree, const Names& names, const Equation& equation) {
  if (!has_electronvolt(tree, names, equation)) return false;
  const auto left = measured_value(tree, names, equation.left, {});
  const auto right = measured_value(tree, names, equation.right, {});
  return !left || !right || !(left->dimension == right->dimension);
}

}  // namespace rigor
