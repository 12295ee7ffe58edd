// SPDX-License-Identifier: GPL-3.0-or-later
// The real and the imaginary part of an expression, as expressions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// re + i·im; one of them may be missing, and then is 0. Never both, so that what has no value somewhere
/// keeps having none there.
struct ComplexParts {
  std::optional<ExprId> re;
  std::optional<ExprId> im;
};

/// Complex symbols already have the axis of parts. Throws Undecidable where roots are taken of what may not
/// be real, and where a function of complex numbers is not known. Each node is taken apart once; recursion:
/// as deep as the tree. A product of n complex factors has up to n² terms, since it is halved again and
/// again.
class PartsReader {
 public:
  PartsReader(ExprTree& tree, const std::vector<bool>& in_parts) : tree_(tree), in_parts_(in_parts) {}

  [[nodiscard]] ComplexParts of(ExprId id);
  /// Both, with a written 0 for the one that is missing, along the axis of parts.
  [[nodiscard]] ExprId pair(const ComplexParts& parts);
  /// |a − b|², which is 0 only where both parts are equal; rank 0.
  [[nodiscard]] ExprId distance_squared(const ComplexParts& a, const ComplexParts& b);

 private:
  using Maybe = std::optional<ExprId>;

  ComplexParts compute(ExprId id);
  ComplexParts of_symbol(ExprId id);
  ComplexParts of_sum(ExprId id);
  ComplexParts of_product(ExprId id);
  ComplexParts of_dot(ExprId id);
  ComplexParts of_power(ExprId id);
  ComplexParts of_determinant(ExprId id);
  ComplexParts of_function(ExprId id);
  ComplexParts of_modulus(ExprId id);
  ExprId modulus(ExprId id);
  ComplexParts of_entries(ExprId id);

  ComplexParts sum(const ComplexParts& a, const ComplexParts& b);
  ComplexParts times(Op op, const ComplexParts& a, const ComplexParts& b);
  ComplexParts product(std::span<const ComplexParts> factors);
  ComplexParts power(const ComplexParts& base, int exponent);
  ComplexParts quotient(const ComplexParts& a, const ComplexParts& b);
  [[nodiscard]] ComplexParts turned(const ComplexParts& a);  // i·a
  ComplexParts conjugate(const ComplexParts& a) { return {a.re, negated(a.im)}; }
  [[nodiscard]] bool are_conjugates(const ComplexParts& a, const ComplexParts& b) const;
  ExprId norm(const ComplexParts& a);  // a*a, of a vector a*·a

  Maybe added(Maybe a, Maybe b);
  Maybe negated(Maybe a);
  Maybe joined(Op op, Maybe a, Maybe b);
  ExprId make(Op op, std::vector<ExprId> children, std::int32_t exponent = 0);
  ExprId applied(Function function, ExprId to);
  ExprId hyperbolic(ExprId x, bool odd);  // sinh or cosh
  ExprId number(const char* digits) { return tree_.add_number(span_, digits); }
  ExprId copied(ExprId like, std::vector<ExprId> children);
  [[nodiscard]] std::vector<ExprId> children(ExprId id) const {
    return {tree_.children(id).begin(), tree_.children(id).end()};
  }

  ExprTree& tree_;
  const std::vector<bool>& in_parts_;  // by symbol
  std::unordered_map<std::uint32_t, ComplexParts> known_;
  Span span_ = {};
};

}  // namespace rigor
