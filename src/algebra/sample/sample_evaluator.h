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

/// The values of one sample, as a Domain of `Evaluator`. The point is rejected where a value is not defined,
/// or not exact unless it may be enclosed. Throws Undecidable where the work is too much.
class SampleDomain {
 public:
  using Number = PointValue;

  explicit SampleDomain(const Limits& limits) : largest_steps_(limits.steps), budget_(limits.budget) {}

  void look_at(const SamplePoint& point) { point_ = &point; }
  /// Before an expression is evaluated.
  void begin() { rejected_ = false; }
  [[nodiscard]] bool is_rejected() const { return rejected_; }
  [[nodiscard]] const SamplePoint& point() const { return *point_; }

  [[nodiscard]] PointValue number(const std::string& digits);
  [[nodiscard]] PointValue integer(int value) { return value; }
  [[nodiscard]] bool is_zero(const PointValue& value) {
    return is_rational(value) && cln::zerop(value.rational);
  }
  void add(PointValue& total, const PointValue& summand) {
    if (is_rational(total) && is_rational(summand)) {
      total.rational = total.rational + summand.rational;  // a sum is hardly longer than its summands
    } else {
      rigor::add(total, summand);
    }
  }
  void negate(PointValue& value) {
    if (is_rational(value)) {
      value.rational = -value.rational;
    } else {
      value = scaled(std::move(value), -1);
    }
  }
  [[nodiscard]] PointValue multiply(const PointValue& a, const PointValue& b);
  [[nodiscard]] PointValue divide(const PointValue& a, const PointValue& b);
  [[nodiscard]] PointValue power(const PointValue& base, int exponent);
  [[nodiscard]] PointValue real_power(const PointValue& base, const PointValue& exponent);
  [[nodiscard]] PointValue root(const PointValue& square);
  [[nodiscard]] PointValue even_power_of_root(const PointValue& square, int exponent) {
    check_root(square);
    return power(square, exponent / 2);
  }
  void check_root(const PointValue& square);
  [[nodiscard]] PointValue function(Function function, const PointValue& argument);
  [[nodiscard]] PointValue circle_number();
  [[nodiscard]] PointValue value(SymbolId symbol, std::uint32_t particle, std::size_t component);
  template <class Body>
  [[nodiscard]] std::vector<PointValue> particle_sum(std::size_t count, const Body& body) {
    std::vector<PointValue> total(count);
    for (std::uint32_t particle = 1; particle <= point_->particles(); ++particle) {
      const std::vector<PointValue> term = body(particle);
      for (std::size_t i = 0; i < count; ++i) add(total[i], term[i]);
    }
    return total;
  }
  /// From now on what is not exact is enclosed.
  void enclose() { encloses_ = true; }
  /// From now on π is taken for a rational number, as any letter is: no polynomial tells the two apart for
  /// good, so that this serves where it is only asked whether something can be met.
  void take_circle_number_as_rational() { circle_ = Rational(22) / 7; }
  void take_circle_number_as_it_is() { circle_.reset(); }
  void settle(PointValue&) {}
  void step();
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  void allow_more(std::uint64_t steps) { largest_steps_ = std::max(largest_steps_, steps_ + steps); }
  void go_on_from(std::uint64_t steps) { steps_ = steps; }

 private:
  [[nodiscard]] PointValue rejected() {
    rejected_ = true;
    return {};
  }
  [[nodiscard]] PointValue bounded(Rational value);
  /// What is not exact; rejected where that does not do, and where there is no such value.
  template <class Bounds>
  [[nodiscard]] PointValue enclosed(const Bounds& bounds);
  [[nodiscard]] bool is_enclosed_above_zero(const PointValue& value);
  /// Counts as many steps as it takes the time of.
  [[nodiscard]] Enclosure enclosure(const PointValue& value);

  const SamplePoint* point_ = nullptr;
  bool rejected_ = false;
  bool encloses_ = false;
  std::optional<Rational> circle_;
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
  PointValue left;
  PointValue right;
};

/// Throws PointRejected where what is asked for has no value on the sample.
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
  [[nodiscard]] std::vector<PointValue> value_of(const Definition& definition, std::uint32_t particle);
  /// From now on what is not exact is enclosed.
  void enclose() { domain_.enclose(); }
  void take_circle_number_as_rational() { domain_.take_circle_number_as_rational(); }
  void take_circle_number_as_it_is() { domain_.take_circle_number_as_it_is(); }
  /// How many steps of evaluation there have been.
  [[nodiscard]] std::uint64_t steps() const { return domain_.steps(); }
  /// From now on at least so many.
  void allow_more(std::uint64_t steps) { domain_.allow_more(steps); }
  /// As if there had been so many.
  void go_on_from(std::uint64_t steps) { domain_.go_on_from(steps); }
  [[nodiscard]] std::vector<Place> places(const Equation& equation) const;

 private:
  void throw_if_rejected() const;
  /// Calls visit(place, left, right) for all components and particles until it returns false.
  template <class Visit>
  void for_each_place(const Equation& equation, const Visit& visit);

  const Scope* scope_;
  SampleDomain domain_;
  Evaluator<SampleDomain> evaluator_;
};

}  // namespace rigor
