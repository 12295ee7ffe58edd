// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over any number of particles. Method: inside Σ_α the body is expanded; what depends on α's own
// quantities in each term (its *key*) becomes one indeterminate, a moment, and the rest moves out:
// Σ_α m_α r_αi r_αj = M[m r_i r_j]. The key 1 gives the number of particles.
//
// Complete for polynomial bodies: moments M_k = Σ_α f_k(x_α) of distinct monomials f_k ≠ 1 are algebraically
// independent once there are enough particles. Else their Jacobian would not have full rank, some
// Σ_k c_k ∇f_k would vanish everywhere, and Σ_k c_k f_k would be constant. So a polynomial in moments that is
// zero for every body, for every number of particles, is the zero polynomial. Only sound for bodies that are
// rational in the particle's own quantities: their keys (denominator, monomial) may be linearly dependent.
// The cost knows no number of particles.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "algebra/ring/radicals.h"

namespace rigor {

class Moments {
 public:
  Moments(Indeterminates& indeterminates, FractionArithmetic& arithmetic, Radicals& radicals, Signs& signs,
          Frame outermost)
      : indeterminates_(indeterminates),
        arithmetic_(arithmetic),
        radicals_(radicals),
        signs_(signs),
        outermost_(outermost) {}

  /// Opens a sum over particles: its frame, until `close`.
  [[nodiscard]] Frame open();
  void close() { --depth_; }
  /// For a while no sum is open, until `return_to`.
  [[nodiscard]] std::uint32_t leave_sums() { return std::exchange(depth_, 0); }
  void return_to(std::uint32_t depth) { depth_ = depth; }
  /// The sum of a body over all particles of the innermost open sum.
  [[nodiscard]] Fraction sum(Fraction body);

  [[nodiscard]] bool any() const { return !moments_.empty(); }
  /// What is summed over all particles in each, a monomial of the outermost sum's frame over a polynomial.
  [[nodiscard]] const std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less>& by_key() const { return moments_; }

 private:
  using Monomial = std::vector<std::pair<std::size_t, int>>;  // letters and exponents
  using Terms = std::map<Monomial, PackedPolynomial::Terms>;  // by what is the particle's own
  [[nodiscard]] Frame innermost() const { return outermost_ + depth_ - 1; }
  [[nodiscard]] Terms by_own_part(const PackedPolynomial& body) const;
  [[nodiscard]] GiNaC::ex moment(const GiNaC::ex& key);
  /// The part of the divisors that is the particle's own, taken out of `body`; common factors of it and the
  /// numerator cancel.
  [[nodiscard]] GiNaC::ex take_own_divisor(Fraction& body) const;

  Indeterminates& indeterminates_;
  FractionArithmetic& arithmetic_;
  Radicals& radicals_;
  Signs& signs_;
  Frame outermost_;
  std::uint32_t depth_ = 0;
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> moments_;  // by key in the outermost frame
};

}  // namespace rigor
