// SPDX-License-Identifier: GPL-3.0-or-later
// Products, powers, transposes, inverses and determinants of matrices whose size is known. All are made of
// entries, so that what decides knows tuples and components only.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// The factors in their order, multiplied as matrices are, and the numbers before, between and behind them. A
/// number that may be a matrix itself is ambiguous, since its place would matter.
[[nodiscard]] MaybeTyped product_of_matrices(Reading& reading, std::vector<Typed> numbers,
                                             const std::vector<Typed>& factors, Span span);

/// (Aᵀ)_ij = A_ji; a column becomes a row.
[[nodiscard]] Typed transposed(ExprTree& tree, const Typed& typed, Span span);
/// Row by row, by minors along the first row; a diagnostic where there would be too many terms.
[[nodiscard]] MaybeTyped determinant_of_entries(Reading& reading, const std::vector<ExprId>& entries,
                                                Span span);
/// A^n, and with n < 0 the power of the adjugate over the determinant.
[[nodiscard]] MaybeTyped matrix_power(Reading& reading, const Typed& base, int exponent, Span span);

/// The entries of a square matrix row by row; none of anything else.
[[nodiscard]] std::vector<ExprId> square_entries(ExprTree& tree, const Typed& typed);
/// With this number along the diagonal.
[[nodiscard]] Typed diagonal_matrix(ExprTree& tree, const std::vector<ExprId>& diagonal, Space space,
                                    Span span);
/// What can be a multiple of the unit matrix is one beside a square matrix; all else stays as it is. Beside
/// the members of a triple each number is, also one with letters.
[[nodiscard]] Typed beside_matrix(Reading& reading, const Typed& typed, const Typed& matrix);

}  // namespace rigor
