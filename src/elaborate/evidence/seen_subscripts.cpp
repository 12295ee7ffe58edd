// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that count the members of a sequence in a subscript: n of `x_{n+1}`.
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
std::vector<std::string> counters_in(const WrittenIndex& index) {
  std::vector<std::string> letters;
  if (index.form != IndexForm::word || index.text.find_first_of("+-/") == std::string::npos) return letters;
  for (std::size_t at = 0; at < index.text.size(); ++at) {
    if (index.text[at] == '\\') {
      while (at + 1 < index.text.size() && is_letter(index.text[at + 1])) ++at;
    } else if (is_letter(index.text[at])) {
      letters.emplace_back(1, index.text[at]);
    }
  }
  return letters;
}

void see_subscripts(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    for (const WrittenIndex& index : syntax.symbol(id).lower) {
      const std::vector<std::string> letters = counters_in(index);
      evidence.counters.insert(letters.begin(), letters.end());
    }
  }
}

}  // namespace rigor
