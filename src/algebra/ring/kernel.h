// SPDX-License-Identifier: GPL-3.0-or-later
// Three equations that say M n = 0 for a unit vector n imply det M = 0, because n is not zero.
#pragma once

#include <ginac/ex.h>

#include <array>
#include <span>
#include <vector>

namespace rigor {

struct KernelDeterminant {
  std::array<std::size_t, 3> rows{};  // positions of the equations
  GiNaC::ex value;                    // not 0 as a polynomial
};

/// The determinants of every three among a few equations (expanded polynomials) that are linear and
/// homogeneous in a vector's components.
[[nodiscard]] std::vector<KernelDeterminant> kernel_determinants(std::span<const GiNaC::ex> equations,
                                                                 const std::array<GiNaC::ex, 3>& vector);

}  // namespace rigor
