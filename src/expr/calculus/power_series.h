// SPDX-License-Identifier: GPL-3.0-or-later
// The first terms of an expression's expansion in powers of one symbol about 0, as trees: for
// `e^x = 1 + x + O(x^2)`. All other symbols are held.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// Σ terms[k] x^(first + k), unknown from x^(first + terms.size()) on. A term that is
/// nothing is 0.
struct PowerSeries {
  int first = 0;
  std::vector<std::optional<ExprId>> terms;
  [[nodiscard]] int end() const { return first + static_cast<int>(terms.size()); }
};

/// Sums, products, quotients and integer powers multiply out; sin, cos and exp of u, and √u, follow from
/// (e^u)' = u'e^u and (√u)²= u. An expression without the symbol is its own term of order 0. A divisor may
/// vanish at 0, as in sin x/x: its first term that is not 0 divides, and so it is asked which that is.
/// Cost: quadratic in the number of terms for each node.
class PowerSeriesExpansion {
 public:
  /// Is the expression 0 for all values, or for some not? Nothing: not known.
  using IsZero = std::function<std::optional<bool>(ExprId)>;

  /// `terms`: of each series, at least 1.
  PowerSeriesExpansion(ExprTree& tree, SymbolId symbol, int terms, IsZero is_zero)
      : tree_(tree), symbol_(symbol), count_(terms), is_zero_(std::move(is_zero)) {}

  /// Nothing where there is no such expansion, as of √x, |x| and sin(1/x), or where that is not known.
  [[nodiscard]] std::optional<PowerSeries> of(ExprId id);

 private:
  using Maybe = std::optional<PowerSeries>;
  using Term = std::optional<ExprId>;

  PowerSeries constant(ExprId id) const;
  Maybe sum(ExprId id);
  Maybe bilinear(ExprId id);  // products of any kind
  Maybe linear(ExprId id);    // of one child: negate, component, index_sum
  Maybe entries(ExprId id);
  Maybe quotient(ExprId id);
  Maybe power(ExprId id);
  Maybe root(ExprId id);
  Maybe real_power(ExprId id);
  Maybe inverse_function(ExprId id);
  Maybe function(ExprId id);

  PowerSeries product(const PowerSeries& a, const PowerSeries& b, ExprId like);
  Maybe divided(const PowerSeries& above, PowerSeries below, std::uint8_t rank);
  bool strip_zeros(PowerSeries& series);  // of order below the first term that is not 0
  Maybe from_zero(Maybe series);          // without negative powers
  [[nodiscard]] bool depends(ExprId id) const;

  ExprId make(ExprNode node, std::vector<ExprId> children);
  ExprId number(int value);
  Term times(Term a, Term b, ExprNode like);
  Term scalar_times(Term a, Term b);
  Term added(std::vector<ExprId> terms, std::uint8_t rank);
  Term over(Term above, ExprId below);
  ExprId scaled(int numerator, int denominator, ExprId value);

  ExprTree& tree_;
  SymbolId symbol_;
  int count_;
  IsZero is_zero_;
  Span span_ = {};
};

}  // namespace rigor
