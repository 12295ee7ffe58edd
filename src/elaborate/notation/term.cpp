// SPDX-License-Identifier: GPL-3.0-or-later
// The factors of a term: operators act on what follows them, the others are multiplied.
#include <fmt/format.h>

#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/application.h"
#include "elaborate/notation/derivative.h"
#include "elaborate/notation/differential.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/change.h"
#include "elaborate/reading/product.h"
#include "elaborate/symbol/space_time_letter.h"

namespace rigor {
namespace {

/// The ∇ of an operator.
const WrittenSymbol& nabla_of(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind == SyntaxKind::power) id = syntax.child(id, 0);
  if (syntax[id].kind == SyntaxKind::group) id = syntax.children(syntax.child(id, 0)).back().id;
  return syntax.symbol(id);
}

/// What the operator makes of its operand; ∇ has at most one subscript.
MaybeTyped act(Reading& reading, SyntaxId id, Joint joint, const Typed& operand, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  const Span whole = cover(span, reading.tree[operand.id].span);
  const WrittenSymbol& nabla = nabla_of(syntax, id);
  if (nabla.lower.size() == 1 && is_space_time_index(*reading.names.symbols.evidence, nabla.lower[0]))
    return unsupported(reading, span, "a covariant derivative is not decided");
  if (nabla.lower.size() == 1) {
    WrittenSymbol coordinate;
    coordinate.letter = "x";
    coordinate.lower = nabla.lower;
    return by_coordinate(reading, operand, coordinate, whole, around);
  }
  if (syntax[id].kind == SyntaxKind::group) {
    const SyntaxId inside = syntax.child(id, 0);
    const auto parts = syntax.children(inside);
    if (parts.size() != 2 || parts[1].joint != Joint::dot || joint != Joint::juxtaposed)
      return unsupported(reading, span, "this operator is not read", {"`(\\mathbf{A}\\cdot\\nabla)` is"});
    const auto along = elaborate(reading, parts[0].id, around);
    return along ? directional(reading, *along, operand, whole) : along;
  }
  if (syntax[id].kind == SyntaxKind::power) {
    if (whole_number(syntax, syntax.child(id, 1)) != 2 || joint != Joint::juxtaposed)
      return unsupported(reading, span, "`\\nabla^2` is the only power of `\\nabla` that is read");
    return apply_nabla(reading, FieldOperator::laplacian, operand, whole);
  }
  return apply_nabla(reading,
                     joint == Joint::dot     ? FieldOperator::divergence
                     : joint == Joint::cross ? FieldOperator::curl
                                             : FieldOperator::gradient,
                     operand, whole);
}

/// The operator at `at` acts on the next factor; where another factor follows that it could act on too, it is
/// not read. `next` becomes the first factor after.
MaybeTyped apply_operator(Reading& reading, std::span<const SyntaxChild> factors, std::size_t at,
                          std::size_t& next, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId id = factors[at].id;
  const Span span = syntax[id].span;
  if (at + 1 >= factors.size())
    return unsupported(reading, span, "an operator without an operand is not read");
  std::size_t run = at;
  while (run < factors.size() && acts_as_operator(syntax, factors[run].id)) ++run;
  if (run - at > most_axes) {
    next = factors.size();
    return unsupported(reading, span, fmt::format("more than {} operators in a row are not read", most_axes));
  }
  const Joint joint = factors[at + 1].joint;
  next = at + 2;
  const WrittenSymbol& nabla = nabla_of(syntax, id);
  const bool component = is_nabla(syntax, id) && nabla.lower.size() == 1 && joint == Joint::juxtaposed;
  const bool marked =
      nabla.accent != Accent::none || nabla.primes > 0 || nabla.dots > 0 || !nabla.change.empty();
  if (marked || (!nabla.lower.empty() && !component))
    return unsupported(reading, span, "a `\\nabla` with marks or subscripts is not read",
                       {"`\\nabla_i f` is"});
  const SyntaxId behind = factors[at + 1].id;
  const bool nested = acts_as_operator(syntax, behind);
  const auto operand =
      nested ? apply_operator(reading, factors, at + 1, next, around) : elaborate(reading, behind, around);
  if (!operand) return operand;
  const Joint after = next < factors.size() ? factors[next].joint : Joint::none;
  const bool takes_more =
      after == Joint::juxtaposed ||
      (after == Joint::cross && (joint != Joint::juxtaposed || operand->rank > 0)) ||
      (after == Joint::dot && joint == Joint::juxtaposed && operand->rank > 0 && is_nabla(syntax, id));
  if (takes_more && !nested)
    return ambiguous(reading, cover(span, syntax[factors[next].id].span),
                     "`\\nabla` can act on the next factor or on all that follow",
                     {"put brackets around what it acts on"});
  return act(reading, id, joint, *operand, around);
}

bool is_applied(Reading& reading, SyntaxId function, const SyntaxChild& next) {
  if (next.joint != Joint::juxtaposed) return false;
  const BracketPart part = part_of_bracket(reading, function, next.id);
  return part == BracketPart::argument ||
         (part == BracketPart::open && reading.rules.open == OpenBracket::argument);
}

bool is_differential_sign(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, std::size_t at) {
  return is_sign_of_differential(syntax, factors, at) || is_sign_of_form(syntax, factors, at);
}

/// `dS` or `\delta Q`, where the row relates differentials.
MaybeTyped differential_at(Reading& reading, std::span<const SyntaxChild> factors, std::size_t at,
                           const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId of = factors[at + 1].id;
  const Span span = cover(syntax[factors[at].id].span, syntax[of].span);
  return is_sign_of_form(syntax, factors, at) ? form_named(reading, of, span, around)
                                              : differential_of(reading, of, span, around);
}

}  // namespace

MaybeTyped elaborate_term(Reading& reading, SyntaxId id, const Around& around) {
  const std::vector<SyntaxChild> factors = without_arguments(reading, reading.syntax.children(id));
  for (std::size_t k = 1; k < factors.size(); ++k) {
    const bool both = factors[k].joint == Joint::dot && is_four_vector(reading, factors[k - 1].id) &&
                      is_four_vector(reading, factors[k].id);
    if (both)
      return ambiguous(reading,
                       cover(reading.syntax[factors[k - 1].id].span, reading.syntax[factors[k].id].span),
                       "this can be a product of four-vectors, or of numbers",
                       {"with indices, as in `p_\\mu k^\\mu`, it is read"});
  }
  std::vector<Operand> operands;
  bool failed = false;
  for (std::size_t k = 0; k < factors.size();) {
    const SyntaxChild& child = factors[k];
    std::size_t next = k + 1;
    const bool sign = reading.rules.differentials && is_differential_sign(reading.syntax, factors, k);
    const auto raised =
        sign || next >= factors.size() ? std::nullopt : power_of_value(reading, child.id, factors[next]);
    const bool applied =
        sign || raised || (next < factors.size() && is_applied(reading, child.id, factors[next]));
    auto typed = raised ? power_of_value(reading, child.id, factors[next].id, *raised, around)
                 : sign ? differential_at(reading, factors, k, around)
                 : acts_as_operator(reading.syntax, child.id)
                     ? apply_operator(reading, factors, k, next, around)
                 : applied ? value_of_function(reading, child.id, factors[next].id, around)
                           : elaborate(reading, child.id, around);
    if (applied) ++next;
    failed = failed || !typed;
    if (typed) operands.push_back({*std::move(typed), child.joint, child.joint_span});
    k = next;
  }
  if (failed) return std::nullopt;
  if (auto doubt = doubt_of_product(reading, factors))
    return ambiguous(reading, doubt->span, std::move(doubt->message), std::move(doubt->help));
  return product_of(reading, std::move(operands), reading.syntax[id].span);
}

}  // namespace rigor
