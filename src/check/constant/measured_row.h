// SPDX-License-Identifier: GPL-3.0-or-later
// A row that has a number on one side, and letters on the other to which the page gives no values: which
// constants can they be, so that the dimensions of the sides agree, and with which does the number?
#pragma once

#include <string>
#include <vector>

#include "check/constant/constant_letters.h"
#include "check/constant/measured_value.h"
#include "check/doubt/digits.h"

namespace rigor {

/// The sides of a row, and what is known of its letters.
struct MeasuredRow {
  const Claim& claim;
  NumberShown shown;
  ExprId value{};  // the other side
  Names names;
  std::vector<SymbolId> letters = {};  // that nothing on the page gives a value
};

/// A constant for each letter, in the order of the letters.
using Assignment = std::vector<const PhysicalConstant*>;

/// What the constants say of the row: one assignment for each set of names.
struct Compared {
  std::vector<Assignment> possible;  // the dimensions agree
  std::vector<Assignment> fitting;   // and the number, to the digits that are shown
};

/// The row as one of pure numbers, in base units: right where the dimensions of its sides agree, and then
/// roots, logarithms and π have bounds.
[[nodiscard]] Claim claim_of_numbers(ExprTree& tree, const MeasuredRow& row, const Names& names);

/// The same of a row without letters; nothing where no number with a unit stands on one side, or the
/// dimensions do not agree.
[[nodiscard]] std::optional<Claim> claim_in_base_units(ExprTree& tree, const Names& names,
                                                       const Claim& claim);

/// Letters that have no value, and no definition, where these names hold.
[[nodiscard]] std::vector<SymbolId> letters_without_value(const ExprTree& tree, const Names& names,
                                                          ExprId value);

/// `c = 3.00\times10^8\,\mathrm{m/s}` of the page is the speed of light, rounded: a number may have been
/// computed with all digits. Is there such a letter? Its definition is taken out.
bool forget_rounded_constants(const ExprTree& tree, NameScope& scope, const std::string& spoken);

[[nodiscard]] MeasuredLetters values_of(const std::vector<SymbolId>& letters, const Assignment& constants);

/// The names with the constants, which `uses` names as conventions; nothing where a unit has too large a
/// power.
[[nodiscard]] std::optional<Names> with_constants(ExprTree& tree, const MeasuredRow& row,
                                                  const Assignment& constants);

/// How far the value may be off, since the constants are measured.
[[nodiscard]] double error_of(const ExprTree& tree, const MeasuredRow& row, const Assignment& constants,
                              double value);

/// What the digits that are shown leave open. Zeros at the end of a whole number may be none.
[[nodiscard]] double half_a_digit(const ExprTree& tree, const MeasuredRow& row, double written);

/// None where one of the letters has no constant, or there are too many ways. In floating point as far as
/// the dimensions go; that the number fits is decided exactly.
[[nodiscard]] Compared compare_with_constants(ExprTree& tree, const MeasuredRow& row,
                                              const std::string& spoken, DecisionCache* cache);

}  // namespace rigor
