// SPDX-License-Identifier: GPL-3.0-or-later
// Which values of a block are computed within the step of their only user.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "numeric/program/run_plan.h"

namespace rigor {

/// A step before its operands have places.
struct FusedStep {
  Kernel kernel = Kernel::clear;
  std::uint8_t operands = 0;
  std::array<ValueId, most_operands> in{};
  std::uint16_t minus = 0;
  Ending ending = Ending::none;
  std::optional<ValueId> factor = std::nullopt;
  bool negated = false;
};

/// What the choice depends on.
struct FusionScope {
  const Code* code = nullptr;
  std::span<const std::uint32_t> uses;   // by value
  std::span<const std::uint32_t> block;  // by value: the block it was collected for
  std::span<const std::uint8_t> wide;    // by value
  std::uint32_t current = 0;

  /// Is it computed in this block, wide as its user, for nothing but it?
  [[nodiscard]] bool is_private(ValueId value, Instruction op, bool user_is_wide) const {
    return is_used(value, op, user_is_wide, 1);
  }
  /// The same of a value and its square, where the square is private.
  [[nodiscard]] bool is_private_to_square(ValueId value, Instruction op, bool user_is_wide) const {
    return is_used(value, op, user_is_wide, 2);
  }
  /// The same of any operation but a sum over particles.
  [[nodiscard]] bool is_private(ValueId value, bool user_is_wide) const {
    const Instruction op = code->values[value].op;
    return has_operands(op) && op != Instruction::sum && is_private(value, op, user_is_wide);
  }

 private:
  [[nodiscard]] bool is_used(ValueId value, Instruction op, bool user_is_wide, std::uint32_t times) const {
    return code->values[value].op == op && uses[value] == times && block[value] == current &&
           (wide[value] != 0) == user_is_wide;
  }
};

/// The step that computes three components at once, if these three steps of its width compute b f − c e, c d
/// − a f and a e − b d, in any order of theirs, and end alike. `order`: which of them is which component.
[[nodiscard]] std::optional<FusedStep> cross_of(const std::array<FusedStep, 3>& steps,
                                                std::array<std::size_t, 3>& order);

/// The step that computes a value. Values that it takes in are set in `taken_in` (by value).
[[nodiscard]] FusedStep fuse(const FusionScope& scope, ValueId value, std::span<std::uint8_t> taken_in);

}  // namespace rigor
