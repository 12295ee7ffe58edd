// SPDX-License-Identifier: GPL-3.0-or-later
// `dU = T\,dS - p\,dV` says how U changes along every path of states: a differential is the derivative by a
// parameter of the path, which nobody writes. So differentials are differentiated, put in and eliminated like
// any other derivatives.
#pragma once

#include <string_view>

#include "expr/tree/symbol.h"

namespace rigor {

/// The parameter's name, which is the sign before each differential.
inline constexpr std::string_view path_parameter = "\\mathrm{d}";

[[nodiscard]] inline bool is_along_path(const SymbolTable& symbols, const Variable& by) {
  return by.by == By::letter && !by.partial && symbols[by.letter].name == path_parameter;
}

/// Is it a differential, `dU`?
[[nodiscard]] inline bool is_differential(const SymbolTable& symbols, SymbolId symbol) {
  const auto& derivation = symbols[symbol].derivation;
  return derivation && derivation->by.size() == 1 && is_along_path(symbols, *derivation->by.begin());
}

}  // namespace rigor
