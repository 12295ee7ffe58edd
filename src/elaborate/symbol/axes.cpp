// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elaborate/reading/summation.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

/// Index letters with their primes are letters of their own, unless a prime only names the axes.
std::string letter_key(const Reading& reading, const WrittenIndex& axis) {
  return reading.rules.primes_on_axes ? axis.text : axis.text + std::string(axis.primes, '\'');
}

/// There is one set of primed axes.
bool primed_twice(Reading& reading, const std::vector<WrittenIndex>& axes, Span span) {
  const bool twice = std::ranges::any_of(axes, [](const WrittenIndex& axis) { return axis.primes > 1; });
  if (twice) unsupported(reading, span, "an index with two primes is not read");
  return twice;
}

std::optional<SymbolId> primed_axes(Reading& reading, Span span) {
  if (space_of(reading.names.symbols) != common_space)
    return unsupported(reading, span, "primed axes are read in three dimensions only");
  if (const auto rotation = reading.names.symbols.primed_axes) {
    note(reading, "a primed index is a component along the primed axes");
    return rotation;
  }
  ambiguous(reading, span, "nothing says how the primed axes are related to the unprimed ones",
            {"`rigor: rotation \\lambda` makes \\lambda_{i'j} the direction cosines; `rigor: basis "
             "\\mathbf{e}_{i'}` names axes in any directions"});
  return std::nullopt;
}

/// λ between a primed axis, the first slot, and an unprimed one.
ExprId cosine(ExprTree& tree, SymbolId rotation, std::array<Slot, 2> slots, Span span) {
  return tree.add({.op = Op::symbol, .span = span, .symbol = rotation}, {}, slots);
}

}  // namespace

bool is_index_letter(const WrittenIndex& axis) {
  return axis.form == IndexForm::letter && axis_of_letter(axis.text) == 0;
}

bool any_primed(const std::vector<WrittenIndex>& axes) {
  return std::ranges::any_of(axes, [](const WrittenIndex& axis) { return axis.primes > 0; });
}

std::optional<Subscript> try_subscript(Reading& reading, const std::vector<WrittenIndex>& axes,
                                       const Around& around) {
  const std::uint8_t dimension = space_of(reading.names.symbols).dimension;
  Subscript read;
  for (const WrittenIndex& axis : axes) {
    if (axis.form == IndexForm::digit) {
      if (axis.text.size() != 1 || axis.text[0] < '1' || axis.text[0] > '0' + dimension) return std::nullopt;
      read.slots.push_back({static_cast<std::uint8_t>(axis.text[0] - '0'), {}});
      continue;
    }
    if (axis.form != IndexForm::letter) return std::nullopt;
    if (axis_of_letter(axis.text) > dimension) return std::nullopt;
    if (axis_of_letter(axis.text) != 0) {
      read.slots.push_back({axis_of_letter(axis.text), {}});
      continue;
    }
    const std::string key = letter_key(reading, axis);
    if (const auto fixed = around.axes.find(key); fixed != around.axes.end()) {
      read.slots.push_back({fixed->second, {}});
      continue;
    }
    const IndexId id = index_named(reading, key);
    read.slots.push_back({0, id});
    if (!reading.indices.summed.contains(key)) read.free.push_back({key, id, axis.span});
  }
  return read;
}

std::optional<Subscript> subscript(Reading& reading, const std::vector<WrittenIndex>& axes, Span span,
                                   const Around& around) {
  auto read = try_subscript(reading, axes, around);
  if (!read) unsupported(reading, span, "a subscript other than index letters and axes is not read");
  return read;
}

Typed basis_vector(Reading& reading, Span span, Slot slot, std::vector<FreeIndex> free) {
  const Space space = use_space(reading);
  note(reading, fmt::format("`\\hat{{x}}`, `\\mathbf{{e}}_i` and the like are the {}orthonormal basis",
                            space == common_space ? "right-handed " : ""));
  const ExprId id = reading.tree.add(
      {.op = Op::basis, .rank = 1, .span = span, .axes = AxisSpaces::of(space, 1)}, {}, std::span(&slot, 1));
  return {.id = id, .rank = 1, .free = std::move(free)};
}

MaybeTyped primed_basis_vector(Reading& reading, const WrittenIndex& axis, Span span, const Around& around) {
  if (primed_twice(reading, {axis}, span)) return std::nullopt;
  const auto rotation = primed_axes(reading, span);
  if (!rotation) return std::nullopt;
  auto written = subscript(reading, {axis}, span, around);
  if (!written) return std::nullopt;
  std::array<ExprId, 3> components{};
  for (std::uint8_t k = 1; k <= 3; ++k)
    components[k - 1u] = cosine(reading.tree, *rotation, {written->slots[0], Slot{k, {}}}, span);
  const ExprId id = reading.tree.add({.op = Op::tuple, .rank = 1, .span = span}, components);
  return Typed{.id = id, .rank = 1, .free = std::move(written->free)};
}

MaybeTyped unit_tensor(Reading& reading, const WrittenSymbol& written, Span span, const Around& around) {
  if (is_kronecker_of_states(written, *reading.names.symbols.evidence)) {
    const auto part = [&](const WrittenIndex& index) {
      return label_of(index.text + std::string(index.primes, '\'')).front();
    };
    return Typed{.id =
                     kronecker_of_states(reading.tree, part(written.lower[0]), part(written.lower[1]), span)};
  }
  const auto primed = static_cast<std::size_t>(
      std::ranges::count_if(written.lower, [](const auto& axis) { return axis.primes > 0; }));
  auto read = subscript(reading, written.lower, span, around);
  if (!read) return std::nullopt;
  auto& [slots, free] = *read;
  if (primed == 0 || primed == written.lower.size()) {
    if (!is_kronecker(written) && space_of(reading.names.symbols) != common_space)
      return unsupported(reading, span, "`\\varepsilon` with three indices belongs to three dimensions");
    const Op op = is_kronecker(written) ? Op::delta : Op::epsilon;
    return contract(reading, {.id = reading.tree.add({.op = op, .span = span}, {}, slots), .free = free});
  }
  const auto rotation = primed_axes(reading, span);
  if (!rotation) return std::nullopt;
  if (!is_kronecker(written))
    return unsupported(reading, span, "an ε between primed and unprimed axes is not decided");
  if (written.lower[1].primes > 0) std::swap(slots[0], slots[1]);
  return contract(reading, {.id = cosine(reading.tree, *rotation, {slots[0], slots[1]}, span), .free = free});
}

MaybeTyped direction_cosine(Reading& reading, const ExprNode& node, const std::vector<WrittenIndex>& axes,
                            Typed typed, Span span, const Around& around) {
  if (primed_twice(reading, axes, span)) return std::nullopt;
  if (axes[0].primes > 0 && axes[1].primes > 0)
    return unsupported(reading, span, "a direction cosine between two primed axes is not read");
  if (reading.rules.primes_on_axes && axes[0].primes == 0 && axes[1].primes == 0)
    return ambiguous(reading, span,
                     "other indices here are primed, but neither index of this rotation is, so its primed "
                     "axes are not known",
                     {"write the prime on one of the two"});
  auto read = subscript(reading, axes, span, around);
  if (!read) return std::nullopt;
  if (axes[1].primes > 0) std::swap(read->slots[0], read->slots[1]);
  typed.id = reading.tree.add(node, {}, read->slots);
  return contract(reading, std::move(typed));
}

MaybeTyped along_axes(Reading& reading, Typed whole, const std::vector<WrittenIndex>& axes, Span span,
                      const Around& around) {
  ExprTree& tree = reading.tree;
  if (primed_twice(reading, axes, span)) return std::nullopt;
  const auto rotation = primed_axes(reading, span);
  if (!rotation) return std::nullopt;
  if (static_cast<int>(axes.size()) != whole.rank)
    return unsupported(reading, span, "a subscript other than index letters and axes is not read");
  const auto written = subscript(reading, axes, span, around);
  if (!written) return std::nullopt;
  std::vector<ExprId> factors;
  std::vector<IndexId> summed_axes;
  std::vector<Slot> inner = written->slots;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (axes[k].primes == 0) continue;
    summed_axes.push_back(tree.add_index(axes[k].text));
    inner[k] = {0, summed_axes.back()};
    factors.push_back(cosine(tree, *rotation, {written->slots[k], inner[k]}, span));
  }
  factors.push_back(component_of(tree, whole.id, inner));
  auto letters = contraction_of(reading, {whole, {.free = written->free}});
  if (!letters) return std::nullopt;
  Typed typed{.id = tree.add({.op = Op::multiply, .span = span}, factors), .particles = whole.particles};
  for (const IndexId index : summed_axes)
    typed.id = tree.add({.op = Op::index_sum, .span = span, .index = index}, std::span(&typed.id, 1));
  return summed(tree, std::move(typed), *std::move(letters));
}

}  // namespace rigor
