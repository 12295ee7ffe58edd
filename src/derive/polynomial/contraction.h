// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of index calculus, each an operation of its own on a sum of monomials.
#pragma once

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// ε_ijk ε_lmn as the determinant of nine δ, for one pair in each monomial, those with most summed letters in
/// common first: with one in common δ_jl δ_km − δ_jm δ_kl. False where there is no pair, or no room.
bool contract_epsilons(IndexPolynomial& polynomial);

/// δ_ij x_j → x_i, δ_ii → 3; δ and ε with numbers for axes are numbers; ε with two equal slots is 0. False
/// where nothing changed.
bool contract_deltas(IndexPolynomial& polynomial);

/// Each sum over components written out as three terms. False where nothing changed or where it is too large.
bool write_out_sums(IndexPolynomial& polynomial);

/// λ_ij λ_kj → δ_ik of a rotation, and n_i n_i → 1 of a unit vector. False where nothing changed.
bool contract_rotations(const SymbolTable& symbols, IndexPolynomial& polynomial);
bool contract_unit_vectors(const SymbolTable& symbols, IndexPolynomial& polynomial);

/// cos² → 1 − sin². False where nothing changed.
bool replace_cosines(IndexPolynomial& polynomial);

}  // namespace rigor
