// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/application.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "base/among.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/name/family.h"
#include "elaborate/notation/notations.h"
#include "elaborate/symbol/named_symbol.h"
#include "expr/print/print_latex.h"
#include "expr/print/usual_letters.h"

namespace rigor {
namespace {

constexpr int most_power_of_value = 16;

/// A bracket that holds one bare symbol or number: `(t)`, `(x)`.
bool holds_one_symbol(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind != SyntaxKind::group) return false;
  const SyntaxKind inside = syntax[syntax.child(id, 0)].kind;
  return inside == SyntaxKind::symbol || inside == SyntaxKind::number;
}

/// `\frac{d\phi}{dt}(t + T)`: a derivative, and a bracket that speaks of what it is by.
bool is_taken_at(const SyntaxTree& syntax, SyntaxId derivative, SyntaxId bracket) {
  if (syntax[derivative].kind != SyntaxKind::derivative || syntax[bracket].kind != SyntaxKind::group)
    return false;
  return std::ranges::any_of(nodes_below(syntax, {syntax.child(bracket, 0)}), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol &&
           std::ranges::any_of(syntax.derivative(derivative).by, [&](const auto& each) {
             return each.symbol.letter == syntax.symbol(id).letter;
           });
  });
}

/// `n(n + 1)`: nobody takes a function of itself.
bool holds_letter(const SyntaxTree& syntax, SyntaxId bracket, const std::string& letter) {
  return std::ranges::any_of(nodes_below(syntax, {bracket}), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).letter == letter;
  });
}

/// `I(\dot\psi + \dot\varphi\cos\theta)`, `U(1 - a^2/r^2)`: a sum with rates, or of a bare number and more
/// than a letter, is a factor to all who read it.
bool sums_as_a_factor(const SyntaxTree& syntax, SyntaxId sum) {
  if (syntax[sum].kind != SyntaxKind::sum || syntax.children(sum).size() < 2) return false;
  bool number = false;
  bool more = false;
  for (const SyntaxChild& term : syntax.children(sum)) {
    if (syntax[term.id].kind == SyntaxKind::number) number = true;
    for (const SyntaxId id : nodes_below(syntax, {term.id})) {
      const SyntaxKind kind = syntax[id].kind;
      if (kind == SyntaxKind::symbol && syntax.symbol(id).dots > 0) return true;
      more =
          more || kind == SyntaxKind::fraction || kind == SyntaxKind::power || kind == SyntaxKind::function;
    }
  }
  return number && more;
}

/// `f(x-ct)`, `V(2r)`: a bracket of plain coordinates after a letter that is no usual coefficient.
bool looks_like_argument(const Reading& reading, const WrittenSymbol& symbol, SyntaxId bracket) {
  const SyntaxTree& syntax = reading.syntax;
  if (syntax[bracket].kind != SyntaxKind::group || is_usual_coefficient(symbol.letter)) return false;
  if (is_declared_letter(reading.names, symbol) || sums_as_a_factor(syntax, syntax.child(bracket, 0)))
    return false;
  bool coordinate = false;
  const bool more = std::ranges::any_of(nodes_below(syntax, {syntax.child(bracket, 0)}), [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return false;
    const WrittenSymbol& inside = syntax.symbol(id);
    coordinate = coordinate || is_usual_coordinate(inside.letter);
    return inside.face != Face::plain || is_kronecker(inside) ||
           std::ranges::any_of(inside.lower,
                               [](const WrittenIndex& index) { return index.form == IndexForm::letter; });
  });
  return coordinate && !more;
}

/// `\omega(2k)` where the section has `\omega(k) = …`, and neither ω nor k is declared.
bool applies_elsewhere(const Reading& reading, SyntaxId symbol, SyntaxId bracket) {
  const SyntaxTree& syntax = reading.syntax;
  if (syntax[bracket].kind == SyntaxKind::power) bracket = syntax.child(bracket, 0);
  if (syntax[bracket].kind != SyntaxKind::group) return false;
  const WrittenSymbol& written = syntax.symbol(symbol);
  const std::set<std::string>* arguments =
      arguments_of(syntax, symbol, bracket, *reading.names.symbols.evidence);
  if (arguments == nullptr || is_declared(reading.names.symbols, {written.letter, 0, false})) return false;
  return std::ranges::any_of(*arguments, [&](const std::string& letter) {
    return !is_declared(reading.names.symbols, {letter, 0, false});
  });
}

bool holds_bold(const SyntaxTree& syntax, SyntaxId bracket) {
  return std::ranges::any_of(nodes_below(syntax, {bracket}), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).face != Face::plain;
  });
}

/// A Greek subscript that labels no particle, twice in a term: a label, or an index of space-time that is
/// summed.
std::optional<SpelledPart> repeated_greek(const Reading& reading, std::span<const SyntaxChild> factors) {
  const SyntaxTree& syntax = reading.syntax;
  std::set<std::string> seen;
  for (const SyntaxChild& child : factors) {
    if (syntax[child.id].kind != SyntaxKind::symbol) continue;
    std::set<std::string> own;
    for (const WrittenIndex& index : syntax.symbol(child.id).lower) {
      const bool label = index.form == IndexForm::greek &&
                         !labels_particles(reading.names.symbols, index.text) &&
                         !is_space_time_index(*reading.names.symbols.evidence, index);
      if (label) own.insert(index.text);
    }
    for (const std::string& letter : own) {
      if (seen.insert(letter).second) continue;
      return SpelledPart{
          syntax[child.id].span,
          fmt::format("`{}` twice in a term can be a label or an index that is summed", letter),
          {fmt::format("`rigor: particles {}` makes it a particle's label, which is summed only by `\\sum`",
                       letter)}};
    }
  }
  return std::nullopt;
}

/// `\pi(10)`: the number of primes or a permutation, or ten times π.
std::optional<SpelledPart> circle_before_number(const SyntaxTree& syntax,
                                                std::span<const SyntaxChild> factors) {
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
    if (syntax[factors[k].id].kind != SyntaxKind::symbol || factors[k + 1].joint != Joint::juxtaposed)
      continue;
    const WrittenSymbol& symbol = syntax.symbol(factors[k].id);
    SyntaxId bracket = factors[k + 1].id;
    if (syntax[bracket].kind == SyntaxKind::power) bracket = syntax.child(bracket, 0);
    if (symbol.letter != "\\pi" || !symbol.lower.empty() || syntax[bracket].kind != SyntaxKind::group ||
        syntax[syntax.child(bracket, 0)].kind != SyntaxKind::number)
      continue;
    return SpelledPart{cover(syntax[factors[k].id].span, syntax[bracket].span),
                       "this can be a multiple of π, or the value of a function `\\pi`",
                       {"write the number before `\\pi`"}};
  }
  return std::nullopt;
}

bool is_greek_d(const WrittenSymbol& symbol) {
  return (symbol.letter == "\\delta" || symbol.letter == "\\Delta") && symbol.lower.empty() &&
         symbol.face == Face::plain && symbol.accent == Accent::none && symbol.primes == 0 &&
         symbol.change.empty();
}

/// `f^{-1}(y)` where the section writes `f(x)`.
bool may_be_inverse(const Reading& reading, SyntaxId power, SyntaxId bracket) {
  const SyntaxTree& syntax = reading.syntax;
  if (syntax[bracket].kind != SyntaxKind::group) return false;
  SyntaxId one = syntax.child(power, 1);
  while (syntax[one].kind == SyntaxKind::group) one = syntax.child(one, 0);
  const bool negative = syntax[one].kind == SyntaxKind::sum && syntax.children(one).size() == 1 &&
                        syntax.children(one)[0].joint == Joint::minus;
  if (!negative || syntax[syntax.child(one, 0)].kind != SyntaxKind::number) return false;
  return syntax.text(syntax.child(one, 0)) == "1" &&
         is_applied(*reading.names.symbols.evidence,
                    letter_with_marks(syntax.symbol(syntax.child(power, 0))));
}

/// \sigma of `\sigma^2` and `\sigma^{-1}`, \psi of `|\psi|^2`; not e of `e^x`.
std::optional<SyntaxId> letter_in_power(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind != SyntaxKind::power) return std::nullopt;
  const bool whole = std::ranges::none_of(nodes_below(syntax, {syntax.child(id, 1)}), [&](SyntaxId each) {
    return syntax[each].kind != SyntaxKind::number && syntax[each].kind != SyntaxKind::sum &&
           syntax[each].kind != SyntaxKind::group;
  });
  if (!whole) return std::nullopt;
  SyntaxId base = syntax.child(id, 0);
  const bool modulus = syntax[base].kind == SyntaxKind::bars;
  if (modulus) base = syntax.child(base, 0);
  return syntax[base].kind == SyntaxKind::symbol ? std::optional(base) : std::nullopt;
}

/// `(fg)` and `(f + g)` where the section writes `f(x)` and `g(x)`.
bool joins_functions(const Reading& reading, SyntaxId group) {
  const SyntaxTree& syntax = reading.syntax;
  if (syntax[group].kind != SyntaxKind::group) return false;
  std::size_t letters = 0;
  for (const SyntaxId id : nodes_below(syntax, {group})) {
    if (syntax[id].kind == SyntaxKind::number) return false;
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    if (!is_applied(*reading.names.symbols.evidence, letter_with_marks(syntax.symbol(id)))) return false;
    ++letters;
  }
  return letters > 1;
}

/// Does an operator stand in it?
bool holds_operator(const Reading& reading, SyntaxId bracket) {
  const Evidence& evidence = *reading.names.symbols.evidence;
  if (evidence.noncommuting.empty() && evidence.noncommuting_triples.empty()) return false;
  return std::ranges::any_of(nodes_below(reading.syntax, {bracket}), [&](SyntaxId id) {
    return reading.syntax[id].kind == SyntaxKind::symbol && is_operator(evidence, reading.syntax.symbol(id));
  });
}

/// `f(x)` and `\omega(t)` can be a value of a function or a product; `dx` a differential or a product.
std::optional<SpelledPart> application(Reading& reading, std::span<const SyntaxChild> factors) {
  const SyntaxTree& syntax = reading.syntax;
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
    const SyntaxId id = factors[k].id;
    const SyntaxId next = factors[k + 1].id;
    const Span both = cover(syntax[id].span, syntax[next].span);
    if (factors[k + 1].joint != Joint::juxtaposed) continue;
    if (syntax[id].kind == SyntaxKind::unit && syntax[next].kind == SyntaxKind::number)
      return SpelledPart{both,
                         "a number after a unit can be added, as in 1 h 30 min, or multiplied",
                         {"a sign between them says which is meant"}};
    if (is_taken_at(syntax, id, next))
      return SpelledPart{both, "this can be a product, or the derivative at the value in the bracket", {}};
    const bool power_of_symbol =
        syntax[id].kind == SyntaxKind::power && syntax[syntax.child(id, 0)].kind == SyntaxKind::symbol;
    if (power_of_symbol && is_greek_d(syntax.symbol(syntax.child(id, 0))))
      return SpelledPart{both, "this can be a change of second order, or a power and a factor", {}};
    if (power_of_symbol && may_be_inverse(reading, id, next))
      return SpelledPart{both, "this can be the value of the inverse function, or a reciprocal", {}};
    const bool of_letter =
        syntax[next].kind == SyntaxKind::group && syntax[syntax.child(next, 0)].kind == SyntaxKind::symbol;
    if (of_letter && joins_functions(reading, id))
      return SpelledPart{both, "this can be the value of functions that are joined, or a product", {}};
    const auto squared = letter_in_power(syntax, id);
    if (squared && syntax[next].kind == SyntaxKind::group &&
        part_of_bracket(reading, *squared, next) != BracketPart::factor)
      return SpelledPart{both,
                         "this can be a power of a function's value, or a power and a factor",
                         {"`f(x)^2` is a power of a value, and a factor can stand before the power"}};
    const bool starred = syntax[id].kind == SyntaxKind::function && syntax.text(id) == "conjugate";
    if (starred && syntax[next].kind == SyntaxKind::group &&
        part_of_bracket(reading, without_derivatives(syntax, id), next) != BracketPart::factor)
      return SpelledPart{both, "this can be a product, or the conjugate of a function's value", {}};
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(id);
    if (is_kronecker(symbol) || is_levi_civita(symbol) || is_nabla(syntax, id)) continue;
    if (power_of_value(reading, id, factors[k + 1])) continue;
    const BracketPart part = part_of_bracket(reading, id, next);
    if (part != BracketPart::factor && holds_operator(reading, next))
      return SpelledPart{
          both,
          fmt::format("this can be a product, or a function `{}` of operators, which is not read yet",
                      symbol.letter),
          {fmt::format("`rigor: scalar {}` makes it a product", symbol.letter)}};
    if (part == BracketPart::argument ||
        (part == BracketPart::open && reading.rules.open != OpenBracket::refused))
      continue;
    if (part == BracketPart::open)
      return SpelledPart{both, reading.found.applied->message, reading.found.applied->help};
    if (applies_elsewhere(reading, id, next))
      return SpelledPart{
          both,
          fmt::format("`{}` is written as a function elsewhere: this can be its value or a product",
                      symbol.letter),
          {fmt::format("`rigor: scalar {}` makes it a product", symbol.letter)}};
    const bool bare_d =
        symbol.letter == "d" && symbol.lower.empty() && symbol.face == Face::plain && symbol.primes == 0;
    SyntaxId changed = next;
    if (syntax[changed].kind == SyntaxKind::power) changed = syntax.child(changed, 0);
    const SyntaxKind of = syntax[changed].kind;
    const bool greek_d = is_greek_d(symbol);
    const bool is_letter = is_declared(reading.names.symbols, {symbol.letter, 0, false}) ||
                           is_small_scalar(reading.names, reading.tree, symbol.letter);
    if (greek_d && of == SyntaxKind::symbol && reading.rules.differentials) continue;
    if (greek_d && of != SyntaxKind::group && !is_letter)
      return SpelledPart{
          syntax[id].span,
          fmt::format("`{}` before another factor reads as a small change of it, which is not decided yet",
                      symbol.letter),
          {fmt::format("`rigor: scalar {}` makes it a factor", symbol.letter)}};
    if (greek_d && of == SyntaxKind::group && !is_letter)
      return SpelledPart{
          syntax[id].span,
          fmt::format("`{}` before a bracket can be a change of what is in it, a function, or a factor",
                      symbol.letter),
          {fmt::format("`rigor: scalar {}` makes it a factor", symbol.letter)}};
    if (bare_d && (of == SyntaxKind::symbol || of == SyntaxKind::group) && !reading.rules.differentials &&
        !is_declared(reading.names.symbols, {"d", 0, false}))
      return SpelledPart{
          syntax[id].span, "`d` can be a differential or a factor", {"`rigor: scalar d` makes it a factor"}};
  }
  return std::nullopt;
}

/// `1\,000` and `2\frac{1}{2}` are one number each to most readers, and products to the letter.
std::optional<SpelledPart> number_run(const Reading& reading, std::span<const SyntaxChild> factors) {
  const SyntaxTree& syntax = reading.syntax;
  const auto is_number_sign = [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::number; };
  const auto is_numeric_fraction = [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::fraction && is_number_sign(syntax.child(id, 0)) &&
           is_number_sign(syntax.child(id, 1));
  };
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
    const SyntaxId next = factors[k + 1].id;
    if (factors[k + 1].joint != Joint::juxtaposed || !is_number_sign(factors[k].id)) continue;
    if (!is_number_sign(next) && !is_numeric_fraction(next)) continue;
    return SpelledPart{cover(syntax[factors[k].id].span, syntax[next].span),
                       "two numbers side by side can be one number or a product",
                       {"write `\\cdot` for a product"}};
  }
  return std::nullopt;
}

}  // namespace

BracketPart part_of_bracket(Reading& reading, SyntaxId function, SyntaxId bracket) {
  const SyntaxTree& syntax = reading.syntax;
  if (syntax[function].kind != SyntaxKind::symbol) return BracketPart::factor;
  const WrittenSymbol& symbol = syntax.symbol(function);
  const SyntaxKind kind = syntax[bracket].kind;
  const bool brackets = kind == SyntaxKind::group || kind == SyntaxKind::tuple;
  if (brackets && holds_operator(reading, bracket) &&
      (is_operator(*reading.names.symbols.evidence, symbol) || is_usual_coefficient(symbol.letter) ||
       symbol.letter == "\\hbar" || symbol.letter == "\\omega"))
    return BracketPart::factor;
  if (is_kronecker(symbol) || is_levi_civita(symbol) || is_nabla(syntax, function) ||
      is_never_applied(symbol) || (kind != SyntaxKind::group && kind != SyntaxKind::tuple) ||
      holds_letter(syntax, bracket, symbol.letter))
    return BracketPart::factor;
  // `\gamma(c, \mathbf v)`: a multiple of a four-vector.
  const bool of_event = reading.names.symbols.evidence->space_time.shown && kind == SyntaxKind::tuple;
  if (of_event && (symbol.letter == "\\gamma" || is_usual_coefficient(symbol.letter)))
    return BracketPart::factor;
  // Nobody writes an argument as a column, and a number stands before a sum of matrices. But `R(\alpha)` is
  // hardly a multiple of R, and `\lambda(AB)` can be an eigenvalue.
  const Evidence& here = *reading.names.symbols.evidence;
  const bool matrix = is_matrix_letter(symbol, here);
  const bool of_matrices = holds_matrix_letter(syntax, bracket, here);
  const bool sum = syntax[syntax.child(bracket, 0)].kind == SyntaxKind::sum;
  if (of_matrices && (matrix || sum || written_shape(syntax, bracket).any())) return BracketPart::factor;
  if (matrix || of_matrices) {
    reading.found.applied =
        Obstacle{DiagnosticKind::ambiguous_reading,
                 "this can be a multiple of a matrix, or the value of a function",
                 {"a number is written before its matrix, and without brackets around a product"}};
    return BracketPart::open;
  }
  const SyntaxId argument = syntax.child(bracket, 0);
  const bool one_symbol = syntax[argument].kind == SyntaxKind::symbol && kind == SyntaxKind::group;
  if (one_symbol && is_declared(reading.names.symbols, {syntax.symbol(argument).letter, 0, false}))
    return BracketPart::factor;
  if (kind == SyntaxKind::group && whole_number(syntax, argument) == 0) return BracketPart::argument;
  if (const auto variables = variables_of(symbol, *reading.names.symbols.evidence)) {
    const bool of_variable = std::ranges::any_of(
        *variables, [&](const std::string& letter) { return holds_letter(syntax, bracket, letter); });
    const bool declared = std::ranges::any_of(*variables, [&](const std::string& letter) {
      return is_declared(reading.names.symbols, {letter, 0, false});
    });
    if (!declared &&
        (holds_one_symbol(syntax, bracket) || (of_variable && !is_usual_coefficient(symbol.letter))))
      return BracketPart::argument;
  }
  const bool looks = holds_one_symbol(syntax, bracket) || looks_like_argument(reading, symbol, bracket) ||
                     (kind == SyntaxKind::tuple && symbol.face == Face::plain);
  const bool elsewhere =
      !looks && applies_elsewhere(reading, function, bracket) && !holds_bold(syntax, bracket);
  if (!looks && !elsewhere) return BracketPart::factor;
  reading.found.applied_elsewhere = reading.found.applied_elsewhere || elsewhere;
  reading.found.applied =
      Obstacle{DiagnosticKind::ambiguous_reading,
               "this can be a product or the value of a function",
               {"write a function without its argument in definitions and claims",
                fmt::format("`rigor: scalar {}` makes it a product",
                            one_symbol ? syntax.symbol(argument).letter : symbol.letter)}};
  return BracketPart::open;
}

std::vector<std::string> variables_of_definition(const Names& names, WrittenSymbol function) {
  function.primes = 0;
  function.dots = 0;
  const auto symbol =
      find_symbol(names.symbols, {with_labels(letter_with_marks(function), function.lower), 0, false});
  const bool is_here = symbol && seen_in_equation(names.scope, *symbol);  // or in a section around it
  const NamedDefinition* named = is_here ? definition_of(names.scope, *symbol) : nullptr;
  std::vector<std::string> variables;
  if (named == nullptr) return variables;
  for (const SymbolId letter : named->along) {
    if (const NameKey* key = key_of(names.symbols, letter)) variables.push_back(key->base);
  }
  return variables;
}

namespace {

/// `V''` of V'' where primes differentiate, as it is read back; else as it is printed.
std::string name_of_function(const Reading& reading, const Typed& of) {
  const ExprNode& node = reading.tree[of.id];
  const auto* derivation = node.op == Op::symbol && reading.tree.symbols[node.symbol].derivation
                               ? &*reading.tree.symbols[node.symbol].derivation
                               : nullptr;
  const bool primed = derivation != nullptr && std::ranges::all_of(derivation->by, [](const Variable& by) {
                        return by.by == By::letter && !by.partial;
                      });
  if (!primed) return print_latex(reading.tree, of.id);
  return reading.tree.symbols[derivation->base].name + std::string(derivation->by.size(), '\'');
}

/// `U(R)` of `U(r) = …`, where R is defined, or `y(L)`, where L stands in what y is: the value there.
bool is_value_at_what_is_known(const Reading& reading, SyntaxId applied, SyntaxId bracket) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId function = without_derivatives(syntax, applied);
  if (syntax[function].kind != SyntaxKind::symbol || syntax[bracket].kind != SyntaxKind::group) return false;
  const SyntaxId argument = syntax.child(bracket, 0);
  if (syntax[argument].kind != SyntaxKind::symbol) return false;
  const Names& names = reading.names;
  const auto named = [&](SyntaxId id) {
    WrittenSymbol letter = syntax.symbol(id);
    letter.primes = 0;
    return with_labels(letter_with_marks(letter), letter.lower);
  };
  const auto symbol = find_symbol(names.symbols, {named(argument), 0, false});
  const std::vector<std::string> variables = variables_of_definition(names, syntax.symbol(function));
  if (!symbol || variables.size() != 1 || variables.front() == named(argument)) return false;
  const auto of = find_symbol(names.symbols, {named(function), 0, false});
  const auto body = of ? body_of_definition(names.scope, *of) : std::nullopt;
  return definition_of(names.scope, *symbol) != nullptr ||
         (body && is_one_of(*symbol, symbols_in(reading.tree, *body)));
}

/// t of `x(t)`, as the section writes it; of what is dotted the time.
std::vector<std::string> running_variables(const Reading& reading, const WrittenSymbol& function, SymbolId of,
                                           std::size_t count) {
  auto defined = variables_of_definition(reading.names, function);
  if (defined.size() == 1 && count == 1) return defined;
  WrittenSymbol bare = function;
  bare.primes = 0;
  bare.dots = 0;
  if (auto variables = variables_of(bare, *reading.names.symbols.evidence))
    return variables->size() == count ? *std::move(variables) : std::vector<std::string>{};
  if (const auto member = membership_of(reading.names, of)) {  // \phi_2(0) of `\phi_n(x) = \sin nx`
    WrittenIndex general;
    general.text = member->family.letter;
    bare.lower = {general};
    if (auto variables = variables_of(bare, *reading.names.symbols.evidence);
        variables && variables->size() == count)
      return *std::move(variables);
  }
  // u(0) beside `\dot u`, also where nobody writes `u(t)`.
  const NameKey* key = key_of(reading.names.symbols, base_of(reading.tree.symbols, of));
  const bool in_time =
      function.dots > 0 || (key != nullptr && has_rate(*reading.names.symbols.sightings, *key));
  return count == 1 && in_time ? std::vector<std::string>{"t"} : std::vector<std::string>{};
}

std::uint8_t axis_of(const std::string& coordinate) {
  return is_one_of(coordinate, {"x", "y", "z"}) ? static_cast<std::uint8_t>(coordinate[0] - 'x' + 1) : 0;
}

/// `f'(c)` of `f(x)`: a derivative by the place is one along the axis of that variable.
bool is_along(const ExprTree& tree, ExprId of, const std::vector<std::string>& variables) {
  const std::span<const Slot> slots = tree.slots(of);
  return slots.empty() || (variables.size() == 1 && std::ranges::all_of(slots, [&](const Slot& slot) {
                             return slot.axis != 0 && slot.axis == axis_of(variables.front());
                           }));
}

}  // namespace

MaybeTyped value_of_function(Reading& reading, SyntaxId function, SyntaxId bracket, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = cover(syntax[function].span, syntax[bracket].span);
  const auto of = elaborate(reading, function, around);
  if (!of) return std::nullopt;
  bool open = !of->free.empty() || !of->particles.empty();
  std::string arguments;
  std::vector<ExprId> at;
  for (const SyntaxChild& child : syntax.children(bracket)) {
    const auto argument = elaborate(reading, child.id, around);
    if (!argument) return std::nullopt;
    open = open || !argument->free.empty() || !argument->particles.empty();
    arguments += (arguments.empty() ? "" : ", ") + print_latex(reading.tree, argument->id);
    at.push_back(argument->id);
  }
  if (open || of->rank > 1)
    return unsupported(reading, span, "the value of a function with indices is not decided");
  const std::string name = fmt::format("{}({})", name_of_function(reading, *of), arguments);
  reading.found.values = true;
  const SymbolId symbol = symbol_named(reading, {name, of->rank, false}, name, span);
  if (reading.tree[of->id].op == Op::symbol && !reading.names.symbols.function_values.contains(symbol)) {
    auto variables =
        running_variables(reading, syntax.symbol(function), reading.tree[of->id].symbol, at.size());
    if (!is_along(reading.tree, of->id, variables)) variables.clear();
    reading.names.symbols.function_values.put(
        {symbol, {reading.tree[of->id].symbol, std::move(variables), at}});
  }
  Typed value{.rank = of->rank};
  value.id = reading.tree.add({.op = Op::symbol,
                               .rank = static_cast<std::uint8_t>(of->rank),
                               .span = span,
                               .symbol = symbol,
                               .axes = reading.tree[of->id].axes});
  return value;
}

namespace {

/// `(x)` of `f(x)`, which is f.
bool only_shows_argument(const Reading& reading, SyntaxId function, SyntaxId bracket) {
  const SyntaxTree& syntax = reading.syntax;
  const auto is_declared_argument = [&](const SyntaxChild& child) {
    return syntax[child.id].kind == SyntaxKind::symbol &&
           is_declared(reading.names.symbols, {syntax.symbol(child.id).letter, 0, false});
  };
  return is_argument(syntax, function, bracket, *reading.names.symbols.evidence) &&
         !is_value_at_what_is_known(reading, function, bracket) &&
         std::ranges::none_of(syntax.children(bracket), is_declared_argument);
}

}  // namespace

std::optional<int> power_of_value(Reading& reading, SyntaxId function, const SyntaxChild& next) {
  const SyntaxTree& syntax = reading.syntax;
  if (next.joint != Joint::juxtaposed || syntax[next.id].kind != SyntaxKind::power ||
      syntax[function].kind != SyntaxKind::symbol)
    return std::nullopt;
  const SyntaxId bracket = syntax.child(next.id, 0);
  const auto exponent = whole_number(syntax, syntax.child(next.id, 1));
  if (syntax[bracket].kind != SyntaxKind::group || !exponent || *exponent < 2 ||
      *exponent > most_power_of_value)
    return std::nullopt;
  if (only_shows_argument(reading, function, bracket)) return exponent;
  const auto applied = reading.found.applied;  // what is open stays with the bracket alone
  const bool elsewhere = reading.found.applied_elsewhere;
  const bool of_value = part_of_bracket(reading, function, bracket) == BracketPart::argument;
  reading.found.applied = applied;
  reading.found.applied_elsewhere = elsewhere;
  return of_value ? exponent : std::nullopt;
}

MaybeTyped power_of_value(Reading& reading, SyntaxId function, SyntaxId power, int exponent,
                          const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId bracket = syntax.child(power, 0);
  const Span span = cover(syntax[function].span, syntax[power].span);
  const auto value = only_shows_argument(reading, function, bracket)
                         ? elaborate(reading, function, around)
                         : value_of_function(reading, function, bracket, around);
  if (!value) return std::nullopt;
  if (value->rank != 0 || !value->free.empty() || !value->particles.empty())
    return unsupported(reading, span,
                       "a power of the value of a vector, or of one with indices, is not decided");
  return apply_op(reading.tree, Op::power, span, 0, {*value}, exponent);
}

std::vector<SyntaxChild> without_arguments(const Reading& reading, std::span<const SyntaxChild> factors) {
  std::vector<SyntaxChild> kept;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const SyntaxChild& factor = factors[k];
    const bool only_shows = k > 0 && factor.joint == Joint::juxtaposed &&
                            only_shows_argument(reading, factors[k - 1].id, factor.id);
    if (!only_shows) kept.push_back(factor);
  }
  return kept;
}

std::optional<SpelledPart> doubt_of_product(Reading& reading, std::span<const SyntaxChild> factors) {
  if (auto spelled = spelled_part(reading.syntax, factors, reading.names)) return spelled;
  if (auto doubt = application(reading, factors)) return doubt;
  if (auto doubt = repeated_greek(reading, factors)) return doubt;
  if (auto doubt = circle_before_number(reading.syntax, factors)) return doubt;
  return number_run(reading, factors);
}

}  // namespace rigor
