// SPDX-License-Identifier: GPL-3.0-or-later
// A sample of the exact side as columns of doubles, each nearest to the exact value: off by at most u
// relative, u = 2^-53, but below 2^-1022.
#pragma once

#include <optional>
#include <string_view>

#include "expr/statement/statement.h"
#include "expr/tree/tree.h"
#include "numeric/program/samples.h"

namespace rigor {

/// `-3/2` as the nearest double, infinite where it is beyond all of them; nothing if the text is no rational
/// number.
[[nodiscard]] std::optional<double> nearest_double(std::string_view rational);

/// Sets the values of a sample, the same for all samples; `samples` has as many particles.
void put_sample(const ExprTree& tree, const Sample& sample, Samples& samples);

/// One sample with the particles of the exact one. A symbol that belongs to particles has a value for each of
/// them, or 0.
[[nodiscard]] Samples samples_of(const ExprTree& tree, const Sample& sample);

}  // namespace rigor
