// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as tables show them: few digits, the same everywhere.
#pragma once

#include <span>
#include <string>

namespace rigor {

/// Two significant digits: `3.1e-16`, `0`, `12`, `2.4`, `inf`; nothing for what is not a number.
[[nodiscard]] std::string short_number(double value);
/// Six significant digits.
[[nodiscard]] std::string value_text(double value);
/// A scalar, or `(x, y, z)`; the rows of a tensor after semicolons.
[[nodiscard]] std::string value_text(std::span<const double> components);

}  // namespace rigor
