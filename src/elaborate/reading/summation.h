// SPDX-License-Identifier: GPL-3.0-or-later
// The summation convention: which letters of a product are summed, which are free.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// The letters of a product's factors.
struct Contraction {
  std::vector<FreeIndex> summed = {};  // they stand twice
  std::vector<FreeIndex> free = {};
  std::vector<FreeIndex> bound = {};  // summed inside a factor
};

/// A letter twice in a product is summed, once is free; more often is a mistake, which gives nothing and a
/// diagnostic.
[[nodiscard]] std::optional<Contraction> contraction_of(Reading& reading, const std::vector<Typed>& factors);

/// `product` with these letters, summed over those that stand twice.
[[nodiscard]] Typed summed(ExprTree& tree, Typed product, Contraction letters);

/// The same for repeated letters on one symbol: `I_{ii}`.
[[nodiscard]] MaybeTyped contract(Reading& reading, Typed typed);

}  // namespace rigor
