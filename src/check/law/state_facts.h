// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says of quantities of state, and which letters are such.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "check/law/from_set.h"
#include "check/law/surface.h"

namespace rigor {

struct StateFact {
  Equation equation;
  std::string name;
  bool of_a_case = false;  // "an ideal gas obeys"
};

struct StateFacts {
  std::vector<StateFact> facts;
  std::set<SymbolId> letters;  // of the claim and of all facts, without derivatives
  std::set<SymbolId> states;   // of these, what the section differentiates, or defines by such
};

[[nodiscard]] bool has_differentials(const ExprTree& tree, const Equation& equation);
/// What is varied and what is held, in either order, each pair once.
[[nodiscard]] std::vector<Coordinates> coordinates_in(const ExprTree& tree, const Equation& equation);

/// The laws of the set, and the definitions that the claim and they lead to. Nothing where the claim has
/// anything but plain numbers, differentials and derivatives that hold a letter by name; facts that have are
/// left out.
[[nodiscard]] std::optional<StateFacts> state_facts(const RowUnderLaws& row, const Laws& set);
/// The letters of the facts alone.
[[nodiscard]] std::set<SymbolId> letters_of_facts(const RowUnderLaws& row, const StateFacts& facts);
/// Some of the facts.
[[nodiscard]] StateFacts only(const RowUnderLaws& row, const StateFacts& facts,
                              const std::set<std::size_t>& which);

}  // namespace rigor
