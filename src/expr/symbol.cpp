// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/symbol.h"

#include <utility>

#include "base/check.h"

namespace rigor {

SymbolId SymbolTable::add(Symbol symbol) {
  RIGOR_CHECK(symbol.rank >= 0, symbol.name, symbol.rank);
  RIGOR_CHECK(!symbol.symmetric || symbol.rank == 2, symbol.name, symbol.rank);
  RIGOR_CHECK(!symbol.unit || symbol.rank == 1, symbol.name, symbol.rank);
  symbols_.push_back(std::move(symbol));
  return static_cast<SymbolId>(symbols_.size() - 1);
}

}  // namespace rigor
