// SPDX-License-Identifier: GPL-3.0-or-later
// Point masses that are a symmetric top but for a small gap of two moments, wherever they are, with
// references for the exact doubles: for tests and benchmarks. The same on every machine.
#pragma once

#include <string>
#include <vector>

#include "numeric/run/run_decimal.h"

namespace rigor {

/// All bodies of one gap are the same, moved exactly.
struct NearlySymmetricTop {
  std::string name;
  double gap = 0;       // of two moments, over the greatest; about
  double distance = 0;  // of each coordinate of the centre from 0, about
  std::vector<double> masses;
  std::array<std::vector<double>, 3> positions;
  std::array<Decimal<50>, 3> squared_frequencies;  // for ω = 1: (I_i − I_j)(I_i − I_k)/(I_j I_k), I ascending
};

/// Of 1,024 points of size 1: gaps of 1e-2, 1e-5, 1e-8, 1e-11, 1e-13 at distances of 0, 1e4 and 1e8.
[[nodiscard]] std::vector<NearlySymmetricTop> nearly_symmetric_tops();

}  // namespace rigor
