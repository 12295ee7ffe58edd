// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace rigor {

/// The worst that is found by so many changes, each kept if it makes things no better. `badness`: an error
/// over its bound, say. `changed` draws from its own bits, so that every run is the same.
template <class State, class Change, class Badness>
[[nodiscard]] double climbed(State state, int steps, const Change& changed, const Badness& badness) {
  double worst = badness(state);
  for (int step = 0; step < steps; ++step) {
    State next = changed(state);
    const double found = badness(next);
    if (found < worst) continue;
    worst = found;
    state = next;
  }
  return worst;
}

}  // namespace rigor
