// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/known_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/differentiate.h"
#include "expr/tree/rough_value.h"

namespace rigor {
namespace {

bool is_whole(const FoundDefinition& of) {
  return !of.at_instant && !of.definition.by_square && of.definition.indices.empty() &&
         of.definition.particle == no_particle;
}

std::optional<SymbolId> letter_named(const Names& names, const std::string& letter) {
  return find_symbol(names.symbols, {letter, 0, false});
}

/// m of `E_m - E_n = \hbar\omega(m - n)`: beside another member, and a number here or in the section.
bool stands_for_a_number(const ExprTree& tree, const Names& names, SymbolId member, const Membership& of,
                         const std::string& letter, const Equation& claim) {
  const std::vector<SymbolId> all = symbols_reached(tree, names.scope, {claim.left, claim.right});
  const bool in_company = std::ranges::any_of(all, [&](SymbolId each) {
    const NameKey* key = each == member ? nullptr : key_of(names.symbols, each);
    const auto other = key == nullptr ? std::nullopt : member_name(*key);
    return other && other->sequence == of.name.sequence;
  });
  const auto& counting = names.symbols.evidence->counting;
  const auto found = counting.find(letter);
  if (!in_company || (found != counting.end() && found->second.some_only)) return false;
  const auto symbol = letter_named(names, letter);
  return (found != counting.end() && found->second.said) || (symbol && is_one_of(*symbol, all));
}

/// Does the body have a part that changes with the letter in a way that is not written: `k_n`, an integral, a
/// derivative?
bool hides_letter(const ExprTree& tree, const Names& names, ExprId body, const Family& family) {
  return std::ranges::any_of(symbols_in(tree, body), [&](SymbolId each) {
    const Symbol& symbol = tree.symbols[each];
    if (symbol.derivation || symbol.integral || names.symbols.function_values.contains(each)) return true;
    const NameKey* key = key_of(names.symbols, each);
    if (key == nullptr) return true;
    const auto behind = key->base.find_first_of("_^");
    if (behind == std::string::npos) return false;
    const auto name = member_name(*key);
    if (name) return name->letters.contains(family.letter);
    return key->base.find(family.letter, behind) != std::string::npos;
  });
}

/// `2n+1`; nothing where one of its letters is no number.
std::optional<ExprId> index_of(ExprTree& tree, const Names& names, const MemberName& name, Span span) {
  std::vector<ExprId> terms;
  for (const auto& [letter, factor] : name.letters) {
    const auto symbol = letter_named(names, letter);
    if (!symbol || definition_of(names.scope, *symbol) != nullptr) return std::nullopt;
    ExprId term = tree.add({.op = Op::symbol, .span = span, .symbol = *symbol});
    if (std::abs(factor) != 1) {
      const std::array parts{tree.add_number(span, std::to_string(std::abs(factor))), term};
      term = tree.add({.op = Op::multiply, .span = span}, parts);
    }
    terms.push_back(factor < 0 ? tree.add({.op = Op::negate, .span = span}, std::span(&term, 1)) : term);
  }
  if (name.number != 0 || terms.empty()) {
    ExprId term = tree.add_number(span, std::to_string(std::abs(name.number)));
    terms.push_back(name.number < 0 ? tree.add({.op = Op::negate, .span = span}, std::span(&term, 1)) : term);
  }
  return terms.size() == 1 ? terms[0] : tree.add({.op = Op::add, .span = span}, terms);
}

/// Zero or infinite for all values of its letters.
bool is_void(const ExprTree& tree, ExprId body) {
  double next = 1.3;
  std::map<SymbolId, double> values;
  const double value = rough_value(
      tree, body, [&](SymbolId symbol) { return values.try_emplace(symbol, next += 0.37).first->second; });
  constexpr double smallest = 1e-12;
  return std::isinf(value) || std::abs(value) < smallest;
}

bool divides_by_zero(const ExprTree& tree, ExprId body) {
  const ExprNode& node = tree[body];
  const auto children = tree.children(body);
  if (node.op == Op::divide && is_void(tree, children[1])) return true;
  return std::ranges::any_of(children, [&](ExprId child) { return divides_by_zero(tree, child); });
}

/// With an axis in the place of these indices. Recursion: as deep as the tree.
ExprId along_axis(ExprTree& tree, ExprId id, const std::vector<IndexId>& indices, std::uint8_t axis) {
  std::vector<ExprId> children(tree.children(id).begin(), tree.children(id).end());
  std::vector<Slot> slots(tree.slots(id).begin(), tree.slots(id).end());
  bool differs = false;
  for (ExprId& child : children) {
    const ExprId own = std::exchange(child, along_axis(tree, child, indices, axis));
    differs = differs || own != child;
  }
  for (Slot& slot : slots) {
    if (slot.axis != 0 || !is_one_of(slot.variable, indices)) continue;
    slot = {axis};
    differs = true;
  }
  const ExprNode node = tree[id];
  return differs ? tree.add(node, children, slots) : id;
}

/// `f'` of `f(x)`, where x, y and z are places: the derivative along the axis of the only variable.
FoundDefinition along_its_variable(ExprTree& tree, const FunctionValue& value, FoundDefinition of) {
  const auto& derivation = tree.symbols[value.of].derivation;
  const bool by_place = derivation && derivation->by.count(By::space) == derivation->by.size() &&
                        tree.symbols[derivation->base].rank == 0;
  if (!by_place || value.variables.size() != 1 || !is_one_of(value.variables[0], {"x", "y", "z"})) return of;
  const auto axis = static_cast<std::uint8_t>(value.variables[0][0] - 'x' + 1);
  of.definition.body = along_axis(tree, of.definition.body, of.definition.indices, axis);
  of.definition.indices.clear();
  return of;
}

}  // namespace

std::optional<FoundDefinition> value_of_function(ExprTree& tree, const Names& names, SymbolId symbol,
                                                 const FunctionValue& value, const FoundDefinition& written,
                                                 const KnownValues& known) {
  const FoundDefinition of = along_its_variable(tree, value, written);
  if (!is_whole(of) || value.variables.size() != value.at.size()) return std::nullopt;
  const auto is_elsewhere = [&](ExprId at) { return tree[at].op != Op::symbol && tree[at].op != Op::number; };
  if (of.origin->of_a_region && std::ranges::any_of(value.at, is_elsewhere)) return std::nullopt;  // `E(R/2)`
  std::map<SymbolId, ExprId> at;
  for (std::size_t k = 0; k < value.at.size(); ++k) {
    const auto variable = letter_named(names, value.variables[k]);
    if (!variable) return std::nullopt;
    at.emplace(*variable, value.at[k]);
  }
  const bool in_time = value.variables == std::vector<std::string>{"t"};
  const auto is_held = [&](SymbolId each) {
    return std::ranges::all_of(at, [&](const auto& entry) {
      return known.is_held(of, each, in_time ? Variable(By::time) : Variable(By::letter, entry.first));
    });
  };
  // s of `f(s)`, where `f(x) = a + b(x - s)`: a place of f, which does not follow the variable.
  const auto is_where = [&](SymbolId each) {
    const NameKey* key = key_of(names.symbols, each);
    if (key == nullptr) return false;
    const auto tied = names.symbols.evidence->tied.find(changing_name(key->base));  // `s = \alpha x`
    return (tied == names.symbols.evidence->tied.end() || tied->second.empty()) &&
           !has_rate(*names.symbols.sightings, *key) &&
           std::ranges::any_of(
               value.at,
               [&](ExprId where) { return tree[where].op == Op::symbol && tree[where].symbol == each; }) &&
           std::ranges::none_of(value.variables, [&](const std::string& variable) {
             return is_function_of(*names.symbols.evidence, key->base, variable);
           });
  };
  const auto body = known.open(of.definition.body, is_held);
  if (!body) return std::nullopt;
  for (const SymbolId each : symbols_in(tree, *body)) {
    const bool runs =
        known.may_run(each, in_time) && !is_declared_constant(names.scope, each) && !is_held(each);
    if (!at.contains(each) && ((runs && !is_where(each)) || tree.symbols[each].integral)) return std::nullopt;
  }
  FoundDefinition result = of;
  result.definition.symbol = symbol;
  result.definition.body = replaced(tree, *body, [&](ExprId id) -> std::optional<ExprId> {
    const auto found = at.find(tree[id].symbol);
    return found == at.end() ? std::nullopt : std::optional(found->second);
  });
  const bool circular = is_one_of(symbol, symbols_in(tree, result.definition.body));
  return circular ? std::nullopt : std::optional(std::move(result));
}

std::optional<FoundDefinition> value_of_member(ExprTree& tree, const Names& names, SymbolId symbol,
                                               const Membership& member, const KnownValues& known) {
  const auto& [family, name] = member;
  const NamedDefinition* general = definition_of(names.scope, family.general);
  const auto counter = letter_named(names, family.letter);
  if (general == nullptr || !counter || definition_of(names.scope, *counter) != nullptr) return std::nullopt;
  FoundDefinition result{general->definition, &general->origin, general->at_instant, {}, general->along};
  const bool is_given = std::ranges::any_of(names.scope.assumptions, [&](const NamedAssumption& each) {
    return each.equation.relation == Relation::equal &&
           (is_one_of(symbol, symbols_in(tree, each.equation.left)) ||
            is_one_of(symbol, symbols_in(tree, each.equation.right)));
  });
  if (!is_whole(result) || is_given) return std::nullopt;
  const auto body = known.open(general->definition.body, {});
  const auto index = index_of(tree, names, name, tree.symbols[symbol].first_seen);
  if (!body || !index || hides_letter(tree, names, *body, family)) return std::nullopt;
  const std::vector<SymbolId> inside = symbols_in(tree, *body);
  if (!is_one_of(*counter, inside) || is_one_of(symbol, inside)) return std::nullopt;
  for (const auto& [letter, factor] : name.letters) {
    if (letter == family.letter) continue;
    if (is_one_of(*letter_named(names, letter), inside) ||
        (name.letters.size() == 1 && !stands_for_a_number(tree, names, symbol, member, letter, known.claim)))
      return std::nullopt;
  }
  result.definition.symbol = symbol;
  result.definition.body = replaced(tree, *body, [&](ExprId id) -> std::optional<ExprId> {
    return tree[id].symbol == *counter ? index : std::nullopt;
  });
  const bool is_number = name.letters.empty();
  if (is_number && (is_void(tree, result.definition.body) || divides_by_zero(tree, result.definition.body)))
    return std::nullopt;
  return result;
}

std::vector<SymbolId> members_in(const Question& question, const ExprTree& tree, const Names& names) {
  std::vector<SymbolId> members;
  for (const Definition& each : question.definitions) {
    const SymbolId base = base_of(tree.symbols, each.symbol);
    const auto member = membership_of(names, base);
    if (!member) continue;
    const NamedDefinition* own = definition_of(names.scope, base);
    const NamedDefinition* general = definition_of(names.scope, member->family.general);
    const bool by_family = own == nullptr || (general != nullptr && own->origin.text == general->origin.text);
    if (by_family) members.push_back(base);
  }
  return members;
}

Names without_members(Names names) {
  std::vector<SymbolId> members;
  for (const NamedDefinition& each : names.scope.definitions) {
    const auto member = membership_of(names, each.definition.symbol);
    const NamedDefinition* general = member ? definition_of(names.scope, member->family.general) : nullptr;
    if (general != nullptr && general->origin.text == each.origin.text)
      members.push_back(each.definition.symbol);
  }
  forget_definitions(names.scope, members);
  names.scope.families = {};
  return names;
}

}  // namespace rigor
