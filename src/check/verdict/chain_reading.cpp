// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/chain_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "check/verdict/antiderivatives.h"
#include "elaborate/notation/differential.h"
#include "elaborate/notation/elaborate.h"
#include "elaborate/reading/equation.h"
#include "elaborate/reading/space_time.h"
#include "expr/calculus/differentiate.h"
#include "latex/reading/rewritings.h"

namespace rigor {
namespace {

/// Vectors and tensors are unequal as a whole: a ≠ b says Σ (a − b)² ≠ 0, over all components.
Equation as_squared_distance(ExprTree& tree, Equation unequal) {
  const Span span = tree[unequal.left].span;
  std::vector<Slot> slots;
  for (int axis = 0; axis < tree[unequal.left].rank; ++axis)
    slots.push_back({0, tree.add_index("i", tree[unequal.left].axes[axis])});
  ExprId value = component_of(tree, unequal.left, slots);
  if (!tree.is_zero_literal(unequal.right)) {
    const ExprId right = component_of(tree, unequal.right, slots);
    const std::array terms{value, tree.add({.op = Op::negate, .span = span}, std::span(&right, 1))};
    value = tree.add({.op = Op::add, .span = span}, terms);
  }
  value = tree.add({.op = Op::power, .span = span, .exponent = 2}, std::span(&value, 1));
  for (const Slot& slot : slots)
    value = tree.add({.op = Op::index_sum, .span = span, .index = slot.variable}, std::span(&value, 1));
  unequal.left = value;
  unequal.right = tree.add_number(span, "0");
  return unequal;
}

Relation relation_of(RelationKind kind) {
  switch (kind) {
    case RelationKind::less:
    case RelationKind::greater:
      return Relation::less;
    case RelationKind::less_or_equal:
    case RelationKind::greater_or_equal:
      return Relation::less_or_equal;
    case RelationKind::unequal:
      return Relation::unequal;
    default:
      return Relation::equal;
  }
}

/// `A_{i'} = \lambda_{ij}A_j`: on the rotation itself a prime says which axis is meant, and none may be left
/// out.
bool drops_prime_on_rotation(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides,
                             const Names& names) {
  const auto rotation = names.symbols.primed_axes;
  const NameKey* key = rotation ? key_of(names.symbols, *rotation) : nullptr;
  if (key == nullptr) return false;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(id);
    const bool bare = std::ranges::all_of(symbol.lower, [](const WrittenIndex& index) {
      return index.form == IndexForm::letter && index.primes == 0;
    });
    if (symbol.lower.size() == 2 && bare && letter_with_marks(symbol) == key->base) return true;
  }
  return false;
}

/// The step on one line; none where words next to it, or another order of its axes, belong to it.
std::string written_step(const ParsedChain& parsed, std::size_t which) {
  const WrittenChain& chain = parsed.written;
  const Tokens left = without_layout(chain.sides[which].tokens);
  const Tokens right = without_layout(chain.sides[which + 1].tokens);
  if (parsed.image != 0 || chain.no_sum || chain.cyclic || left.empty() || right.empty()) return {};
  return text_of(left) + " " + chain.relations[which].text + " " + text_of(right);
}

/// The indices of a node that no sum below it runs over; each node is visited once. Recursion: as deep as the
/// tree.
const std::set<IndexId>& free_indices(const ExprTree& tree, ExprId id,
                                      std::map<ExprId, std::set<IndexId>>& known) {
  if (const auto found = known.find(id); found != known.end()) return found->second;
  std::set<IndexId> free;
  for (const Slot& slot : tree.slots(id)) {
    if (slot.axis == 0) free.insert(slot.variable);
  }
  for (const ExprId child : tree.children(id)) {
    const std::set<IndexId>& below = free_indices(tree, child, known);
    free.insert(below.begin(), below.end());
  }
  if (tree[id].op == Op::index_sum) free.erase(tree[id].index);
  return known[id] = std::move(free);
}

/// An index that neither a sum nor the equation runs over; nothing as a rule.
std::optional<IndexId> unbound_index(const ExprTree& tree, const Equation& equation) {
  const auto has_index = [&](ExprId id) {
    return std::ranges::any_of(tree.slots(id), [](const Slot& slot) { return slot.axis == 0; });
  };
  if (std::ranges::none_of(nodes_below(tree, {equation.left, equation.right}), has_index))
    return std::nullopt;
  std::map<ExprId, std::set<IndexId>> known;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const IndexId index : free_indices(tree, side, known)) {
      if (!is_one_of(index, equation.indices)) return index;
    }
  }
  return std::nullopt;
}

}  // namespace

ChainReading::ChainReading(const SyntaxTree& syntax, ExprTree& tree, Names& names, const ParsedChain& parsed,
                           const ReadingRules& how)
    : tree_(tree), reading_{syntax, tree, names, read_letters(syntax, parsed.sides, names), own_, how} {
  reading_.rules.differentials = reads_differentials(syntax, parsed.sides, names);
  for (const SyntaxId id : parsed.sides) {
    Side side;
    side.typed = read(id);
    side.diagnostics = std::exchange(own_, {});
    sides.push_back(std::move(side));
  }
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k - 1].typed && sides[k].typed)
      match_components(reading_, *sides[k - 1].typed, *sides[k].typed);
  }
}

std::optional<Typed> ChainReading::read(SyntaxId id) {
  Around around;
  if (!sides.empty() && sides[0].typed) around.slots = sides[0].typed->free;
  return elaborate(reading_, id, around);
}

std::optional<Claim> ChainReading::claim(const ParsedChain& parsed, std::size_t which, bool first_order,
                                         Diagnostics& diagnostics) {
  return claim(parsed, which, *sides[which].typed, *sides[which + 1].typed, first_order, diagnostics);
}

std::optional<Claim> ChainReading::claim(const ParsedChain& parsed, std::size_t which, const Typed& left,
                                         const Typed& right, bool first_order, Diagnostics& diagnostics) {
  const WrittenRelation& relation = parsed.written.relations[which];
  const bool swapped =
      relation.kind == RelationKind::greater || relation.kind == RelationKind::greater_or_equal;
  const Mismatch place{relation.span, diagnostics};
  auto equation = equate(reading_, swapped ? right : left, swapped ? left : right, place);
  if (!equation) return std::nullopt;
  equation->relation = relation_of(relation.kind);
  if (const auto index = unbound_index(tree_, *equation)) {
    diagnostics.push_back({DiagnosticKind::ambiguous_reading, relation.span,
                           fmt::format("`{}` is an index on one side, and nothing says what it runs over",
                                       tree_.name(*index))});
    return std::nullopt;
  }
  const bool unequal = relation.kind == RelationKind::unequal;
  if (is_order(relation.kind) && !unequal && tree_[equation->left].rank > 0) {
    diagnostics.push_back(
        {DiagnosticKind::rank_mismatch, relation.span, "vectors and tensors have no order"});
    return std::nullopt;
  }
  if (unequal && !equation->indices.empty()) {
    diagnostics.push_back({DiagnosticKind::ambiguous_reading,
                           relation.span,
                           "with a free index, unequal can mean every component or the whole",
                           {},
                           {"without indices the whole is meant, as in `\\mathbf{A} \\ne 0`",
                            "with digits a component is meant, as in `A_1 \\ne 0`"}});
    return std::nullopt;
  }
  std::string derived_by;
  if (has_antiderivative(tree_, equation->left) || has_antiderivative(tree_, equation->right)) {
    std::vector<ExprId> all{left.id, right.id};
    for (const Side& side : sides) {
      if (side.typed) all.push_back(side.typed->id);
    }
    auto derivatives = differentiated(reading_, *equation, all, relation.span, diagnostics);
    if (!derivatives) return std::nullopt;
    *equation = std::move(derivatives->equation);
    derived_by = std::move(derivatives->by);
  }
  const bool as_a_whole = unequal && tree_[equation->left].rank > 0;
  if (as_a_whole) *equation = as_squared_distance(tree_, *equation);
  const bool nearly = relation.kind == RelationKind::nearly || (first_order && !is_order(relation.kind));
  return Claim{.equation = *equation,
               .nearly = nearly,
               .swapped = swapped,
               .for_all = for_all,
               .as_a_whole = as_a_whole,
               .derived_by = derived_by,
               .relation = relation.span,
               .left = parsed.written.sides[which].span,
               .right = parsed.written.sides[which + 1].span,
               .written = written_step(parsed, which),
               .reading = &reading_,
               .doubt = parsed.written.doubt ? &*parsed.written.doubt : nullptr,
               .alternative = parsed.written.alternative,
               .digits_go_on = parsed.written.digits_go_on};
}

bool ChainReading::is_balanced() const {
  std::optional<std::set<std::string>> first;
  for (const Side& side : sides) {
    if (!side.typed) return false;
    std::set<std::string> own;
    for (const FreeIndex& free : side.typed->free) own.insert(free.letter);
    if (is_literal_zero(tree_, *side.typed)) continue;
    if (first && *first != own) return false;
    first = own;
  }
  return true;
}

std::unique_ptr<ChainReading> read_chain(const SyntaxTree& syntax, ExprTree& tree, Names& names,
                                         const ParsedChain& parsed, ReadingRules plain) {
  const auto read = [&](const ReadingRules& how) {
    return std::make_unique<ChainReading>(syntax, tree, names, parsed, how);
  };
  plain.no_sum = parsed.written.no_sum;
  auto first = read(plain);
  if (parsed.sides.size() < 2 || first->is_balanced()) return first;
  ReadingRules unsummed = plain;
  const bool all_read =
      std::ranges::all_of(first->sides, [](const auto& side) { return side.typed.has_value(); });
  for (const ChainReading::Side& side : first->sides) {
    if (!all_read) break;
    for (const FreeIndex& free : side.typed->free) {
      if (first->reading().found.summed_letters.contains(free.letter)) unsummed.unsummed.insert(free.letter);
    }
  }
  ReadingRules primes = plain;
  primes.primes_on_axes = !drops_prime_on_rotation(syntax, parsed.sides, names);
  for (const ReadingRules& other : {unsummed, primes}) {
    const bool differs = !other.unsummed.empty() || other.primes_on_axes;
    if (!differs) continue;
    auto again = read(other);
    if (!again->is_balanced()) {
      first->add_used(again->used());
      continue;
    }
    again->add_used(first->used());
    return again;
  }
  return first;
}

}  // namespace rigor
