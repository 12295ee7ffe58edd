// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many numbered things were met, for walks that meet few of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// Clearing costs nothing but for things that are new, so that one object serves many walks.
class Marks {
 public:
  /// No thing from 0 to `count` is marked.
  void clear(std::size_t count) {
    if (++walk_ == 0) {  // after 2^32 walks
      walks_.assign(walks_.size(), 0);
      walk_ = 1;
    }
    if (walks_.size() < count) walks_.resize(count);
  }
  /// False: it was marked before.
  bool mark(std::size_t thing) {
    if (walks_[thing] == walk_) return false;
    walks_[thing] = walk_;
    return true;
  }

 private:
  std::vector<std::uint32_t> walks_;  // of each thing the last walk that met it
  std::uint32_t walk_ = 0;
};

}  // namespace rigor
