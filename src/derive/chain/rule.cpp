// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/rule.h"

namespace rigor {
namespace {

std::string words_of(const Rule& rule) {
  switch (rule.kind) {
    case RuleKind::named:
      return rule.name;
    case RuleKind::multiplied_out:
      return "multiplied out";
    case RuleKind::factored:
      return "factored";
    case RuleKind::common_denominator:
      return "common denominator";
    case RuleKind::divided_out:
      return "divided out";
    case RuleKind::cancelled:
      return "cancelled";
    case RuleKind::roots_out_of_denominators:
      return "no root in a denominator";
    case RuleKind::like_terms_collected:
      return "like terms collected";
    case RuleKind::terms_split:
      return "terms split";
    case RuleKind::powers_joined:
      return "equal factors as a power";
    case RuleKind::powers_split:
      return "powers as products";
    case RuleKind::squares_of_roots:
      return "square of a root";
    case RuleKind::square_of_length:
      return "the square of a length";
    case RuleKind::components_of_tuple:
      return "components of a tuple";
    case RuleKind::numbers_worked_out:
      return "numbers worked out";
    case RuleKind::taken_out_of_sum:
      return "taken out of the sum";
    case RuleKind::taken_into_sum:
      return "taken into the sum";
    case RuleKind::rearranged:
    case RuleKind::order:
      return "order of terms and factors";
    case RuleKind::dummies_renamed:
      return "renamed dummies";
    case RuleKind::dummies_renamed_in_order:
      return "renamed dummies, order of factors";
    case RuleKind::antisymmetric_epsilon:
      return "ε is antisymmetric";
    case RuleKind::symmetric_tensor:
      return "a tensor is symmetric";
    case RuleKind::products_turned:
      return "a×b = −b×a, a·(b×c) = b·(c×a)";
    case RuleKind::delta_contracted:
      return "δ contracted";
    case RuleKind::delta_put_in:
      return "δ put in";
    case RuleKind::product_with_itself:
      return "a×a = 0";
    case RuleKind::orthogonal_rotation:
      return "a rotation is orthogonal";
    case RuleKind::unit_vector:
      return "length of a unit vector";
    case RuleKind::epsilon_delta:
      return "ε–δ";
    case RuleKind::cross_of_cross:
      return "A×(B×C) = B(A·C) − C(A·B)";
    case RuleKind::dot_of_crosses:
      return "(A×B)·(C×D) = (A·C)(B·D) − (A·D)(B·C)";
    case RuleKind::squares_of_sine_and_cosine:
      return "sin² + cos² = 1";
    case RuleKind::along_axes:
      return "components along the axes 1, 2, 3";
    case RuleKind::by_axes:
      return "component by component along the axes 1, 2, 3";
    case RuleKind::transport:
      return "transport theorem";
  }
  return {};
}

}  // namespace

std::string words_of(const Rules& rules) {
  std::string all;
  for (const Rule& rule : rules) all += (all.empty() ? "" : ", ") + words_of(rule);
  return all;
}

}  // namespace rigor
