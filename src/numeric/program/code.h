// SPDX-License-Identifier: GPL-3.0-or-later
// What a Program is made of: values in single assignment, operands before what uses them, each value once. A
// value does not say when it is computed, only what it depends on; `run_plan.h` puts values in order.
// Levels number the loops over particles: all sums that depend on no other particle are at level 1, sums
// within them at 2, and so on, so that Σ_α and Σ_β share what they have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "numeric/program/program.h"

namespace rigor {

enum class Instruction : std::uint8_t {
  constant,  // a: into `constants`
  input,     // a: into `inputs`; b: which particle, as `particle_of` says
  add,
  subtract,
  multiply,
  divide,
  negate,
  root,
  absolute,
  sin,
  cos,
  exp,
  tan,
  sinh,
  cosh,
  tanh,
  sum,  // Σ of `a` over all particles at `level`, one after the other
};

using ValueId = std::uint32_t;
using LevelMask = std::uint8_t;  // bit l: depends on the particle of level l; bit 0 is for `run_plan.h`
inline constexpr int deepest_level = 7;

struct Value {
  Instruction op = Instruction::constant;
  LevelMask levels = 0;
  std::uint8_t level = 0;    // of a sum
  std::uint16_t height = 0;  // how many sums are taken one after the other before this value is known
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// The particle that an input is taken at.
struct InputParticle {
  static constexpr std::uint32_t none = 0;
  static constexpr std::uint32_t first_free = 8;  // free particle k is `first_free + k`; 1..7 are levels
};

/// A number as it was written, and its nearest double.
struct Constant {
  std::string digits;  // empty: `value` is exact
  double value = 0.0;
};

struct Code {
  std::vector<Value> values;
  std::vector<Constant> constants;
  std::vector<ProgramInput> inputs;
  std::vector<ParticleId> free_particles;
  std::vector<ValueId> outputs;
};

[[nodiscard]] constexpr bool has_second_operand(Instruction op) {
  return op >= Instruction::add && op <= Instruction::divide;
}
[[nodiscard]] constexpr bool has_operands(Instruction op) { return op >= Instruction::add; }
[[nodiscard]] constexpr bool is_elementary(Instruction op) {
  return op >= Instruction::sin && op <= Instruction::tanh;
}

}  // namespace rigor
