// SPDX-License-Identifier: GPL-3.0-or-later
// A statement about matrices of any size, for matrices of one size: their entries are letters, and products,
// transposes, inverses, traces and determinants are written out. A statement about all sizes that fails for
// one fails.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>

#include "expr/statement/statement.h"

namespace rigor {

struct SizedQuestion {
  std::unique_ptr<ExprTree> tree;
  Question question;
  std::map<SymbolId, SymbolId> sized;  // of each matrix and column
  std::set<SymbolId> unfolded;         // definitions that were put in
  int rows = 0;
};

/// Entries are real. Definitions that reach matrices are put in. Nothing where something is no matrix of any
/// size, or is not written out: exponentials, powers above the eighth, inverses of more than three rows.
[[nodiscard]] std::optional<SizedQuestion> at_size(const Question& question, int rows);

/// What the notes say of the number of rows, in the traces and determinants of a question: a written number.
/// 0: nothing, or a letter.
[[nodiscard]] int stated_rows(const Question& question);

/// Values of matrices and columns in the sample of a sized question, as values of the letters.
[[nodiscard]] Sample unsized(Sample sample, const SizedQuestion& of);
/// The other way round.
[[nodiscard]] Sample sized(Sample sample, const SizedQuestion& of);

/// The number of rows that the sample's values have; 0: it has no matrix and no column, or several sizes.
[[nodiscard]] int rows_of_sample(const ExprTree& tree, const Sample& sample);

}  // namespace rigor
