// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a sample as text, and back.
#pragma once

#include <optional>
#include <vector>

#include "algebra/sample/sample_point.h"

namespace rigor {

/// The values of all symbols of a point, in its order.
[[nodiscard]] std::vector<SampleValue> values_of(const SamplePoint& point, const ExprTree& tree);

/// What the sample's numbers for a symbol stand for: 0 is an angle and a logarithm, too.
[[nodiscard]] Meaning meaning_in(const Sample& sample, SymbolId symbol);

/// The numbers of a value; empty if they do not fit its symbol.
[[nodiscard]] std::optional<std::vector<Rational>> to_components(const SampleValue& value,
                                                                 const Symbol& symbol,
                                                                 const Meaning& meaning);

}  // namespace rigor
