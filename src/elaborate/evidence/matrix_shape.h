// SPDX-License-Identifier: GPL-3.0-or-later
// How many rows and columns a written matrix has.
#pragma once

#include <compare>
#include <cstdint>

namespace rigor {

inline constexpr std::uint8_t most_rows = 9;  // and columns: axes are one digit

/// Without rows it is of no matrix. One column alone is a vector, and so is one row, which stands apart from
/// it in products only.
struct MatrixShape {
  std::uint8_t rows = 0;
  std::uint8_t columns = 0;
  [[nodiscard]] constexpr bool is_matrix() const { return rows > 1 && columns > 1; }
  [[nodiscard]] constexpr bool any() const { return rows > 0; }
  friend constexpr auto operator<=>(const MatrixShape&, const MatrixShape&) = default;
};

}  // namespace rigor
