// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/assumptions.h"

#include <algorithm>
#include <cmath>

#include "numeric/measure/bounds.h"
#include "numeric/program/program.h"

namespace rigor {
namespace {

Holds relate(Relation relation, double left, double right, double bound) {
  if (!std::isfinite(left) || !std::isfinite(right) || !std::isfinite(bound)) return Holds::open;
  const double distance = right - left;
  const bool apart = std::abs(distance) > bound;
  switch (relation) {
    case Relation::equal:
      return apart ? Holds::no : Holds::yes;
    case Relation::unequal:
      return apart ? Holds::yes : Holds::open;
    case Relation::less:
      if (!apart) return Holds::open;
      break;
    case Relation::less_or_equal:
      if (!apart) return Holds::yes;
      break;
  }
  return distance > 0 ? Holds::yes : Holds::no;
}

Result<Program> compiled(const ExprTree& tree, std::span<const Definition> definitions, ExprId side,
                         const Equation& equation) {
  const ProgramRoot root{side, equation.indices};
  return Program::compile(tree, definitions, std::span(&root, 1));
}

/// What all of them amount to: the worst.
Holds worst(Holds a, Holds b) {
  if (a == Holds::no || b == Holds::no) return Holds::no;
  return a == Holds::open || b == Holds::open ? Holds::open : Holds::yes;
}

}  // namespace

Result<Holds> holds(const ExprTree& tree, std::span<const Definition> definitions, const Equation& equation,
                    const Samples& samples, double uncertainty) {
  const auto left = compiled(tree, definitions, equation.left, equation);
  if (!left) return tl::unexpected(left.error());
  const auto right = compiled(tree, definitions, equation.right, equation);
  if (!right) return tl::unexpected(right.error());
  if (left->outputs() != right->outputs()) return Holds::open;
  const std::size_t particles = equation.particles.empty() ? 1 : samples.particles();
  // a ≠ of vectors holds where any component differs
  const bool any = equation.relation == Relation::unequal;
  Holds whole = Holds::yes;
  for (std::uint32_t particle = 0; particle < particles; ++particle) {
    const std::vector<std::uint32_t> left_at(left->free_particles().size(), particle);
    const std::vector<std::uint32_t> right_at(right->free_particles().size(), particle);
    const BoundedResults a = evaluate_with_bounds(*left, samples, uncertainty, left_at);
    const BoundedResults b = evaluate_with_bounds(*right, samples, uncertainty, right_at);
    for (std::size_t sample = 0; sample < samples.samples(); ++sample) {
      Holds here = any ? Holds::open : Holds::yes;
      for (std::size_t output = 0; output < left->outputs(); ++output) {
        const std::size_t k = output * samples.samples() + sample;
        const Holds found = relate(equation.relation, a.values[k], b.values[k], a.bounds[k] + b.bounds[k]);
        here = any ? (found == Holds::yes ? found : here) : worst(here, found);
      }
      whole = worst(whole, here);
    }
  }
  return whole;
}

bool meets_all(const ExprTree& tree, std::span<const Definition> definitions,
               std::span<const Equation> assumptions, const Samples& samples, double uncertainty) {
  return std::ranges::all_of(assumptions, [&](const Equation& assumption) {
    const auto held = holds(tree, definitions, assumption, samples, uncertainty);
    return held && *held == Holds::yes;
  });
}

}  // namespace rigor
