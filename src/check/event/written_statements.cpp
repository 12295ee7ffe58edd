// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/written_statements.h"

namespace rigor {

std::vector<WrittenStatement> statements_in(const Notes& notes) {
  std::vector<WrittenStatement> statements;
  const auto take = [&](const std::vector<ParsedChain>& chains, bool displayed) {
    for (const ParsedChain& chain : chains) {
      if (chain.image == 0) statements.push_back({&chain, displayed});
    }
  };
  for (const Event& event : notes.events) {
    if (const auto* display = std::get_if<ParsedDisplay>(&event)) take(display->chains, true);
    if (const auto* placed = std::get_if<PlacedDirective>(&event)) take(placed->directive.chains, false);
  }
  return statements;
}

}  // namespace rigor
