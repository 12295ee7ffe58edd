// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions at the generic point: every symbol's components are indeterminates, so that a difference which
// is zero here is zero everywhere. A unit vector is (2p, 2q, 1 − p² − q²) / (1 + p² + q²), which misses one
// point of the sphere and therefore no identity; a rotation is that of a quaternion q, a quadratic form over
// q·q, which misses none; a symmetric tensor is six indeterminates.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "algebra/evaluator/evaluator.h"
#include "algebra/ring/functions.h"
#include "algebra/ring/moments.h"

namespace rigor {

/// Rational functions (with roots, and moments of particle sums), as a Domain of `Evaluator`. Particles are
/// frames.
class GenericDomain {
 public:
  using Number = Fraction;

  GenericDomain(const Scope& scope, const Limits& limits, Effort effort, Work& work, int angle_divisor = 1)
      : scope_(&scope),
        budget_(limits.budget),
        arithmetic_(indeterminates_, limits, work),
        signs_(indeterminates_),
        radicals_(indeterminates_, arithmetic_, signs_, effort),
        functions_(indeterminates_, arithmetic_, signs_, radicals_, angle_divisor),
        moments_(indeterminates_, arithmetic_, radicals_, signs_,
                 first_free_frame + static_cast<Frame>(scope.question().claim.particles.size())) {}
  GenericDomain(const GenericDomain&) = delete;
  GenericDomain& operator=(const GenericDomain&) = delete;

  [[nodiscard]] Fraction number(const std::string& digits);
  [[nodiscard]] Fraction integer(int value) { return to_fraction(value); }
  [[nodiscard]] bool is_zero(const Fraction& value) const { return value.numerator.is_zero(); }
  void add(Fraction& total, const Fraction& summand) { arithmetic_.add(total, summand); }
  void negate(Fraction& value) { arithmetic_.negate(value); }
  [[nodiscard]] Fraction multiply(const Fraction& a, const Fraction& b) { return arithmetic_.multiply(a, b); }
  [[nodiscard]] Fraction divide(const Fraction& a, const Fraction& b);
  [[nodiscard]] Fraction power(const Fraction& base, int exponent);
  [[nodiscard]] Fraction root(const Fraction& square) { return radicals_.root(square); }
  [[nodiscard]] Fraction even_power_of_root(const Fraction& square, int exponent) {
    return power(root(square), exponent);
  }
  void check_root(const Fraction& square) const;
  [[nodiscard]] Fraction function(Function function, const Fraction& argument) {
    return functions_.value(function, argument);
  }
  [[nodiscard]] Fraction real_power(const Fraction& base, const Fraction& exponent) {
    return functions_.real_power(base, exponent);
  }
  [[nodiscard]] Fraction circle_number() { return functions_.circle_number(); }
  [[nodiscard]] Fraction value(SymbolId symbol, std::uint32_t frame, std::size_t component);
  template <class Body>
  [[nodiscard]] std::vector<Fraction> particle_sum(std::size_t count, const Body& body) {
    std::vector<Fraction> total = body(moments_.open());
    for (std::size_t i = 0; i < count; ++i) {
      const Sign sign = sign_as_written(total[i]);
      total[i] = moments_.sum(std::move(total[i]));
      note_sign(total[i], sign);
    }
    moments_.close();
    return total;
  }
  /// What speaks of no particle is worth the same inside a sum: it is evaluated outside of all of them.
  template <class Body>
  [[nodiscard]] auto outside_sums(const Body& body) {
    const std::uint32_t depth = moments_.leave_sums();
    auto value = body();
    moments_.return_to(depth);
    return value;
  }
  void settle(Fraction& value) {
    const Sign sign = sign_as_written(value);
    arithmetic_.expand(value);
    note_sign(value, sign);
  }
  void step() { arithmetic_.step(); }
  void count(double units) { arithmetic_.count(units); }
  [[nodiscard]] Budget* budget() const { return budget_; }

  /// The numerator of left − right, expanded and reduced by the relations of radicals.
  [[nodiscard]] Numerator difference(const Fraction& left, const Fraction& right);
  /// Of an expanded polynomial.
  [[nodiscard]] std::size_t term_count(const Numerator& expanded) const {
    return arithmetic_.term_count(expanded);
  }
  /// right − left, as it is written.
  [[nodiscard]] Fraction subtracted(const Fraction& right, const Fraction& left);
  /// A polynomial, expanded and reduced, that has the sign of a fraction (whose divisors are not 0).
  [[nodiscard]] GiNaC::ex with_sign_of(const Fraction& value);
  /// From now on the signs of sums, as they are written, are noted as facts before they are expanded.
  void note_signs_as_written() { notes_signs_ = true; }
  /// A polynomial expanded and reduced; `terms` is an estimate of how many that may give.
  [[nodiscard]] Numerator reduced(const Numerator& value, double terms);

  /// From now on a unit vector is three coordinates; a particle's third one is known by its square, for
  /// others the caller has to see to n·n = 1. False if that was so before.
  [[nodiscard]] bool take_as_coordinates(SymbolId symbol) { return as_coordinates_.insert(symbol).second; }
  /// From now on a particle's component is worth this, written in the template frame.
  void replace(SymbolId symbol, std::uint32_t component, const GiNaC::ex& worth);

  [[nodiscard]] Indeterminates& indeterminates() { return indeterminates_; }
  [[nodiscard]] Radicals& radicals() { return radicals_; }
  [[nodiscard]] const Functions& functions() const { return functions_; }
  [[nodiscard]] const Moments& moments() const { return moments_; }
  [[nodiscard]] bool is_coordinates(SymbolId unit_vector) const {
    return as_coordinates_.contains(unit_vector);
  }
  [[nodiscard]] Signs& signs() { return signs_; }
  [[nodiscard]] bool used_moments() const { return moments_.any(); }
  [[nodiscard]] bool used_radicals() const { return radicals_.any(); }
  [[nodiscard]] bool used_functions() const { return functions_.any(); }
  [[nodiscard]] bool used_unit_vectors() const { return used_unit_vectors_; }
  [[nodiscard]] bool used_rotations() const { return used_rotations_; }

 private:
  [[nodiscard]] Sign sign_as_written(const Fraction& value) const;
  void note_sign(const Fraction& value, Sign sign);
  [[nodiscard]] Fraction unit_vector(SymbolId symbol, Frame frame, std::size_t component);
  [[nodiscard]] Fraction unit_vector_by_coordinates(SymbolId symbol, Frame frame, std::size_t component);
  [[nodiscard]] PackedPolynomial packed_coordinate(SymbolId symbol, std::uint32_t component, Frame frame);
  [[nodiscard]] Fraction packed(const PackedPolynomial& value) const;
  [[nodiscard]] Fraction rotation(SymbolId symbol, Frame frame, std::size_t component);

  const Scope* scope_;
  Budget* budget_;  // may be none
  Indeterminates indeterminates_;
  FractionArithmetic arithmetic_;
  Signs signs_;
  Radicals radicals_;
  Functions functions_;
  Moments moments_;
  std::map<std::pair<SymbolId, std::uint32_t>, GiNaC::ex> replaced_;
  std::set<SymbolId> as_coordinates_;  // unit vectors
  bool notes_signs_ = false;
  bool used_unit_vectors_ = false;
  bool used_rotations_ = false;
};

}  // namespace rigor
