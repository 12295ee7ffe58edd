// SPDX-License-Identifier: GPL-3.0-or-later
// F with F(k + 1) − F(k) = f(k), the discrete twin of an antiderivative, for f = k^m g(k), where g is a
// product of powers r^{αk+β} and exponentials. Whoever asks checks the result by its difference, so that a
// slip here proves nothing.
#pragma once

#include <optional>
#include <vector>

#include "expr/calculus/integrate.h"
#include "expr/tree/tree.h"

namespace rigor {

/// One term of a summand: factors without the variable, a power of it, and the rest.
struct SummandTerm {
  std::vector<ExprId> constant = {};
  int power = 0;                       // of the variable
  std::vector<ExprId> geometric = {};  // factors g with g(k + 1) = r g(k)…
  std::vector<ExprId> ratios = {};     // …and r of each
  std::vector<ExprId> others = {};     // of which nothing is known
};

/// The summand multiplied out; nothing where that is too much, or where something in it is no number.
[[nodiscard]] std::optional<std::vector<SummandTerm>> summand_terms(ExprTree& tree, ExprId summand,
                                                                    const Running& running, Span span);

/// F of a term, without its constant factors; nothing where it has `others`.
[[nodiscard]] std::optional<ExprId> antidifference(ExprTree& tree, const SummandTerm& term,
                                                   const Running& running, Span span);

}  // namespace rigor
