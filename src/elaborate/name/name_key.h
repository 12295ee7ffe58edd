// SPDX-License-Identifier: GPL-3.0-or-later
// What makes two letters one symbol. The text alone does not: `A_i` and `\mathbf{A}` are one symbol, `I` and
// `I_{ij}` are two, and `\mathbf{r}` is another one where each particle has its own.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "elaborate/evidence/matrix_shape.h"
#include "expr/tree/symbol.h"

namespace rigor {

/// A symbol's name apart from indices: `r`, `T_{\text{rot}}`, `\hat{n}`.
struct NameKey {
  std::string base;
  int rank = 0;
  bool per_particle = false;
  std::uint8_t space = 0;           // of its axes, as `Space::id`; `Symbols` fills in the one in force
  MatrixShape shape = {};           // of a letter that is set equal to a written matrix
  bool complex = false;             // `Symbols` fills in what the section shows
  bool noncommuting = false;        // the same
  Unsized unsized = Unsized::none;  // the same
  friend auto operator<=>(const NameKey&, const NameKey&) = default;
};

/// `T` of `T_{\text{rot}}` and of `T^{(0)}_{1}`: a name without its labels.
[[nodiscard]] inline std::string without_labels(const std::string& name) {
  return name.substr(0, name.find_first_of("_^"));
}

/// Numbers of directives: those that something used.
using Directives = std::set<std::size_t>;

}  // namespace rigor
