// SPDX-License-Identifier: GPL-3.0-or-later
// How much work deciding may take, counted and not timed: the same in every run and on every machine. A unit
// is a step of evaluation, a term that is expanded, or an operation of linear algebra: 0.05 µs at a sample,
// and up to 7 µs where roots are taken at the generic point.
#pragma once

#include <cstdint>

namespace rigor {

/// Of one step of some notes, unless something else is asked for.
inline constexpr std::uint64_t default_effort = 5'000'000;

/// One counter for all that is asked about a step: its proofs, samples, and the assumptions' samples. What
/// counts beyond the end gives up, at once and each time, so that everything ends.
class Budget {
 public:
  explicit Budget(std::uint64_t most = default_effort) : most_(most) {}

  /// Throws Undecidable where the end is passed.
  void count(std::uint64_t units) {
    used_ += units;
    if (used_ > most_) give_up();
  }
  [[nodiscard]] std::uint64_t used() const { return used_; }
  [[nodiscard]] std::uint64_t left() const { return used_ < most_ ? most_ - used_ : 0; }
  [[nodiscard]] bool exhausted() const { return used_ > most_; }

 private:
  [[noreturn]] void give_up() const;

  std::uint64_t most_;
  std::uint64_t used_ = 0;
};

}  // namespace rigor
