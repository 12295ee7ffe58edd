// SPDX-License-Identifier: GPL-3.0-or-later
// An expression as a sum of monomials in index notation: rational coefficient × factors under sums over
// components and particles. Components of symbols, δ, ε and what is opaque (roots, quotients by a sum,
// functions, tables) are factors. Summed letters are variables of their own: no two sums share one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/small_rational.h"
#include "expr/tree/tree.h"

namespace rigor {

struct IndexPolynomial;

struct IndexFactor {
  enum class Kind : std::uint8_t {
    delta,
    epsilon,
    component,  // of a symbol, at all its slots; also of a scalar, without any
    root,       // the non-negative square root of `argument`
    sum,        // `argument` itself, to a negative exponent
    function,
    table,  // at its slots; `table` is the node
  };
  Kind kind = Kind::component;
  SymbolId symbol{};
  ParticleId particle = no_particle;
  std::vector<Slot> slots = {};
  int exponent = 1;  // of δ and ε always 1
  Function function{};
  ExprId table{};
  std::shared_ptr<const IndexPolynomial> argument = nullptr;
};

struct IndexMonomial {
  SmallRational coefficient = 1;
  std::vector<IndexId> indices = {};       // summed over 1..3
  std::vector<ParticleId> particles = {};  // summed over
  std::vector<IndexFactor> factors = {};   // in the order in which they were written
};

struct IndexPolynomial {
  std::vector<IndexMonomial> terms = {};
};

/// What may be multiplied out.
inline constexpr std::size_t most_monomials = 400;
inline constexpr std::size_t most_factors = 40;

/// The component of an expression at as many slots as it has rank, multiplied out; direct notation is written
/// in components. Nothing where it is too large, or where a number does not fit.
[[nodiscard]] std::optional<IndexPolynomial> polynomial_of(ExprTree& tree, ExprId id,
                                                           std::span<const Slot> slots = {});

/// Back to an expression of rank 0: coefficients first, common factors of what is under one particle sum in
/// front of it. Letters are the variables' own (`with_letters` in derive/notation/letter_choice.h chooses
/// better ones).
[[nodiscard]] ExprId expression_of(ExprTree& tree, const IndexPolynomial& polynomial);

/// The product. Nothing where it is too large.
[[nodiscard]] std::optional<IndexPolynomial> product_of(const IndexPolynomial& a, const IndexPolynomial& b);

/// The same with new variables for its sums.
[[nodiscard]] IndexMonomial with_new_sums(ExprTree& tree, const IndexMonomial& monomial);

/// The slots of all factors and of what is opaque; and where a variable is replaced by a slot.
void replace_index(IndexMonomial& monomial, IndexId variable, const Slot& by);
void replace_particle(IndexMonomial& monomial, ParticleId variable, ParticleId by);
[[nodiscard]] std::size_t occurrences(const IndexMonomial& monomial, IndexId variable);
[[nodiscard]] bool speaks_of(const IndexFactor& factor, IndexId variable);
[[nodiscard]] bool speaks_of(const IndexFactor& factor, ParticleId variable);

}  // namespace rigor
