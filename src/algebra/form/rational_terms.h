// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials between trees and GiNaC: indeterminates stand for what is opaque, terms have an order of our
// own.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// One term: a whole coefficient and the exponent of each indeterminate, in their order.
struct RationalTerm {
  std::vector<int> exponents;
  GiNaC::numeric coefficient;
};

/// The indeterminates of one expression, each with the part of the tree that it stands for.
class RationalAtoms {
 public:
  explicit RationalAtoms(ExprTree& tree) : tree_(tree) {}
  RationalAtoms(const RationalAtoms&) = delete;
  RationalAtoms& operator=(const RationalAtoms&) = delete;

  /// The expression as a rational function; vectors and tensors are linear in indeterminates of their own.
  /// Throws Undecidable where it is too large.
  [[nodiscard]] GiNaC::ex value_of(ExprId id);
  /// The indeterminate that an expression is, if it is one and occurs.
  [[nodiscard]] std::optional<std::size_t> position_of(ExprId id);
  [[nodiscard]] const GiNaC::ex& at(std::size_t position) const { return atoms_[position].symbol; }
  [[nodiscard]] ExprId expression_at(std::size_t position) const { return atoms_[position].id; }
  [[nodiscard]] std::size_t count() const { return atoms_.size(); }

  /// The terms of an expanded polynomial, the highest powers first, indeterminates in `order`.
  [[nodiscard]] std::vector<RationalTerm> terms_of_polynomial(const GiNaC::ex& expanded) const;
  /// Back to a tree, a positive term in front; no terms are 0.
  [[nodiscard]] ExprId expression_of(const std::vector<RationalTerm>& terms);
  [[nodiscard]] ExprId monomial(const RationalTerm& term);
  [[nodiscard]] ExprId number(const GiNaC::numeric& value);  // rational
  [[nodiscard]] ExprId make(Op op, std::vector<ExprId> children, int exponent = 0);
  [[nodiscard]] ExprId product(std::vector<ExprId> factors);
  [[nodiscard]] ExprTree& tree() { return tree_; }

  /// The positions in the order in which terms and their factors are written.
  [[nodiscard]] std::vector<std::size_t> order() const;

 private:
  struct Atom {
    GiNaC::ex symbol;
    ExprId id{};
  };
  GiNaC::ex atom(ExprId id);
  GiNaC::ex product_of(ExprId id);
  GiNaC::ex length_squared(ExprId vector);

  ExprTree& tree_;
  std::vector<Atom> atoms_;
  std::map<std::string, std::size_t> by_text_;
};

}  // namespace rigor
