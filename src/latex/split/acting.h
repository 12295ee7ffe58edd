// SPDX-License-Identifier: GPL-3.0-or-later
// Words and letters that act on what comes after them, or stand for something else than a quantity:
// `\text{grad}`, `\mathop{\rm rot}`, `O(x^2)`, `\frac{Df}{Dt}`. To read one as a factor proves what is false.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "latex/token/tokens.h"

namespace rigor {

/// A word in upright letters: `\operatorname{grad}`, `\mathrm{rot}`, `\text{Re }`, `{\rm div}`,
/// `\mathop{\mathrm{curl}}\nolimits`.
struct UprightWord {
  std::string word;
  std::size_t next;
};
[[nodiscard]] std::optional<UprightWord> upright_word_at(TokenView tokens, std::size_t at);

/// `\text{$a$}`: what is between the two signs; nothing if there is more or less in the words.
[[nodiscard]] std::optional<TokenView> mathematics_in(TokenView words);
/// `\textbf{a}`, `\text{$a + b$}`, `\text{sin}`, `\operatorname{grad}`: part of an expression, whatever is
/// next to it.
[[nodiscard]] bool writes_mathematics(TokenView tokens, std::size_t at);

/// `O(x^2)`, `\mathcal O(\epsilon)`, `\order{x}`: the place after it; `at` itself for anything else.
[[nodiscard]] std::size_t landau_end(TokenView tokens, std::size_t at);

/// What is in the bracket of such an O, which ends at `end`; nothing for a small o.
[[nodiscard]] std::optional<TokenView> landau_argument(TokenView tokens, std::size_t at, std::size_t end);

/// `\frac{Df}{Dt}`, `\frac{\mathrm D}{\mathrm Dt}`, for the two parts of the fraction.
[[nodiscard]] bool is_material(TokenView above, TokenView below);
/// What a material derivative of the first order by the time t acts on as far as it is above, perhaps
/// nothing; no value for another one.
[[nodiscard]] std::optional<TokenView> material_operand(TokenView above, TokenView below);
/// `Df/Dt`, `D/Dt`: the place after it; `at` itself for anything else.
[[nodiscard]] std::size_t material_end(TokenView tokens, std::size_t at);

/// `\mathrm dx`, `\dd x`, `\text{d}(xy)`: an upright d before a symbol or a bracket.
[[nodiscard]] bool is_lone_differential(TokenView tokens, std::size_t at);

}  // namespace rigor
