// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that the page gives for letters, in lines and in displays, and what holds with them put in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/place/place.h"

namespace rigor {

/// The page gives this number, or another expression, for a letter.
struct GivenValue {
  SymbolId letter{};
  ExprId number{};
  std::string text;          // as a verdict names it
  std::size_t sentence = 0;  // 0: in a display
};

/// u of `u \approx 6.3\,\mathrm{m/s}`
[[nodiscard]] std::optional<SymbolId> bare_letter(const ExprTree& tree, ExprId side);

/// What lines say that letters are, by numbers or by others: `$\kappa = e^2/4\pi\varepsilon_0$`. In the order
/// of the notes. `divides_by_all`: a slash with all that is behind it.
[[nodiscard]] std::vector<GivenValue> said_of_letters(RowPlace& place, bool divides_by_all = false);

/// The last one of each letter. Where its section gives several, only that of the same sentence counts, and
/// none where one sentence gives several: "In air $n = 1.00$. In glass $n = 1.50$."
[[nodiscard]] std::vector<GivenValue> values_above(RowPlace& place);

/// What holds here, with the laws that say what a letter is, and with the values. `again`: also for letters
/// that are defined: the period of a pendulum is measured, and what plates have for `C = Q/V` is a law.
/// Without `laws` only definitions and values: c of `c = \lambda\nu` is the speed of light.
[[nodiscard]] Names with_values(const RowPlace& place, const ParsedChain& parsed, const Claim& claim,
                                const std::vector<GivenValue>& values, bool again, bool laws = true);

/// What the sides lead to.
[[nodiscard]] std::vector<std::string> uses_of(const ExprTree& tree, const Names& names, const Claim& claim);

/// The row is proved with these.
void prove_by_numbers(RowPlace& place, const StepReading& row, const Claim& claim,
                      std::vector<std::string> uses, std::string route, Judgement& judgement);

/// "The largest current is" may say another one. A link of a chain, a conclusion, and a row without words of
/// its own go on with what stands above; a letter that has a number already has it for another case.
/// `spelled_out`: `h/mc` is what it is, whatever the words say.
[[nodiscard]] bool number_may_be_suspected(const RowPlace& place, const StepReading& row, const Claim& claim,
                                           bool spelled_out = false);

/// More than roundings on the way from the numbers to the result: 3 %, and ten of the last digit.
[[nodiscard]] bool is_far(double ratio, int digits);

}  // namespace rigor
