// SPDX-License-Identifier: GPL-3.0-or-later
// Holes: places of the notes where `\square` stands for what is to be derived, each with what a reader knows
// there: the statement that it is in, read in every way in which ranks and indices fit, with the
// definitions and assumptions in scope, and the names that were proved to fill it.
#pragma once

#include <string>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/written_forms.h"
#include "source/diagnostic.h"

namespace rigor {

struct ParsedChain;

/// A name in scope, with a sign if it needs one, that was put into the hole and proved.
struct FittingName {
  ExprId expr{};
};

/// The hole taken for a symbol of one rank, with letters of its own.
struct HoleReading {
  Equation claim;  // left: what the hole's side is equal to; right: the side with the hole
  bool nearly = false;
  SymbolId symbol{};                     // of the hole
  ExprId node{};                         // the hole as it is in the claim
  std::vector<Question> questions = {};  // exact: one; nearly: of orders 0 and 1; their `tree` is not set
  std::vector<FittingName> names = {};   // the first that fit
  std::vector<ExprId> small = {};        // what is small where it stands
  bool takes_anything = false;           // the claim was proved for every value of the hole
};

struct WrittenHole {
  Span span;              // with its subscripts
  Span statement;         // the chain that it is in
  std::size_t chain = 0;  // its position among all chains
  std::size_t side = 0;   // of the chain
  std::size_t partner = 0;
  bool alone = false;  // nothing else is on its side
  std::string tag;
  std::string label;
  std::vector<std::string> headings;
  std::vector<HoleReading> readings;  // the likeliest first
  Diagnostics troubles;               // why there is no reading
};

/// The chain that a hole is in, and what holds there.
struct HoleChain {
  const SyntaxTree& syntax;
  ExprTree& tree;
  Names& names;
  const ParsedChain& parsed;
  bool assumed;
  bool first_order;
};

/// Adds the chain's holes. Cost: a proof or a refutation for each name in scope.
void record_holes(const HoleChain& chain, const WrittenFormChain& forms, std::size_t position,
                  std::vector<WrittenHole>& into);

}  // namespace rigor
