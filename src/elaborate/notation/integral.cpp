// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals over one variable, and differences between limits. Each is a symbol of its own that keeps what is
// integrated: its value is looked for only when a question is asked, with the definitions of that place.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/name/function_value.h"
#include "elaborate/notation/derivative.h"
#include "elaborate/notation/notations.h"
#include "elaborate/symbol/symbol.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

/// Letters whose order may matter, and axes that turn, are seen only where they stand in the open.
bool may_be_hidden(Reading& reading, ExprId integrand) {
  const Symbols& symbols = reading.names.symbols;
  return std::ranges::none_of(letters_in(reading.tree, integrand), [&](SymbolId symbol) {
    const SymbolId base = base_of(reading.tree.symbols, symbol);
    const NameKey* key = key_of(symbols, base);
    const bool turns = reading.tree.symbols[base].rank > 0 && !reading.names.scope.frames->empty();
    return turns || reading.tree.symbols[base].noncommuting ||
           (key != nullptr && symbols.evidence->is_ordered(without_labels(key->base)));
  });
}

bool is_closed_number(const Typed& typed) {
  return typed.rank == 0 && typed.free.empty() && typed.particles.empty();
}

/// A limit, which may be an infinity with its sign.
std::optional<Limit> limit_of(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const auto is_infinity = [&](SyntaxId each) {
    return syntax[each].kind == SyntaxKind::symbol && syntax.symbol(each).letter == "\\infty";
  };
  Limit limit;
  if (is_infinity(id)) {
    limit.infinity = 1;
    return limit;
  }
  if (syntax[id].kind == SyntaxKind::sum && is_infinity(syntax.child(id, 0))) {
    limit.infinity = -1;
    return limit;
  }
  const auto typed = elaborate(reading, id, around);
  if (!typed) return std::nullopt;
  if (is_closed_number(*typed)) {
    limit.at = typed->id;
    return limit;
  }
  unsupported(reading, syntax[id].span, "a limit with indices, or a vector as a limit, is not decided");
  return std::nullopt;
}

/// `\int_0^1\langle sx\rangle\,ds`, `\sum_i\langle x_i\rangle`: the variable stands where nothing runs.
bool is_averaged_over(Reading& reading, SymbolId variable, ExprId integrand, Span span) {
  const ExprTree& tree = reading.tree;
  const auto& values = reading.names.symbols.function_values;
  const auto speaks = [&](SymbolId each) {
    const auto value = values.find(base_of(tree.symbols, each));
    return each == variable || (value != nullptr && std::ranges::any_of(value->second.at, [&](ExprId at) {
                                  return is_one_of(variable, letters_in(tree, at));
                                }));
  };
  const bool hidden = std::ranges::any_of(symbols_in(tree, integrand), [&](SymbolId each) {
    const auto& average = tree.symbols[base_of(tree.symbols, each)].integral;
    return average && average->average && std::ranges::any_of(letters_in(tree, average->integrand), speaks);
  });
  if (hidden) unsupported(reading, span, "what an integral or a sum runs over stands inside an average");
  const bool states = holds_states(tree, integrand);
  if (states && !hidden) unsupported(reading, span, "integrals and sums over states are not decided");
  return hidden || states;
}

/// `Q = CU` above `\int U\,dQ`: does a letter of the integrand change with the variable?
bool is_bound_to(const Reading& reading, SymbolId variable, ExprId integrand) {
  const NameScope& scope = reading.names.scope;
  const std::vector<SymbolId> own = symbols_in(reading.tree, integrand);
  const auto speaks = [&](const std::vector<SymbolId>& letters) {
    return std::ranges::any_of(letters, [&](SymbolId each) {
      return each != variable && !reading.tree.symbols[each].is_fixed() && is_one_of(each, own);
    });
  };
  if (const auto body = body_of_definition(scope, variable);
      body && speaks(symbols_reached(reading.tree, scope, {*body})))
    return true;
  return std::ranges::any_of(scope.assumptions, [&](const NamedAssumption& each) {
    if (each.equation.relation != Relation::equal) return false;
    std::vector<SymbolId> letters = symbols_in(reading.tree, each.equation.left);
    for (const SymbolId letter : symbols_in(reading.tree, each.equation.right)) letters.push_back(letter);
    return is_one_of(variable, letters) && speaks(letters);
  });
}

/// The symbol of a plain number that is integrated over.
std::optional<SymbolId> variable_of(Reading& reading, SyntaxId id, const Around& around) {
  const WrittenSymbol& written = reading.syntax.symbol(id);
  const auto read = elaborate_symbol(reading, written, reading.syntax[id].span, around);
  if (!read) return std::nullopt;
  const ExprNode& node = reading.tree[read->id];
  const bool plain = node.op == Op::symbol && node.slot_count == 0 && node.particle == no_particle &&
                     is_closed_number(*read) && !reading.tree.symbols[node.symbol].derivation;
  if (plain) return node.symbol;
  unsupported(reading, reading.syntax[id].span,
              fmt::format("an integral over this `{}` is not decided", written.letter),
              {"integrals over a letter that is a plain number are; beside the vector `\\mathbf{r}`, `r` is "
               "its length"});
  return std::nullopt;
}

/// `\int_{V_1}^{V_2} p\,dV` and `\int_0^Q dq`; in `\int_0^R \rho\,dV` and `\int_1^2 dU` the limits are those
/// of something else.
bool is_limit_of(const Reading& reading, const Limit& limit, const std::string& letter) {
  static const std::set<std::string> of_bodies{"m", "q", "\\Omega"};
  const bool capital = letter.size() == 1 && is_capital_letter(letter[0]);
  if ((!capital && !of_bodies.contains(letter)) || !limit.at || reading.tree.is_zero_literal(*limit.at))
    return true;
  const std::string own = lowered(letter);
  return std::ranges::any_of(symbols_in(reading.tree, *limit.at), [&](SymbolId symbol) {
    return lowered(without_labels(reading.tree.symbols[symbol].name)) == own;
  });
}

void note_variable(const Reading& reading, const WrittenSymbol& written, SymbolId symbol,
                   Integral& integral) {
  integral.variable = symbol;
  integral.by = {By::letter, symbol};
  if (is_time(written)) integral.by = By::time;
  if (is_time(written) || !is_place(reading, written) || !written.lower.empty()) return;
  const std::uint8_t axis = axis_of_letter(written.letter);
  if (axis == 0) return;
  integral.by = By::space;
  integral.axis = axis;
}

std::string name_of_limit(const ExprTree& tree, const Limit& limit) {
  if (limit.at) return print_latex(tree, *limit.at);
  return limit.infinity < 0 ? "-\\infty" : "\\infty";
}

std::string name_of(const ExprTree& tree, const Integral& integral) {
  std::string limits;
  if (integral.lower)
    limits = fmt::format("_{{{}}}^{{{}}}", name_of_limit(tree, *integral.lower),
                         name_of_limit(tree, *integral.upper));
  const std::string inside = print_latex(tree, integral.integrand);
  if (integral.sum)
    return fmt::format("\\sum_{{{}={}}}^{{{}}} {}", tree.symbols[integral.variable].name,
                       name_of_limit(tree, *integral.lower), name_of_limit(tree, *integral.upper),
                       tree[integral.integrand].op == Op::add ? "(" + inside + ")" : inside);
  if (integral.primitive) return fmt::format("[{}]{}", inside, limits);
  const bool sum = tree[integral.integrand].op == Op::add || tree[integral.integrand].op == Op::negate;
  return fmt::format("\\int{} {}\\,d{}", limits, sum ? "(" + inside + ")" : inside,
                     tree.symbols[integral.variable].name);
}

/// `[g^2]_\mu^\nu`
bool is_index(const SyntaxTree& syntax, SyntaxId limit) {
  static const std::set<std::string> letters{"k",    "l",    "m",       "n",      "p",        "q",
                                             "\\mu", "\\nu", "\\alpha", "\\beta", "\\lambda", "\\sigma"};
  return syntax[limit].kind == SyntaxKind::symbol && syntax.symbol(limit).lower.empty() &&
         letters.contains(syntax.symbol(limit).letter);
}

bool same_limit(const ExprTree& tree, const std::optional<Limit>& a, const std::optional<Limit>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  if (!a->at || !b->at) return a->infinity == b->infinity && a->at.has_value() == b->at.has_value();
  return same_expression(tree, *a->at, tree, *b->at);
}

bool is_same(const ExprTree& tree, const Integral& a, const Integral& b) {
  return a.variable == b.variable && a.by == b.by && a.primitive == b.primitive && a.sum == b.sum &&
         same_limit(tree, a.lower, b.lower) && same_limit(tree, a.upper, b.upper) &&
         same_expression(tree, a.integrand, tree, b.integrand);
}

}  // namespace

SymbolId symbol_of_integral(ExprTree& tree, const Integral& integral, Span span) {
  for (std::uint32_t k = 0; k < tree.symbols.size(); ++k) {
    const std::optional<Integral>& known = tree.symbols[SymbolId{k}].integral;
    if (known && is_same(tree, *known, integral)) return SymbolId{k};
  }
  return tree.symbols.add({.name = name_of(tree, integral), .first_seen = span, .integral = integral});
}

namespace {

Typed as_symbol(Reading& reading, const Integral& integral, Span span) {
  Typed typed;
  typed.id = reading.tree.add(
      {.op = Op::symbol, .span = span, .symbol = symbol_of_integral(reading.tree, integral, span)});
  return typed;
}

}  // namespace

MaybeTyped elaborate_line_integral(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  const auto parts = syntax.children(id);
  if (is_declared(reading.names.symbols, {"d", 0, false}))
    return ambiguous(reading, span, "`d` is declared, and can be a differential here");
  const auto inside = elaborate(reading, parts[0].id, around);
  const auto variable = variable_of(reading, parts[1].id, around);
  if (!inside || !variable) return std::nullopt;
  if (!is_closed_number(*inside) || around.body_point)
    return unsupported(reading, span, "integrals of vectors and of components are not decided",
                       {"integrals of numbers over a number are"});
  if (!may_be_hidden(reading, inside->id))
    return unsupported(reading, span,
                       "an integral of what may be a matrix, or of vectors in a frame, is not decided");
  if (is_bound_to(reading, *variable, inside->id))
    return unsupported(reading, span,
                       fmt::format("what `{}` is was said above, and the integrand may change with it",
                                   syntax.symbol(parts[1].id).letter),
                       {"put what was said into the integrand"});
  if (is_averaged_over(reading, *variable, inside->id, span)) return std::nullopt;
  Integral integral{.integrand = inside->id};
  note_variable(reading, syntax.symbol(parts[1].id), *variable, integral);
  if (parts.size() > 2) {
    integral.lower = limit_of(reading, parts[2].id, around);
    integral.upper = limit_of(reading, parts[3].id, around);
    if (!integral.lower || !integral.upper) return std::nullopt;
    const std::string& letter = syntax.symbol(parts[1].id).letter;
    if (!is_limit_of(reading, *integral.lower, letter) || !is_limit_of(reading, *integral.upper, letter))
      return ambiguous(reading, span,
                       fmt::format("the limits can be those of `{}`, or of something else", letter));
  }
  reading.found.integrated = *variable;
  return as_symbol(reading, integral, span);
}

/// `\sum_{k=1}^n f`, with whole numbers as limits.
MaybeTyped elaborate_counted_sum(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  const auto parts = syntax.children(id);
  const WrittenSum& written = syntax.big_sum(id);
  const WrittenIndex& index = written.indices[0];
  reading.counting.push_back(index.text);
  const auto inside = elaborate(reading, parts[0].id, around);
  reading.counting.pop_back();
  const auto counter =
      elaborate_symbol(reading, {.letter = index.text, .letter_span = index.span}, index.span, around);
  if (!inside || !counter) return std::nullopt;
  if (!is_closed_number(*inside) || around.body_point)
    return unsupported(reading, span, "sums of vectors and of components over whole numbers are not decided");
  const ExprNode& node = reading.tree[counter->id];
  if (node.op != Op::symbol || !is_closed_number(*counter) || node.particle != no_particle)
    return unsupported(reading, index.span, fmt::format("a sum over this `{}` is not decided", index.text));
  const SymbolId variable = node.symbol;
  if (!may_be_hidden(reading, inside->id))
    return unsupported(reading, span,
                       "a sum of what may be matrices, or of vectors in a frame, is not decided");
  if (is_bound_to(reading, variable, inside->id))
    return unsupported(
        reading, span,
        fmt::format("what `{}` is was said above, and what is added may change with it", index.text));
  if (is_averaged_over(reading, variable, inside->id, span)) return std::nullopt;
  Integral sum{.integrand = inside->id, .variable = variable, .by = {By::letter, variable}, .sum = true};
  const auto written_limit = [&](const std::string& text) -> std::optional<Limit> {
    if (text != "N") return Limit{.at = reading.tree.add_number(span, text)};
    const auto letter = elaborate_symbol(reading, {.letter = text, .letter_span = span}, span, around);
    return letter && is_closed_number(*letter) ? std::optional(Limit{.at = letter->id}) : std::nullopt;
  };
  sum.lower = parts.size() > 1 ? limit_of(reading, parts[1].id, around) : written_limit(written.from);
  sum.upper = parts.size() > 1 ? limit_of(reading, parts[2].id, around) : written_limit(written.to);
  if (!sum.lower || !sum.upper) return std::nullopt;
  for (const Limit& limit : {*sum.lower, *sum.upper}) {
    if (limit.at && is_one_of(variable, symbols_in(reading.tree, *limit.at)))
      return ambiguous(reading, span,
                       fmt::format("`{}` is a limit of the sum over `{}` itself", index.text, index.text));
  }
  return as_symbol(reading, sum, span);
}

MaybeTyped elaborate_between(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  const auto parts = syntax.children(id);
  const auto inside = elaborate(reading, parts[0].id, around);
  if (!inside) return std::nullopt;
  if (!is_closed_number(*inside) || around.body_point)
    return unsupported(reading, span, "the difference of vectors between two limits is not decided");
  if (!may_be_hidden(reading, inside->id))
    return unsupported(reading, span,
                       "the limits of what may be a matrix, or of vectors in a frame, are not decided");
  Integral integral{.integrand = inside->id, .primitive = true};
  if (parts.size() > 3) {
    if (syntax[parts[3].id].kind != SyntaxKind::symbol)
      return unsupported(reading, span, "these limits are not read");
    const auto variable = variable_of(reading, parts[3].id, around);
    if (!variable) return std::nullopt;
    integral.variable = *variable;
  } else if (reading.found.integrated) {
    integral.variable = *reading.found.integrated;
  } else {
    const std::vector<SymbolId> letters = symbols_in(reading.tree, inside->id);
    if (letters.size() != 1)
      return ambiguous(reading, span, "nothing says for which letter the limits are put in",
                       {"`[…]_{x=a}^{x=b}` says so"});
    integral.variable = letters[0];
    if (is_index(syntax, parts[1].id) && is_index(syntax, parts[2].id))
      return ambiguous(reading, span, "the letters at this bracket can be limits or indices");
  }
  if (is_averaged_over(reading, integral.variable, inside->id, span)) return std::nullopt;
  integral.by = {By::letter, integral.variable};
  integral.lower = limit_of(reading, parts[1].id, around);
  integral.upper = limit_of(reading, parts[2].id, around);
  if (!integral.lower || !integral.upper) return std::nullopt;
  return as_symbol(reading, integral, span);
}

}  // namespace rigor
