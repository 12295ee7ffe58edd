// SPDX-License-Identifier: GPL-3.0-or-later
// One line that says how far the work has come: `notes.md: 12 of 63 displays` (or `forms`). It appears after
// a second, changes at most ten times a second, and leaves nothing behind.
#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace rigor {

class Progress {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Clock = std::function<Time()>;

  /// Nothing is ever written unless `shown`, that is, unless `err` is a terminal.
  Progress(std::ostream& err, bool shown, Clock clock = std::chrono::steady_clock::now);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(const std::string& path, std::size_t done, std::size_t all, std::string_view what = "displays");
  void clear();

 private:
  std::ostream& err_;
  bool shown_;
  Clock clock_;
  Time next_;  // before it nothing is written
  bool visible_ = false;
};

}  // namespace rigor
