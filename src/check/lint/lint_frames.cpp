// SPDX-License-Identifier: GPL-3.0-or-later
// Two frames in one sum: `A_1 + B_{1'}`, a component along the fixed axes and one along the primed ones, or
// the rates of two quantities in two frames. Equations that carry one frame's components or rates into the
// other do add them, but have direction cosines or angles, respectively a cross product, or speak of one
// quantity only.
#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"

namespace rigor {
namespace {

bool is_axis(const WrittenIndex& index) {
  return (index.form == IndexForm::digit && index.text >= "1" && index.text <= "3") ||
         (index.form == IndexForm::letter && index.text.size() == 1 && index.text >= "x" &&
          index.text <= "z");
}

/// Said in a frame: a component along a numbered axis, or a rate.
struct Framed {
  std::string frame;
  std::string quantity;
  Span place;
  bool is_rate = false;
};

std::optional<Framed> framed(const LintInput& input, SyntaxId id) {
  const SyntaxTree& syntax = input.notes.syntax;
  if (syntax[id].kind == SyntaxKind::symbol) {
    const WrittenSymbol& symbol = syntax.symbol(id);
    if (symbol.face != Face::plain || symbol.lower.empty() || !is_axis(symbol.lower.back()))
      return std::nullopt;
    return Framed{symbol.lower.back().primes > 0 ? "primed" : "", symbol.letter, syntax[id].span};
  }
  if (syntax[id].kind != SyntaxKind::component || syntax.indices(id).size() != 1) return std::nullopt;
  const WrittenIndex& label = syntax.indices(id)[0];
  if (label.form != IndexForm::word) return std::nullopt;
  for (const SyntaxId below : nodes_below(syntax, {id})) {
    if (syntax[below].kind != SyntaxKind::derivative) continue;
    return Framed{label.text, std::string(input.sources.text(syntax[syntax.child(below, 0)].span)),
                  syntax[id].span, true};
  }
  return std::nullopt;
}

/// What a term says in a frame, if it is one thing.
std::optional<Framed> only_framed(const LintInput& input, SyntaxId term) {
  std::optional<Framed> only;
  for (const SyntaxId id : nodes_below(input.notes.syntax, {term})) {
    const auto found = framed(input, id);
    if (!found) continue;
    if (only) return std::nullopt;
    only = found;
  }
  return only;
}

/// Does the statement carry components or rates over?
bool carries_over(const SyntaxTree& syntax, const std::vector<SyntaxId>& nodes, bool rates) {
  return std::ranges::any_of(nodes, [&](SyntaxId id) {
    if (rates) {
      return std::ranges::any_of(syntax.children(id),
                                 [](const SyntaxChild& child) { return child.joint == Joint::cross; });
    }
    if (syntax[id].kind == SyntaxKind::function) return true;
    if (syntax[id].kind != SyntaxKind::symbol || syntax.symbol(id).lower.size() != 2) return false;
    const auto& lower = syntax.symbol(id).lower;
    return (lower[0].primes > 0) != (lower[1].primes > 0);
  });
}

/// Where a symbol with a digit was read as a component, and not as a symbol with a label.
std::set<Extent> components_in(const LintInput& input) {
  std::set<Extent> components;
  for (const StatedEquation& stated : input.stated) {
    for (const ExprId id : nodes_below(input.tree, {stated.left, stated.right})) {
      const bool axis =
          std::ranges::any_of(input.tree.slots(id), [](const Slot& slot) { return slot.axis != 0; });
      if (axis) components.insert(extent_of(input.tree[id].span));
    }
  }
  return components;
}

}  // namespace

Findings lint_frames(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  const std::set<Extent> components = components_in(input);
  Findings findings;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    const std::vector<SyntaxId> nodes = nodes_below(syntax, statement.chain->sides);
    for (const SyntaxId sum : nodes) {
      if (syntax[sum].kind != SyntaxKind::sum) continue;
      std::optional<Framed> first;
      for (const SyntaxChild& term : syntax.children(sum)) {
        const auto found = only_framed(input, term.id);
        if (!found || (!found->is_rate && !components.contains(extent_of(found->place)))) continue;
        if (!first) first = found;
        const bool mixed = found->is_rate == first->is_rate && found->frame != first->frame &&
                           found->quantity != first->quantity;
        if (!mixed || carries_over(syntax, nodes, found->is_rate)) continue;
        findings.push_back({{DiagnosticKind::mixed_frames,
                             found->place,
                             found->is_rate ? "rates in two frames are added"
                                            : "components along primed and unprimed axes are added",
                             {{first->place, ""}},
                             {"transform one of them first"}}});
        break;
      }
    }
  }
  return findings;
}

}  // namespace rigor
