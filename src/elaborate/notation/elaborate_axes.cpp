// SPDX-License-Identifier: GPL-3.0-or-later
// Primed axes and rotating frames. Components are along the unprimed axes; \lambda_{i'j} = e_i'·e_j carries
// them to the primed ones. A derivative in the fixed frame is taken of the components along fixed axes:
// (dA/dt)_in = Rᵀ d(R A)/dt, with the rotation R of `frame` (see check/scope/frame.h).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elaborate/notation/elaborator.h"

namespace rigor {

bool Elaborator::any_primed(const std::vector<WrittenIndex>& axes) {
  return std::any_of(axes.begin(), axes.end(), [](const WrittenIndex& axis) { return axis.primes > 0; });
}

std::optional<SymbolId> Elaborator::primed_axes(Span span) {
  if (const auto rotation = names_.primed_axes()) {
    note("a primed index is a component along the primed axes");
    return rotation;
  }
  fail(DiagnosticKind::ambiguous_reading, span, "nothing says how the primed axes lie to the unprimed ones",
       {"`rigor: rotation \\lambda` makes \\lambda_{i'j} the direction cosines; `rigor: basis "
        "\\mathbf{e}_{i'}` names axes of any direction"});
  return std::nullopt;
}

/// There is one set of primed axes.
bool Elaborator::primed_twice(const std::vector<WrittenIndex>& axes, Span span) {
  const bool twice =
      std::any_of(axes.begin(), axes.end(), [](const WrittenIndex& axis) { return axis.primes > 1; });
  if (twice) unsupported(span, "an index with two primes is not read");
  return twice;
}

/// The component of a vector or tensor along axes some of which are primed: A_i' = λ_i'a A_a.
std::optional<Typed> Elaborator::along_axes(Typed whole, const std::vector<WrittenIndex>& axes, Span span) {
  if (primed_twice(axes, span)) return std::nullopt;
  const auto rotation = primed_axes(span);
  if (!rotation) return std::nullopt;
  std::vector<Slot> slots;
  Typed subscript;
  if (static_cast<int>(axes.size()) != whole.rank || !read_slots(axes, slots, subscript.free))
    return unsupported(span, "this subscript is not one of index letters or axes");
  std::vector<ExprId> factors;
  std::vector<IndexId> summed;
  std::vector<Slot> inner = slots;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (axes[k].primes == 0) continue;
    summed.push_back(tree_.add_index(axes[k].text));
    inner[k] = {0, summed.back()};
    const std::array cosine{slots[k], inner[k]};
    factors.push_back(tree_.add({.op = Op::symbol, .span = span, .symbol = *rotation}, {}, cosine));
  }
  factors.push_back(component_of(tree_, whole.id, inner));
  std::vector<Typed> parts{std::move(whole), std::move(subscript)};
  std::vector<FreeIndex> to_sum;
  Typed typed;
  if (!sum_repeated(parts, to_sum, typed.free, typed.bound)) return std::nullopt;
  typed.particles = parts[0].particles;
  typed.id = tree_.add({.op = Op::multiply, .span = span}, factors);
  for (const IndexId index : summed)
    typed.id = tree_.add({.op = Op::index_sum, .span = span, .index = index}, std::span(&typed.id, 1));
  return sum_over(std::move(typed), to_sum);
}

/// `\lambda_{i'j}` and `\lambda_{ji'}` are the same cosine; where no prime is written in all of a statement,
/// the first index is the primed one.
std::optional<Typed> Elaborator::direction_cosine(const ExprNode& node, const std::vector<WrittenIndex>& axes,
                                                  Typed typed, Span span) {
  if (primed_twice(axes, span)) return std::nullopt;
  if (axes[0].primes > 0 && axes[1].primes > 0)
    return unsupported(span, "a direction cosine between two primed axes is not read");
  if (reading_.primes_on_axes && axes[0].primes == 0 && axes[1].primes == 0)
    return fail(
        DiagnosticKind::ambiguous_reading, span,
        "beside primed indices, this rotation has none, so which of its indices is the primed one is open",
        {"write the prime on one of them"});
  std::vector<Slot> slots;
  std::vector<FreeIndex> known;
  if (!read_slots(axes, slots, known))
    return unsupported(span, "this subscript is not one of index letters or axes");
  if (axes[1].primes > 0) std::swap(slots[0], slots[1]);
  typed.id = tree_.add(node, {}, slots);
  return contract(std::move(typed));
}

/// e_i' has the components λ_i'1, λ_i'2, λ_i'3.
std::optional<Typed> Elaborator::primed_basis_vector(const WrittenIndex& axis, Span span) {
  if (primed_twice({axis}, span)) return std::nullopt;
  const auto rotation = primed_axes(span);
  if (!rotation) return std::nullopt;
  std::vector<Slot> slots;
  Typed typed;
  if (!read_slots({axis}, slots, typed.free))
    return unsupported(span, "this subscript is not one of index letters or axes");
  std::array<ExprId, 3> components{};
  for (std::uint8_t k = 1; k <= 3; ++k) {
    const std::array cosine{slots[0], Slot{k, {}}};
    components[k - 1u] = tree_.add({.op = Op::symbol, .span = span, .symbol = *rotation}, {}, cosine);
  }
  typed.rank = 1;
  typed.id = tree_.add({.op = Op::tuple, .rank = 1, .span = span}, components);
  return typed;
}

/// `x_i`, `x_{i'}` in `\cos(x_{i'}, x_j)`: the direction of that axis.
std::optional<Typed> Elaborator::axis_direction(SyntaxId id, bool& is_axis) {
  is_axis = true;
  if (syntax_[id].kind == SyntaxKind::symbol) {
    const WrittenSymbol& symbol = syntax_.symbol(id);
    const bool axis = symbol.letter == "x" && symbol.face == Face::plain && symbol.lower.size() == 1;
    if (axis && symbol.lower[0].primes > 0) return primed_basis_vector(symbol.lower[0], syntax_[id].span);
    std::vector<Slot> slots;
    Typed typed;
    if (axis && read_slots(symbol.lower, slots, typed.free))
      return basis_vector(syntax_[id].span, slots[0], std::move(typed.free));
  }
  const Maybe vector = expression(id);
  is_axis = vector && tree_[vector->id].op == Op::basis;
  if (!vector || vector->rank == 1) return vector;
  return fail(DiagnosticKind::rank_mismatch, syntax_[id].span,
              "an angle lies between two vectors or two axes");
}

/// cos(a, b) = a·b/(|a||b|); the lengths of axes are 1.
std::optional<Typed> Elaborator::angle_cosine(SyntaxId first, SyntaxId second, Span span) {
  std::array<bool, 2> is_axis{};
  const Maybe a = axis_direction(first, is_axis[0]);
  const Maybe b = axis_direction(second, is_axis[1]);
  if (!a || !b) return std::nullopt;
  std::vector<FreeIndex> to_sum;
  Typed typed;
  if (!sum_repeated({*a, *b}, to_sum, typed.free, typed.bound)) return std::nullopt;
  Typed product = make(Op::dot, span, 0, {&*a, &*b});
  for (const std::size_t k : {0u, 1u}) {
    if (is_axis[k]) continue;
    const Typed length = make(Op::length, span, 0, {k == 0 ? &*a : &*b});
    product = make(Op::divide, span, 0, {&product, &length});
  }
  product.free = std::move(typed.free);
  product.bound = std::move(typed.bound);
  return sum_over(std::move(product), to_sum);
}

const Frame* Elaborator::frame_of(const std::string& label) const {
  for (const Frame& frame : names_.frames()) {
    if (frame.rotating == label || frame.fixed == label) return &frame;
  }
  return nullptr;
}

/// `\left(\frac{d\mathbf A}{dt}\right)_{\text{in}}`
std::optional<Typed> Elaborator::frame_derivative(SyntaxId id, const Frame& frame, bool fixed) {
  const Span span = syntax_[id].span;
  while (syntax_[id].kind == SyntaxKind::group) id = syntax_.child(id, 0);
  int times = 0;
  Maybe operand;
  if (syntax_[id].kind == SyntaxKind::derivative) {
    for (const WrittenVariable& by : syntax_.derivative(id).by) {
      if (syntax_.derivative(id).partial || !is_time(by.symbol))
        return unsupported(span, "a frame is read on a derivative `d/dt` only");
      times += by.times;
    }
    operand = expression(syntax_.child(id, 0));
  } else if (syntax_[id].kind == SyntaxKind::symbol && syntax_.symbol(id).dots > 0) {
    WrittenSymbol written = syntax_.symbol(id);
    times = std::exchange(written.dots, std::uint8_t{0});
    operand = symbol(written, syntax_[id].span);
  } else {
    return unsupported(span, "a frame is read on a derivative `d/dt` only");
  }
  if (!operand) return operand;
  names_.mark_used(frame.directive);
  note(fmt::format("components are along the axes of the frame `{}`", frame.rotating));
  if (!fixed || operand->rank == 0) {
    if (fixed && (!operand->free.empty() || names_an_axis(tree_, operand->id)))
      return unsupported(span, "a component's derivative in the fixed frame can be read in two ways",
                         {"differentiate the vector, then take the component"});
    return rate_of(std::move(*operand), times);
  }
  if (operand->rank > 1)
    return unsupported(span, "the derivative of a tensor in the fixed frame is not decided");
  Typed rotation;
  rotation.rank = 2;
  rotation.id = tree_.add({.op = Op::symbol, .rank = 2, .span = span, .symbol = frame.rotation});
  for (int k = 0; k < times; ++k) {
    const Typed turned = rate_of(make(Op::dot, span, 1, {&rotation, &*operand}));
    *operand = make(Op::dot, span, 1, {&turned, &rotation});
  }
  return operand;
}

}  // namespace rigor
