// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that readers take for coefficients or for what functions depend on: `a(x + y)` is a product,
// `f(x + y)` can be the value of a function.
#pragma once

#include <string_view>

namespace rigor {

[[nodiscard]] bool is_usual_coefficient(std::string_view letter);
[[nodiscard]] bool is_usual_coordinate(std::string_view letter);

}  // namespace rigor
