// SPDX-License-Identifier: GPL-3.0-or-later
// Which form of a chain to compute where. A form is safe in a range if it loses nowhere there on the best
// form; that is what attacks on it try to refute. Ranges are proposed from the widest one down: one form
// everywhere, one form for each half, one form for some sizes. What an attack finds refutes every later
// proposal that holds the point.
#pragma once

#include <optional>
#include <vector>

#include "numeric/advice/attack.h"

namespace rigor {

/// Where another form loses, and how much.
struct OtherForm {
  std::size_t form = 0;
  LosingPoint worst;
};

/// One form for one range. The other forms that lose there, each at its worst point.
struct AdvisedForm {
  std::size_t form = 0;
  Range range;
  std::vector<OtherForm> others;
};

/// At most two ranges. None: no form is safe in any range that can be named; `others` says where each loses.
struct RangeAdvice {
  std::vector<AdvisedForm> parts;
  std::vector<OtherForm> others;
};

/// Operations after which nothing more is proposed: about ten seconds, and four times what any chain of
/// derivations/ takes.
inline constexpr std::size_t most_search_work = 400'000'000;

/// `costs`: of the forms; of safe forms the cheapest is advised. Nothing where no point meets the conditions,
/// or where `most_work` is done before a proposal stands.
[[nodiscard]] std::optional<RangeAdvice> advise_forms(const SearchSpace& space, const ExprTree& tree,
                                                      std::span<const double> costs, std::uint64_t seed,
                                                      std::size_t most_work = most_search_work);

}  // namespace rigor
