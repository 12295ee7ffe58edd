// SPDX-License-Identifier: GPL-3.0-or-later
// `1\,\text{F} = 10^{-15}\,\text{m}`: a row that says what a unit is. Its sign can be that of a unit that is
// known, here the farad, and is another one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigor {

/// `F` of a row with these sides: one of a unit on the left, and on the right a number, which is not 1, of a
/// single unit. `1\,\mathrm N = 1\,\mathrm{kg\,m/s}` names none.
[[nodiscard]] std::optional<std::string> unit_introduced(std::string_view left, std::string_view right);
/// The same of a relation as it is written in a line.
[[nodiscard]] std::optional<std::string> unit_introduced_in(std::string_view relation);
/// Is it written with this unit: `3\,\text{F}`?
[[nodiscard]] bool writes_unit(std::string_view text, std::string_view unit);

}  // namespace rigor
