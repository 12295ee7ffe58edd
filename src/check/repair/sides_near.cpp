// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/sides_near.h"

#include <algorithm>
#include <variant>

namespace rigor {

std::vector<TokenView> sides_near(const Notes& notes, const ParsedChain& parsed) {
  constexpr std::size_t before = 6;
  constexpr std::size_t behind = 2;
  std::vector<const ParsedChain*> chains;
  std::size_t own = 0;
  const auto take = [&](const std::vector<ParsedChain>& more) {
    for (const ParsedChain& chain : more) {
      if (chain.written.span == parsed.written.span && chain.image == parsed.image &&
          chain.signs == parsed.signs)
        own = chains.size();
      chains.push_back(&chain);
    }
  };
  for (const Event& event : notes.events) {
    if (const auto* display = std::get_if<ParsedDisplay>(&event)) take(display->chains);
    if (const auto* placed = std::get_if<PlacedDirective>(&event)) take(placed->directive.chains);
  }
  std::vector<TokenView> sides;
  for (std::size_t k = own - std::min(own, before); k < chains.size() && k <= own + behind; ++k) {
    if (k == own) continue;
    for (const WrittenSide& side : chains[k]->written.sides) sides.emplace_back(side.tokens);
  }
  return sides;
}

}  // namespace rigor
