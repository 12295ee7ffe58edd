// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives: by the time, by coordinates, and ∇ in front of what it acts on.
#include <fmt/format.h>

#include <set>
#include <utility>

#include "base/among.h"
#include "elaborate/notation/elaborator.h"

namespace rigor {
namespace {

/// `x` in `\partial x/\partial y`: nobody differentiates one coordinate by another, so x is a function of y.
bool is_bare_coordinate(const SyntaxTree& syntax, SyntaxId operand) {
  if (syntax[operand].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& symbol = syntax.symbol(operand);
  return symbol.face == Face::plain && symbol.lower.empty() && axis_of_letter(symbol.letter) != 0;
}

}  // namespace

/// A partial derivative by the time holds the position.
Differentiator& Elaborator::differentiator(By by, Slot axis, bool partial) {
  const auto dependence_of = [this, by, partial](SymbolId symbol) {
    using Kind = Dependence::Kind;
    if (partial && by == By::time && names_.dependence(tree_, symbol, By::space).kind == Kind::variable)
      return Dependence{Kind::constant};
    const Dependence dependence = names_.dependence(tree_, symbol, by);
    if (by == By::space && dependence.kind == Kind::variable) note_position(symbol);
    const bool guessed = dependence.kind == Kind::varies && !names_.knows_change(tree_, symbol, by);
    const bool noted = is_one_of(symbol, unknown_changes_);
    if (guessed && !noted) unknown_changes_.push_back(symbol);
    return dependence;
  };
  const auto key = std::tuple(by, partial, axis.axis, axis.variable);
  return differentiators_.try_emplace(key, tree_, by, dependence_of, derivatives_, axis).first->second;
}

Typed Elaborator::rate_of(Typed typed, int times, bool partial) {
  Differentiator& by_time = differentiator(By::time, {}, partial);
  for (int k = 0; k < times; ++k) typed.id = by_time.derivative_or_zero(typed.id);
  return typed;
}

/// A vector changes in its own way in every frame.
bool Elaborator::frame_is_open(const Typed& typed, Span span) {
  if (typed.rank == 0 || names_.frames().empty()) return false;
  const Frame& frame = names_.frames().back();
  fail(
      DiagnosticKind::ambiguous_reading, span,
      fmt::format("the vector's change can be meant as seen in `{}` or in `{}`", frame.fixed, frame.rotating),
      {fmt::format("write `\\left(…\\right)_{{\\text{{{}}}}}` or `\\left(…\\right)_{{\\text{{{}}}}}`",
                   frame.fixed, frame.rotating)});
  return true;
}

/// d/dt of a field follows the motion; only ∂/∂t is a free symbol.
bool Elaborator::is_total_rate_of_field(const Typed& typed, Span span) {
  for (const SymbolId symbol : symbols_in(tree_, typed.id)) {
    const bool varies = names_.dependence(tree_, symbol, By::space).kind == Dependence::Kind::varies;
    if (!varies || !names_.is_field(tree_, symbol)) continue;
    unsupported(span,
                fmt::format("the total rate of the field `{}` is not decided", tree_.symbols[symbol].name),
                {"`\\frac{\\partial}{\\partial t}` is read, and `(\\mathbf{v}\\cdot\\nabla)`"});
    return true;
  }
  return false;
}

/// Does a definition lead to the place?
bool Elaborator::reaches_place(ExprId id) const {
  std::set<SymbolId> seen;
  std::vector<ExprId> pending{id};
  while (!pending.empty()) {
    const ExprId at = pending.back();
    pending.pop_back();
    for (const SymbolId symbol : symbols_in(tree_, at)) {
      if (!seen.insert(symbol).second) continue;
      if (names_.dependence(tree_, symbol, By::space).kind == Dependence::Kind::variable) return true;
      const NamedDefinition* named = names_.definition_of(base_of(tree_.symbols, symbol));
      if (named != nullptr) pending.push_back(named->definition.body);
    }
  }
  return false;
}

/// A partial rate holds the place, also that in a definition: U = r² does not change by itself.
std::optional<Typed> Elaborator::with_places_open(Typed typed, Span span) {
  bool open = true;
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = tree_[id];
    const NamedDefinition* named = names_.definition_of(base_of(tree_.symbols, node.symbol));
    if (named == nullptr || !reaches_place(named->definition.body)) return std::nullopt;
    const Definition& definition = named->definition;
    const bool plain = definition.symbol == node.symbol && definition.indices.empty() &&
                       definition.particle == no_particle && !definition.by_square;
    open = open && plain;
    if (!plain) return std::nullopt;
    const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
    return component_of(tree_, definition.body, slots);
  };
  for (ExprId before = typed.id; open; before = typed.id) {
    typed.id = replaced(tree_, typed.id, by);
    if (typed.id == before) return typed;
  }
  return unsupported(span, "the partial rate of what is defined through the place is not decided");
}

/// `\dot x`. A dot on the length r of a vector is d|r|/dt, to the letter; on that of a particle's vector,
/// squared, a missing bold face may be meant, as in ½ Σ m ṙ².
std::optional<Typed> Elaborator::rate(const WrittenSymbol& written, Span span) {
  WrittenSymbol bare = written;
  const int times = std::exchange(bare.dots, std::uint8_t{0});
  Maybe typed = symbol(bare, span);
  if (!typed || frame_is_open(*typed, span) || is_total_rate_of_field(*typed, span)) return std::nullopt;
  if (tree_[typed->id].op != Op::length || !squared_) return rate_of(std::move(*typed), times);
  const ExprNode& vector_of_length = tree_[tree_.children(typed->id)[0]];
  const bool of_particle =
      vector_of_length.op == Op::symbol && tree_.symbols[vector_of_length.symbol].per_particle;
  if (!of_particle) return rate_of(std::move(*typed), times);
  dotted_length_ = span;
  if (!reading_.dots_on_vectors) return rate_of(std::move(*typed), times);
  typed->id = tree_.children(typed->id)[0];
  typed->rank = 1;
  const Typed vector = rate_of(std::move(*typed), times);
  return make(Op::length, span, 0, {&vector});
}

std::optional<Typed> Elaborator::derivative(SyntaxId id) {
  const Span span = syntax_[id].span;
  const bool partial = syntax_.derivative(id).partial;
  if (!partial && names_.is_declared({"d", 0, false}))
    return fail(DiagnosticKind::ambiguous_reading, span, "`d` is declared, and can be a differential here");
  Maybe operand = expression(syntax_.child(id, 0));
  for (const WrittenVariable& variable : syntax_.derivative(id).by) {
    if (!operand) return operand;
    if (is_time(variable.symbol)) {
      if (frame_is_open(*operand, span) || (!partial && is_total_rate_of_field(*operand, span)))
        return std::nullopt;
      if (partial) operand = with_places_open(*std::move(operand), span);
      if (!operand) return operand;
      operand = rate_of(std::move(*operand), variable.times, partial);
      continue;
    }
    const bool may_depend = !partial || is_bare_coordinate(syntax_, syntax_.child(id, 0));
    if (may_depend && depends_on_other_coordinate(*operand, variable.symbol, span)) return std::nullopt;
    for (int k = 0; operand && k < variable.times; ++k)
      operand = by_coordinate(std::move(*operand), variable.symbol, span);
  }
  return operand;
}

/// In `\frac{dy}{dx}` y is a function of x as a rule, and no coordinate.
bool Elaborator::depends_on_other_coordinate(const Typed& operand, const WrittenSymbol& variable, Span span) {
  for (const SymbolId symbol : symbols_in(tree_, operand.id)) {
    const Dependence dependence = names_.dependence(tree_, symbol, By::space);
    const bool same = variable.lower.empty() && dependence.axis == axis_of_letter(variable.letter);
    if (dependence.kind != Dependence::Kind::variable || same) continue;
    fail(DiagnosticKind::ambiguous_reading, span,
         fmt::format("`{}` can be a coordinate of its own here, or a function of `{}`",
                     tree_.symbols[symbol].name, variable.letter),
         {"`\\partial` holds the other coordinates; `rigor: let` says what it depends on"});
    return true;
  }
  return false;
}

/// Of x, y, z, the vector r and the vector x, any one can be the position; two of them are related in a way
/// that nothing says.
void Elaborator::note_position(SymbolId symbol) {
  differentiates_position_ = true;
  positions_.insert(position_name(symbol));
}

std::string Elaborator::position_name(SymbolId symbol) const {
  const Symbol& named = tree_.symbols[symbol];
  return named.rank == 0 ? "x, y, z" : named.name;
}

std::optional<Obstacle> Elaborator::guess() const {
  if (guess_ || !differentiates_position_ || positions_.size() < 2) return guess_;
  return Obstacle{DiagnosticKind::ambiguous_reading,
                  fmt::format("`{}` and `{}` can both be the position", *positions_.begin(),
                              *std::next(positions_.begin())),
                  {"`rigor: let \\mathbf{r} = (x, y, z)` relates them"}};
}

std::optional<Typed> Elaborator::by_coordinate(Typed operand, const WrittenSymbol& variable, Span span) {
  const std::uint8_t axis = variable.lower.empty() ? axis_of_letter(variable.letter) : std::uint8_t{0};
  const bool indexed = (variable.letter == "x" || variable.letter == "r") && variable.lower.size() == 1;
  if (!is_undecorated(variable) || (axis == 0 && !indexed))
    return unsupported(span, fmt::format("a derivative by this `{}` is not decided", variable.letter),
                       {"derivatives by the time t and by x, y, z, x_i are"});
  std::vector<Slot> slots{{axis, {}}};
  Typed subscript;
  if (axis == 0) {
    slots.clear();
    if (any_primed(variable.lower))
      return unsupported(span, "a derivative along a primed axis is not decided");
    if (!read_slots(variable.lower, slots, subscript.free))
      return unsupported(span, "this subscript is not one of index letters or axes");
  }
  Typed typed;
  std::vector<FreeIndex> to_sum;
  if (!sum_repeated({subscript, operand}, to_sum, typed.free, typed.bound)) return std::nullopt;
  typed.rank = operand.rank;
  typed.particles = operand.particles;
  typed.id = differentiator(By::space, slots[0]).derivative_or_zero(operand.id);
  return sum_over(std::move(typed), to_sum);
}

/// The ∇ of an operator.
const WrittenSymbol& Elaborator::nabla_of(SyntaxId id) const {
  if (syntax_[id].kind == SyntaxKind::power) id = syntax_.child(id, 0);
  if (syntax_[id].kind == SyntaxKind::group) id = syntax_.children(syntax_.child(id, 0)).back().id;
  return syntax_.symbol(id);
}

/// Acts on the next factor; where another factor follows that it could act on too, it is not read.
std::optional<Typed> Elaborator::apply_operator(std::span<const SyntaxChild> factors, std::size_t at,
                                                std::size_t& next) {
  const SyntaxId id = factors[at].id;
  const Span span = syntax_[id].span;
  if (at + 1 >= factors.size()) return unsupported(span, "an operator without what it acts on is not read");
  std::size_t run = at;
  while (run < factors.size() && acts_as_operator(syntax_, factors[run].id)) ++run;
  if (run - at > most_axes) {
    next = factors.size();
    return unsupported(span, fmt::format("more than {} operators in a row are not read", most_axes));
  }
  const Joint joint = factors[at + 1].joint;
  next = at + 2;
  const WrittenSymbol& nabla = nabla_of(id);
  const bool component = is_nabla(syntax_, id) && nabla.lower.size() == 1 && joint == Joint::juxtaposed;
  const bool marked =
      nabla.accent != Accent::none || nabla.primes > 0 || nabla.dots > 0 || !nabla.change.empty();
  if (marked || (!nabla.lower.empty() && !component))
    return unsupported(span, "a `\\nabla` with marks or subscripts is not read", {"`\\nabla_i f` is"});
  const SyntaxId behind = factors[at + 1].id;
  const bool nested = acts_as_operator(syntax_, behind);
  const Maybe operand = nested ? apply_operator(factors, at + 1, next) : expression(behind);
  if (!operand) return operand;
  const Joint after = next < factors.size() ? factors[next].joint : Joint::none;
  const bool takes_more =
      after == Joint::juxtaposed ||
      (after == Joint::cross && (joint != Joint::juxtaposed || operand->rank > 0)) ||
      (after == Joint::dot && joint == Joint::juxtaposed && operand->rank > 0 && is_nabla(syntax_, id));
  if (takes_more && !nested)
    return fail(DiagnosticKind::ambiguous_reading, cover(span, syntax_[factors[next].id].span),
                "`\\nabla` can act on the next factor or on all that follow",
                {"put brackets around what it acts on"});
  const Span whole = cover(span, tree_[operand->id].span);
  if (component) {
    WrittenSymbol coordinate;
    coordinate.letter = "x";
    coordinate.lower = nabla.lower;
    return by_coordinate(*operand, coordinate, whole);
  }
  if (syntax_[id].kind == SyntaxKind::group) {
    const SyntaxId inside = syntax_.child(id, 0);
    const auto parts = syntax_.children(inside);
    if (parts.size() != 2 || parts[1].joint != Joint::dot || joint != Joint::juxtaposed)
      return unsupported(span, "this operator is not read", {"`(\\mathbf{A}\\cdot\\nabla)` is"});
    const Maybe along = expression(parts[0].id);
    return along ? directional(*along, *operand, whole) : along;
  }
  if (syntax_[id].kind == SyntaxKind::power) {
    if (integer(syntax_.child(id, 1)) != 2 || joint != Joint::juxtaposed)
      return unsupported(span, "of powers of `\\nabla`, `\\nabla^2` is read");
    return apply_nabla(FieldOperator::laplacian, *operand, whole);
  }
  return apply_nabla(joint == Joint::dot     ? FieldOperator::divergence
                     : joint == Joint::cross ? FieldOperator::curl
                                             : FieldOperator::gradient,
                     *operand, whole);
}

ExprId Elaborator::partial(ExprId id, std::uint8_t axis) {
  return differentiator(By::space, {axis, {}}).derivative_or_zero(id);
}

ExprId Elaborator::at_axis(ExprId id, std::uint8_t axis) {
  const Slot slot{axis, {}};
  return component_of(tree_, id, std::span(&slot, 1));
}

ExprId Elaborator::sum_of(std::vector<ExprId> terms, int rank, Span span) {
  return tree_.add({.op = Op::add, .rank = static_cast<std::uint8_t>(rank), .span = span}, terms);
}

/// (∇f)_i = ∂_i f, (∇A)_ij = ∂_i A_j, ∇·A = ∂_i A_i, (∇×A)_i = ε_ijk ∂_j A_k, ∇²A = ∂_i ∂_i A.
std::optional<Typed> Elaborator::apply_nabla(FieldOperator what, const Typed& operand, Span span) {
  const bool of_vector = what == FieldOperator::divergence || what == FieldOperator::curl;
  if (of_vector && operand.rank != 1)
    return operand.rank > 1
               ? unsupported(span, "the divergence of a tensor is not decided in this notation")
               : fail(DiagnosticKind::rank_mismatch, span, "a divergence or curl is taken of a vector",
                      {"`\\nabla f` is the gradient"});
  if (operand.rank > 1) return unsupported(span, "derivatives of tensors are decided in index notation only");
  const auto along = [&](std::uint8_t i) -> ExprId {
    const auto j = static_cast<std::uint8_t>(i % 3 + 1);
    const auto k = static_cast<std::uint8_t>(j % 3 + 1);
    switch (what) {
      case FieldOperator::gradient:
        return partial(operand.id, i);
      case FieldOperator::divergence:
        return at_axis(partial(operand.id, i), i);
      case FieldOperator::laplacian:
        return partial(partial(operand.id, i), i);
      case FieldOperator::curl:
        break;
    }
    const ExprId subtracted = at_axis(partial(operand.id, k), j);
    const ExprId negated = tree_.add({.op = Op::negate, .span = span}, std::span(&subtracted, 1));
    return sum_of({at_axis(partial(operand.id, j), k), negated}, 0, span);
  };
  std::vector<ExprId> parts{along(1), along(2), along(3)};
  Typed typed = operand;
  if (what == FieldOperator::gradient) ++typed.rank;
  if (what == FieldOperator::divergence) typed.rank = 0;
  const bool is_sum = what == FieldOperator::divergence || what == FieldOperator::laplacian;
  const auto rank = static_cast<std::uint8_t>(typed.rank);
  typed.id = is_sum ? sum_of(std::move(parts), typed.rank, span)
                    : tree_.add({.op = Op::tuple, .rank = rank, .span = span}, parts);
  return typed;
}

/// (A·∇)X = A_i ∂_i X
std::optional<Typed> Elaborator::directional(const Typed& along, const Typed& operand, Span span) {
  if (along.rank != 1)
    return fail(DiagnosticKind::rank_mismatch, span, "`(\\mathbf{A}\\cdot\\nabla)` needs a vector");
  std::vector<ExprId> terms;
  for (std::uint8_t i = 1; i <= 3; ++i) {
    const ExprId factors[] = {at_axis(along.id, i), partial(operand.id, i)};
    terms.push_back(tree_.add(
        {.op = Op::multiply, .rank = static_cast<std::uint8_t>(operand.rank), .span = span}, factors));
  }
  Typed typed = operand;
  merge_free(typed.free, along.free);
  merge_free(typed.particles, along.particles);
  merge_free(typed.bound, along.bound);
  typed.id = sum_of(terms, operand.rank, span);
  return typed;
}

/// Df/Dt = ∂f/∂t + (u·∇)f along a motion u of which nothing is said: what holds for every u is proved, and
/// nothing is refuted.
std::optional<Typed> Elaborator::material_rate(SyntaxId operand, Span span) {
  const NameKey letter{"D", 0, false};
  if (names_.is_declared(letter)) {
    static_cast<void>(names_.resolve(tree_, letter, "D", span));  // the declaration is used
    return unsupported(span, "`D` is declared, and `D/Dt` is the derivative along a motion");
  }
  const std::size_t unknown_before = unknown_changes_.size();
  const Maybe typed = expression(operand);
  if (!typed || frame_is_open(*typed, span)) return std::nullopt;
  const SymbolId flow =
      names_.resolve(tree_, {"u_{\\text{material}}", 1, false}, "\\mathbf{u}_{\\text{material}}", span);
  Typed along;
  along.rank = 1;
  along.id = tree_.add({.op = Op::symbol, .rank = 1, .span = span, .symbol = flow});
  const Maybe carried = directional(along, *typed, span);
  const Maybe open = with_places_open(*typed, span);
  if (!carried || !open) return std::nullopt;
  const Typed local = rate_of(*open, 1, true);
  unknown_changes_.resize(unknown_before);  // it is the motion that is not known
  guess_ = Obstacle{DiagnosticKind::unsupported, "nothing says along which motion `D/Dt` follows", {}};
  return make(Op::add, span, typed->rank, {&local, &*carried});
}

/// `\delta x` is one symbol, and where \delta is a small number, a product is as likely meant.
bool Elaborator::hides_small_factor(const WrittenSymbol& written, const WrittenName& name) const {
  return !written.change.empty() && names_.is_small_scalar(tree_, written.change) &&
         !names_.is_declared({name.base, 0, false}) && !names_.is_declared({name.base, 1, false});
}

}  // namespace rigor
