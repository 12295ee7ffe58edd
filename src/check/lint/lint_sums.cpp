// SPDX-License-Identifier: GPL-3.0-or-later
// A sum over an index that its terms do not have: `\sum_\alpha m_\beta`, `\sum_i A_jB_j`. A sum of plain
// numbers counts, and is meant.
#include <fmt/format.h>

#include <algorithm>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"

namespace rigor {
namespace {

bool has(const std::vector<WrittenIndex>& indices, const WrittenIndex& index) {
  return std::ranges::any_of(indices, [&](const WrittenIndex& other) {
    return other.text == index.text && other.primes == index.primes;
  });
}

bool stands_at(const SyntaxTree& syntax, SyntaxId id, const WrittenIndex& index) {
  switch (syntax[id].kind) {
    case SyntaxKind::symbol:
      return syntax.symbol(id).letter == index.text || has(syntax.symbol(id).lower, index);
    case SyntaxKind::component:
      return has(syntax.indices(id), index);
    case SyntaxKind::derivative: {
      return std::ranges::any_of(syntax.derivative(id).by,
                                 [&](const WrittenVariable& each) { return has(each.symbol.lower, index); });
    }
    default:
      return false;
  }
}

}  // namespace

Findings lint_sums(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  Findings findings;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    for (const SyntaxId id : nodes_below(syntax, statement.chain->sides)) {
      if (syntax[id].kind != SyntaxKind::big_sum) continue;
      const auto any = [&](const auto& predicate) {
        return std::ranges::any_of(nodes_below(syntax, {syntax.child(id, 0)}), predicate);
      };
      const bool unread = any([&](SyntaxId part) { return syntax[part].kind == SyntaxKind::opaque; });
      const bool counts = !any([&](SyntaxId part) { return syntax[part].kind == SyntaxKind::symbol; });
      if (unread || counts) continue;
      for (const WrittenIndex& index : syntax.big_sum(id).indices) {
        if (any([&](SyntaxId part) { return stands_at(syntax, part, index); })) continue;
        findings.push_back(
            {{DiagnosticKind::idle_sum,
              index.span,
              fmt::format("the sum is over `{}`, which does not occur in what is summed", index.text),
              {{syntax[syntax.child(id, 0)].span, ""}},
              {"a sum ends before the next `+` or `-`; brackets carry it further"}}});
      }
    }
  }
  return findings;
}

}  // namespace rigor
