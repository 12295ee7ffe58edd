// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/family/family_letters.h"

#include <charconv>

namespace rigor {

std::optional<NumberedLetter> numbered_letter(const Symbol& symbol) {
  if (symbol.rank != 0 || symbol.per_particle || symbol.unit_of_measure) return std::nullopt;
  const auto open = symbol.name.rfind("_{");
  if (open == std::string::npos || !symbol.name.ends_with('}')) return std::nullopt;
  NumberedLetter letter{symbol.name.substr(0, open), 0};
  const char* begin = symbol.name.data() + open + 2;
  const char* end = symbol.name.data() + symbol.name.size() - 1;
  const auto [last, error] = std::from_chars(begin, end, letter.number);
  if (error != std::errc() || last != end || letter.number < 0 || letter.number > 1000) return std::nullopt;
  return letter;
}

bool is_free_vector(const Symbol& symbol) { return symbol.rank == 1 && !symbol.per_particle; }

bool has_gap_between_components(const Symbol& symbol) {
  if (symbol.per_particle) return false;
  if (symbol.rank == 2) return symbol.symmetric;
  const bool is_plain = !symbol.name.empty() && symbol.name.find("\\math") == std::string::npos &&
                        symbol.name.find("\\vec") == std::string::npos &&
                        symbol.name.find("\\bm") == std::string::npos &&
                        symbol.name.find("\\boldsymbol") == std::string::npos;
  return symbol.rank == 1 && !symbol.unit && !symbol.derivation && is_plain;
}

}  // namespace rigor
