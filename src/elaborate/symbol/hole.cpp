// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/hole.h"

#include <algorithm>

#include "elaborate/reading/summation.h"
#include "elaborate/symbol/axes.h"
#include "latex/token/vocabulary.h"

namespace rigor {

MaybeTyped elaborate_hole(Reading& reading, const WrittenSymbol& written, Span span, const Around& around) {
  if (!reading.rules.hole) {
    return fail(reading, DiagnosticKind::hole, span, "what belongs here is to be found",
                {"`rigor derive` answers it"});
  }
  if (written.dots > 0 || !written.change.empty() || written.primes > 0 || written.accent != Accent::none)
    return unsupported(reading, span, "a hole has no dots, accents or primes");
  HoleShape shape = *reading.rules.hole;
  const bool lettered = std::ranges::any_of(written.lower, is_index_letter);
  if (lettered) shape = {.particles = shape.particles};
  if (written.face != Face::plain) shape = {.rank = written.face == Face::tensor ? 2 : 1};
  std::vector<WrittenIndex> axes;
  for (const WrittenIndex& axis : written.lower) {
    if (lettered && is_index_letter(axis)) axes.push_back(axis);
    if (labels_particles(reading.names.symbols, axis.text)) shape.particles = {axis.text};
  }
  for (const std::string& letter : shape.letters) axes.push_back({letter, IndexForm::letter, 0, span});
  const int rank = shape.rank + static_cast<int>(axes.size());
  if (rank > 4) return unsupported(reading, span, "tensors of rank above 4 are not decided");
  const auto read = try_subscript(reading, axes, around);
  if (!read) return unsupported(reading, span, "this subscript is not read on a hole");
  Typed typed{.rank = shape.rank, .free = read->free};
  ExprNode node{.op = Op::symbol, .rank = static_cast<std::uint8_t>(shape.rank), .span = span};
  node.symbol = reading.tree.symbols.add({.name = std::string(hole_letter),
                                          .rank = rank,
                                          .per_particle = !shape.particles.empty(),
                                          .declared = true,
                                          .first_seen = span,
                                          .axes = AxisSpaces::of(space_of(reading.names.symbols), rank)});
  if (!shape.particles.empty()) {
    const std::string& letter = shape.particles[0];
    node.particle = particle_named(reading, letter);
    if (!reading.particles.summed.contains(letter)) typed.particles.push_back({letter, node.particle, span});
  }
  reading.found.holes.push_back({node.symbol, span});
  typed.id = reading.tree.add(node, {}, read->slots);
  return contract(reading, std::move(typed));
}

}  // namespace rigor
