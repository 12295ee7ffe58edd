// SPDX-License-Identifier: GPL-3.0-or-later
// All that the exact side sees of a question, as text: the same for the same question, wherever it stands in
// whichever notes.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// Symbols, indices, particles and nodes are numbered in the order of their ids among those that the question
/// reaches; no id and no place is in the text. Names are, since reasons are worded with them.
struct QuestionText {
  std::string text;
  std::vector<SymbolId> symbols;                // by number
  std::map<SymbolId, std::uint64_t> number_of;  // the other way round
};

/// `also`: symbols that are numbered, too, whether or not the question reaches them. Two questions with one
/// text get one answer from `decide`, up to the numbering. Cost: n log n in the nodes that are reached.
[[nodiscard]] QuestionText question_text(const Question& question, std::span<const SymbolId> also = {});

}  // namespace rigor
