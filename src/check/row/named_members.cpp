// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/row/named_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/ascii.h"
#include "check/row/row.h"
#include "expr/calculus/differentiate.h"
#include "expr/tree/latex_name.h"

namespace rigor {
namespace {

std::string bare_label(std::string label) {
  std::erase_if(label, [](char c) { return c == '{' || c == '}' || c == ' '; });
  return label;
}

/// `E` and `1` of E_1; the label is a small whole number.
std::optional<LatexName> counted_name(const std::string& name) {
  LatexName parts = latex_name(name);
  parts.labels = bare_label(parts.labels);
  const bool number = !parts.labels.empty() && parts.labels.size() <= 2 &&
                      std::ranges::all_of(parts.labels, is_digit) && parts.primes.empty() &&
                      parts.behind.empty();
  return number ? std::optional(std::move(parts)) : std::nullopt;
}

/// What is said of all members: `E_n = …`, with the letter that counts in its body.
std::optional<ExprId> body_of_member(ExprTree& tree, SymbolId member, SymbolId general, ExprId body) {
  const auto own = counted_name(tree.symbols[member].name);
  LatexName other = latex_name(tree.symbols[general].name);
  other.labels = bare_label(other.labels);
  const bool letter = other.labels.size() == 1 && is_letter(other.labels[0]);
  if (!own || !letter || other.letter != own->letter || !other.primes.empty()) return std::nullopt;
  bool counts = false;
  const ExprId with_number = replaced(tree, body, [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = tree[id];
    if (node.op != Op::symbol || tree.symbols[node.symbol].name != other.labels) return std::nullopt;
    counts = true;
    return tree.add_number(node.span, own->labels);
  });
  return counts ? std::optional(with_number) : std::nullopt;
}

/// By a line, a definition in scope or a law above.
void define_member(RowPlace& place, Names& names, SymbolId letter, const std::vector<GivenValue>& lines) {
  ExprTree& tree = place.tree;
  std::optional<NamedDefinition> found;
  for (const GivenValue& said : lines) {
    if (said.letter == letter && tree[said.number].rank == 0)
      found = NamedDefinition{{letter, {}, no_particle, said.number}, Origin{said.text, {}, std::nullopt}};
  }
  for (const NamedDefinition& named : names.scope.definitions) {
    if (!named.definition.indices.empty() || named.definition.by_square) continue;
    const auto body = body_of_member(tree, letter, named.definition.symbol, named.definition.body);
    if (body) found = NamedDefinition{{letter, {}, no_particle, *body}, named.origin};
  }
  for (const StatedLaw& stated : place.above.stated) {
    const PageLaw& law = stated.law;
    if (!place.notes.prose.sections.reaches(law.place, beside(place).place)) continue;
    const Origin origin{law.name, {}, std::nullopt};
    const auto general = bare_letter(tree, law.equation.left);
    const auto body =
        general ? body_of_member(tree, letter, *general, law.equation.right) : std::optional<ExprId>();
    if (body) found = NamedDefinition{{letter, {}, no_particle, *body}, origin};
    const ExprNode left = tree[law.equation.left];
    const bool square = left.op == Op::power && left.exponent == 2 &&
                        bare_letter(tree, tree.children(law.equation.left)[0]) == letter &&
                        law.equation.relation == Relation::equal;
    if (!square) continue;
    const ExprId root = tree.add({.op = Op::root, .span = left.span}, std::span(&law.equation.right, 1));
    found = NamedDefinition{
        {letter, {}, no_particle, root},
        Origin{fmt::format("{}, where `{}` is not negative", law.name, tree.symbols[letter].name),
               {},
               std::nullopt}};
  }
  if (!found) return;
  const std::vector<SymbolId> reached = symbols_reached(tree, names.scope, {found->definition.body});
  if (std::ranges::find(reached, letter) == reached.end()) define(names.scope, *std::move(found));
}

}  // namespace

Names with_members(RowPlace& place, Names names, ExprId value, const std::vector<GivenValue>& lines) {
  constexpr int deepest_member = 4;
  std::vector<SymbolId> tried;
  for (int round = 0; round < deepest_member; ++round) {
    bool more = false;
    for (const SymbolId each : symbols_reached(place.tree, names.scope, {value})) {
      const bool known = place.tree.symbols[each].is_fixed() || body_of_definition(names.scope, each) ||
                         std::ranges::find(tried, each) != tried.end();
      if (known) continue;
      tried.push_back(each);
      define_member(place, names, each, lines);
      more = true;
    }
    if (!more) break;
  }
  return names;
}

}  // namespace rigor
