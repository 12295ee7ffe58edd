// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a longer chain that repeats its left side sign for sign: `L = I\omega = I\omega`. The step is
// proved, but a line was perhaps copied and never changed. Alone, `0 = 0` and `a\omega = a\omega` are what a
// test of a solution ends with, so a chain of one step is left alone.
#include <algorithm>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"
#include "latex/reading/rewritings.h"
#include "latex/token/tokens.h"

namespace rigor {
namespace {

/// Without spaces; sizes of brackets are gone already. The braces stay: `x^{12}` is not `x^12`.
std::string signs_of(const WrittenSide& side) {
  Tokens signs = without_layout(side.tokens);
  std::erase_if(signs, is_spacing);
  return text_of(signs);
}

/// Numbers alone are said again on purpose, and nothing is said of what is not read.
bool has_letters(const SyntaxTree& syntax, SyntaxId side) {
  const std::vector<SyntaxId> nodes = nodes_below(syntax, {side});
  const auto any = [&](SyntaxKind kind) {
    return std::any_of(nodes.begin(), nodes.end(), [&](SyntaxId id) { return syntax[id].kind == kind; });
  };
  return any(SyntaxKind::symbol) && !any(SyntaxKind::opaque);
}

}  // namespace

Findings lint_repeats(const LintInput& input) {
  Findings findings;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    const WrittenChain& chain = statement.chain->written;
    if (!statement.displayed || chain.relations.size() < 2) continue;
    for (std::size_t k = 0; k < chain.relations.size(); ++k) {
      const WrittenSide& left = chain.sides[k];
      const WrittenSide& right = chain.sides[k + 1];
      const RelationKind relation = chain.relations[k].kind;
      const bool says_alike = is_equality(relation) || relation == RelationKind::nearly;
      if (!says_alike || !has_letters(input.notes.syntax, statement.chain->sides[k])) continue;
      if (signs_of(left) != signs_of(right)) continue;
      findings.push_back({{DiagnosticKind::repeated_side,
                           right.span,
                           "the step repeats its left side",
                           {{left.span, ""}},
                           {"write what the step is to show, or take one of the two out"}}});
    }
  }
  return findings;
}

}  // namespace rigor
