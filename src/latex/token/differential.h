// SPDX-License-Identifier: GPL-3.0-or-later
// The `d` of `dx`, `\mathrm dm`, `\partial x`, and how far the symbol after it reaches.
#pragma once

#include <cstddef>
#include <optional>

#include "latex/token/tokens.h"

namespace rigor {

struct Differential {
  std::size_t next = 0;  // after the sign and its order
  int order = 1;         // 2 in `d^2`; 0: an order that is not read
  bool partial = false;
};

/// `d`, `\mathrm{d}`, `\text{d}`, `\dd` or `\partial` at `at`; a `d` with a subscript or a prime is a letter.
[[nodiscard]] std::optional<Differential> differential_at(TokenView tokens, std::size_t at);

[[nodiscard]] bool is_partial(const Token& token);

/// The place after one symbol with its accents and scripts, `\dot{\mathbf r}_\alpha^2`; `at` itself where
/// none stands.
[[nodiscard]] std::size_t symbol_end(TokenView tokens, std::size_t at);
/// The same for one bracket `(…)` or `[…]`; `at` where there is none or it is not closed.
[[nodiscard]] std::size_t bracket_end(TokenView tokens, std::size_t at);

/// The place after blanks and narrow spacing.
[[nodiscard]] std::size_t skip_narrow(TokenView tokens, std::size_t at);

}  // namespace rigor
