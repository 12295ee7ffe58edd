// SPDX-License-Identifier: GPL-3.0-or-later
// What stands next to an equation: where a remark such as "(no sum over i)" ends, where the next equation
// begins without a wide space, and short stretches that are no equation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "latex/token/tokens.h"

namespace rigor {

/// The words with what is between them, without the controls around them.
[[nodiscard]] std::string spoken(TokenView tokens);

/// The letters and signs with a name that are outside of words: `i`, `alpha`.
[[nodiscard]] std::set<std::string> symbols_in(TokenView tokens);

/// Nothing but symbols with commas between, as after `\forall`.
[[nodiscard]] bool lists_symbols(TokenView tokens);

/// `\text{no sum over }i`: the place after the letters that belong to the words.
[[nodiscard]] std::size_t remark_end(TokenView tokens, const Argument& words);

/// `a_i = b_i \; (\text{no sum})`: the place after a bracket at `at` that holds only "no sum" or "and cyclic
/// permutations"; `at` itself for any other.
[[nodiscard]] std::size_t bracketed_remark_end(TokenView tokens, std::size_t at);

/// What a symbol does that is after a visible space (`~`, `\ `, `\enspace`) and directly before a
/// relation.
enum class Beside : std::uint8_t {
  goes_on,  // no such symbol: it belongs to what comes before it
  begins,   // `\dot\omega_1 = a~\dot\omega_2 = b`: the letter on the left side again, so the next equation
  unclear,  // `a = b~c = d` is `a = b` and `c = d`, or `a = bc = d`
};
/// `before`: an equation with its relation.
[[nodiscard]] Beside behind_space(TokenView before, TokenView tokens, std::size_t at);

/// In brackets, an equation number: `(6)`, `(2.3a)`, `(A1')`.
[[nodiscard]] bool is_equation_number(TokenView block);
/// `i, j = 1, 2, 3`: says only what every index does.
[[nodiscard]] bool is_index_range(TokenView block);
/// `n = 0, \pm1, \dots`, `l = 0, 1, \ldots, n - 1`, `n \in \mathbb{Z}`: which values letters take.
[[nodiscard]] bool lists_values(TokenView block);
/// Punctuation, `\checkmark`, `\qed`.
[[nodiscard]] bool is_ornament(TokenView block);
/// Without a full stop or comma at its end.
[[nodiscard]] TokenView without_stop(TokenView block);

}  // namespace rigor
