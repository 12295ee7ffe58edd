// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/chain_ends.h"

namespace rigor {

std::vector<std::optional<ChainPlace>> places_in_chain(
    const std::vector<Link>& steps, const std::function<Link(std::size_t, std::size_t)>& across) {
  std::vector<std::optional<ChainPlace>> places(steps.size());
  bool slipped = false;       // is a slip in force…
  std::size_t slip = 0;       // …that of this step?
  Link so_far = Link::holds;  // between its left side and the last side that was looked at
  const auto end_of_slip = [&] {
    if (slipped) places[slip]->stays = so_far == Link::fails;
    slipped = false;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] == Link::no_equality) {
      end_of_slip();
    } else if (!slipped) {
      if (steps[i] != Link::fails) continue;
      slipped = true;
      slip = i;
      so_far = Link::fails;
      places[i] = ChainPlace{.first_wrong = true};
    } else {
      if (steps[i] != Link::holds) so_far = across(slip, i + 1);
      if (steps[i] == Link::fails)
        places[i] = ChainPlace{.undoes = so_far == Link::holds, .first_step = slip};
      if (so_far != Link::holds) continue;
      places[slip]->undone_at = i;
      slipped = false;
    }
  }
  end_of_slip();
  return places;
}

}  // namespace rigor
