// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/named_symbol.h"

#include <fmt/format.h>

#include <set>

#include "elaborate/evidence/evidence.h"
#include "elaborate/reading/summation.h"
#include "elaborate/symbol/axes.h"

namespace rigor {
namespace {

/// In an integral over the body: does a quantity belong to the point, as `\mathbf r` and the density do?
/// Nothing, and a diagnostic, where it can be read in both ways.
std::optional<bool> is_varying_in_body(Reading& reading, const WrittenName& name, int rank, Span span) {
  static const std::set<std::string> of_a_point{"r", "x", "y", "z", "\\rho"};
  const Names& names = reading.names;
  const auto is_defined = [&](bool per_particle) {
    const auto symbol = find_symbol(names.symbols, {name.base, rank, per_particle});
    return symbol && definition_of(names.scope, *symbol) != nullptr;
  };
  const bool one = is_declared(names.symbols, {name.base, rank, false}) || is_defined(false);
  const bool each = names.symbols.sightings->bold.contains({name.base, true}) ||
                    names.symbols.sightings->indexed.contains({name.base, rank, true}) ||
                    is_declared(names.symbols, {name.base, rank, true}) || is_defined(true);
  const bool of_point = of_a_point.contains(name.base);
  if (one && !of_point) return false;
  if (!one && (each || of_point)) return true;
  if (one)
    return ambiguous(
        reading, span,
        fmt::format(
            "`{0}` is declared as one quantity, but inside an integral over a body it belongs to each point",
            name.base),
        {"give one of them another name, or drop the declaration"});
  return ambiguous(
      reading, span,
      fmt::format("`{}` can be one number for the body, or differ from point to point", name.base),
      {fmt::format("`rigor: scalar {0}` or `rigor: vector {0}` makes it one for the body", name.base)});
}

/// Is this letter π the number? Not where it is declared, or the section lets it change.
bool is_circle_number(const Names& names, const NameKey& key) {
  return key == NameKey{"\\pi", 0, false} && !is_declared(names.symbols, key) &&
         !is_changing(*names.symbols.evidence, key.base) &&
         !names.symbols.evidence->primed.contains(key.base);
}

}  // namespace

std::string bold(const std::string& base) {
  const auto tail = base.find_first_of("_'^");
  const std::string letter = base.substr(0, tail);
  const std::string rest = tail == std::string::npos ? "" : base.substr(tail);
  if (letter.starts_with("\\hat")) return base;
  return fmt::format("\\{}{{{}}}{}", letter.starts_with("\\") ? "boldsymbol" : "mathbf", letter, rest);
}

bool is_known(const Names& names, const std::string& base, int rank, bool per_particle) {
  if (is_declared(names.symbols, {base, rank, per_particle})) return true;
  if (rank == 1 && names.symbols.sightings->bold.contains({base, per_particle})) return true;
  return names.symbols.sightings->indexed.contains({base, rank, per_particle});
}

bool is_declared_letter(const Names& names, const WrittenSymbol& symbol) {
  const std::string labelled = with_labels(symbol.letter, symbol.lower);
  return is_declared(names.symbols, {symbol.letter, 0, false}) ||
         is_declared(names.symbols, {symbol.letter, 1, false}) ||
         is_declared(names.symbols, {labelled, 0, false});
}

MaybeTyped named_symbol(Reading& reading, const Occurrence& at, const std::string& base, int rank,
                        const std::vector<WrittenIndex>& axes) {
  const auto& [written, name, span, around] = at;
  ExprTree& tree = reading.tree;
  const Names& names = reading.names;
  std::optional<bool> in_body = false;
  if (!name.per_particle() && around.body_point) in_body = is_varying_in_body(reading, name, rank, span);
  if (!in_body) return std::nullopt;
  const NameKey key{base, rank, name.per_particle() || *in_body};
  const bool fresh = !find_symbol(names.symbols, key).has_value();
  const bool vector_position = rank == 1 && (base == "r" || base == "x");
  const bool coordinate = rank == 0 && axis_of_letter(base) != 0;
  const bool vector_face = rank == 1 && (written.face == Face::vector ||
                                         names.symbols.sightings->bold.contains({base, key.per_particle}));
  const SymbolId symbol = symbol_named(reading, key, vector_face ? bold(base) : base, span);
  if (fresh && written.accent == Accent::hat && rank == 1) {
    if (space_of(names.symbols) != common_space)
      return unsupported(reading, span, "unit vectors are read in three dimensions only");
    tree.symbols.write(symbol).unit = true;
  }
  if (fresh && is_circle_number(names, key)) tree.symbols.write(symbol).circle_number = true;
  const bool position = (vector_position || coordinate) && !key.per_particle;
  if (position && change_of(reading, symbol, By::space).kind == Dependence::Kind::variable)
    note_position(reading, symbol);
  const auto read = subscript(reading, axes, span, around);
  if (!read) return std::nullopt;
  Typed typed{.rank = axes.empty() ? rank : 0, .free = read->free};
  ExprNode node{
      .op = Op::symbol, .rank = static_cast<std::uint8_t>(typed.rank), .span = span, .symbol = symbol};
  if (*in_body) {
    node.particle = *around.body_point;
  } else if (key.per_particle) {
    const WrittenIndex& particle = name.particles[0];
    node.particle = particle_named(reading, particle.text);
    if (!reading.particles.summed.contains(particle.text))
      typed.particles.push_back({particle.text, node.particle, particle.span});
  }
  if (rank > 4) return unsupported(reading, span, "tensors of rank above 4 are not decided");
  if (tree.symbols[symbol].rotation && names.symbols.primed_axes == symbol && axes.size() == 2)
    return direction_cosine(reading, node, axes, std::move(typed), span, around);
  if (any_primed(axes)) {
    node.rank = static_cast<std::uint8_t>(rank);
    return along_axes(reading, {.id = tree.add(node), .rank = rank, .particles = typed.particles}, axes, span,
                      around);
  }
  const bool principal = rank == 1 && axes.size() == 1 && names.symbols.sightings->diagonal.contains(base);
  for (FreeIndex& free : typed.free) free.rides = principal;
  typed.id = tree.add(node, {}, read->slots);
  return contract(reading, std::move(typed));
}

}  // namespace rigor
