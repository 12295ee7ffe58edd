// SPDX-License-Identifier: GPL-3.0-or-later
// A hole, `\square`: a symbol that no name belongs to, of the shape that the reading gives it.
#include <algorithm>

#include "elaborate/notation/elaborator.h"

namespace rigor {
namespace {

bool is_index_letter(const WrittenIndex& axis) {
  return axis.form == IndexForm::letter && axis_of_letter(axis.text) == 0;
}

}  // namespace

/// Letters on the hole itself are its own; other subscripts only name it.
std::optional<Typed> Elaborator::hole(const WrittenSymbol& written, Span span) {
  if (!reading_.hole) {
    return fail(DiagnosticKind::hole, span, "what stands here is asked for", {"`rigor derive` answers it"});
  }
  if (written.dots > 0 || !written.change.empty() || written.primes > 0 || written.accent != Accent::none)
    return unsupported(span, "what is asked for stands without dots, accents and primes");
  HoleShape shape = *reading_.hole;
  const bool lettered = std::any_of(written.lower.begin(), written.lower.end(), is_index_letter);
  if (lettered) shape = {.particles = shape.particles};
  if (written.face != Face::plain) shape = {.rank = written.face == Face::tensor ? 2 : 1};
  std::vector<WrittenIndex> axes;
  for (const WrittenIndex& axis : written.lower) {
    if (lettered && is_index_letter(axis)) axes.push_back(axis);
    if (names_.labels_particles(axis.text)) shape.particles = {axis.text};
  }
  for (const std::string& letter : shape.letters) axes.push_back({letter, IndexForm::letter, 0, span});
  const int rank = shape.rank + static_cast<int>(axes.size());
  if (rank > 4) return unsupported(span, "tensors of rank above 4 are not decided");
  Typed typed;
  typed.rank = shape.rank;
  std::vector<Slot> slots;
  if (!read_slots(axes, slots, typed.free)) return unsupported(span, "this subscript is not read on a hole");
  ExprNode node{.op = Op::symbol, .rank = static_cast<std::uint8_t>(shape.rank), .span = span};
  node.symbol = tree_.symbols.add({.name = std::string(hole_letter),
                                   .rank = rank,
                                   .per_particle = !shape.particles.empty(),
                                   .declared = true,
                                   .first_seen = span});
  if (!shape.particles.empty()) {
    const std::string& letter = shape.particles[0];
    node.particle = particle(letter);
    if (!bound_particles_.contains(letter)) typed.particles.push_back({letter, node.particle, span});
  }
  holes_.push_back({node.symbol, span});
  typed.id = tree_.add(node, {}, slots);
  return contract(std::move(typed));
}

}  // namespace rigor
