// SPDX-License-Identifier: GPL-3.0-or-later
// A number that is one slip away from the right one: its power of ten, a factor 2 or π, two digits exchanged.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigor {

/// What is written, `6.3\times10^{-24}`, and what it should come to in the same unit.
struct WrittenNumber {
  std::string digits;  // `6.3`
  int ten = 0;         // the exponent that is written
  double ratio = 1;    // of the right number to the written one
};

inline constexpr std::string_view exchanged_digits = "two digits are exchanged";

/// "it differs by a factor of 2π"; nothing where no single slip leads from the right number to the written
/// one.
[[nodiscard]] std::optional<std::string> slip_of(const WrittenNumber& number);

/// The digits and the exponent as a side shows them, `6.3\times10^{-24}\,\mathrm s` or `\SI{6.3e-24}{s}`;
/// where they are not found, what is known of the number.
[[nodiscard]] WrittenNumber number_in(std::string_view side, const WrittenNumber& number);

/// The side with the right number to as many digits.
[[nodiscard]] std::optional<std::string> with_right_number(std::string_view side,
                                                           const WrittenNumber& number);

}  // namespace rigor
