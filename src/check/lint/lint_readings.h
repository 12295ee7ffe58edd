// SPDX-License-Identifier: GPL-3.0-or-later
// What each written symbol was read as, by its place.
#pragma once

#include <map>
#include <string>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"

namespace rigor {

enum class ReadAs : std::uint8_t { number, length, vector, tensor };

struct SymbolReading {
  ReadAs meaning;
  SymbolId symbol;   // of a length: the vector
  std::string name;  // its name
  Span place;
};

/// Of symbols as a whole: neither components, nor what stands for more than one symbol, such as `\dot r`, the
/// rate of a length.
[[nodiscard]] std::map<Extent, SymbolReading> symbol_readings(const LintInput& input);

}  // namespace rigor
