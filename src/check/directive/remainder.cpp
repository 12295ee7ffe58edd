// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/directive/remainder.h"

#include <string>

namespace rigor {
namespace {

bool is_landau(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::function && syntax.text(id) == "O";
}

/// The letter and its power in `O(x^n)`.
std::optional<Remainder> read(const SyntaxTree& syntax, SyntaxId id) {
  const SyntaxId inside = syntax.child(id, 0);
  if (syntax[inside].kind == SyntaxKind::symbol) return Remainder{.letter = inside, .power = 1};
  if (syntax[inside].kind != SyntaxKind::power) return std::nullopt;
  const SyntaxId base = syntax.child(inside, 0);
  const SyntaxId exponent = syntax.child(inside, 1);
  if (syntax[base].kind != SyntaxKind::symbol || syntax[exponent].kind != SyntaxKind::number)
    return std::nullopt;
  const std::string& digits = syntax.text(exponent);
  const bool whole = digits.size() == 1 && digits[0] >= '1' && digits[0] <= '9';
  return whole ? std::optional(Remainder{.letter = base, .power = digits[0] - '0'}) : std::nullopt;
}

}  // namespace

std::vector<std::optional<Remainder>> remainders_of(SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::vector<std::optional<Remainder>> remainders;
  for (const SyntaxId side : sides) {
    std::optional<Remainder>& remainder = remainders.emplace_back();
    if (is_landau(syntax, side)) {
      remainder = read(syntax, side);
      if (!remainder) continue;
      remainder->alone = true;
      remainder->rest = syntax.add_text(SyntaxKind::number, syntax[side].span, "0");
      continue;
    }
    if (syntax[side].kind != SyntaxKind::sum) continue;
    std::vector<SyntaxChild> others;
    std::vector<SyntaxId> found;
    for (const SyntaxChild& child : syntax.children(side)) {
      if (is_landau(syntax, child.id)) {
        found.push_back(child.id);
      } else {
        others.push_back(child);
      }
    }
    if (found.size() == 1) remainder = read(syntax, found.front());
    if (!remainder) continue;
    remainder->alone = others.empty();
    const Span span = syntax[side].span;
    remainder->rest = others.empty() ? syntax.add_text(SyntaxKind::number, span, "0")
                                     : syntax.add(SyntaxKind::sum, span, others);
  }
  return remainders;
}

}  // namespace rigor
