// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/elaborator.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/among.h"

namespace rigor {

Elaborator::Elaborator(const SyntaxTree& syntax, ExprTree& tree, Names& names, Letters letters,
                       Diagnostics& diagnostics, Reading reading)
    : syntax_(syntax),
      tree_(tree),
      names_(names),
      letters_(std::move(letters)),
      diagnostics_(diagnostics),
      reading_(std::move(reading)) {}

std::optional<Typed> Elaborator::expression(SyntaxId id) {
  Maybe typed = read(id);
  if (!derivatives_.exceeded) return typed;
  return unsupported(syntax_[id].span, *std::exchange(derivatives_.exceeded, std::nullopt));
}

std::optional<Typed> Elaborator::read(SyntaxId id) {
  const SyntaxNode& node = syntax_[id];
  switch (node.kind) {
    case SyntaxKind::number: {
      if (syntax_.text(id).size() > 300)
        return unsupported(node.span, "a number of more than 300 digits is not read");
      Typed typed;
      typed.id = tree_.add_number(node.span, syntax_.text(id));
      return typed;
    }
    case SyntaxKind::symbol:
      return symbol(syntax_.symbol(id), node.span);
    case SyntaxKind::sum:
      return sum(id);
    case SyntaxKind::term:
      return term(id);
    case SyntaxKind::fraction: {
      const Maybe dividend = expression(syntax_.child(id, 0));
      const Maybe divisor = expression(syntax_.child(id, 1));
      if (!dividend || !divisor) return std::nullopt;
      return divide(*dividend, *divisor, node.span);
    }
    case SyntaxKind::root:
      return square_root(id);
    case SyntaxKind::power:
      return power(id);
    case SyntaxKind::component:
      return component(id);
    case SyntaxKind::group:
      for (const SyntaxChild& words : syntax_.children(id).subspan(1)) {
        if (syntax_[words.id].kind == SyntaxKind::opaque) guess_ = syntax_.obstacle(words.id);
      }
      return expression(syntax_.child(id, 0));
    case SyntaxKind::bars:
      return bars(id, false);
    case SyntaxKind::norm:
      return bars(id, true);
    case SyntaxKind::tuple:
      return tuple(id);
    case SyntaxKind::matrix:
      return matrix(id);
    case SyntaxKind::determinant:
      return determinant(id);
    case SyntaxKind::big_sum:
      return big_sum(id);
    case SyntaxKind::cases:
      return cases(id);
    case SyntaxKind::derivative:
      return derivative(id);
    case SyntaxKind::function:
      return function(id);
    case SyntaxKind::integral:
      return integral(id);
    case SyntaxKind::unit:
      return unit(id);
    case SyntaxKind::text:
      return unsupported(node.span, fmt::format("the words `{}` stand for a quantity", syntax_.text(id)));
    case SyntaxKind::opaque: {
      const Obstacle& obstacle = syntax_.obstacle(id);
      return fail(obstacle.kind, node.span, obstacle.message, obstacle.help);
    }
  }
  return std::nullopt;
}

std::optional<Equation> Elaborator::equation(const Typed& left, const Typed& right, Mismatch mismatch) {
  const bool left_zero = is_literal_zero(tree_, left);
  const bool right_zero = is_literal_zero(tree_, right);
  if (!left_zero && !right_zero && !same_type(left, right, "side", mismatch)) return std::nullopt;
  Equation equation;
  equation.left = left_zero ? zero_of(left, right.rank) : left.id;
  equation.right = right_zero ? zero_of(right, left.rank) : right.id;
  const Typed& whole = left_zero ? right : left;
  for (const FreeIndex& free : whole.free) equation.indices.push_back(free.id);
  std::vector<FreeParticle> particles = left.particles;
  merge_free(particles, right.particles);
  for (const FreeParticle& free : particles) equation.particles.push_back(free.id);
  return equation;
}

/// A written 0 stands for the zero of whatever it is compared with.
ExprId Elaborator::zero_of(const Typed& written, int rank) {
  return rank == 0 ? written.id : zero_of_rank(tree_, tree_[written.id].span, rank);
}

std::optional<Typed> Elaborator::fail(DiagnosticKind kind, Span span, std::string message,
                                      std::vector<std::string> help) {
  diagnostics_.push_back({kind, span, std::move(message), {}, std::move(help)});
  return std::nullopt;
}

void Elaborator::note(std::string convention) {
  if (!is_one_of(convention, conventions_)) conventions_.push_back(std::move(convention));
}

Typed Elaborator::make(Op op, Span span, int rank, std::initializer_list<const Typed*> parts, int exponent) {
  Typed typed;
  typed.rank = rank;
  std::vector<ExprId> children;
  for (const Typed* part : parts) {
    children.push_back(part->id);
    merge_free(typed.free, part->free);
    merge_free(typed.particles, part->particles);
    merge_free(typed.bound, part->bound);
  }
  typed.id = tree_.add(
      {.op = op, .rank = static_cast<std::uint8_t>(rank), .span = span, .exponent = exponent}, children);
  return typed;
}

void merge_free(std::vector<FreeIndex>& into, const std::vector<FreeIndex>& from) {
  for (const FreeIndex& entry : from) {
    const bool known = std::any_of(into.begin(), into.end(),
                                   [&](const FreeIndex& old) { return old.letter == entry.letter; });
    if (!known) into.push_back(entry);
  }
}

void merge_free(std::vector<FreeParticle>& into, const std::vector<FreeParticle>& from) {
  for (const FreeParticle& entry : from) {
    const bool known = std::any_of(into.begin(), into.end(),
                                   [&](const FreeParticle& old) { return old.letter == entry.letter; });
    if (!known) into.push_back(entry);
  }
}

bool is_literal_zero(const ExprTree& tree, const Typed& typed) {
  return typed.rank == 0 && tree.is_zero_literal(typed.id);
}

}  // namespace rigor
