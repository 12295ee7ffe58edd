// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/rule.h"

#include <array>
#include <string_view>
#include <utility>

namespace rigor {
namespace {

constexpr auto words_of_kinds = [] {
  using enum RuleKind;
  return std::to_array<std::pair<RuleKind, std::string_view>>({
      {named, ""},
      {rearranged, "order of terms and factors"},
      {multiplied_out, "multiplied out"},
      {factored, "factored"},
      {common_denominator, "common denominator"},
      {divided_out, "divided out"},
      {cancelled, "cancelled"},
      {roots_out_of_denominators, "no root in a denominator"},
      {like_terms_collected, "like terms collected"},
      {terms_split, "terms split"},
      {powers_joined, "equal factors as a power"},
      {powers_split, "powers as products"},
      {squares_of_roots, "square of a root"},
      {square_of_length, "the square of a length"},
      {components_of_tuple, "components of a tuple"},
      {numbers_worked_out, "numbers worked out"},
      {taken_out_of_sum, "taken out of the sum"},
      {taken_into_sum, "taken into the sum"},
      {order, "order of terms and factors"},
      {dummies_renamed, "renamed dummies"},
      {dummies_renamed_in_order, "renamed dummies, order of factors"},
      {antisymmetric_epsilon, "ε is antisymmetric"},
      {symmetric_tensor, "a tensor is symmetric"},
      {products_turned, "a×b = −b×a, a·(b×c) = b·(c×a)"},
      {delta_contracted, "δ contracted"},
      {delta_put_in, "δ put in"},
      {product_with_itself, "a×a = 0"},
      {orthogonal_rotation, "a rotation is orthogonal"},
      {unit_vector, "length of a unit vector"},
      {epsilon_delta, "ε–δ"},
      {cross_of_cross, "A×(B×C) = B(A·C) − C(A·B)"},
      {dot_of_crosses, "(A×B)·(C×D) = (A·C)(B·D) − (A·D)(B·C)"},
      {squares_of_sine_and_cosine, "sin² + cos² = 1"},
      {along_axes, "components along the axes 1, 2, 3"},
      {by_axes, "component by component along the axes 1, 2, 3"},
      {transport, "transport theorem"},
  });
}();

constexpr bool words_follow_enum() {
  for (std::size_t k = 0; k < words_of_kinds.size(); ++k)
    if (static_cast<std::size_t>(words_of_kinds[k].first) != k) return false;
  return static_cast<std::size_t>(RuleKind::transport) + 1 == words_of_kinds.size();
}
static_assert(words_follow_enum(), "one entry for each kind, in the order of the enumeration");

std::string words_of(const Rule& rule) {
  return rule.kind == RuleKind::named
             ? rule.name
             : std::string(words_of_kinds[static_cast<std::size_t>(rule.kind)].second);
}

}  // namespace

std::string words_of(const Rules& rules) {
  std::string all;
  for (const Rule& rule : rules) all += (all.empty() ? "" : ", ") + words_of(rule);
  return all;
}

}  // namespace rigor
