// SPDX-License-Identifier: GPL-3.0-or-later
// What a wrong step may have been meant to say: the statements nearest to it that can be proved.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algebra/engine/limits.h"
#include "check/repair/repair_candidates.h"
#include "check/step/report.h"
#include "check/verdict/judge.h"
#include "elaborate/name/names.h"
#include "expr/tree/tree.h"

namespace rigor {

class DecisionCache;

inline constexpr std::size_t most_repairs = 3;

/// For a guess at what was meant beside the step.
inline constexpr Limits limits_of_guesses{.expanded_terms = 3'000,
                                          .steps = 20'000,
                                          .quick_points = 2,
                                          .quick_steps = 4'000,
                                          .sample_attempts = 12,
                                          .fewest_assumptions = false,
                                          .only_proofs = true};

/// For the proof of a neighbour; that of a typical step takes a hundredth of this.
inline constexpr Limits limits_of_candidates{.expanded_terms = 10'000,
                                             .steps = 60'000,
                                             .quick_points = 2,
                                             .quick_steps = 4'000,
                                             .sample_attempts = 12,
                                             .fewest_assumptions = false,
                                             .only_proofs = true};

/// Is a claim that takes this slip back true? Then what that rests on. The tree and the names are copies that
/// have grown by what was read, so what was read before is in them as well.
using NeighbourProof =
    std::function<std::optional<std::vector<std::string>>(ExprTree&, const Names&, const Claim&, Slip)>;

/// What is asked on samples in place of a neighbour: of `x = …` beside an equation of motion, that equation
/// with the side put in. Nothing: the neighbour is none.
using Asked = std::function<std::optional<Equation>(ExprTree&, const Names&, const Equation&)>;

/// What is done with neighbours that samples do not compare, such as integrals that the wrong row has not:
/// each is proved or not, which takes a thousand times as long. A row that is known to be wrong is worth it.
/// `few`: of a row that is left open, the nearest of these are asked; before that, letters of other rows are
/// tried on samples. `all_asked`: of a row that is rounded, which no sample compares, the nearest of all.
enum class NotCompared : std::uint8_t { left_out, few, asked, all_asked };

/// A true statement within one slip of the wrong one.
struct TrueNeighbour {
  Repair repair;
  Slip slip = Slip::sign;         // that it takes back
  std::vector<std::string> uses;  // as the proof said
};

/// At most three, the nearest first; none where no slip of the pen makes it true. Of a refuted step, of one
/// whose indices or ranks do not fit, or of one that is not proved. Method: each side is rewritten; terms are
/// compared by the number that the difference of the sides is of each (`left − right = c · term`); what holds
/// on exact samples is read anew with its whole chain, and proved. The samples meet what `names` assumes, so
/// laws are assumed there if the proof is to use them. Trivial statements (a = a, 0 = 0, v − v = 0) are left
/// out. It works on copies. Cost: a few milliseconds for a typical step (tests/bench/repair_bench.cpp); sides
/// of more than 400 tokens are not mended.
[[nodiscard]] std::vector<TrueNeighbour> true_neighbours(const ExprTree& tree, const Names& names,
                                                         const WrongStep& wrong, const NeighbourProof& proof,
                                                         DecisionCache* cache = nullptr,
                                                         const Asked& asked = {},
                                                         NotCompared others = NotCompared::left_out);

/// Those that are judged to be proved, without a warning.
[[nodiscard]] std::vector<Repair> nearest_true_statements(const ExprTree& tree, const Names& names,
                                                          const WrongStep& wrong,
                                                          DecisionCache* cache = nullptr);

/// Of a row that cannot be read: what it may speak of, as its nearest neighbour says that can be read. The
/// tree and the names grow by what is read. Without its reading, which is gone.
[[nodiscard]] std::optional<Claim> nearest_claim(ExprTree& tree, Names& names, const WrongStep& wrong);

/// Each with what it rests on.
[[nodiscard]] std::vector<Repair> repairs_of(std::vector<TrueNeighbour> neighbours);

/// Without blanks, braces and sizes of brackets: to find a statement again that stands on the page.
[[nodiscard]] std::string bare_formula(std::string latex);

/// `+ 3Ek_0`: nobody forgets a term with such a number.
[[nodiscard]] bool adds_an_unusual_term(const Repair& repair);

}  // namespace rigor
