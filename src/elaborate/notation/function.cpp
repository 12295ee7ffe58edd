// SPDX-License-Identifier: GPL-3.0-or-later
// Named functions, angles between axes, and integrals over a body.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "elaborate/notation/derivative.h"
#include "elaborate/notation/matrix.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/change.h"
#include "elaborate/reading/summation.h"
#include "elaborate/reading/triple.h"
#include "elaborate/symbol/axes.h"

namespace rigor {
namespace {

/// A vector, or an axis, whose length is 1.
struct Direction {
  Typed along;
  bool is_axis = true;
};

/// `x_i`, `x_{i'}` in `\cos(x_{i'}, x_j)`: the direction of that axis.
std::optional<Direction> axis_direction(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  if (reading.syntax[id].kind == SyntaxKind::symbol) {
    const WrittenSymbol& symbol = reading.syntax.symbol(id);
    const bool axis = symbol.letter == "x" && symbol.face == Face::plain && symbol.lower.size() == 1;
    if (axis && symbol.lower[0].primes > 0) {
      auto primed = primed_basis_vector(reading, symbol.lower[0], span, around);
      return primed ? std::optional(Direction{*std::move(primed)}) : std::nullopt;
    }
    auto read = axis ? try_subscript(reading, symbol.lower, around) : std::nullopt;
    if (read) return Direction{basis_vector(reading, span, read->slots[0], std::move(read->free))};
  }
  auto vector = elaborate(reading, id, around);
  if (!vector) return std::nullopt;
  if (vector->rank != 1) return wrong_rank(reading, span, "an angle lies between two vectors or two axes");
  const bool is_axis = reading.tree[vector->id].op == Op::basis;
  return Direction{*std::move(vector), is_axis};
}

/// cos(a, b) = a·b/(|a||b|).
MaybeTyped angle_cosine(Reading& reading, SyntaxId first, SyntaxId second, Span span, const Around& around) {
  ExprTree& tree = reading.tree;
  const auto a = axis_direction(reading, first, around);
  const auto b = axis_direction(reading, second, around);
  if (!a || !b) return std::nullopt;
  auto letters = contraction_of(reading, {a->along, b->along});
  if (!letters) return std::nullopt;
  Typed cosine = apply_op(tree, Op::dot, span, 0, {a->along, b->along});
  for (const Direction& each : {*a, *b}) {
    if (each.is_axis) continue;
    const Typed length = apply_op(tree, Op::length, span, 0, {each.along});
    cosine = apply_op(tree, Op::divide, span, 0, {cosine, length});
  }
  return summed(tree, std::move(cosine), *std::move(letters));
}

/// Those that an expression has as they are; the others are made of them.
std::optional<Function> function_of_tree(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Function>, 8> table{{{"sin", Function::sin},
                                                                               {"cos", Function::cos},
                                                                               {"exp", Function::exp},
                                                                               {"ln", Function::log},
                                                                               {"log", Function::log},
                                                                               {"arcsin", Function::arcsin},
                                                                               {"arccos", Function::arccos},
                                                                               {"arctan", Function::arctan}}};
  const auto found = std::ranges::find(table, name, &std::pair<std::string_view, Function>::first);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

MaybeTyped elementary_function(Reading& reading, const std::string& name, const Typed& argument, Span span) {
  if (argument.rank != 0)
    return wrong_rank(reading, span, fmt::format("`{}` of a vector or tensor is not defined", name));
  if (!argument.free.empty())
    return unsupported(reading, span, "a function of a component with a free index is not decided");
  ExprTree& tree = reading.tree;
  const auto apply = [&](Function function, Typed to) {
    to.id = tree.add({.op = Op::function, .span = span, .function = function}, std::span(&to.id, 1));
    return to;
  };
  const auto over = [&](const Typed& above, const Typed& below) {
    return apply_op(tree, Op::divide, span, 0, {above, below});
  };
  // What every library of functions has, as the quotient that decides it.
  const auto named_quotient = [&](Typed above, const Typed& below) {
    const ExprId parts[] = {above.id, below.id};
    above.id = tree.add({.op = Op::divide, .span = span, .spelled_out = true}, parts);
    return above;
  };
  if (name == "log" && !reading.found.guess)
    reading.found.guess = Obstacle{DiagnosticKind::ambiguous_reading,
                                   "`\\log` was read as the natural logarithm, and can be the decimal one",
                                   {"write `\\ln` or `\\log_{10}`"}};
  if (const auto function = function_of_tree(name)) return apply(*function, argument);
  const auto number = [&](const char* digits) { return Typed{.id = tree.add_number(span, digits)}; };
  const auto opposite = [&](const Typed& of) { return apply_op(tree, Op::negate, span, 0, {of}); };
  const auto sum = [&](const Typed& a, const Typed& b) { return apply_op(tree, Op::add, span, 0, {a, b}); };
  const auto root = [&](const Typed& of) { return apply_op(tree, Op::root, span, 0, {of}); };
  const auto logarithm = [&](const Typed& of) { return apply(Function::log, of); };
  const Typed one = number("1");
  const Typed sine = apply(Function::sin, argument);
  const Typed cosine = apply(Function::cos, argument);
  if (name == "tan") return named_quotient(sine, cosine);
  if (name == "cot") return over(cosine, sine);
  if (name == "sec") return over(one, cosine);
  if (name == "csc") return over(one, sine);
  if (name == "lg") return over(logarithm(argument), logarithm(number("10")));
  if (name == "lb") return over(logarithm(argument), logarithm(number("2")));
  const Typed square = apply_op(tree, Op::power, span, 0, {argument}, 2);
  if (name == "arsinh") return logarithm(sum(argument, root(sum(square, one))));
  if (name == "arcosh") return logarithm(sum(argument, root(sum(square, opposite(one)))));
  if (name == "artanh")
    return over(logarithm(over(sum(one, argument), sum(one, opposite(argument)))), number("2"));
  const Typed grows = apply(Function::exp, argument);
  const Typed falls = apply(Function::exp, opposite(argument));
  const Typed both = sum(grows, falls);
  const Typed difference = sum(grows, opposite(falls));
  if (name == "sinh") return named_quotient(difference, number("2"));
  if (name == "cosh") return named_quotient(both, number("2"));
  if (name == "tanh") return named_quotient(difference, both);
  if (name == "coth") return over(both, difference);
  if (name == "sech") return over(number("2"), both);
  if (name == "csch") return over(number("2"), difference);
  return unsupported(reading, span, fmt::format("the function `\\{}` is not decided", name));
}

MaybeTyped elaborate_function(Reading& reading, SyntaxId id, const Around& around) {
  const std::string& name = reading.syntax.text(id);
  const SyntaxId argument = reading.syntax.child(id, 0);
  const Span span = reading.syntax[id].span;
  if (is_part_of_complex(name)) return elaborate_part(reading, id, around);
  if (name == "average") return elaborate_average(reading, id, around);
  if (name == "ket" || name == "bra") return elaborate_state(reading, id);
  if (name == "D/Dt") return material_rate(reading, argument, span, around);
  if (name == "O")
    return unsupported(reading, span,
                       "`O(…)` is read at the end of a side, where it says up to which power of a letter "
                       "the sides agree");
  if (name == "transpose") return elaborate_transpose(reading, id, around);
  if (name == "adjoint") return elaborate_adjoint(reading, id, around);
  if (name == "diag") return elaborate_diagonal(reading, id, around);
  if (name == "det" || name == "tr") return trace_or_determinant(reading, argument, name != "det", around);
  if (reading.syntax[argument].kind == SyntaxKind::tuple) {
    if (name == "cos" && reading.syntax[argument].count == 2)
      return angle_cosine(reading, reading.syntax.child(argument, 0), reading.syntax.child(argument, 1), span,
                          around);
    return unsupported(reading, span, fmt::format("`\\{}` of several arguments is not read", name));
  }
  const auto inside = elaborate(reading, argument, around);
  if (!inside) return inside;
  if (const auto of_field = field_operator(name)) return apply_nabla(reading, *of_field, *inside, span);
  if (name == "exp" && reading.found.triples && inside->layout == Layout::matrix)
    return matrix_exponential(reading, *inside, span);
  return elementary_function(reading, name, *inside, span);
}

/// ∫ f dm is Σ over the body's particles of m f. A volume element is a particle's volume V, and ρ = m/V.
MaybeTyped elaborate_integral(Reading& reading, SyntaxId id, const Around& around) {
  ExprTree& tree = reading.tree;
  const Span span = reading.syntax[id].span;
  if (reading.syntax.children(id).size() > 1) {
    const std::string& region = reading.syntax.text(reading.syntax.child(id, 1));
    std::optional<std::string>& known = reading.found.region;
    if (known && *known != region)
      return ambiguous(
          reading, span,
          fmt::format("the regions `{}` and `{}` can be the same or different ones", *known, region),
          {"write one name for one region"});
    known = region;
  }
  const auto of_point = [&](const char* base) { return symbol_named(reading, {base, 0, true}, base, span); };
  const bool by_mass = reading.syntax.text(id) == "m";
  const ParticleId point = tree.add_particle("∫");
  Around body = around;
  body.body_point = point;
  const auto inside = elaborate(reading, reading.syntax.child(id, 0), body);
  if (!inside) return inside;
  note(reading, "an integral over the body is a sum over its particles");
  const auto value = [&](SymbolId symbol) {
    return tree.add({.op = Op::symbol, .span = span, .symbol = symbol, .particle = point});
  };
  const SymbolId mass = of_point("m");
  const SymbolId volume = of_point("V");
  const SymbolId density = of_point("\\rho");
  if (!by_mass && definition_of(reading.names.scope, density) == nullptr) {
    const ExprId parts[] = {value(mass), value(volume)};
    const ExprId ratio = tree.add({.op = Op::divide, .span = span}, parts);
    define(reading.names.scope, {{density, {}, point, ratio}, {"density \\rho", "", std::nullopt}, 0});
  }
  Typed typed = *inside;
  const ExprId factors[] = {inside->id, value(by_mass ? mass : volume)};
  const auto rank = static_cast<std::uint8_t>(inside->rank);
  const ExprId element = tree.add({.op = Op::multiply, .rank = rank, .span = span}, factors);
  typed.id = tree.add({.op = Op::particle_sum, .rank = rank, .span = span, .particle = point},
                      std::span(&element, 1));
  return typed;
}

}  // namespace rigor
