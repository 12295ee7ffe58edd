// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of a rigid body without torque in closed form: its spin at any time.
//
//   I₁ dω₁/dt = (I₂ − I₃) ω₂ ω₃ and cyclic; I, ω along the body's principal axes, in kg m² and rad/s.
//
// Moments in any order, positive and within 2^200 of each other; bodies that break the triangle inequality
// move, too. Method: ω is Jacobi's cn, sn, dn of a phase linear in the time. The squares of the modulus and
// of its complement are formed from the differences of the moments and from L² − 2T I₂ = I₃ (I₃ − I₂) ω₃² −
// I₁ (I₂ − I₁) ω₁², in two parts, and exactly where its terms cancel: 0 is the separatrix and nothing else
// is. The functions are quotients of theta functions in the nome or, for k' < 1/2, in the complementary nome
// (≤ 0.09 each: four terms); phase, rate and period have two parts each. Sources: C. G. J. Jacobi, J. reine
// angew. Math. 39 (1850) 293; R. van Zon, J. Schofield, J. Comput. Phys. 225 (2007) 145; T. Fukushima, SIAM
// J. Sci. Comput. 35 (2013) A1 (phase from tan φ).
//
// Cost on a machine with AVX-512: 0.3 us for set-up and one time, 1.3 us where k' < 1/2; 28 to 42 ns a time
// after that, 5 to 8 ns each of many (tests/bench/torque_free_cases.cpp).
// Error, for the doubles as given: 16 u of every component on its own, and what that component changes in δt
// = 2^-62 of a period and 2^-93 of the time: no more than that next to its zeros, where it is small itself,
// and after very many periods. 7 u measured elsewhere. At every time within 2^47 turns, forwards and
// backwards, on the separatrix and next to it (torque_free_test.cpp, 50 digits). The same bits on every
// machine.
#pragma once

#include <span>

#include "base/result.h"
#include "numeric/kernels/position.h"
#include "numeric/lane/free_bodies.h"

namespace rigor {

/// dω/dt of the equations above, as they are written. Error: 4 u (I_j + I_k)/I_i |ω_j ω_k|.
[[nodiscard]] Position free_spin_rates(const Position& moments, const Position& spin);

class TorqueFree {
 public:
  /// `spin`: at the time 0. An error for what is not finite, for moments that are not positive or too unlike,
  /// where the spin would leave the range of doubles, and where its other components are both below 2^-800 of
  /// the one along the middle axis, from which it is e-foldings away that no double holds. A zero moment is
  /// refused, since nothing then determines the spin about its axis.
  [[nodiscard]] static Result<TorqueFree> make(const Position& moments, const Position& spin);

  /// `time` in s, of any sign. Not a number if it is not, and beyond 2^47 turns.
  [[nodiscard]] Position spin(double time) const;

  /// The same bits for each of many times; as many spins as times.
  void spins(std::span<const double> times, std::span<Position> into) const;

  [[nodiscard]] const FreeSpin& constants() const { return spin_; }

 private:
  FreeSpin spin_;
};

}  // namespace rigor
