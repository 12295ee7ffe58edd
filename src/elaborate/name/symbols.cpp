// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/symbols.h"

#include <utility>

namespace rigor {

Space column_space(const Symbols& symbols, int dimension) {
  const Space here = space_of(symbols);
  if (here.dimension == dimension) return here;
  if (common_space.dimension == dimension) return common_space;
  if (dimension == space_time.dimension && symbols.evidence->space_time.shown) return space_time;
  return {static_cast<std::uint8_t>(dimension), space_of_columns};
}

AxisSpaces axes_of(const Symbols& symbols, MatrixShape shape) {
  AxisSpaces axes;
  if (shape.columns != 1) axes.set(0, column_space(symbols, shape.columns));
  if (shape.rows == 1) return axes;
  AxisSpaces all;
  all.set(0, column_space(symbols, shape.rows));
  return all.then(1, axes);
}

std::optional<SymbolId> find_symbol(const Symbols& symbols, const NameKey& key) {
  const NameKey here = placed(symbols, key);
  if (const auto* declared = symbols.declared.find(here)) return declared->second.symbol;
  const auto* found = symbols.entries.find(here);
  return found == nullptr ? std::nullopt : std::optional(found->second);
}

SymbolId resolve(Symbols& symbols, ExprTree& tree, const NameKey& named, const std::string& name, Span span) {
  const NameKey key = placed(symbols, named);
  if (const auto known = find_symbol(symbols, key)) return *known;
  Symbol symbol;
  symbol.name = name;
  symbol.rank = key.rank;
  // Of rank 3 it is a vector of matrices of this shape.
  const AxisSpaces of_shape = key.shape.any() ? axes_of(symbols, key.shape) : AxisSpaces{};
  symbol.axes = key.shape.any()
                    ? (key.rank == 3 ? AxisSpaces::of(common_space, 1).then(1, of_shape) : of_shape)
                    : AxisSpaces::of(key.rank == 0                ? common_space
                                     : key.space == space_time.id ? space_time
                                                                  : space_of(symbols),
                                     key.rank);
  symbol.per_particle = key.per_particle;
  symbol.complex = key.complex;
  symbol.noncommuting = key.noncommuting;
  symbol.unsized = key.unsized;
  symbol.first_seen = span;
  symbol.made_at = tree.size();
  // After its section, a declared letter is the same symbol, undeclared; if the declaration gave it
  // properties (symmetric, unit, rotation), it is another symbol.
  const auto* before = symbols.declared_before.find(key);
  const bool same = before != nullptr && !tree.symbols[before->second].symmetric &&
                    !tree.symbols[before->second].unit && !tree.symbols[before->second].rotation;
  const SymbolId id = same ? before->second : tree.symbols.add(std::move(symbol));
  tree.symbols.write(id).declared = false;
  if (!symbols.keys.contains(id)) symbols.keys.put({id, key});
  symbols.entries.put({key, id});
  return id;
}

const NameKey* key_of(const Symbols& symbols, SymbolId symbol) {
  const auto* found = symbols.keys.find(symbol);
  return found == nullptr ? nullptr : &found->second;
}

std::optional<std::size_t> declared_by(const Symbols& symbols, const NameKey& key) {
  const auto* found = symbols.declared.find(placed(symbols, key));
  return found == nullptr ? std::nullopt : std::optional(found->second.by.directive);
}

std::optional<std::size_t> space_declared_by(const Symbols& symbols) {
  if (symbols.spaces->empty()) return std::nullopt;
  return symbols.spaces->back().declared.directive;
}

NameKey placed(const Symbols& symbols, NameKey key) {
  if (key.rank > 0 && key.space == 0 && !key.shape.any()) key.space = space_of(symbols).id;
  const std::set<std::string>& complex = symbols.evidence->complex_numbers;
  if (key.shape.any()) return key;
  if (!complex.empty()) key.complex = key.complex || complex.contains(complex_name(key.base, key.rank));
  const Evidence& shown = *symbols.evidence;
  const bool any = !shown.noncommuting.empty() || !shown.noncommuting_triples.empty();
  if (any && !key.per_particle) key.noncommuting = key.noncommuting || is_operator(shown, key.base, key.rank);
  if (key.noncommuting) key.complex = false;
  if (key.noncommuting && key.rank == 0) key.unsized = unsized_letter(shown, key.base);
  return key;
}

bool labels_particles(const Symbols& symbols, const std::string& letter) {
  return symbols.particle_letters.contains(letter) || symbols.sightings->summed_greek.contains(letter) ||
         symbols.sightings->members.has(letter) || symbols.evidence->members.has(letter);
}

std::optional<std::size_t> particles_declared_by(const Symbols& symbols, const std::string& letter) {
  const auto* found = symbols.particle_letters.find(letter);
  return found == nullptr ? std::nullopt : std::optional(found->second.directive);
}

bool is_principal_value(const Symbols& symbols, const SymbolTable& table, SymbolId symbol) {
  const NameKey* key = key_of(symbols, base_of(table, symbol));
  return key != nullptr && key->rank == 1 && symbols.sightings->diagonal.contains(key->base);
}

bool is_differentiated_by_place(const Symbols& symbols, const NameKey& key) {
  const auto& fields = symbols.sightings->fields;
  if (fields.contains({key.base, key.rank > 0})) return true;
  return key.rank > 0 && is_plain(symbols, key) && fields.contains({key.base, false});
}

void close_sections(Symbols& symbols, int level) {
  symbols.declared.erase_if([&](const auto& entry) { return entry.second.by.depth >= level; });
  symbols.particle_letters.erase_if([&](const auto& entry) { return entry.second.depth >= level; });
  symbols.spaces.erase_if([&](const SpaceInForce& each) { return each.declared.depth >= level; });
}

}  // namespace rigor
