// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/reading.h"

#include <fmt/format.h>

#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

template <typename Id, typename Make>
Id variable_of(Reading::Variables<Id>& variables, const std::string& letter, const Make& make) {
  if (const auto at = variables.summed.find(letter); at != variables.summed.end()) return at->second.back();
  const auto [at, fresh] = variables.free.try_emplace(letter);
  if (fresh) at->second = make();
  return at->second;
}

}  // namespace

std::optional<Obstacle> guess_of(const Reading& reading) {
  if (auto guess = lasting_guess_of(reading)) return guess;
  return reading.found.belongs ? reading.found.belongs : reading.found.applied;
}

std::optional<Obstacle> lasting_guess_of(const Reading& reading) {
  const Reading::Found& found = reading.found;
  if (found.guess || !found.differentiates_position || found.positions.size() < 2) return found.guess;
  return Obstacle{DiagnosticKind::ambiguous_reading,
                  fmt::format("`{}` and `{}` can both be the position", *found.positions.begin(),
                              *std::next(found.positions.begin())),
                  {"`rigor: let \\mathbf{r} = (x, y, z)` relates them"}};
}

void note_position(Reading& reading, SymbolId symbol) {
  const Symbol& named = reading.tree.symbols[symbol];
  reading.found.positions.insert(named.rank == 0 ? "x, y, z" : named.name);
}

void note(Reading& reading, std::string convention) {
  std::vector<std::string>& known = reading.found.conventions;
  if (!is_one_of(convention, known)) known.push_back(std::move(convention));
}

SymbolId symbol_named(Reading& reading, const NameKey& key, const std::string& name, Span span) {
  if (const auto directive = declared_by(reading.names.symbols, key)) reading.found.used.insert(*directive);
  if (key.rank > 0) use_space(reading);
  return resolve(reading.names.symbols, reading.tree, key, name, span);
}

Dependence change_of(Reading& reading, SymbolId symbol, const Variable& by) {
  const KnownChange known = change(reading.names, reading.tree, symbol, by);
  if (known.directive) reading.found.used.insert(*known.directive);
  return known.dependence;
}

Space use_space(Reading& reading) {
  if (const auto directive = space_declared_by(reading.names.symbols)) reading.found.used.insert(*directive);
  return space_of(reading.names.symbols);
}

IndexId index_named(Reading& reading, const std::string& letter) {
  return variable_of(reading.indices, letter,
                     [&] { return reading.tree.add_index(letter, use_space(reading)); });
}

IndexId index_named(Reading& reading, const std::string& letter, Space space) {
  return variable_of(reading.indices, letter, [&] { return reading.tree.add_index(letter, space); });
}

ParticleId particle_named(Reading& reading, const std::string& letter) {
  return variable_of(reading.particles, letter, [&] { return reading.tree.add_particle(letter); });
}

}  // namespace rigor
