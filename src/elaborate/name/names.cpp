// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/names.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

/// Known from its letter: the time t, the position.
Dependence usual_change(const NameKey& key, const Variable& by) {
  using Kind = Dependence::Kind;
  if (key == NameKey{"t", 0, false}) return {by == By::time ? Kind::variable : Kind::constant};
  if (by != By::space) return {};
  if (key.rank == 1 && key.space == 0 && (key.base == "r" || key.base == "x")) return {Kind::variable};
  if (key.rank != 0 || key.complex || key.noncommuting) return {};
  if (key.base == "x" || key.base == "y" || key.base == "z")
    return {Kind::variable, static_cast<std::uint8_t>(key.base[0] - 'x' + 1)};
  return {};
}

/// `E = p^2/2m + kx^2/2` is constant in time; by p and by place it has the derivative that its definition
/// gives.
bool is_defined_with(const Names& names, const ExprTree& tree, SymbolId base, const Variable& by) {
  if (by == By::time || by == By::small) return false;
  const auto body = body_of_definition(names.scope, base);
  if (!body) return false;
  return std::ranges::any_of(symbols_reached(tree, names.scope, {*body}), [&](SymbolId each) {
    if (by.by == By::letter) return each == by.letter;
    const NameKey* key = key_of(names.symbols, each);
    return key != nullptr && usual_change(*key, by).kind == Dependence::Kind::variable;
  });
}

/// Known from a directive about this symbol, or about one with the same key.
std::optional<KnownChange> declared_change(const Names& names, const ExprTree& tree, SymbolId base,
                                           const Variable& by) {
  const NameKey* key = key_of(names.symbols, base);
  for (const DeclaredConstant& constant : names.scope.constants) {
    const NameKey* own = key_of(names.symbols, constant.symbol);
    const bool same = constant.symbol == base || (own != nullptr && key != nullptr && *own == *key);
    if (!same) continue;
    // A vector or tensor that does not change along fixed axes does along turning ones.
    const bool turns =
        key != nullptr && key->rank > 0 && !is_principal_value(names.symbols, tree.symbols, base);
    if (turns && by == By::time && constant.frames < names.scope.frames->size()) continue;
    if (is_defined_with(names, tree, base, by)) continue;
    return KnownChange{{Dependence::Kind::constant}, constant.directive};
  }
  return std::nullopt;
}

/// The name of a symbol, as the section's evidence has it.
std::string name_in(const Names& names, const ExprTree& tree, SymbolId symbol) {
  const NameKey* key = key_of(names.symbols, base_of(tree.symbols, symbol));
  return key == nullptr ? std::string{} : dotted(key->base, tree.symbols[symbol].order(By::time));
}

/// Does a derivative by a letter say that this is held? The other variables of the section are, and rates.
bool is_held(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by) {
  const SymbolId base = base_of(tree.symbols, symbol);
  if (!by.partial || by.held) return false;  // who names one holds no other
  const Symbol& written = tree.symbols[symbol];
  if (base == base_of(tree.symbols, by.letter)) return true;  // x of \partial/\partial\dot x
  const std::string name = name_in(names, tree, base);
  const Evidence& evidence = *names.symbols.evidence;
  if (is_function_of(evidence, name, name_in(names, tree, by.letter))) return false;
  const bool rate = written.derivation && written.order() == written.order(By::time);
  const bool of_places = tree.symbols[by.letter].derivation.has_value() && is_applied(evidence, name);
  return rate || of_places || name == "t" || evidence.by.contains(name);
}

KnownChange change_but_for_squares(const Names& names, const ExprTree& tree, SymbolId symbol,
                                   const Variable& by) {
  if (by == By::small) return {};  // what does not change in time can be small
  const SymbolId base = base_of(tree.symbols, symbol);
  if (by.by == By::letter && symbol == by.letter) return {{Dependence::Kind::variable}};
  if (by.held && (*by.held == symbol || *by.held == base)) return {{Dependence::Kind::constant}};
  if (tree.symbols[base].is_fixed() && definition_of(names.scope, base) == nullptr)
    return {{Dependence::Kind::constant}};
  if (auto declared = declared_change(names, tree, base, by)) return *std::move(declared);
  const NameKey* key = key_of(names.symbols, symbol);
  if (definition_of(names.scope, symbol) != nullptr) return {};
  if (by.by == By::letter) {
    const auto body = body_of_definition(names.scope, by.letter);  // x = 2t: t changes with x
    if (body && is_one_of(base, symbols_reached(tree, names.scope, {*body}))) return {};
    return is_held(names, tree, symbol, by) ? KnownChange{{Dependence::Kind::constant}} : KnownChange{};
  }
  if (key == nullptr || key->per_particle) return {};
  return {usual_change(*key, by)};
}

/// The symbol that was declared with these properties before, in any section.
std::optional<SymbolId> declared_alike(const Symbols& symbols, const SymbolTable& table, const NameKey& key,
                                       const Symbol& symbol) {
  const auto* before = symbols.declared_before.find(key);
  if (before == nullptr) return std::nullopt;
  const Symbol& known = table[before->second];
  const bool alike =
      known.symmetric == symbol.symmetric && known.unit == symbol.unit && known.rotation == symbol.rotation;
  return alike ? std::optional(before->second) : std::nullopt;
}

/// What a directive alone spoke of before (`small x`, then `scalar x`) is the same symbol.
std::optional<SymbolId> spoken_of(const Names& names, const NameKey& key, const Symbol& symbol) {
  const bool plain = !symbol.symmetric && !symbol.unit && !symbol.rotation;
  const auto known = find_symbol(names.symbols, key);
  const bool fits = plain && known && !is_declared(names.symbols, key) &&
                    !names.scope.seen_anywhere.contains(*known) &&
                    !names.symbols.declared_before.contains(key);
  return fits ? known : std::nullopt;
}

}  // namespace

SymbolId declare(Names& names, ExprTree& tree, const NameKey& named, Symbol symbol, std::size_t directive) {
  const NameKey key = placed(names.symbols, named);
  symbol.rank = key.rank;
  symbol.axes = AxisSpaces::of(key.rank > 0 ? space_of(names.symbols) : common_space, key.rank);
  symbol.per_particle = key.per_particle;
  symbol.complex = key.complex;
  symbol.noncommuting = key.noncommuting;
  symbol.unsized = key.unsized;
  symbol.declared = true;
  auto known = declared_alike(names.symbols, tree.symbols, key, symbol);
  if (!known) known = spoken_of(names, key, symbol);
  const SymbolId id = known ? *known : tree.symbols.add(std::move(symbol));
  tree.symbols.write(id).declared = true;
  names.symbols.declared_before.put({key, id});
  if (!names.symbols.keys.contains(id)) names.symbols.keys.put({id, key});
  names.symbols.entries.erase(key);
  names.symbols.declared.put({key, {id, {directive, names.scope.depth}}});
  return id;
}

bool enter_space(Names& names, const std::string& name, int dimension, std::size_t directive) {
  Symbols& symbols = names.symbols;
  const std::pair key(name, dimension);
  const auto known = symbols.spaces_by_name->find(key);
  const auto next = static_cast<std::uint8_t>(symbols.spaces_by_name->size() + 1);
  Space space{static_cast<std::uint8_t>(dimension), next};
  if (known != symbols.spaces_by_name->end()) {
    space = known->second;
  } else if (symbols.spaces_by_name->size() == most_named_spaces) {
    return false;
  } else {
    symbols.spaces_by_name.write()[key] = space;
  }
  symbols.spaces.write().push_back({space, {directive, names.scope.depth}});
  return true;
}

void declare_particles(Names& names, const std::string& letter, std::size_t directive) {
  names.symbols.particle_letters.put({letter, {directive, names.scope.depth}});
}

void forget(Names& names, std::size_t directive) {
  const auto brought = [&](const auto& entry) { return entry.origin.directive == directive; };
  names.symbols.declared.erase_if([&](const auto& entry) { return entry.second.by.directive == directive; });
  NameScope& scope = names.scope;
  scope.definitions.erase_if(brought);
  scope.assumptions.erase_if(brought);
  scope.unread.erase_if([&](const UnreadAssumption& each) { return each.directive == directive; });
  if (scope.frames->empty()) return;
  for (Frame& frame : scope.frames.write()) {
    frame.before.definitions.erase_if(brought);
    frame.before.assumptions.erase_if(brought);
  }
}

void open_section(Names& names, int level) {
  close_sections(names.symbols, level);
  open_section(names.scope, level);
}

KnownChange change(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by) {
  KnownChange result = change_but_for_squares(names, tree, symbol, by);
  const NamedDefinition* named = definition_of(names.scope, symbol);
  if (named != nullptr && named->definition.by_square && named->definition.particle == no_particle)
    result.dependence.square = tree.children(named->definition.body)[0];
  return result;
}

bool knows_change(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by) {
  const SymbolId base = base_of(tree.symbols, symbol);
  if (tree.symbols[base].unit_of_measure) return true;
  if (definition_of(names.scope, base) != nullptr || definition_of(names.scope, symbol) != nullptr)
    return true;
  if (names.scope.variables.contains(base) || is_declared_constant(names.scope, base)) return true;
  const NameKey* found = key_of(names.symbols, base);
  if (found == nullptr || by == By::small) return true;
  NameKey plain = *found;
  plain.base = plain.base.substr(0, plain.base.find('#'));  // V of V_μ in curved space
  const NameKey* key = &plain;
  if (by == By::space) return is_differentiated_by_place(names.symbols, *key);
  if (by.by == By::letter)
    return is_function_of(*names.symbols.evidence, key->base, name_in(names, tree, by.letter));
  // What another section differentiates may be another quantity there.
  if (!is_changing(*names.symbols.evidence, key->base)) return false;
  const Sightings& sightings = *names.symbols.sightings;
  if (has_rate(sightings, *key)) return true;
  const bool principal_values = key->rank == 1 && sightings.diagonal.contains(key->base);
  return principal_values && has_rate(sightings, {key->base, 2, key->per_particle});
}

bool leads_to(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by) {
  const SymbolTable& symbols = tree.symbols;
  const auto body = body_of_definition(names.scope, base_of(symbols, symbol));
  if (!body) return symbol == by.letter || knows_change(names, tree, symbol, by);
  const bool rate = symbols[symbol].derivation.has_value();
  return std::ranges::any_of(symbols_reached(tree, names.scope, {*body}), [&](SymbolId each) {
    const bool same = rate && base_of(symbols, each) == base_of(symbols, by.letter);
    const bool defined = body_of_definition(names.scope, base_of(symbols, each)).has_value();
    return same || each == by.letter || (!defined && knows_change(names, tree, each, by));
  });
}

bool is_free_variable(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by) {
  if (change(names, tree, symbol, by).dependence.kind != Dependence::Kind::variable) return false;
  const NameKey* key = key_of(names.symbols, symbol);
  const Sightings& sightings = *names.symbols.sightings;
  if (by == By::time) return true;
  return sightings.places && key != nullptr && !has_rate(sightings, *key) &&
         !is_function_of_a_coordinate(*names.symbols.evidence, key->base);
}

bool is_field(const Names& names, const ExprTree& tree, SymbolId symbol) {
  if (tree.symbols[symbol].order(By::space) > 0) return true;
  const SymbolId base = base_of(tree.symbols, symbol);
  const NameKey* key = key_of(names.symbols, base);
  if (key == nullptr || key->per_particle) return false;
  const bool partial_rate = names.symbols.sightings->partial_rates.contains({key->base, key->rank > 0});
  if (partial_rate || is_differentiated_by_place(names.symbols, *key)) return true;
  const NamedDefinition* named = definition_of(names.scope, base);
  if (named == nullptr) return false;
  return std::ranges::any_of(symbols_in(tree, named->definition.body),
                             [&](SymbolId each) { return tree.symbols[each].order(By::space) > 0; });
}

bool is_small_scalar(const Names& names, const ExprTree& tree, const std::string& base) {
  const auto symbol = find_symbol(names.symbols, {base, 0, false});
  return symbol && std::ranges::any_of(names.scope.small, [&](const SmallQuantity& small) {
           return tree[small.quantity].op == Op::symbol && tree[small.quantity].symbol == *symbol;
         });
}

std::vector<std::string> known_names(const Names& names, const ExprTree& tree) {
  std::map<NameKey, SymbolId> in_scope;
  for (const auto& [key, declared] : names.symbols.declared) in_scope.emplace(key, declared.symbol);
  for (const auto& [key, symbol] : names.symbols.entries) {
    if (definition_of(names.scope, symbol) != nullptr || seen_in_equation(names.scope, symbol))
      in_scope.emplace(key, symbol);
  }
  std::vector<std::string> known;
  for (const auto& [key, symbol] : in_scope) known.push_back(tree.symbols[symbol].name);
  return known;
}

}  // namespace rigor
