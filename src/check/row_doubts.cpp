// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/row_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "check/chain_reading.h"
#include "elaborate/possible_ranks.h"

namespace rigor {
namespace {

/// The first thing in the row that was not read, or was read as one of two.
std::optional<OpenPart> unread_part(const SyntaxTree& syntax, const ParsedChain& parsed,
                                    const Diagnostics& diagnostics) {
  std::vector<SyntaxId> pending(parsed.sides.rbegin(), parsed.sides.rend());
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
    if (syntax[id].kind != SyntaxKind::opaque || is_malformation(syntax.obstacle(id).kind)) continue;
    return OpenPart{syntax[id].span, syntax.obstacle(id).message};
  }
  const auto unread = std::find_if(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& each) {
    return each.severity() == Severity::not_understood && each.kind != DiagnosticKind::undeclared_symbol;
  });
  if (unread != diagnostics.end()) return OpenPart{unread->span, unread->message};
  const WrittenChain& written = parsed.written;
  if (written.condition) return OpenPart{written.condition_span, written.condition->message};
  if (written.doubt) return OpenPart{written.span, written.doubt->message};
  return std::nullopt;
}

/// `|n> = …`: the sign may close what the bar opens.
std::optional<OpenPart> angle(const WrittenChain& written) {
  const auto found =
      std::find_if(written.relations.begin(), written.relations.end(), [](const auto& relation) {
        return relation.kind == RelationKind::less || relation.kind == RelationKind::greater;
      });
  if (found == written.relations.end()) return std::nullopt;
  return OpenPart{found->span, fmt::format("`{}` can be a bracket", found->text)};
}

/// Numbers have an order, and symmetric matrices.
bool has_order(RankSet ranks) { return (ranks & 0b0101) != 0; }

/// Nothing, if the ranks of the step fit in no reading.
std::optional<OpenPart> open_rank(const SyntaxTree& syntax, const Names& names, const ParsedChain& parsed,
                                  std::size_t which) {
  const Letters letters = read_letters(syntax, parsed.sides, names);
  std::vector<OpenPart> open;
  const RankSet left = possible_ranks(syntax, parsed.sides[which], letters, names, open);
  const RankSet right = possible_ranks(syntax, parsed.sides[which + 1], letters, names, open);
  const bool fits = is_order(parsed.written.relations[which].kind) &&
                            parsed.written.relations[which].kind != RelationKind::unequal
                        ? has_order(static_cast<RankSet>(left & right))
                        : (left & right) != no_rank;
  if (!fits) return std::nullopt;
  if (open.empty())
    return OpenPart{parsed.written.relations[which].span, "another reading of it has fitting ranks"};
  return open.front();
}

}  // namespace

bool is_malformation(DiagnosticKind kind) {
  switch (kind) {
    case DiagnosticKind::bad_syntax:
    case DiagnosticKind::unbalanced:
    case DiagnosticKind::free_index_mismatch:
    case DiagnosticKind::index_repeats:
    case DiagnosticKind::index_clash:
    case DiagnosticKind::rank_mismatch:
      return true;
    default:
      return false;
  }
}

void doubt_errors(const SyntaxTree& syntax, const Names& names, const ParsedChain& parsed, std::size_t which,
                  Diagnostics& diagnostics) {
  const bool any = std::any_of(diagnostics.begin(), diagnostics.end(),
                               [](const Diagnostic& each) { return is_malformation(each.kind); });
  if (!any) return;
  const std::optional<OpenPart> row = unread_part(syntax, parsed, diagnostics);
  for (Diagnostic& diagnostic : diagnostics) {
    if (!is_malformation(diagnostic.kind)) continue;
    std::optional<OpenPart> open = row;
    const bool broken =
        diagnostic.kind == DiagnosticKind::unbalanced || diagnostic.kind == DiagnosticKind::bad_syntax;
    if (!open && broken) open = angle(parsed.written);
    if (!open && diagnostic.kind == DiagnosticKind::rank_mismatch && which + 1 < parsed.sides.size())
      open = open_rank(syntax, names, parsed, which);
    if (!open) continue;
    diagnostic.kind = broken ? DiagnosticKind::unsupported : DiagnosticKind::ambiguous_reading;
    diagnostic.message += ", if the row is read rightly: " + open->doubt;
    diagnostic.labels.push_back({open->span, "this is open"});
  }
}

}  // namespace rigor
