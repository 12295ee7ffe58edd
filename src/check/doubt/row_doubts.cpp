// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/row_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "check/doubt/other_notation.h"
#include "elaborate/name/possible_ranks.h"
#include "latex/token/vocabulary.h"

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
  const auto unread = std::ranges::find_if(
      diagnostics, [](const Diagnostic& each) { return each.severity() == Severity::not_understood; });
  if (unread != diagnostics.end()) return OpenPart{unread->span, unread->message};
  const WrittenChain& written = parsed.written;
  if (written.condition) return OpenPart{written.condition_span, written.condition->message};
  if (written.doubt) return OpenPart{written.span, written.doubt->message};
  return std::nullopt;
}

/// `|n> = …`: the sign may close what the bar opens.
std::optional<OpenPart> angle(const WrittenChain& written) {
  const auto found = std::ranges::find_if(written.relations, [](const auto& relation) {
    return relation.kind == RelationKind::less || relation.kind == RelationKind::greater;
  });
  if (found == written.relations.end()) return std::nullopt;
  return OpenPart{found->span, fmt::format("`{}` can be a bracket", found->text)};
}

bool holds(const SyntaxTree& syntax, SyntaxId root, const std::function<bool(SyntaxId)>& is_it) {
  return std::ranges::any_of(nodes_below(syntax, {root}), is_it);
}

/// `\mathbf x \ge \mathbf 0`, `\mathbf x < 1`: in each component.
std::optional<OpenPart> order_of_components(const SyntaxTree& syntax, const Names& names,
                                            const ParsedChain& parsed, std::size_t which) {
  const WrittenRelation& relation = parsed.written.relations[which];
  if (!is_order(relation.kind) || relation.kind == RelationKind::unequal) return std::nullopt;
  const Letters letters = read_letters(syntax, parsed.sides, names);
  for (const SyntaxId side : {parsed.sides[which], parsed.sides[which + 1]}) {
    std::vector<OpenPart> open;
    const bool vector = (possible_ranks(syntax, side, letters, names, open) & 0b0010) != 0;
    if (!vector && syntax[side].kind != SyntaxKind::number) return std::nullopt;
  }
  return OpenPart{relation.span, "an order of vectors can be meant component by component"};
}

/// `A = (l, 0, 0)`, `X = \{a, b\}`, `\tau^3 = …` of a plain letter, whatever is bold elsewhere; `(a_m)_j` of
/// a vector with a number.
std::optional<OpenPart> open_letter(const SyntaxTree& syntax, const Names& names, const ParsedChain& parsed,
                                    std::size_t which) {
  for (const auto& [one, other] : {std::pair(which, which + 1), std::pair(which + 1, which)}) {
    SyntaxId alone = parsed.sides[one];
    if (syntax[alone].kind == SyntaxKind::power) alone = syntax.child(alone, 0);
    const SyntaxKind kind = syntax[parsed.sides[other]].kind;
    const bool table = kind == SyntaxKind::tuple || kind == SyntaxKind::matrix;
    const bool matrix = written_shape(syntax, parsed.sides[other]).any() &&
                        syntax[alone].kind == SyntaxKind::symbol &&
                        is_matrix_letter(syntax.symbol(alone), *names.symbols.evidence);
    if (matrix) continue;  // it was read as one
    if (!table || syntax[alone].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(alone);
    const bool declared = is_declared(names.symbols, {symbol.letter, 0, false});
    if (symbol.face != Face::plain || !symbol.lower.empty() || declared) continue;
    return OpenPart{syntax[alone].span, fmt::format("`{}` can be a point, a set or a matrix", symbol.letter)};
  }
  std::optional<OpenPart> found;
  for (const std::size_t side : {which, which + 1}) {
    holds(syntax, parsed.sides[side], [&](SyntaxId id) {
      if (syntax[id].kind != SyntaxKind::component) return false;
      SyntaxId inside = syntax.child(id, 0);
      if (syntax[inside].kind == SyntaxKind::group) inside = syntax.child(inside, 0);
      const bool labelled = syntax[inside].kind == SyntaxKind::symbol && !syntax.symbol(inside).lower.empty();
      if (labelled) found = OpenPart{syntax[inside].span, "this can be one of several vectors"};
      return labelled;
    });
  }
  return found;
}

/// `I_{Cij}`: a label and indices in one subscript.
std::optional<OpenPart> open_subscript(const SyntaxTree& syntax, const ParsedChain& parsed,
                                       std::size_t which) {
  std::optional<OpenPart> found;
  for (const std::size_t side : {which, which + 1}) {
    holds(syntax, parsed.sides[side], [&](SyntaxId id) {
      if (syntax[id].kind != SyntaxKind::symbol) return false;
      const std::vector<WrittenIndex>& lower = syntax.symbol(id).lower;
      for (const WrittenIndex& index : lower) {
        const bool capital =
            lower.size() > 1 && index.form == IndexForm::letter && is_capital_letter(index.text);
        if (capital) found = OpenPart{index.span, fmt::format("`{}` can be a label", index.text)};
        const bool word = index.form == IndexForm::word && !is_subscript_word(index.text) &&
                          index.text.find_first_of("ijklmn") != std::string::npos;
        if (word) found = OpenPart{index.span, fmt::format("`{}` can hold a label and indices", index.text)};
      }
      return found.has_value();
    });
  }
  return found;
}

/// `|\nu\vu|`: `\vu` of the physics package takes the bar, that of the author may take nothing.
std::optional<OpenPart> author_command(const WrittenChain& written) {
  for (const WrittenSide& side : written.sides) {
    for (std::size_t at = 0; at + 1 < side.tokens.size(); ++at) {
      const Token& command = side.tokens[at];
      const bool unit = is_control(command, "vu") || is_control(command, "vb") || is_control(command, "va");
      const std::size_t behind = skip_blank(side.tokens, at + 1);
      if (!unit || behind >= side.tokens.size()) continue;
      const Token& next = side.tokens[behind];
      const bool sign = next.kind == TokenKind::other || relation_kind(next).has_value();
      if (sign) return OpenPart{command.span, fmt::format("`\\{}` can be a macro of your own", command.text)};
    }
  }
  return std::nullopt;
}

/// `f(\mathbf r(u))`: a plain letter before a bracket that holds nothing but a function's value is one of its
/// own rather than a factor.
std::optional<OpenPart> open_argument(const SyntaxTree& syntax, const ParsedChain& parsed,
                                      std::size_t which) {
  const auto is_value = [&](SyntaxId id) {
    if (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
    if (syntax[id].kind != SyntaxKind::term || syntax.children(id).size() != 2) return false;
    const auto children = syntax.children(id);
    return syntax[children[0].id].kind == SyntaxKind::symbol && children[1].joint == Joint::juxtaposed &&
           syntax[children[1].id].kind == SyntaxKind::group;
  };
  std::optional<OpenPart> found;
  for (const std::size_t side : {which, which + 1}) {
    holds(syntax, parsed.sides[side], [&](SyntaxId id) {
      if (syntax[id].kind != SyntaxKind::term) return false;
      const auto children = syntax.children(id);
      for (std::size_t k = 1; k < children.size(); ++k) {
        const SyntaxId letter = children[k - 1].id;
        const bool applied = syntax[letter].kind == SyntaxKind::symbol &&
                             syntax.symbol(letter).face == Face::plain &&
                             children[k].joint == Joint::juxtaposed &&
                             syntax[children[k].id].kind == SyntaxKind::group && is_value(children[k].id);
        if (applied)
          found = OpenPart{syntax[letter].span, "this letter can be a function of what follows it"};
      }
      return found.has_value();
    });
  }
  return found;
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
  if (open.empty()) return OpenPart{parsed.written.relations[which].span, "in another reading its ranks fit"};
  return open.front();
}

}  // namespace

bool can_be_labels(const SyntaxTree& syntax, const ParsedChain& parsed, std::size_t which) {
  std::array<std::set<std::string>, 2> letters;
  for (const std::size_t k : {0, 1}) {
    holds(syntax, parsed.sides[which + k], [&](SyntaxId id) {
      if (syntax[id].kind != SyntaxKind::symbol) return false;
      for (const WrittenIndex& index : syntax.symbol(id).lower) letters[k].insert(index.text);
      return false;
    });
  }
  return letters[0] == letters[1];
}

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
  const bool any =
      std::ranges::any_of(diagnostics, [](const Diagnostic& each) { return is_malformation(each.kind); });
  if (!any) return;
  const std::optional<OpenPart> row = unread_part(syntax, parsed, diagnostics);
  for (Diagnostic& diagnostic : diagnostics) {
    if (!is_malformation(diagnostic.kind)) continue;
    std::optional<OpenPart> open = row;
    const bool broken =
        diagnostic.kind == DiagnosticKind::unbalanced || diagnostic.kind == DiagnosticKind::bad_syntax;
    if (!open && broken) open = angle(parsed.written);
    if (!open && broken) open = author_command(parsed.written);
    const bool step = which + 1 < parsed.sides.size();
    if (!open && step && diagnostic.kind == DiagnosticKind::rank_mismatch) {
      open = order_of_components(syntax, names, parsed, which);
      if (!open) open = open_letter(syntax, names, parsed, which);
      if (!open) open = open_argument(syntax, parsed, which);
      if (!open) open = other_kind(syntax, names, parsed, which);
      if (!open) open = open_rank(syntax, names, parsed, which);
    }
    if (!open && step && diagnostic.kind == DiagnosticKind::free_index_mismatch) {
      open = open_subscript(syntax, parsed, which);
      if (!open) open = other_subscript(syntax, names, parsed, which, diagnostic.span);
    }
    if (!open) continue;
    diagnostic.kind = broken ? DiagnosticKind::unsupported : DiagnosticKind::ambiguous_reading;
    diagnostic.message += ", if this is the right reading: " + open->doubt;
    diagnostic.labels.push_back({open->span, "this can be read in two ways"});
  }
}

}  // namespace rigor
