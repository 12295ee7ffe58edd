// SPDX-License-Identifier: GPL-3.0-or-later
// Antiderivatives as trees, for what can be integrated term by term: powers, exponentials, sines and cosines
// of a linear argument with powers of the variable before them, 1/(c + s x²) and its root, logarithms, and
// what is a derivative already. Whoever asks checks the result by differentiating it, so that a slip here
// proves nothing.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// What an integral runs over, and what changes with it.
struct Running {
  SymbolId variable{};
  std::function<bool(SymbolId)> changes;                        // the variable does
  std::function<std::optional<ExprId>(ExprId)> antiderivative;  // f, of a node f'
};

/// One term of an integrand: factors without the variable, and factors with it.
struct IntegrandTerm {
  std::vector<ExprId> constant = {};
  std::vector<ExprId> running = {};
};

/// The integrand multiplied out; nothing where that is too much, or where something in it is no number.
/// Recursion: as deep as the tree.
[[nodiscard]] std::optional<std::vector<IntegrandTerm>> integrand_terms(ExprTree& tree, ExprId integrand,
                                                                        const Running& running);

/// F with F' = f, and what is known of it at the ends of an interval.
struct Primitive {
  ExprId value{};
  std::optional<ExprId> rate = {};  // F vanishes where the variable times this goes to −∞
  bool falls = false;               // F vanishes at infinity
};

/// Of the product of a term's running factors; nothing where none was found.
[[nodiscard]] std::optional<Primitive> primitive(ExprTree& tree, const IntegrandTerm& term,
                                                 const Running& running, Span span);

/// What a term divides by, as far as it is linear: where one of these vanishes, it may have no integral.
[[nodiscard]] std::vector<ExprId> linear_divisors(ExprTree& tree, const IntegrandTerm& term,
                                                  const Running& running, Span span);

/// The product of some factors; 1 of none.
[[nodiscard]] ExprId product_of(ExprTree& tree, std::vector<ExprId> factors, Span span);

}  // namespace rigor
