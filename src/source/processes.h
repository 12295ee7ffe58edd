// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of work in processes of their own: what uses a library that knows no threads, and what may crash.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"

namespace rigor {

/// How far one piece has come.
using ReportProgress = std::function<void(std::size_t done, std::size_t all)>;

struct Pieces {
  std::size_t count = 0;
  /// The answer for one piece; called in a process that was forked for it.
  std::function<std::string(std::size_t piece, const ReportProgress& progress)> work;
  /// Called in this process.
  std::function<void(std::size_t piece, std::size_t done, std::size_t all)> progress;
};

/// The answers in the order of the pieces, whatever order they were finished in; at most `most_at_once` (at
/// least 1) processes at a time. An exception, a crash or a process that cannot be started is an error of its
/// piece and of no other. The processes end with this one, however it ends.
[[nodiscard]] std::vector<Result<std::string>> in_processes(const Pieces& pieces, std::size_t most_at_once);

/// The same, but nothing is lost with a process: what it did not answer is done here. `progress` may be
/// empty, and what is given to `work` as well.
[[nodiscard]] std::vector<std::string> in_processes_or_here(const Pieces& pieces, std::size_t most_at_once);

/// How many of them this machine runs at once; at least 1.
[[nodiscard]] std::size_t processor_count();

}  // namespace rigor
