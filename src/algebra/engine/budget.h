// SPDX-License-Identifier: GPL-3.0-or-later
// How much work deciding may take, counted and not timed, so that it is the same on every machine. A unit
// is about 0.3 µs: a step of evaluation or an operation of linear algebra takes one or less, and what GiNaC
// does takes more, by the prices below. They were measured on steps that are slow; `tests/bench` compares
// them.
#pragma once

#include <cstdint>

namespace rigor {

/// For one step of the notes, unless the user says otherwise.
inline constexpr std::uint64_t default_effort = 4'000'000;

/// Units for what GiNaC does with expanded polynomials.
namespace price {
inline constexpr std::uint64_t expanded_term = 6;       // of the result, before equal ones are collected
inline constexpr std::uint64_t divided_pair = 25;       // terms of the dividend times terms of the divisor
inline constexpr std::uint64_t factored_term = 5000;    // of what is taken apart into powers
inline constexpr std::uint64_t summed_term = 40;        // over particles, `moments.h`
inline constexpr std::uint64_t looked_at_term = 4;      // along a line, `line_image.h`
inline constexpr std::uint64_t row_of_multiples = 100;  // an equation times a monomial, `membership.h`
inline constexpr std::uint64_t derived_node = 2;        // of the derivative of a definition or a law
}  // namespace price

/// One counter for all that is asked about a step: its proofs, samples, and the assumptions' samples. Once it
/// is used up, every further count throws, so that everything ends soon.
class Budget {
 public:
  explicit Budget(std::uint64_t most = default_effort) : most_(most) {}

  /// Throws Undecidable when more is used than there was.
  void count(std::uint64_t units) {
    used_ += units;
    if (used_ > most_) give_up();
  }
  /// The same without a throw: is there so much left?
  [[nodiscard]] bool takes(std::uint64_t units) {
    used_ += units;
    return !exhausted();
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
