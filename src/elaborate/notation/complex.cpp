// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugates, and real and imaginary parts.
#include <fmt/format.h>

#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/matrix.h"
#include "elaborate/notation/notations.h"
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

}  // namespace

bool is_part_of_complex(std::string_view name) {
  return name == "conjugate" || name == "bar" || name == "Re" || name == "Im";
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
