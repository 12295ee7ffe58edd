// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic/constraints.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/evaluator/components.h"
#include "algebra/ring/kernel.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::size_t largest_instances = 64;  // choices of the claim's particles for an assumption

/// The solution of an equation that is linear in x with a numeric coefficient.
[[nodiscard]] ex solved_for(const ex& equation, const ex& x) {
  return (-equation.coeff(x, 0) / equation.coeff(x, 1)).expand();
}

}  // namespace

void Constraints::assume(std::span<const std::size_t> positions) {
  const std::vector<Equation>& assumptions = scope_.question().assumptions;
  const auto for_each = [&](bool order, const auto& take) {
    for (const std::size_t position : positions) {
      if ((assumptions[position].relation != Relation::equal) == order) take(position);
    }
  };
  for (const std::size_t position : positions) {
    take_unit_vectors_as_coordinates(reach(scope_, assumptions[position]).symbols);
  }
  for_each(true, [&](std::size_t position) {
    orders_.insert(position);
    learn_signs(position);
  });
  domain_.signs().conclude();
  evaluator_.forget();
  for_each(false, [&](std::size_t position) {
    if (assumptions[position].particles.size() == 1) solve_for_each_particle(position);
  });
  for_each(false, [&](std::size_t position) { collect(position); });
  eliminate();
}

/// An order for each particle is learnt at the template, which all particles share, and for those of the
/// claim.
void Constraints::learn_signs(std::size_t position) {
  const Equation& assumption = scope_.question().assumptions[position];
  if (assumption.particles.size() > 1) return;
  const bool each_particle = !assumption.particles.empty();
  const Relation relation = assumption.relation;
  const Sign sign = relation == Relation::less            ? Sign::positive
                    : relation == Relation::less_or_equal ? Sign::not_negative
                                                          : Sign::not_zero;
  const auto last = static_cast<Frame>(scope_.question().claim.particles.size()) + first_free_frame;
  for (Frame frame = template_frame; frame < (each_particle ? last : template_frame + 1); ++frame) {
    if (each_particle) evaluator_.bind(assumption.particles[0], frame);
    for_each_component(evaluator_, scope_.tree(), assumption,
                       [&](const auto&, const Fraction& left, const Fraction& right) {
                         const Fraction difference = domain_.subtracted(right, left);
                         const ex value = domain_.with_sign_of(difference);
                         const Sign narrower = common(sign, domain_.signs().of(difference));
                         if (narrower == Sign::negative) {  // −Σ (a − b)² ≠ 0
                           domain_.signs().add_fact((-value).expand(), Sign::positive);
                         } else {
                           domain_.signs().add_fact(value, narrower == Sign::impossible ? sign : narrower);
                         }
                         const bool nonzero = rigor::is_within(sign, Sign::not_zero);
                         if (nonzero && (!each_particle || frame != template_frame))
                           note_nonzero(value, position);
                         if (is_number(value) && !rigor::is_within(domain_.signs().of(value), sign)) {
                           throw Contradiction();
                         }
                         return true;
                       });
    evaluator_.forget();
  }
}

std::vector<Signs::Fact> Constraints::reduced_facts() {
  used_.insert(orders_.begin(), orders_.end());
  std::vector<Signs::Fact> facts;
  for (const Signs::Fact& fact : domain_.signs().facts()) {
    const ex value = reduced(fact.value);
    if (!is_number(value)) facts.push_back({value, fact.sign});
    if (is_number(value) && !rigor::is_within(domain_.signs().of(value), fact.sign)) {
      throw Contradiction();
    }
  }
  return facts;
}

void Constraints::take_unit_vectors_as_coordinates(std::span<const SymbolId> symbols) {
  for (const SymbolId symbol : symbols) {
    const Symbol& named = scope_.tree().symbols[symbol];
    if (!named.unit || scope_.is_defined(symbol) || !domain_.take_as_coordinates(symbol)) continue;
    if (named.per_particle) continue;  // then n_3² = 1 − n_1² − n_2² is replaced wherever it stands
    ex square = -1;
    for (std::uint32_t i = 0; i < 3; ++i) {
      square += GiNaC::pow(domain_.indeterminates().coordinate(symbol, i, common_frame), 2);
    }
    unit_vectors_.push_back({symbol, trace_.given.size()});
    give({.equation = square, .origin = ConstraintsTrace::Given::Origin::unit_vector}, {});
  }
}

/// Component after component, each with the earlier ones in force.
void Constraints::solve_for_each_particle(std::size_t position) {
  const Equation& assumption = scope_.question().assumptions[position];
  std::size_t solved = 0;
  for (bool again = true; again;) {
    again = false;
    std::size_t seen = 0;
    evaluator_.forget();
    evaluator_.bind(assumption.particles[0], template_frame);
    for_each_component(evaluator_, scope_.tree(), assumption,
                       [&](const auto&, const Fraction& left, const Fraction& right) {
                         if (seen++ < solved) return true;
                         ++solved;
                         again = replace_own_number(domain_.difference(left, right), position);
                         if (again) used_.insert(position);
                         return !again;
                       });
  }
  evaluator_.forget();
}

bool Constraints::replace_own_number(const ex& equation, std::size_t position) {
  const Indeterminates& indeterminates = domain_.indeterminates();
  const std::vector<ex>& all = indeterminates.all();
  const bool plain = std::ranges::none_of(all, [&](const ex& x) {
    const Indeterminates::Origin& origin = indeterminates.origin(x);
    return origin.kind != Indeterminates::Kind::coordinate && origin.frames != 0 && equation.has(x);
  });
  if (!plain) return false;  // a root or a moment that is this particle's
  for (const ex& x : all) {
    const Indeterminates::Origin origin = indeterminates.origin(x);
    if (origin.kind != Indeterminates::Kind::coordinate || origin.frame != template_frame) continue;
    const Symbol& named = scope_.tree().symbols[origin.symbol];
    if ((named.unit || named.rotation) && !scope_.is_defined(origin.symbol)) continue;
    if (equation.degree(x) != 1 || !is_number(equation.coeff(x, 1))) continue;
    const ex own = x;  // the list may grow
    const ex worth = solved_for(equation, own);
    domain_.replace(origin.symbol, origin.component, worth);
    trace_.of_each_particle.push_back({position, own, worth});
    return true;
  }
  return false;
}

/// An assumption for each particle holds for those that the claim names.
void Constraints::collect(std::size_t position) {
  using Origin = ConstraintsTrace::Given::Origin;
  const Equation& assumption = scope_.question().assumptions[position];
  const std::size_t free_particles = scope_.question().claim.particles.size();
  const std::size_t count = assumption.particles.size();
  if (count > 0 && free_particles == 0) return;
  const double instances = std::pow(static_cast<double>(free_particles), static_cast<double>(count));
  if (count > 0 && instances > static_cast<double>(largest_instances)) return;
  const auto last = first_free_frame + static_cast<Frame>(free_particles) - 1;
  std::vector<std::uint32_t> frames(count, first_free_frame);
  std::vector<ex> all;
  const std::size_t first = trace_.given.size();
  do {
    for (std::size_t i = 0; i < count; ++i) evaluator_.bind(assumption.particles[i], frames[i]);
    for_each_component(evaluator_, scope_.tree(), assumption,
                       [&](const auto& axes, const Fraction& left, const Fraction& right) {
                         const ex equation = domain_.difference(left, right);
                         for (const Fraction* side : {&left, &right}) {
                           for (const Divisor& each : side->divisors) note_nonzero(each.base);
                         }
                         all.push_back(equation);
                         give({equation, Origin::assumption, position, axes, frames}, {position});
                         give({domain_.radicals().squared(equation), Origin::square_of_previous}, {position});
                         return true;
                       });
  } while (next_tuple(frames, first_free_frame, last));
  collect_determinants(all, first, position);
}

void Constraints::give(ConstraintsTrace::Given given, Positions from) {
  equations_.push_back({given.equation, std::move(from), trace_.given.size()});
  trace_.given.push_back(std::move(given));
}

/// `first`: where the first of the equations is given; after each stands its square.
void Constraints::collect_determinants(std::span<const ex> equations, std::size_t first,
                                       std::size_t position) {
  Indeterminates& known = domain_.indeterminates();
  for (const UnitVector& unit : unit_vectors_) {
    const std::array<ex, 3> n{known.coordinate(unit.symbol, 0, common_frame),
                              known.coordinate(unit.symbol, 1, common_frame),
                              known.coordinate(unit.symbol, 2, common_frame)};
    for (KernelDeterminant& each : kernel_determinants(equations, n)) {
      determinants_.push_back({std::move(each.value), {position}});
      for (std::size_t& row : each.rows) row = first + 2 * row;
      trace_.determinants.push_back({each.rows, unit.given, n});
    }
  }
}

/// The highest exponent of each indeterminate; nothing of what cannot be packed.
std::vector<int> Constraints::degrees(const Numerator& equation) const {
  const PackedPolynomial* const packed = equation.packed(letters());
  return packed == nullptr ? std::vector<int>{} : packed->degrees(letters().count());
}

/// The first in the order of creation, so that the choice is the same in every run; a radical only if there
/// is no other.
std::optional<std::size_t> Constraints::linear_indeterminate(const Numerator& equation) const {
  const std::vector<int> highest = degrees(equation);
  for (const bool radical : {false, true}) {
    for (std::size_t x = 0; x < highest.size(); ++x) {
      if (highest[x] != 1 || domain_.radicals().is_radical(letters().at(x)) != radical) continue;
      if (equation.packed(letters())->coefficient_of(x, 1).is_number()) return x;
    }
  }
  return std::nullopt;
}

ex Constraints::monic_indeterminate(const Numerator& equation) const {
  const std::vector<int> highest = degrees(equation);
  for (std::size_t x = 0; x < highest.size(); ++x) {
    if (highest[x] < 2 || domain_.radicals().is_radical(letters().at(x))) continue;
    if (equation.packed(letters())->coefficient_of(x, highest[x]).is_number()) return letters().at(x);
  }
  return 0;
}

int Constraints::degree_in(const Numerator& value, const Solution& by) const {
  const PackedPolynomial* const packed = value.packed(letters());
  return packed == nullptr ? value.written().degree(by.indeterminate) : packed->degree_in(by.letter);
}

Numerator Constraints::substituted(const Numerator& value, const Solution& by) {
  const int degree = degree_in(value, by);
  if (degree == 0) return value;
  const std::size_t terms_of_worth = std::max<std::size_t>(domain_.term_count(by.worth), 1);
  const double terms =
      static_cast<double>(domain_.term_count(value)) * std::pow(static_cast<double>(terms_of_worth), degree);
  const PackedPolynomial* const packed = value.packed(letters());
  if (packed == nullptr) {  // its degree is very high
    const ex replaced =
        value.written().subs(by.indeterminate == by.worth.written(), GiNaC::subs_options::no_pattern);
    return domain_.reduced(replaced, terms);
  }
  Numerator sum;
  for (int power = 0; power <= degree; ++power) {
    Numerator part(packed->coefficient_of(by.letter, power), letters());
    if (power > 0) part = part.times(by.worth.to_power(power, letters()), letters());
    sum.add(part, letters());
  }
  return domain_.reduced(sum, terms);
}

void Constraints::substitute(Numerator& value, Positions& from, const Solution& by) {
  if (degree_in(value, by) == 0) return;
  value = substituted(value, by);
  from.insert(by.from.begin(), by.from.end());
}

void Constraints::eliminate() {
  std::vector<Known> open = equations_;
  for (bool again = true; again;) {
    again = false;
    std::erase_if(open, [](const Known& each) { return each.equation.is_zero(); });
    for (std::size_t i = 0; i < open.size() && !again; ++i) {
      if (is_number(open[i].equation)) throw Contradiction();
      const auto letter = linear_indeterminate(open[i].equation);
      if (!letter) continue;
      const ex x = letters().at(*letter);
      const PackedPolynomial& equation = *open[i].equation.packed(letters());
      const PackedNumber factor = equation.coefficient_of(*letter, 1).coefficient(0);
      Numerator worth(equation.coefficient_of(*letter, 0) * (PackedNumber(-1) / factor), letters());
      const Solution solution{x, *letter, std::move(worth), open[i].from};
      trace_.eliminations.push_back({x, open[i].given});
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
      for (Known& other : open) substitute(other.equation, other.from, solution);
      for (Solution& earlier : solutions_) substitute(earlier.worth, earlier.from, solution);
      solutions_.push_back(solution);
      again = true;
    }
  }
  for (const Known& each : open) {
    remaining_.push_back({each.equation, monic_indeterminate(each.equation), each.from,
                          domain_.indeterminates().positions_in(each.equation)});
    trace_.left.push_back({each.given, remaining_.back().monic_in});
  }
}

}  // namespace rigor
