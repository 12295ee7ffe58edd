// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/run_steps.h"

#include <array>
#include <cstring>
#include <vector>

#include "catch.h"
#include "numeric/lane/lane_kernels.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

constexpr std::size_t width = lane_count;

/// Wide slots of random numbers; the last three are for results.
struct Slots {
  std::vector<double> numbers;
  std::array<double*, most_operands + 3> at{};

  explicit Slots(std::uint64_t seed) : numbers((most_operands + 3) * width) {
    SplitMix bits(seed);
    for (double& x : numbers) x = uniform_sign(bits);
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = numbers.data() + k * width;
  }
};

PlanStep step_of(Kernel kernel, unsigned wide, std::uint16_t minus) {
  PlanStep step;
  step.kernel = kernel;
  step.wide = static_cast<std::uint16_t>(wide);
  step.minus = minus;
  step.out = most_operands;
  step.also_out = {most_operands + 1, most_operands + 2};
  for (std::size_t k = 0; k < most_operands; ++k) step.in[k] = static_cast<SlotId>(k);
  return step;
}

TEST_CASE("steps have the same bits in every instruction set") {
  std::size_t compared = 0;
  for (auto kernel = static_cast<unsigned>(Kernel::clear); kernel < static_cast<unsigned>(Kernel::loop);
       ++kernel) {
    for (unsigned operands = 0; operands < 1u << most_operands; ++operands) {
      for (const Ending ending : {Ending::none, Ending::divide, Ending::add}) {
        PlanStep step = step_of(static_cast<Kernel>(kernel), wide_result | operands,
                                static_cast<std::uint16_t>(operands % 7));
        step.ending = ending;
        step.negated = kernel % 2 == 0;
        if (ending != Ending::none) step.factor = 1;
        const auto expected = steps_of("baseline")(step);
        if (expected == nullptr) continue;
        Slots baseline(kernel);
        expected(baseline.at.data(), step, 77);
        for (const LaneKernels* set : runnable_lane_kernels()) {
          const auto found = steps_of(set->instruction_set)(step);
          REQUIRE(found != nullptr);
          Slots slots(kernel);
          found(slots.at.data(), step, 77);
          INFO(set->instruction_set << ", kernel " << kernel << ", wide " << step.wide);
          CHECK(std::memcmp(slots.numbers.data(), baseline.numbers.data(),
                            sizeof(double) * slots.numbers.size()) == 0);
          ++compared;
        }
      }
    }
  }
  CHECK(compared >= 2 * 45);
}

TEST_CASE("each lane has the value that the step's formula has with roundings in its order") {
  const auto run = [](Kernel kernel, unsigned wide, std::uint16_t minus, Slots& slots) {
    const PlanStep step = step_of(kernel, wide_result | wide, minus);
    const auto found = wide_steps()(step);
    REQUIRE(found != nullptr);
    found(slots.at.data(), step, lane_count);
  };
  Slots slots(3);
  const auto x = [&](std::size_t k, std::size_t lane) { return slots.at[k][lane]; };
  run(Kernel::product_difference, 0b0101, 0, slots);
  for (std::size_t i = 0; i < width; ++i) {
    const double first = x(0, i) * x(1, 0);
    const double second = x(2, i) * x(3, 0);
    CHECK(x(most_operands, i) == first - second);
  }
  run(Kernel::cross_square, 0b111, 0, slots);
  for (std::size_t i = 0; i < width; ++i) {
    std::array<double, 3> squares{};
    constexpr std::array<std::array<std::size_t, 4>, 3> factors{{{0, 3, 1, 4}, {1, 5, 2, 3}, {2, 4, 0, 5}}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double first = x(factors[k][0], i) * x(factors[k][1], 0);
      const double second = x(factors[k][2], i) * x(factors[k][3], 0);
      squares[k] = (first - second) * (first - second);
    }
    CHECK(x(most_operands, i) == squares[0] + squares[1] + squares[2]);
  }
  run(Kernel::cross, 0b111, 0, slots);
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double first = x((k + 1) % 3, i) * x(3 + (k + 2) % 3, 0);
      const double second = x((k + 2) % 3, i) * x(3 + (k + 1) % 3, 0);
      CHECK(x(most_operands + k, i) == first - second);
    }
  }
  run(Kernel::less_square, 0b1010101, 0, slots);
  for (std::size_t i = 0; i < width; ++i) {
    const double c = (x(2, i) * x(3, 0) + x(4, i) * x(5, 0)) + x(6, i) * x(7, 0);
    CHECK(x(most_operands, i) == x(0, i) * x(1, 0) - c * c);
  }
  run(Kernel::gram, 0b111111, 0, slots);
  for (std::size_t i = 0; i < width; ++i) {
    const auto dot = [&](std::size_t a, std::size_t b) {
      return (x(a, i) * x(b, i) + x(a + 1, i) * x(b + 1, i)) + x(a + 2, i) * x(b + 2, i);
    };
    const double squares = dot(0, 0) * dot(3, 3);
    CHECK(x(most_operands, i) == squares - dot(0, 3) * dot(0, 3));
  }
  // The fourth and the ninth term are subtracted.
  run(Kernel::quadratic_form_3, 0b111, 0b100001000, slots);
  for (std::size_t i = 0; i < width; ++i) {
    double sum = 0;
    for (std::size_t n = 0; n < 9; ++n) {
      const double term = x(n / 3, i) * x(3 + n, 0) * x(n % 3, i);
      sum = n == 3 || n == 8 ? sum - term : sum + term;
    }
    CHECK(x(most_operands, i) == sum);
  }
  // The second triple is subtracted.
  run(Kernel::add_triple_sum_3, 0x2db, 2, slots);
  for (std::size_t i = 0; i < width; ++i) {
    const double sum = x(0, i) + x(1, i) * x(2, 0) * x(3, i);
    const double less = sum - x(4, i) * x(5, 0) * x(6, i);
    CHECK(x(most_operands, i) == less + x(7, i) * x(8, 0) * x(9, i));
  }
}

TEST_CASE("a step ends with a factor, a divisor or a sum, and only lanes that count are added to") {
  const auto run = [](Ending ending, SlotId factor, bool negated, Slots& slots) {
    PlanStep step = step_of(Kernel::add, wide_result | 0b11, 0);
    step.ending = ending;
    step.factor = factor;
    step.negated = negated;
    wide_steps()(step)(slots.at.data(), step, 77);
  };
  const Slots before(4);
  for (const bool negated : {false, true}) {
    for (const SlotId factor : {SlotId{5}, no_slot}) {
      const double f = (factor == no_slot ? 1 : *before.at[5]) * (negated ? -1 : 1);
      for (const Ending ending : {Ending::none, Ending::divide, Ending::add}) {
        Slots slots(4);
        run(ending, factor, negated, slots);
        for (std::size_t i = 0; i < 77; ++i) {
          const double value = before.at[0][i] + before.at[1][i];
          const double ended = ending == Ending::divide ? value / f : value * f;
          const double sum = before.at[most_operands][i] + ended;
          CHECK(slots.at[most_operands][i] == (ending == Ending::add ? sum : ended));
        }
        for (std::size_t i = ending == Ending::add ? 77 : 80; i < width; ++i)
          CHECK(slots.at[most_operands][i] == before.at[most_operands][i]);
      }
    }
  }
}

TEST_CASE("each instruction set has steps of its own, and a step that is narrow has none") {
  for (const LaneKernels* set : runnable_lane_kernels()) {
    const bool is_baseline = std::string_view(set->instruction_set) == "baseline";
    CHECK((steps_of(set->instruction_set) == steps_of("baseline")) == is_baseline);
    CHECK(steps_of(set->instruction_set)(step_of(Kernel::sin, 0x8001, 0)) == nullptr);
    CHECK(steps_of(set->instruction_set)(step_of(Kernel::add, 0, 0)) == nullptr);
  }
}

}  // namespace
}  // namespace rigor
