// SPDX-License-Identifier: GPL-3.0-or-later
// Powers, roots, bars, components, tuples and determinants.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "elaborate/evidence/raised_indices.h"
#include "elaborate/notation/elaborator.h"

namespace rigor {
namespace {

constexpr int largest_exponent = 64;

}  // namespace

std::optional<int> Elaborator::integer(SyntaxId id) const {
  const SyntaxNode& node = syntax_[id];
  if (node.kind == SyntaxKind::number) {
    const std::string& digits = syntax_.text(id);
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
  }
  if (node.kind == SyntaxKind::sum && node.count == 1 && syntax_.children(id)[0].joint == Joint::minus) {
    const auto value = integer(syntax_.child(id, 0));
    return value ? std::optional(-*value) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<int> Elaborator::half_integer(SyntaxId id) const {
  if (const auto whole = integer(id))
    return std::abs(*whole) <= largest_exponent ? std::optional(2 * *whole) : std::nullopt;
  const SyntaxNode& node = syntax_[id];
  if (node.kind == SyntaxKind::sum && node.count == 1 && syntax_.children(id)[0].joint == Joint::minus) {
    const auto value = half_integer(syntax_.child(id, 0));
    return value ? std::optional(-*value) : std::nullopt;
  }
  const bool fraction = node.kind == SyntaxKind::fraction;
  const bool slash =
      node.kind == SyntaxKind::term && node.count == 2 && syntax_.children(id)[1].joint == Joint::slash;
  if (!fraction && !slash) return std::nullopt;
  const auto above = integer(syntax_.child(id, 0));
  const auto below = integer(syntax_.child(id, 1));
  if (!above || !below || *below != 2 || std::abs(*above) > largest_exponent) return std::nullopt;
  return *above;
}

/// `e^{\lambda t}`: Euler's number, unless e is declared, carries scripts or has a plain number above it.
bool Elaborator::is_exponential(SyntaxId id) const {
  const SyntaxId base = syntax_.child(id, 0);
  if (syntax_[base].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& symbol = syntax_.symbol(base);
  const bool euler = symbol.letter == "e" || symbol.letter == "\\mathrm{e}";
  return euler && symbol.face == Face::plain && symbol.accent == Accent::none && symbol.lower.empty() &&
         symbol.primes == 0 && !names_.is_declared({symbol.letter, 0, false}) &&
         !integer(syntax_.child(id, 1)).has_value();
}

/// `H^0`, `E^1`: nobody writes such a power of a letter, but of Euler's number.
bool Elaborator::reads_as_order(SyntaxId id) const {
  const SyntaxId base = syntax_.child(id, 0);
  if (syntax_[base].kind != SyntaxKind::symbol || syntax_[syntax_.child(id, 1)].kind != SyntaxKind::number)
    return false;
  const std::string& exponent = syntax_.text(syntax_.child(id, 1));
  const WrittenSymbol& symbol = syntax_.symbol(base);
  const bool euler = symbol.letter == "e" && symbol.lower.empty() && symbol.face == Face::plain &&
                     !names_.is_declared({symbol.letter, 0, false});
  return (exponent == "0" || exponent == "1") && !euler;
}

std::optional<Typed> Elaborator::power(SyntaxId id) {
  const Span span = syntax_[id].span;
  if (is_exponential(id)) {
    const Maybe argument = expression(syntax_.child(id, 1));
    return argument ? elementary("exp", *argument, span) : std::nullopt;
  }
  if (reads_as_order(id)) {
    const WrittenSymbol& symbol = syntax_.symbol(syntax_.child(id, 0));
    return fail(DiagnosticKind::ambiguous_reading, span,
                fmt::format("a {} above `{}` can be a power, or say of which order it is",
                            syntax_.text(syntax_.child(id, 1)), symbol.letter),
                {"a power of a bracket is no label: `(a)^0`"});
  }
  if (const SyntaxId raised = syntax_.child(id, 0);
      syntax_[raised].kind == SyntaxKind::symbol && integer(syntax_.child(id, 1)).has_value() &&
      may_be_raised(syntax_.symbol(raised), names_.evidence) && !is_declared_letter(syntax_.symbol(raised))) {
    const std::string& letter = syntax_.symbol(raised).letter;
    return fail(DiagnosticKind::ambiguous_reading, span,
                fmt::format("`{}` has upper indices elsewhere: this can be one of them or a power", letter),
                {fmt::format("`rigor: scalar {}` makes it a power", letter)});
  }
  squared_ = integer(syntax_.child(id, 1)) == 2 && syntax_[syntax_.child(id, 0)].kind == SyntaxKind::symbol;
  const Maybe base = expression(syntax_.child(id, 0));
  squared_ = false;
  if (!base) return std::nullopt;
  const auto halves = half_integer(syntax_.child(id, 1));
  if (!halves) {
    return unsupported(syntax_[syntax_.child(id, 1)].span,
                       fmt::format("only whole and half exponents up to {} are read, and no upper indices",
                                   largest_exponent));
  }
  if (*halves == 2) return base;
  if (!base->free.empty()) {
    const std::string& letter = base->free[0].letter;
    return fail(DiagnosticKind::ambiguous_reading, span,
                fmt::format("a power of a component with the free index `{}` can be summed over `{}` or not",
                            letter, letter),
                {"write the factors out, or the sum"});
  }
  if (base->rank > 1) return unsupported(span, "a power of a tensor is not decided");
  if (base->rank == 1) {
    if (*halves == 4) return make(Op::dot, span, 0, {&*base, &*base});
    if (*halves % 4 != 0)
      return unsupported(span, "an odd power of a vector is not defined, and matrices in bold are not read",
                         {"a power of its length is written without bold"});
    const Typed length = make(Op::length, span, 0, {&*base});
    return make(Op::power, span, 0, {&length}, *halves / 2);
  }
  if (*halves % 2 == 0) return make(Op::power, span, 0, {&*base}, *halves / 2);
  const Typed root = make(Op::root, span, 0, {&*base});
  return *halves == 1 ? root : make(Op::power, span, 0, {&root}, *halves);
}

std::optional<Typed> Elaborator::square_root(SyntaxId id) {
  const Maybe radicand = expression(syntax_.child(id, 0));
  if (!radicand) return std::nullopt;
  if (radicand->rank != 0)
    return fail(DiagnosticKind::rank_mismatch, syntax_[id].span,
                "the root of a vector or tensor is not defined");
  if (!radicand->free.empty())
    return unsupported(syntax_[id].span, "a root of a component with a free index is not decided");
  return make(Op::root, syntax_[id].span, 0, {&*radicand});
}

/// Is there a symbol with two subscripts of its own?
bool Elaborator::names_a_tensor(SyntaxId id) const {
  std::vector<SyntaxId> pending{id};
  while (!pending.empty()) {
    const SyntaxId each = pending.back();
    pending.pop_back();
    if (syntax_[each].kind == SyntaxKind::symbol && syntax_.symbol(each).lower.size() > 1) return true;
    if (syntax_[each].kind == SyntaxKind::component) return true;
    for (const SyntaxChild& child : syntax_.children(each)) pending.push_back(child.id);
  }
  return false;
}

std::optional<Typed> Elaborator::bars(SyntaxId id, bool norm) {
  const Span span = syntax_[id].span;
  const Maybe inside = expression(syntax_.child(id, 0));
  if (!inside) return std::nullopt;
  if (inside->rank == 1) return make(Op::length, span, 0, {&*inside});
  if (inside->rank > 1)
    return norm ? unsupported(span, "the norm of a tensor is not decided")
                : determinant_of(id, *inside, span);
  if (norm)
    return fail(DiagnosticKind::rank_mismatch, span, "a norm of a scalar", {"`|…|` is the absolute value"});
  if (inside->free.size() == 2) {
    if (names_a_tensor(syntax_.child(id, 0))) return determinant_of(syntax_.child(id, 0), *inside, span);
    return fail(DiagnosticKind::ambiguous_reading, span,
                "the bars can mean a determinant of what has two free indices, or an absolute value",
                {"`\\det` is a determinant"});
  }
  if (inside->free.size() > 2)
    return unsupported(span, "bars around a quantity with more than two free indices are not read");
  return make(Op::absolute, span, 0, {&*inside});
}

/// `(AB)_{ij}`, where `A_{ij}` occurs in the notes.
bool Elaborator::is_matrix_product(SyntaxId id) const {
  std::vector<SyntaxId> pending{id};
  while (!pending.empty()) {
    const SyntaxId each = pending.back();
    pending.pop_back();
    if (syntax_[each].kind == SyntaxKind::symbol &&
        names_.sightings.indexed.contains({syntax_.symbol(each).letter, 2, false}))
      return true;
    for (const SyntaxChild& child : syntax_.children(each)) pending.push_back(child.id);
  }
  return false;
}

bool Elaborator::is_derivative_in_bracket(SyntaxId id) const {
  while (syntax_[id].kind == SyntaxKind::group) id = syntax_.child(id, 0);
  return syntax_[id].kind == SyntaxKind::derivative;
}

std::optional<Typed> Elaborator::component(SyntaxId id) {
  const Span span = syntax_[id].span;
  const std::vector<WrittenIndex>& axes = syntax_.indices(id);
  std::string label;
  for (const WrittenIndex& axis : axes) label += axis.text;
  if (const Frame* frame = frame_of(label))
    return frame_derivative(syntax_.child(id, 0), *frame, label == frame->fixed);
  if (is_derivative_in_bracket(syntax_.child(id, 0)) && axes.size() == 1 &&
      axes[0].form != IndexForm::digit && !letters_.is_index(axes[0].text))
    return unsupported(axes[0].span, fmt::format("nothing says what `{}` is to this derivative", label),
                       {"`rigor: frame … rotates with … in …` names two frames"});
  const Maybe base = expression(syntax_.child(id, 0));
  if (!base) return std::nullopt;
  for (const WrittenIndex& axis : axes) {
    const bool letter =
        axis.form == IndexForm::letter && (letters_.is_index(axis.text) || axis_of_letter(axis.text) != 0);
    if (axis.form != IndexForm::digit && !letter) {
      return unsupported(axis.span, fmt::format("the label `{}` on a bracket is not read yet", axis.text));
    }
  }
  if (static_cast<int>(axes.size()) != base->rank) {
    if (base->rank == 0 && is_matrix_product(syntax_.child(id, 0))) {
      return fail(
          DiagnosticKind::ambiguous_reading, span,
          "letters that carry two indices elsewhere stand here without: a product of matrices is not read");
    }
    const char* what = base->rank == 0
                           ? "a scalar has no components"
                           : "the subscript has another number of indices than the bracket has axes";
    return fail(DiagnosticKind::rank_mismatch, span, what);
  }
  if (any_primed(axes)) return along_axes(*base, axes, span);
  std::vector<Slot> slots;
  Typed subscript;
  if (!read_slots(axes, slots, subscript.free))
    return unsupported(span, "this subscript is not one of index letters or axes");
  std::vector<Typed> parts{*base, std::move(subscript)};
  std::vector<FreeIndex> to_sum;
  Typed typed;
  if (!sum_repeated(parts, to_sum, typed.free, typed.bound)) return std::nullopt;
  typed.particles = base->particles;
  typed.id = tree_.add({.op = Op::component, .span = span}, std::span(&base->id, 1), slots);
  return sum_over(std::move(typed), to_sum);
}

std::optional<Typed> Elaborator::tuple(SyntaxId id) {
  const Span span = syntax_[id].span;
  if (syntax_[id].count != 3) return unsupported(span, "only tuples of three components are read");
  std::vector<Typed> entries;
  for (const SyntaxChild& child : syntax_.children(id)) {
    Maybe entry = expression(child.id);
    if (!entry) return std::nullopt;
    entries.push_back(std::move(*entry));
    if (entries.back().rank != 0)
      return unsupported(syntax_[child.id].span,
                         "a bracket of vectors is not read; write a triple product out");
    if (!entries.back().free.empty())
      return unsupported(syntax_[child.id].span, "a free index inside a tuple is not decided");
  }
  return make(Op::tuple, span, 1, {&entries[0], &entries[1], &entries[2]});
}

std::optional<Typed> Elaborator::matrix(SyntaxId id) {
  const Span span = syntax_[id].span;
  if (syntax_[id].count != 9 || syntax_[id].payload != 3)
    return unsupported(span, "only matrices of three rows and three columns are read");
  std::vector<Typed> rows;
  for (std::size_t row = 0; row < 3; ++row) {
    std::vector<Typed> entries;
    for (std::size_t column = 0; column < 3; ++column) {
      Maybe entry = expression(syntax_.child(id, 3 * row + column));
      if (!entry) return std::nullopt;
      if (entry->rank != 0 || !entry->free.empty())
        return unsupported(span, "an entry of this matrix is not a plain scalar");
      entries.push_back(std::move(*entry));
    }
    rows.push_back(make(Op::tuple, span, 1, {&entries[0], &entries[1], &entries[2]}));
  }
  return make(Op::tuple, span, 2, {&rows[0], &rows[1], &rows[2]});
}

std::optional<Typed> Elaborator::determinant(SyntaxId id) {
  const Span span = syntax_[id].span;
  if (syntax_[id].count != 9 || syntax_[id].payload != 3)
    return unsupported(span, "only determinants of three rows are read");
  Typed typed;
  std::vector<ExprId> children;
  int rank = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    const Maybe entry = expression(syntax_.child(id, k));
    if (!entry) return std::nullopt;
    // Each entry occurs in several products, so a letter's place in them is not that of the summation
    // convention.
    merge_free(typed.free, entry->free);
    if (entry->rank > 1) return unsupported(span, "an entry of this determinant is a tensor");
    if (entry->rank == 1 && k >= 3)
      return unsupported(span, "vectors are read in the first row of a determinant only");
    merge_free(typed.bound, entry->bound);
    if (k == 0) rank = entry->rank;
    if (k < 3 && entry->rank != rank)
      return fail(DiagnosticKind::rank_mismatch, span, "the first row mixes scalars and vectors");
    merge_free(typed.particles, entry->particles);
    children.push_back(entry->id);
  }
  for (const FreeIndex& bound : typed.bound) {
    const bool free_too = std::any_of(typed.free.begin(), typed.free.end(),
                                      [&](const FreeIndex& free) { return free.letter == bound.letter; });
    if (free_too) {
      return unsupported(
          span,
          fmt::format("`{}` is summed in one entry of the determinant and free in another", bound.letter));
    }
  }
  typed.rank = rank;
  typed.id =
      tree_.add({.op = Op::determinant, .rank = static_cast<std::uint8_t>(rank), .span = span}, children);
  return typed;
}

}  // namespace rigor
