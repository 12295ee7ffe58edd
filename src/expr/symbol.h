// SPDX-License-Identifier: GPL-3.0-or-later
// The names that a file's statements are about. A symbol is what a letter with its face, accent, primes and
// labels stands for:
// `\mathbf{r}_\alpha`, `r_{\alpha i}` and the length `r_\alpha` are one symbol (rank 1, one for each
// particle).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/span.h"

namespace rigor {

enum class SymbolId : std::uint32_t {};

struct Symbol {
  std::string name;  // LaTeX without indices and particle label: `\mathbf{r}`, `T_{\text{rot}}`
  int rank = 0;      // 0 scalar, 1 vector, 2 and more tensor; axes run over 1..3, right-handed orthonormal
  bool per_particle = false;  // has a value for each particle
  bool symmetric = false;     // rank 2: equal to its transpose
  bool unit = false;          // rank 1: length 1
  bool declared = false;      // by a directive: a statement holds for all its values
  Span first_seen = {};
};

class SymbolTable {
 public:
  SymbolId add(Symbol symbol);
  [[nodiscard]] const Symbol& operator[](SymbolId id) const { return symbols_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] Symbol& operator[](SymbolId id) { return symbols_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] std::size_t size() const { return symbols_.size(); }

 private:
  std::vector<Symbol> symbols_;
};

}  // namespace rigor
