// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions and equations on an exact sample.
#pragma once

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "algebra/engine/limits.h"
#include "algebra/evaluator/components.h"
#include "algebra/evaluator/evaluator.h"
#include "algebra/sample/sample_point.h"
#include "expr/statement/statement.h"

namespace rigor {

/// The exact values of one sample, as a Domain of `Evaluator`. Throws PointRejected where a value is not
/// rational or not defined, Undecidable where the work is too much.
class SampleDomain {
 public:
  using Number = ExactValue;

  explicit SampleDomain(const Limits& limits) : largest_steps_(limits.steps), budget_(limits.budget) {}

  void look_at(const SamplePoint& point) { point_ = &point; }
  [[nodiscard]] const SamplePoint& point() const { return *point_; }

  [[nodiscard]] ExactValue number(const std::string& digits);
  [[nodiscard]] ExactValue integer(int value) { return value; }
  [[nodiscard]] bool is_zero(const ExactValue& value) {
    return value.parts.empty() && cln::zerop(value.rational);
  }
  void add(ExactValue& total, const ExactValue& summand) {
    if (summand.parts.empty()) {
      total.rational = total.rational + summand.rational;  // a sum is hardly longer than its summands
    } else {
      rigor::add(total, summand);
    }
  }
  void negate(ExactValue& value) {
    if (value.parts.empty()) {
      value.rational = -value.rational;
    } else {
      value = scaled(std::move(value), -1);
    }
  }
  [[nodiscard]] ExactValue multiply(const ExactValue& a, const ExactValue& b);
  [[nodiscard]] ExactValue divide(const ExactValue& a, const ExactValue& b);
  [[nodiscard]] ExactValue power(const ExactValue& base, int exponent);
  [[nodiscard]] ExactValue root(const ExactValue& square);
  [[nodiscard]] ExactValue even_power_of_root(const ExactValue& square, int exponent) {
    check_root(square);
    return power(square, exponent / 2);
  }
  void check_root(const ExactValue& square);
  [[nodiscard]] ExactValue function(Function function, const ExactValue& argument);
  [[nodiscard]] ExactValue value(SymbolId symbol, std::uint32_t particle, std::size_t component);
  template <class Body>
  [[nodiscard]] std::vector<ExactValue> particle_sum(std::size_t count, const Body& body) {
    std::vector<ExactValue> total(count);
    for (std::uint32_t particle = 1; particle <= point_->particles(); ++particle) {
      const std::vector<ExactValue> term = body(particle);
      for (std::size_t i = 0; i < count; ++i) add(total[i], term[i]);
    }
    return total;
  }
  void settle(ExactValue&) {}
  void step();
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  void allow_more(std::uint64_t steps) { largest_steps_ = std::max(largest_steps_, steps_ + steps); }

 private:
  const SamplePoint* point_ = nullptr;
  std::unordered_map<std::string, Rational> numbers_;
  std::uint64_t largest_steps_;
  Budget* budget_;  // may be none
  std::uint64_t steps_ = 0;
};

/// One component of an equation, for one choice of particles.
struct Place {
  std::vector<std::uint8_t> axes;  // the free indices' values, then the axes of a vector or tensor equation
  std::vector<std::uint32_t> particles;  // of the free particle variables, from 1
};

/// Where a relation does not hold.
struct Difference {
  Place place;
  Rational left;
  Rational right;
};

class SampleEvaluator {
 public:
  SampleEvaluator(const Scope& scope, const Limits& limits)
      : scope_(&scope), domain_(limits), evaluator_(scope, domain_) {}

  /// The sample to evaluate on; to be called again when it has changed.
  void look_at(const SamplePoint& point);

  /// The first place where the sides differ (or are not in order); none: the equation holds on the sample.
  [[nodiscard]] std::optional<Difference> difference(const Equation& equation);
  [[nodiscard]] bool holds(const Equation& equation) { return !difference(equation); }
  /// Is the left side zero by itself, everywhere?
  [[nodiscard]] bool left_vanishes(const Equation& equation);
  /// left − right at all places, in the order of `places`.
  [[nodiscard]] std::vector<Rational> residuals(const Equation& equation);
  [[nodiscard]] Difference at(const Equation& equation, const Place& place);
  [[nodiscard]] std::vector<Rational> value_of(const Definition& definition, std::uint32_t particle);
  /// How many steps of evaluation there have been.
  [[nodiscard]] std::uint64_t steps() const { return domain_.steps(); }
  /// From now on at least so many.
  void allow_more(std::uint64_t steps) { domain_.allow_more(steps); }
  [[nodiscard]] std::vector<Place> places(const Equation& equation) const;

 private:
  /// Calls visit(place, left, right) for all components and particles until it returns false.
  template <class Visit>
  void for_each_place(const Equation& equation, const Visit& visit);

  const Scope* scope_;
  SampleDomain domain_;
  Evaluator<SampleDomain> evaluator_;
};

}  // namespace rigor
