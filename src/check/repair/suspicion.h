// SPDX-License-Identifier: GPL-3.0-or-later
// Is a row that does not follow one slip of the pen away from something that does? Few rows are so by chance:
// what stands near a law and follows from the page relates the same letters as the law, and both together
// leave them hardly any values. What is near by its form alone is left out: a side that becomes 0 or equal to
// the other, what a law or a definition says already, and another quantity that merely looks alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/law/page_law.h"
#include "check/repair/repair.h"

namespace rigor {

struct Suspicion {
  Repair repair;
  std::vector<std::string> uses;  // what the repaired statement follows from; of an identity, conventions
  Slip slip = Slip::sign;         // that it takes back
};

/// A row that does not follow, and what it may have been meant to follow from.
struct OpenRow {
  const WrongStep& wrong;
  const Claim& claim;
  const Laws& available = {};     // in the order of the notes
  const Laws& to_be_solved = {};  // differential equations and their conditions
  bool announced = false;         // as a conclusion: then it may lack a term
  bool restricted = false;        // words may limit it to a case: only an identity near it counts
  bool of_a_case = false;         // beside laws only slips count that exclude the row
  bool unread = false;            // the claim is that of a neighbour
};

/// No pair of true rows differs in it, unless something vanishes, is 1 or equals another thing, and nobody
/// writes such a row then: words that limit it to a case explain nothing.
[[nodiscard]] bool excludes_the_other(Slip slip);
/// `p = -\sqrt{2mE}` of `p^2 = 2mE`: both roots can be meant.
[[nodiscard]] bool chooses_a_root(Slip slip, const std::vector<std::string>& uses);

/// The nearest statement that is an identity or follows from definitions and from what is given; else one
/// that follows from laws, of the smallest set that is enough. Nothing for orders and `≈`. It works on
/// copies. At most eight sets of laws are tried, with as many neighbours as a repair looks at, for a share of
/// the work that a step may take.
[[nodiscard]] std::optional<Suspicion> suspicion(const ExprTree& tree, const Names& names, const OpenRow& row,
                                                 DecisionCache& cache);

/// What stands one slip of the pen away from a row that is left open, and holds as `follows` asks the row:
/// another quantity may be meant, so this says nothing against the row. At most three, the nearest first.
/// `row.available` are the laws that samples of neighbours meet. Orders and `≈` are searched as well.
[[nodiscard]] std::vector<TrueNeighbour> statements_near(const ExprTree& tree, const Names& names,
                                                         const OpenRow& row, const NeighbourProof& follows,
                                                         DecisionCache& cache);

}  // namespace rigor
