// SPDX-License-Identifier: GPL-3.0-or-later
// Stands between the floors `check` and `algebra`: every question that a session asks passes here on its way
// to `decide`. The linker puts it there (`--wrap`), so that neither floor knows of it.
#pragma once

#include <functional>

#include "algebra/decide/decide.h"

namespace rigor::bench {

/// Called with each question instead of `decide`, as long as the watch lives. One watch at a time.
class DecideWatch {
 public:
  using Watcher = std::function<Decision(const Question&, const Limits&)>;
  explicit DecideWatch(Watcher watcher);
  ~DecideWatch();
  DecideWatch(const DecideWatch&) = delete;
  DecideWatch& operator=(const DecideWatch&) = delete;
};

/// The real one.
[[nodiscard]] Decision decide_unwatched(const Question& question, const Limits& limits);

}  // namespace rigor::bench
