// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugates, real and imaginary parts, and averages, which a bar can mean as well.
#include <fmt/format.h>

#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/matrix.h"
#include "elaborate/notation/notations.h"
#include "elaborate/symbol/average.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

/// Why a star or bar is not read as a conjugate.
std::nullopt_t refuse_mark(Reading& reading, bool star, const Typed& inside, Span span) {
  const std::string what = print_latex(reading.tree, inside.id);
  const bool symbol = reading.tree[inside.id].op == Op::symbol;
  return ambiguous(reading, span,
                   fmt::format("the {} can be a conjugate, or {}; nothing here says that `{}` is complex",
                               star ? "star on this" : "bar over this",
                               star ? "the mark of another quantity" : "a mean value", what),
                   symbol ? std::vector{fmt::format("`rigor: complex {}` makes it a conjugate", what)}
                          : std::vector<std::string>{});
}

/// A symbol of its own: what is known of it follows when a question is asked.
MaybeTyped average_of(Reading& reading, const Typed& inside, Span span) {
  const bool number = inside.rank == 0 && inside.free.empty() && inside.particles.empty();
  if (!number || inside.layout != Layout::none)
    return unsupported(reading, span,
                       "averages of vectors, and of components with free indices, are not decided",
                       {"averages of numbers are, and of `v_x`"});
  const auto observables = observables_with_real_average(reading.names, reading.tree, inside.id);
  if (observables) {
    for (const SymbolId symbol : *observables)
      note(reading, fmt::format("averages of `{}` are real, as those of an observable",
                                reading.tree.symbols[symbol].name));
  }
  Typed typed;
  const SymbolId symbol = symbol_of_average(reading.tree, inside.id, !observables, span);
  typed.id = reading.tree.add({.op = Op::symbol, .span = span, .symbol = symbol});
  return typed;
}

}  // namespace

bool is_part_of_complex(std::string_view name) {
  return name == "conjugate" || name == "bar" || name == "Re" || name == "Im";
}

MaybeTyped elaborate_average(Reading& reading, SyntaxId id, const Around& around) {
  const Span span = reading.syntax[id].span;
  if (reading.names.symbols.evidence->angles_generate)
    return ambiguous(reading, span, "this can be an average, or what its letters generate");
  if (around.body_point)
    return unsupported(reading, span, "an average inside an integral over the body is not decided");
  const auto inside = elaborate(reading, reading.syntax.child(id, 0), around);
  return inside ? average_of(reading, *inside, span) : std::nullopt;
}

MaybeTyped elaborate_part(Reading& reading, SyntaxId id, const Around& around) {
  const std::string& name = reading.syntax.text(id);
  const Span span = reading.syntax[id].span;
  const auto inside = elaborate(reading, reading.syntax.child(id, 0), around);
  if (!inside) return std::nullopt;
  const bool mark = name == "conjugate" || name == "bar";
  if (mark && inside->layout != Layout::none) return conjugate_of_matrix(reading, *inside, span);
  if (!has_complex_numbers(reading.tree, inside->id)) {
    if (name == "bar" && reading.names.symbols.evidence->speaks_of_means && !around.body_point) {
      note(reading, "a bar over an expression is its mean");
      return average_of(reading, *inside, span);
    }
    if (mark) return refuse_mark(reading, name == "conjugate", *inside, span);
    return ambiguous(
        reading, span,
        fmt::format("`{0}` can be a part of a complex number, or a quantity of this name; nothing "
                    "here says that `{1}` is complex",
                    name, print_latex(reading.tree, inside->id)));
  }
  const Op op = mark ? Op::conjugate : name == "Re" ? Op::real_part : Op::imaginary_part;
  return apply_op(reading.tree, op, span, inside->rank, {*inside});
}

}  // namespace rigor
