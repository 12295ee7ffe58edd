// SPDX-License-Identifier: GPL-3.0-or-later
// Rewritings of one side that exchange two things, or change what a letter, a function or a factor is.
#pragma once

#include <vector>

#include "latex/reading/rewritings.h"

namespace rigor {

/// Two indices of a term, two neighbouring terms or two letters exchanged; another letter, a dot or a prime
/// more or less; a function for its neighbour; a fraction turned over; a number in a denominator; a letter as
/// a factor more or less. Letters and factors are those of the chain.
[[nodiscard]] std::vector<Rewriting> exchanges_of(TokenView side, const std::vector<TokenView>& chain);

/// The same for letters that no side of the chain has, but sides near it: another letter, or one as a factor
/// more.
[[nodiscard]] std::vector<Rewriting> letters_from(const std::vector<TokenView>& near, TokenView side,
                                                  const std::vector<TokenView>& chain);

}  // namespace rigor
