// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/parse.h"

#include <fmt/format.h>

#include "latex/parse/parser.h"
#include "latex/parse/unseen_braces.h"

namespace rigor {
namespace {

bool holds_opaque(const SyntaxTree& tree, SyntaxId side) {
  std::vector<SyntaxId> pending{side};
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    if (tree[id].kind == SyntaxKind::opaque) return true;
    const bool named = tree[id].kind == SyntaxKind::group;  // by words at a brace, which the account knows
    for (const SyntaxChild& child : tree.children(id).first(named ? 1 : tree.children(id).size()))
      pending.push_back(child.id);
  }
  return false;
}

}  // namespace

SyntaxId parse_side(TokenView tokens, Span place, SyntaxTree& tree, Choices* choices) {
  Tokens written(tokens.begin(), tokens.end());
  lift_idle_braces(written);
  SideAccount account(written);
  const SyntaxId side = Parser(tree, account, 0, choices, written).expression(written, place);
  const Token* left_over = account.left_over();
  if (left_over == nullptr || holds_opaque(tree, side)) return side;
  return tree.add_opaque(left_over->span,
                         {DiagnosticKind::passed_over,
                          fmt::format("`{}` is not part of what was read", text_of({left_over, 1}))});
}

}  // namespace rigor
