// SPDX-License-Identifier: GPL-3.0-or-later
// A question as a value: with the part of the tree that it reaches, and nothing else. So its answer cannot
// depend on what was asked before, it can be compared with a question of an earlier run, and another process
// can decide it without the notes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// Symbols, indices, particles and nodes are numbered in the order of their ids in the tree of the notes;
/// derivatives follow their symbol. So equal questions have equal numbers, wherever they are and whatever was
/// asked before. Places are left out, and so is what only the notes know about a symbol. Names are kept,
/// because reasons mention them.
struct ClosedQuestion {
  std::unique_ptr<ExprTree> tree;
  Question question;              // in `tree`
  std::vector<SymbolId> symbols;  // by number in `tree`: the symbol of the notes
};

/// `also`: symbols to include, whether or not the question reaches them. Cost: n log n in the nodes that are
/// reached.
[[nodiscard]] ClosedQuestion closed(const Question& question, std::span<const SymbolId> also = {});

/// The symbol of the notes, as numbered in the closed question; nothing if it is not included.
[[nodiscard]] std::optional<SymbolId> number_of(const ClosedQuestion& question, SymbolId symbol);
/// An answer to the closed question in the symbols of the notes.
[[nodiscard]] Decision in_notes(Decision decision, const ClosedQuestion& question);
[[nodiscard]] Sample in_notes(Sample sample, const ClosedQuestion& question);
/// A sample of the notes for the closed question: without the values of symbols that it does not have.
[[nodiscard]] Sample in_question(Sample sample, const ClosedQuestion& question);

}  // namespace rigor
