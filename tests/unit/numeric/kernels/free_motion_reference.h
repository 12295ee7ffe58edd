// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of a free rigid body to 50 digits or more, by another algorithm than the kernel's: Taylor series
// of Euler's equations and of q' = ½ q ω, in 70 digits, from step to step. Many periods are taken off first,
// with the period from the textbook's modulus in 70 digits.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "numeric/body/body.h"

namespace rigor {

using Digits70 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>, boost::multiprecision::et_off>;

/// Body components of ω, and the turn from the body's axes to those at the time 0.
struct ReferenceMotion {
  std::array<Digits70, 3> spin;
  std::array<Digits70, 4> turn;
};

inline ReferenceMotion at_rest_of(const Position& spin) {
  return {{spin[0], spin[1], spin[2]}, {1, 0, 0, 0}};
}

/// The greatest of √|gᵢgⱼ| |ωₖ|, dωᵢ/dt = gᵢ ωⱼ ωₖ.
inline Digits70 rate_of(const std::array<Digits70, 3>& factor, const std::array<Digits70, 3>& spin) {
  Digits70 rate = 0;
  for (std::size_t k = 0; k < 3; ++k)
    rate = std::max<Digits70>(rate, sqrt(abs(factor[(k + 1) % 3] * factor[(k + 2) % 3])) * abs(spin[k]));
  return rate;
}

/// After `time` more. Each step's remainder is below e^-160 of the largest component and, since a step is at
/// most 1/4 over the rate, about 4^-60 of every other; the separatrix costs a digit per 2.3 e-foldings.
inline ReferenceMotion moved(const Position& moments, ReferenceMotion state, Digits70 time,
                             bool turns = false) {
  constexpr std::size_t order = 60;
  const std::array<Digits70, 3> moment{moments[0], moments[1], moments[2]};
  std::array<Digits70, 3> factor;
  for (std::size_t i = 0; i < 3; ++i) factor[i] = (moment[(i + 1) % 3] - moment[(i + 2) % 3]) / moment[i];
  const std::size_t parts = turns ? 7 : 3;
  while (time != 0) {
    std::array<std::vector<Digits70>, 7> c;
    for (std::size_t i = 0; i < parts; ++i) c[i] = {i < 3 ? state.spin[i] : state.turn[i - 3]};
    const auto coefficient = [&](std::size_t a, std::size_t b, std::size_t n) {
      Digits70 sum = 0;
      for (std::size_t m = 0; m <= n; ++m) sum += c[a][m] * c[b][n - m];
      return sum;
    };
    for (std::size_t n = 0; n < order; ++n) {
      const Digits70 next = n + 1;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3;
        const std::size_t b = (i + 2) % 3;
        c[i].push_back(factor[i] * coefficient(a, b, n) / next);
      }
      if (!turns) continue;
      c[3].push_back(-(coefficient(4, 0, n) + coefficient(5, 1, n) + coefficient(6, 2, n)) / (2 * next));
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3;
        const std::size_t b = (i + 2) % 3;
        c[4 + i].push_back((coefficient(3, i, n) + coefficient(4 + a, b, n) - coefficient(4 + b, a, n)) /
                           (2 * next));
      }
    }
    Digits70 last = 0;
    Digits70 first = 0;
    for (std::size_t i = 0; i < parts; ++i) {
      last = std::max<Digits70>(last, std::max<Digits70>(abs(c[i][order]), abs(c[i][order - 1])));
      first = std::max<Digits70>(first, abs(c[i][0]));
    }
    Digits70 step = abs(time);
    if (last != 0) step = std::min<Digits70>(step, exp((log(first / last) - 160) / Digits70(order)));
    const Digits70 rate = rate_of(factor, state.spin);
    if (step * rate > 0.25) step = 1 / (4 * rate);
    if (time < 0) step = -step;
    for (std::size_t i = 0; i < parts; ++i) {
      Digits70 sum = c[i][order];
      for (std::size_t n = order; n-- > 0;) sum = sum * step + c[i][n];
      (i < 3 ? state.spin[i] : state.turn[i - 3]) = sum;
    }
    time -= step;
  }
  return state;
}

/// 4 K / λ from k² of the textbook.
inline Digits70 period_of(const Position& moments, const Position& spin) {
  Position order = moments;
  std::array<std::size_t, 3> at{0, 1, 2};
  std::sort(at.begin(), at.end(), [&](std::size_t a, std::size_t b) { return order[a] < order[b]; });
  std::array<Digits70, 3> i;
  std::array<Digits70, 3> w;
  for (std::size_t k = 0; k < 3; ++k) {
    i[k] = moments[at[k]];
    w[k] = spin[at[k]];
  }
  Digits70 energy = 0;  // twice
  Digits70 momentum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    energy += i[k] * w[k] * w[k];
    momentum += i[k] * i[k] * w[k] * w[k];
  }
  if (momentum < energy * i[1]) std::swap(i[0], i[2]);
  const Digits70 rate = sqrt((i[2] - i[1]) * (momentum - energy * i[0]) / (i[0] * i[1] * i[2]));
  const Digits70 square =
      (i[1] - i[0]) * (energy * i[2] - momentum) / ((i[2] - i[1]) * (momentum - energy * i[0]));
  Digits70 a = 1;
  Digits70 b = sqrt(1 - square);
  while (abs(a - b) > Digits70(1e-50)) {
    const Digits70 mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return 4 * boost::math::constants::half_pi<Digits70>() / ((a + b) / 2) / rate;
}

}  // namespace rigor
