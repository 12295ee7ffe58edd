// SPDX-License-Identifier: GPL-3.0-or-later
// A number that is written with a decimal point, or after ≈, stands for all numbers that round to it:
// 27/16 = 1.69 holds, 27/16 = 1.68 does not, 2^{-53} ≈ 1.11·10^{-16} does. So does a whole number
// that is computed from decimals: 0.5·9.8·3^2 = 44. One that is computed from whole numbers may: 2π·50 = 314.
// Trailing zeros of a whole number may be digits or not. Letters that both sides have alike are left out: τ
// ln 2 = 0.693 τ.
#pragma once

#include <optional>
#include <string>

#include "check/verdict/judge.h"

namespace rigor {

/// How a number agrees with the digits that are shown of it.
enum class Agreement : std::uint8_t {
  rounds,   // it rounds to them
  unclear,  // it may, by how many of the digits count
  cut,      // its own digits are these, and the next one would round them up
  differs,  // it does not
};

struct DigitComparison {
  Agreement agreement = Agreement::unclear;
  std::string bound = {};    // where it differs: `less than 1.415`
  bool of_decimals = false;  // it is computed from decimals, which may be rounded themselves
  std::optional<Equation> before_letters = {};  // the numbers that were compared, without the letters
};

/// `6.3\,\mathrm{m/s}`: a side that is one number, with powers of ten and units.
struct NumberShown {
  ExprId side{};
  ExprId number{};
  int digits = 0;
};

/// That of one side, where the other is none.
[[nodiscard]] std::optional<NumberShown> number_shown(const ExprTree& tree, const Names& names,
                                                      const Claim& claim);

/// π, unless the notes say something else about it.
[[nodiscard]] bool is_circle_number(const ExprTree& tree, const Names& names, SymbolId symbol);

/// \pi/180
[[nodiscard]] bool is_degree(const ExprTree& tree, const Names& names, ExprId id);
/// `80^\circ - 20^\circ` can be temperatures, and `270^\circ = -90^\circ` leaves out a turn. Beside π and
/// inverse functions, and in the argument of a function, degrees are angles.
[[nodiscard]] bool has_degrees_alone(const ExprTree& tree, const Names& names, const Equation& equation);

/// `37^\circ`, but not `45^\circ`: an angle in whole degrees, of which most are rounded. Definitions are put
/// in.
[[nodiscard]] bool has_rounded_degrees(const ExprTree& tree, const Names& names, const Equation& equation);

/// `\pi = 3.14`: such a row says what π is worth, and defines nothing.
[[nodiscard]] bool shows_circle_number(const ExprTree& tree, const Names& names, const Typed& left,
                                       const Typed& right);

/// Is a number in it written with a point, definitions unfolded? Then it is measured or rounded already.
[[nodiscard]] bool has_decimal(const ExprTree& tree, const Names& names, ExprId root);

/// Are both sides numbers, and is one of them made of decimals? What is not shown to be rounded may be so.
[[nodiscard]] bool compares_decimals(const ExprTree& tree, const Names& names, const Equation& equation);

/// Nothing where neither side is such a number, where the other depends on a letter, or where that cannot be
/// decided. `measured`: the numbers had units, so that a whole one may be rounded.
[[nodiscard]] std::optional<DigitComparison> agreement_of_digits(ExprTree& tree, const Names& names,
                                                                 const Claim& claim, DecisionCache* cache,
                                                                 bool measured = false);

}  // namespace rigor
