// SPDX-License-Identifier: GPL-3.0-or-later
// A question as a value: with the part of the tree that it reaches, and nothing else. It can be asked again,
// in any order, and in another process, where the notes that it comes from are not known.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// Symbols, indices, particles and nodes are numbered in the order of their ids in the tree of the notes, and
/// derivatives behind their symbol, so that equal questions are equal wherever they stand and whatever was
/// asked before. Places, and what only the notes know of a symbol, are left behind; names are kept, since
/// reasons are worded with them.
struct ClosedQuestion {
  std::unique_ptr<ExprTree> tree;
  Question question;              // in `tree`
  std::vector<SymbolId> symbols;  // by number in `tree`: the symbol of the notes
};

/// `also`: symbols that are taken along, whether or not the question reaches them. Cost: n log n in the nodes
/// that are reached.
[[nodiscard]] ClosedQuestion closed(const Question& question, std::span<const SymbolId> also = {});

/// The symbol of the notes, as numbered in the closed question; nothing if it was not taken along.
[[nodiscard]] std::optional<SymbolId> number_of(const ClosedQuestion& question, SymbolId symbol);
/// An answer to the closed question in the symbols of the notes.
[[nodiscard]] Decision in_notes(Decision decision, const ClosedQuestion& question);
[[nodiscard]] Sample in_notes(Sample sample, const ClosedQuestion& question);
/// A sample of the notes for the closed question: without the values of symbols that it does not have.
[[nodiscard]] Sample in_question(Sample sample, const ClosedQuestion& question);

}  // namespace rigor
