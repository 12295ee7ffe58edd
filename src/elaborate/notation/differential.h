// SPDX-License-Identifier: GPL-3.0-or-later
// Differentials by themselves: `dU = T\,dS - p\,dV`, `\delta Q = T\,dS`.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// Is it a row that relates differentials? A section in which `d` is also a letter has none.
[[nodiscard]] bool reads_differentials(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides,
                                       const Names& names);
/// The derivative along any path of states; a diagnostic where the row does not relate differentials.
[[nodiscard]] MaybeTyped differential_of(Reading& reading, SyntaxId operand, Span span, const Around& around);
/// `\delta Q`: a symbol of its own, of which nothing says that it is the differential of a quantity.
[[nodiscard]] MaybeTyped form_named(Reading& reading, SyntaxId letter, Span span, const Around& around);

}  // namespace rigor
