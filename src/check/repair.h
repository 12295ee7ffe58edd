// SPDX-License-Identifier: GPL-3.0-or-later
// What a refuted step may have been meant to say: the statements nearest to it that can be proved.
#pragma once

#include <string>
#include <vector>

#include "check/directive.h"
#include "check/report.h"
#include "elaborate/names.h"
#include "expr/tree.h"

namespace rigor {

/// What is known about the sides of a wrong step from the steps before and behind it.
enum class Trust : std::uint8_t { unknown, supported, doubted };

struct WrongStep {
  const ParsedChain& parsed;
  std::size_t which = 0;
  bool first_order = false;     // `=` means ≈
  Trust left = Trust::unknown;  // supported: the step before it is proved
  Trust right = Trust::unknown;
  std::vector<TokenView> near = {};  // sides in lines before and behind it, whose terms may be missing here
};

inline constexpr std::size_t most_repairs = 3;

/// At most three, the nearest first; none where no slip of the pen makes it true. Method: each side is
/// rewritten (latex/rewritings.h); terms are compared by the number that the difference of the sides is of
/// each; what holds on exact samples is read anew with its whole chain, and proved. Trivial statements (a =
/// a, 0 = 0) are left out. The names are as before afterwards. Cost: a few milliseconds.
[[nodiscard]] std::vector<Repair> nearest_true_statements(ExprTree& tree, Names& names,
                                                          const WrongStep& wrong);

}  // namespace rigor
