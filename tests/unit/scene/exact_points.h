// SPDX-License-Identifier: GPL-3.0-or-later
// Point masses with their inertia in 200 digits, for tests of what scenes print.
#pragma once

#include <vector>

#include "numeric/body/body.h"
#include "numeric/run/run_decimal.h"

namespace rigor {

using Digits200 = Decimal<200>;
using DigitsTensor = std::array<std::array<Digits200, 3>, 3>;

struct ExactPoints {
  std::vector<double> masses;
  std::vector<Position> places;

  void add(double mass, const Position& at) {
    masses.push_back(mass);
    places.push_back(at);
  }
  [[nodiscard]] Body body() const { return *point_masses("points", masses, places); }

  /// About their centre of mass.
  [[nodiscard]] DigitsTensor inertia() const {
    Digits200 mass = 0;
    std::array<Digits200, 3> centre{};
    for (std::size_t k = 0; k < masses.size(); ++k) {
      mass += masses[k];
      for (std::size_t i = 0; i < 3; ++i) centre[i] += Digits200(masses[k]) * places[k][i];
    }
    DigitsTensor inertia{};
    for (std::size_t k = 0; k < masses.size(); ++k) {
      std::array<Digits200, 3> r;
      for (std::size_t i = 0; i < 3; ++i) r[i] = places[k][i] - centre[i] / mass;
      const Digits200 square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          inertia[i][j] += masses[k] * ((i == j ? square : 0) - r[i] * r[j]);
    }
    return inertia;
  }
};

/// How much of a bound an error takes; 190 of 200 digits of the exact number are known.
inline double part_of(const Digits200& error, double bound) {
  return static_cast<double>(Digits200(abs(error) / (bound + Digits200("1e-190"))));
}

}  // namespace rigor
