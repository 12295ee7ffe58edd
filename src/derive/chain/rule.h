// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of small steps, and what they are called.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

enum class RuleKind : std::uint8_t {
  named,       // by its own words: an equation, an assumption, a definition of notation
  rearranged,  // by what two lines are (derive/chain/rearrangement.h)
  multiplied_out,
  factored,
  common_denominator,
  divided_out,
  cancelled,
  roots_out_of_denominators,
  like_terms_collected,
  terms_split,
  powers_joined,
  powers_split,
  squares_of_roots,
  square_of_length,
  components_of_tuple,
  numbers_worked_out,
  taken_out_of_sum,
  taken_into_sum,
  order,
  dummies_renamed,
  dummies_renamed_in_order,
  antisymmetric_epsilon,
  symmetric_tensor,
  products_turned,
  delta_contracted,
  delta_put_in,
  product_with_itself,
  orthogonal_rotation,
  unit_vector,
  epsilon_delta,
  cross_of_cross,
  dot_of_crosses,
  squares_of_sine_and_cosine,
  along_axes,
  by_axes,
  transport,
};

struct Rule {
  RuleKind kind = RuleKind::named;
  std::string name = {};  // of a named one

  [[nodiscard]] bool operator==(const Rule&) const = default;
};

/// What was done in one step, the first thing first.
using Rules = std::vector<Rule>;

/// `multiplied out, ε–δ`. One that is only `rearranged` is an order of terms and factors.
[[nodiscard]] std::string words_of(const Rules& rules);

}  // namespace rigor
