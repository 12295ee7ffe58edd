// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <limits>

#include "numeric/measure/measure.h"
#include "numeric/program/code.h"

namespace rigor {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();

}  // namespace

std::size_t tuples_of(unsigned levels, std::size_t particles) {
  std::size_t count = 1;
  for (int i = std::popcount(levels); i > 0; --i) {
    if (particles != 0 && count > most / particles) return most;
    count *= particles;
  }
  return count;
}

std::size_t work_of(const Program& program, std::size_t particles, std::size_t operation,
                    std::size_t function) {
  const Code& code = program.code();
  std::size_t work = 1;
  for (const Value& value : code.values) {
    if (!has_operands(value.op)) continue;
    const bool is_sum = value.op == Instruction::sum;
    const unsigned levels = is_sum ? code.values[value.a].levels | 1u << value.level : value.levels;
    const std::size_t count = tuples_of(levels, particles);
    const std::size_t weight = is_elementary(value.op) ? function : operation;
    work = count > (most - work) / weight ? most : work + count * weight;
  }
  return work;
}

std::size_t work_of(const Program& program, const Samples& samples, std::size_t operation,
                    std::size_t function) {
  return work_of(program, samples.particles(), operation, function);
}

}  // namespace rigor
