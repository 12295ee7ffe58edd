// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that are made of matrices of any size: xᵀAy, traces and determinants, as parts that commute. Equal
// ones become one part: xᵀAy = yᵀAᵀx, tr ABC = tr CAB = tr (ABC)ᵀ, det AB = det A det B.
#pragma once

#include <optional>
#include <set>

#include "algebra/words/word_sum.h"

namespace rigor {

/// A row before a column, with matrices between, is taken out of each word.
[[nodiscard]] WordSum with_numbers_out(const WordSum& sum, CommutingParts& parts);

/// `rows`: how many it has, if that is known; the trace of 1 is that. Throws Undecidable where a word is no
/// square matrix.
[[nodiscard]] Coefficient trace_of(const WordSum& sum, std::optional<ExprId> rows, CommutingParts& parts);

/// The product of those of its factors, where each is one of `square`. What is no product is one part, with
/// what stands on both sides of all its words as X⁻¹…X taken away. det cA = cⁿ det A where n is known. Throws
/// Undecidable where a factor may not be square.
[[nodiscard]] Coefficient determinant_of(const WordSum& sum, const std::set<SymbolId>& square,
                                         std::optional<ExprId> rows, CommutingParts& parts);

}  // namespace rigor
