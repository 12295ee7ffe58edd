// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a program's values are computed, and where they are kept meanwhile. Lanes of a step are
// samples, or particles of the loops at level 1 (for a few samples with many particles). What depends on no
// sample is computed once, with lanes of particles, before all samples. A value is computed in the outermost
// loop in which its operands are known; sums at one level that do not wait for each other share a loop.
// Up to thirty operations become one step where the first one's result has no other use: no rounding is left
// out or moved. A register is free again after its last use.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "numeric/program/code.h"

namespace rigor {

enum class Kernel : std::uint8_t {
  clear,     // 0
  copy,      // a
  negate,    // −a
  absolute,  // |a|
  root,
  sin,
  cos,
  exp,
  tan,
  sinh,
  cosh,
  tanh,
  add,                 // a + b
  subtract,            // a − b
  multiply,            // a b
  divide,              // a / b
  multiply_add,        // a b + c
  multiply_subtract,   // a b − c
  subtract_product,    // c − a b
  product_sum,         // a b + c d
  product_difference,  // a b − c d
  product_sum_3,       // (a b + c d) + e f
  square_sum_3,        // (a a + b b) + c c
  cross_square,        // ((a d − b e)² + (b f − c d)²) + (c e − a f)²
  cross,               // (b f − c e, c d − a f, a e − b d): three results
  gram,                // ((a a + b b) + c c) ((d d + e e) + f f) − ((a d + b e) + c f)²
  less_square,         // a b − ((c d + e f) + g h)²
  product_3,           // (a b) c
  triple_sum_3,        // ((a b) c ± (d e) f) ± (g h) i
  add_triple_sum_3,    // ((s ± (a b) c) ± (d e) f) ± (g h) i
  quadratic_form_3,  // of (a, b, c) with nine narrow entries d, …: (a d) a ± (a e) b ± …, one after the other
  fold,              // the sum of the lanes of a
  loop,              // the steps up to `end`, for all particles
};

/// Where an operand is: a slot holds a pointer to one number (narrow) or to one for each lane (wide).
using SlotId = std::uint32_t;

inline constexpr std::size_t most_operands = 12;
inline constexpr std::uint16_t wide_result = 0x8000;
inline constexpr SlotId no_slot = ~SlotId{0};

/// What a step does with its value v at last: v f, v / f, out + v f, where f is narrow, or 1 without a slot.
enum class Ending : std::uint8_t { none, divide, add };

struct PlanStep {
  Kernel kernel = Kernel::clear;
  Ending ending = Ending::none;
  bool negated = false;    // −f for f
  std::uint16_t wide = 0;  // bit k: operand k is wide; bit 15: so is the result
  std::uint8_t operands = 0;
  std::uint16_t minus = 0;   // triples: bit k: triple k is subtracted
  std::uint8_t level = 0;    // loop
  bool over_lanes = false;   // loop: takes as many particles at a time as there are lanes
  std::uint32_t end = 0;     // loop: the step after it
  std::uint32_t inputs = 0;  // loop: into Plan::loop_inputs
  std::uint32_t input_count = 0;
  SlotId out = 0;
  std::array<SlotId, 2> also_out{};  // of a cross product: where its other components go
  SlotId factor = no_slot;
  std::array<SlotId, most_operands> in{};
};

/// An input at a particle, as a step reads it.
struct PlanInput {
  std::uint32_t input = 0;
  std::uint32_t particle = 0;  // as InputParticle says
  bool wide = false;
  bool lanes_are_particles = false;
  friend bool operator==(const PlanInput&, const PlanInput&) = default;
};

/// What is done side by side: none: nothing; one: particles in sums that depend on no sample; samples: these
/// too; particles: in all sums.
enum class Lanes : std::uint8_t { none, one, samples, particles };
inline constexpr std::size_t many_particles = 16;  // from so many on they are taken side by side

struct Plan {
  std::vector<PlanStep> once;              // before all samples
  std::vector<PlanStep> each;              // for each batch of samples, or each sample
  std::vector<std::uint32_t> loop_inputs;  // that change from particle to particle of a loop: into `inputs`
  std::vector<std::uint32_t> once_inputs;  // that are set before `once`
  std::vector<std::uint32_t> each_inputs;  // that are set before `each`
  // Slots: wide registers, narrow registers, constants, inputs, outputs.
  std::uint32_t wide_registers = 0;
  std::uint32_t narrow_registers = 0;
  std::vector<std::uint32_t> constants;  // into Code::constants
  std::vector<PlanInput> inputs;
  std::uint32_t outputs = 0;
  Lanes lanes = Lanes::none;

  [[nodiscard]] std::uint32_t first_constant() const { return wide_registers + narrow_registers; }
  [[nodiscard]] std::uint32_t first_input() const {
    return first_constant() + static_cast<std::uint32_t>(constants.size());
  }
  [[nodiscard]] std::uint32_t first_output() const {
    return first_input() + static_cast<std::uint32_t>(inputs.size());
  }
  [[nodiscard]] std::uint32_t slots() const { return first_output() + outputs; }
};

/// `varies`: for each input of the code, whether it is another one for each sample; empty: all are.
[[nodiscard]] Plan make_plan(const Code& code, Lanes lanes, std::span<const std::uint8_t> varies = {});

}  // namespace rigor
