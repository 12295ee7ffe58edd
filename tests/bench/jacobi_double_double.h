// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "numeric/body/body.h"

namespace rigor {

/// Jacobi's rotations on QD's double-double numbers: the peer that has the digits, rounded at the end.
/// Ascending, with I₂ − I₁, I₃ − I₂, I₃ − I₁ and the axes in that order.
void jacobi_double_double(const InertiaTensor& tensor, Position& moments, Position& gaps,
                          std::array<Position, 3>& axes);

}  // namespace rigor
