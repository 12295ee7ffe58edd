// SPDX-License-Identifier: GPL-3.0-or-later
#include "decide_watch.h"

#include <utility>

namespace rigor::bench {
namespace {

DecideWatch::Watcher& watcher_in_force() {
  static DecideWatch::Watcher watcher;
  return watcher;
}

}  // namespace

// `--wrap` sends calls of `rigor::decide` to the second name; the first one is where they went before.
Decision real_decide(const Question& question, const Limits& limits) __asm__("__real_" RIGOR_DECIDE_SYMBOL);
Decision watched_decide(const Question& question,
                        const Limits& limits) __asm__("__wrap_" RIGOR_DECIDE_SYMBOL);

Decision watched_decide(const Question& question, const Limits& limits) {
  return watcher_in_force() ? watcher_in_force()(question, limits) : real_decide(question, limits);
}

Decision decide_unwatched(const Question& question, const Limits& limits) {
  return real_decide(question, limits);
}

DecideWatch::DecideWatch(Watcher watcher) { watcher_in_force() = std::move(watcher); }
DecideWatch::~DecideWatch() { watcher_in_force() = nullptr; }

}  // namespace rigor::bench
