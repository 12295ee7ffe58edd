// SPDX-License-Identifier: GPL-3.0-or-later
// `\mathbf A = 0`, where the zero vector is meant. Most notes write it so. It is a slip only in notes that
// write `\mathbf 0` somewhere, or that ask for this warning.
#include <algorithm>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"

namespace rigor {
namespace {

bool is_plain_zero(std::string_view written) { return written == "0"; }

/// Does a display write a zero that is set as a vector?
bool writes_vector_zero(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    const bool found = std::ranges::any_of(nodes_below(syntax, statement.chain->sides), [&](SyntaxId id) {
      return syntax[id].kind == SyntaxKind::number && syntax.text(id) == "0" &&
             input.sources.text(syntax[id].span).starts_with('\\');
    });
    if (found && statement.displayed) return true;
  }
  return false;
}

}  // namespace

Findings lint_zeros(const LintInput& input) {
  const bool certain = writes_vector_zero(input);
  Findings findings;
  for (const StatedEquation& stated : input.stated) {
    const ExprTree& tree = input.tree;
    const bool zero_right = tree.is_zero_literal(stated.right);
    const ExprId zero = zero_right ? stated.right : stated.left;
    const ExprId other = zero_right ? stated.left : stated.right;
    const bool vector_is_number = tree.is_zero_literal(zero) && tree[other].rank == 1 &&
                                  is_plain_zero(input.sources.text(tree[zero].span));
    if (!vector_is_number) continue;
    findings.push_back({{DiagnosticKind::scalar_zero,
                         tree[zero].span,
                         "a vector is set equal to the number `0`",
                         {{tree[other].span, ""}},
                         {"write `\\mathbf{0}`"}},
                        certain && stated.by_notes});
  }
  return findings;
}

}  // namespace rigor
