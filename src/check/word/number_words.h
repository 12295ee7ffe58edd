// SPDX-License-Identifier: GPL-3.0-or-later
// A row of numbers alone holds or does not: no case, place or condition on letters can restrict it. Only
// words on numbers can.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigor {

/// "roughly", "rounded up", "in binary", "in quadrature", "a clock shows": the numbers are meant in another
/// way.
[[nodiscard]] std::optional<std::string> word_on_numbers(std::string_view text);

}  // namespace rigor
