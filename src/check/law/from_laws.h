// SPDX-License-Identifier: GPL-3.0-or-later
// Does a row follow from what the page states? `m\ddot x = -kx` is a law: it is meant for some values only,
// and nothing on the page proves it. With `\omega^2 = k/m`, the row `\ddot x + \omega^2x = 0` follows from
// it.
//
// A wrong law proves wrong results, and two special cases together prove anything: `m\ddot x = -kx` and
// `m\ddot x = kx` leave only x = 0, for which `m\ddot x = 7kx` holds, too. So a set of laws proves a row only
// if some sample meets the set on which no letter, no term and no side of the row or of these laws is 0,
// unless a 0 is written. On such a sample the row is false with any sign turned or any factor put to a term,
// so none of these twins follows from the set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/verdict/judge.h"

namespace rigor {

/// A relation that the page states, or that follows from such.
struct PageLaw {
  Equation equation;
  std::string name;  // as a verdict names it: `law (3)`, `law in line 12`, `result in line 14`
  Span span = {};
  std::size_t place = 0;      // its section, as `Sections` counts them
  std::size_t paragraph = 0;  // and its paragraph
  bool at_instant = false;    // it may hold at one moment or place only: it says nothing of rates
  bool of_a_case = false;     // behind "for critical damping": it holds in its paragraph only
};

struct FromLaws {
  Judgement judgement;                // proved, or a law that is restated; `uses` names the laws
  const PageLaw* restated = nullptr;  // the row says the same as this law, up to its sides and a number
};

/// The smallest set of laws that was found to prove the claim; nothing if none was found. `available`: in the
/// order of the notes. What nothing on the page differentiates is taken as constant, which `uses` says. A few
/// sets of laws are tried: those that share letters with the claim, bring in few others and stand near it
/// come first. That takes at most a share of the work that the step may take.
[[nodiscard]] std::optional<FromLaws> follow_from_laws(ExprTree& tree, const Names& names, const Claim& claim,
                                                       const std::vector<const PageLaw*>& available,
                                                       DecisionCache& cache);

}  // namespace rigor
