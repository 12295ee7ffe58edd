// SPDX-License-Identifier: GPL-3.0-or-later
// Which register each result is kept in, and until when: linear scan over the steps of a phase. What is
// defined before a loop and used in it is kept to the loop's end. Results of what is computed once stay.
#pragma once

#include <cstdint>
#include <vector>

#include "numeric/program/run_plan.h"

namespace rigor {

using RegisterId = std::uint32_t;

/// A slot before it has its final number.
enum class PlaceKind : std::uint8_t { reg, constant, input, output };

[[nodiscard]] constexpr SlotId place(PlaceKind kind, std::uint32_t index) {
  return static_cast<std::uint32_t>(kind) << 28 | index;
}

class Registers {
 public:
  /// Starts a phase. Kept: narrow registers outside all loops outlive it.
  void begin(bool kept);
  [[nodiscard]] RegisterId define(bool wide, std::size_t position);
  void use(RegisterId id, std::size_t position);
  void open_loop() { loops_.emplace_back(); }
  void close_loop(std::size_t position);
  /// Chooses registers for what the phase defined.
  void end();
  /// Gives all slots of all steps their final numbers.
  void settle(Plan& plan) const;

 private:
  struct Range {
    bool wide = false;
    bool kept = false;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t depth = 0;  // of loops at its definition
    std::uint32_t chosen = 0;
  };
  struct Pool {
    std::uint32_t size = 0;
    std::vector<std::uint32_t> free;
    [[nodiscard]] std::uint32_t take();
  };

  std::vector<Range> ranges_;
  std::vector<std::vector<RegisterId>> loops_;  // what each open loop uses from outside
  std::size_t phase_begin_ = 0;
  bool kept_ = false;
  Pool wide_;
  Pool narrow_;
};

}  // namespace rigor
