// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/said_pieces.h"

#include <algorithm>

namespace rigor {

std::vector<SaidPiece> said_pieces(std::string_view text) {
  std::vector<SaidPiece> pieces;
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at).starts_with("<!--")) {
      at = std::min(text.find("-->", at), text.size() - 3) + 3;
      continue;
    }
    if (text[at] == '$') {
      const std::size_t close = text.find('$', at + 1);
      if (close == std::string_view::npos) break;
      pieces.push_back({std::string(text.substr(at + 1, close - at - 1)), true});
      at = close + 1;
      continue;
    }
    if (!is_letter(text[at])) {
      const bool blank = is_white(text[at]) || text[at] == '~' || text[at] == '-' || text[at] == '(';
      if (!blank) pieces.push_back({std::string(1, text[at]), false});
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && is_letter(text[at])) ++at;
    pieces.push_back({lowered(text.substr(begin, at - begin)), false});
  }
  return pieces;
}

}  // namespace rigor
