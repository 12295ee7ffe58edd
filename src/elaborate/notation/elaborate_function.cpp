// SPDX-License-Identifier: GPL-3.0-or-later
// Named functions, determinants and traces, and integrals over a body.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elaborate/evidence/seen_functions.h"
#include "elaborate/notation/elaborator.h"

namespace rigor {

std::optional<Typed> Elaborator::function(SyntaxId id) {
  const std::string& name = syntax_.text(id);
  const SyntaxId argument = syntax_.child(id, 0);
  const Span span = syntax_[id].span;
  if (name == "D/Dt") return material_rate(argument, span);
  if (name == "O")
    return unsupported(span,
                       "`O(…)` is read at the end of a side, where it says up to which power of a letter "
                       "the sides agree");
  if (name == "det" || name == "tr") return trace_or_determinant(argument, name != "det");
  if (syntax_[argument].kind == SyntaxKind::tuple) {
    if (name == "cos" && syntax_[argument].count == 2)
      return angle_cosine(syntax_.child(argument, 0), syntax_.child(argument, 1), span);
    return unsupported(span, fmt::format("`\\{}` of several arguments is not read", name));
  }
  const Maybe inside = expression(argument);
  if (!inside) return inside;
  if (const auto of_field = field_operator(name)) return apply_nabla(*of_field, *inside, span);
  return elementary(name, *inside, span);
}

/// `\omega(2k)` where the section has `\omega(k) = …`, and neither ω nor k is declared.
bool Elaborator::applies_elsewhere(SyntaxId symbol, SyntaxId bracket) const {
  if (syntax_[bracket].kind == SyntaxKind::power) bracket = syntax_.child(bracket, 0);
  if (syntax_[bracket].kind != SyntaxKind::group) return false;
  const WrittenSymbol& written = syntax_.symbol(symbol);
  const std::set<std::string>* arguments = arguments_of(syntax_, symbol, bracket, names_.evidence);
  if (arguments == nullptr || names_.is_declared({written.letter, 0, false})) return false;
  return std::any_of(arguments->begin(), arguments->end(), [&](const std::string& letter) {
    return !names_.is_declared({letter, 0, false});
  });
}

std::optional<Typed> Elaborator::elementary(const std::string& name, const Typed& argument, Span span) {
  if (argument.rank != 0)
    return fail(DiagnosticKind::rank_mismatch, span,
                fmt::format("`{}` of a vector or tensor is not defined", name));
  if (!argument.free.empty())
    return unsupported(span, "a function of a component with a free index is not decided");
  const auto apply = [&](Function function, const Typed& to) {
    Typed typed = to;
    typed.id = tree_.add({.op = Op::function, .span = span, .function = function}, std::span(&to.id, 1));
    return typed;
  };
  const auto over = [&](const Typed& above, const Typed& below) {
    return make(Op::divide, span, 0, {&above, &below});
  };
  if (name == "exp") return apply(Function::exp, argument);
  const Typed sine = apply(Function::sin, argument);
  const Typed cosine = apply(Function::cos, argument);
  Typed one;
  one.id = tree_.add_number(span, "1");
  if (name == "sin") return sine;
  if (name == "cos") return cosine;
  if (name == "tan") return over(sine, cosine);
  if (name == "cot") return over(cosine, sine);
  if (name == "sec") return over(one, cosine);
  if (name == "csc") return over(one, sine);
  const bool hyperbolic = name == "sinh" || name == "cosh" || name == "tanh";
  if (!hyperbolic) return unsupported(span, fmt::format("the function `\\{}` is not decided", name));
  const Typed grows = apply(Function::exp, argument);
  const Typed falls = apply(Function::exp, make(Op::negate, span, 0, {&argument}));
  const Typed minus = make(Op::negate, span, 0, {&falls});
  Typed two;
  two.id = tree_.add_number(span, "2");
  const Typed sum = make(Op::add, span, 0, {&grows, &falls});
  const Typed difference = make(Op::add, span, 0, {&grows, &minus});
  if (name == "tanh") return over(difference, sum);
  return over(name == "cosh" ? sum : difference, two);
}

/// `\det A` where A_{ij} is a tensor.
std::optional<Typed> Elaborator::whole_tensor(SyntaxId id) {
  if (syntax_[id].kind != SyntaxKind::symbol) return std::nullopt;
  const WrittenSymbol& written = syntax_.symbol(id);
  if (!is_undecorated(written) || !written.lower.empty()) return std::nullopt;
  const bool tensor = is_known(written.letter, 2, false) && !names_.is_declared({written.letter, 0, false});
  if (!tensor) return std::nullopt;
  return make_symbol(written, written.letter, 2, {.base = written.letter, .axes = {}, .particles = {}}, {},
                     syntax_[id].span);
}

std::optional<Typed> Elaborator::trace_or_determinant(SyntaxId id, bool trace) {
  const Span span = syntax_[id].span;
  const Maybe whole = whole_tensor(id);
  const Maybe inside = whole ? whole : expression(id);
  if (!inside) return inside;
  if (!trace) return determinant_of(id, *inside, span);
  if (inside->rank != 2) return unsupported(span, "a trace is read of a second-rank tensor only");
  std::vector<ExprId> diagonal;
  for (std::uint8_t k = 1; k <= 3; ++k) {
    const std::array slots{Slot{k, {}}, Slot{k, {}}};
    diagonal.push_back(component_of(tree_, inside->id, slots));
  }
  Typed typed = *inside;
  typed.rank = 0;
  typed.id = sum_of(diagonal, 0, span);
  return typed;
}

/// Of a second-rank tensor, or of what stands at `id` with two free indices: row by row, each entry read with
/// the indices at its place.
std::optional<Typed> Elaborator::determinant_of(SyntaxId id, const Typed& inside, Span span) {
  if (inside.rank != 2 && !(inside.rank == 0 && inside.free.size() == 2))
    return unsupported(span, "a determinant is read of a second-rank tensor only");
  std::vector<ExprId> entries;
  for (std::uint8_t row = 1; row <= 3; ++row) {
    for (std::uint8_t column = 1; column <= 3; ++column) {
      if (inside.rank == 2) {
        const std::array slots{Slot{row, {}}, Slot{column, {}}};
        entries.push_back(component_of(tree_, inside.id, slots));
        continue;
      }
      fixed_axes_[inside.free[0].letter] = row;
      fixed_axes_[inside.free[1].letter] = column;
      const Maybe entry = expression(id);
      if (!entry) break;
      entries.push_back(entry->id);
    }
  }
  if (inside.rank == 0) {
    for (const FreeIndex& free : inside.free) fixed_axes_.erase(free.letter);
  }
  if (entries.size() != 9) return std::nullopt;
  Typed typed;
  typed.particles = inside.particles;
  if (inside.rank == 2) typed.free = inside.free;
  typed.id = tree_.add({.op = Op::determinant, .span = span}, entries);
  return typed;
}

/// ∫ f dm is Σ over the body's particles of m f. A volume element is a particle's volume V, and ρ = m/V.
std::optional<Typed> Elaborator::integral(SyntaxId id) {
  const Span span = syntax_[id].span;
  if (syntax_.children(id).size() > 1) {
    const std::string& region = syntax_.text(syntax_.child(id, 1));
    if (region_ && *region_ != region)
      return fail(
          DiagnosticKind::ambiguous_reading, span,
          fmt::format("the regions `{}` and `{}` can be the same or different ones", *region_, region),
          {"write one name for one region"});
    region_ = region;
  }
  const auto of_point = [&](const char* base) { return names_.resolve(tree_, {base, 0, true}, base, span); };
  const bool by_mass = syntax_.text(id) == "m";
  const ParticleId point = tree_.add_particle("∫");
  const auto before = std::exchange(body_point_, point);
  const Maybe inside = expression(syntax_.child(id, 0));
  body_point_ = before;
  if (!inside) return inside;
  note("an integral over the body is a sum over its particles");
  const auto value = [&](SymbolId symbol) {
    return tree_.add({.op = Op::symbol, .span = span, .symbol = symbol, .particle = point});
  };
  const SymbolId mass = of_point("m");
  const SymbolId volume = of_point("V");
  const SymbolId density = of_point("\\rho");
  if (!by_mass && names_.definition_of(density) == nullptr) {
    const ExprId parts[] = {value(mass), value(volume)};
    const ExprId ratio = tree_.add({.op = Op::divide, .span = span}, parts);
    names_.define({{density, {}, point, ratio}, {"density \\rho", "", std::nullopt}, 0});
  }
  Typed typed = *inside;
  const ExprId factors[] = {inside->id, value(by_mass ? mass : volume)};
  const auto rank = static_cast<std::uint8_t>(inside->rank);
  const ExprId element = tree_.add({.op = Op::multiply, .rank = rank, .span = span}, factors);
  typed.id = tree_.add({.op = Op::particle_sum, .rank = rank, .span = span, .particle = point},
                       std::span(&element, 1));
  return typed;
}

}  // namespace rigor
