// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/program.h"

#include <algorithm>

#include "numeric/program/code.h"
#include "numeric/program/compile_walk.h"

namespace rigor {
namespace {

[[nodiscard]] std::vector<bool> needed_values(const Code& code) {
  std::vector<bool> needed(code.values.size(), false);
  for (const ValueId output : code.outputs) needed[output] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    const Value& value = code.values[i];
    if (!needed[i] || !has_operands(value.op)) continue;
    needed[value.a] = true;
    if (has_second_operand(value.op)) needed[value.b] = true;
  }
  return needed;
}

/// Takes out values that no result needs, and the inputs that only these have: nobody has to provide them.
void drop_what_is_not_needed(Code& code) {
  const std::vector<bool> needed = needed_values(code);
  std::vector<ValueId> value_now(code.values.size(), 0);
  std::vector<std::uint32_t> input_now(code.inputs.size(), 0);  // plus 1; 0: not met yet
  std::vector<ProgramInput> inputs;
  ValueId kept = 0;
  for (ValueId id = 0; id < code.values.size(); ++id) {
    if (!needed[id]) continue;
    Value value = code.values[id];
    if (has_operands(value.op)) value.a = value_now[value.a];
    if (has_second_operand(value.op)) value.b = value_now[value.b];
    if (value.op == Instruction::input) {
      std::uint32_t& now = input_now[value.a];
      if (now == 0) {
        inputs.push_back(code.inputs[value.a]);
        now = static_cast<std::uint32_t>(inputs.size());
      }
      value.a = now - 1;
    }
    code.values[kept] = value;
    value_now[id] = kept++;
  }
  code.values.resize(kept);
  code.inputs = std::move(inputs);
  for (ValueId& output : code.outputs) output = value_now[output];
}

}  // namespace

Result<Program> Program::compile(const ExprTree& tree, std::span<const Definition> definitions,
                                 std::span<const ProgramRoot> roots) {
  const auto code = std::make_shared<Code>();
  ExpressionCompiler compiler(tree, definitions, *code);
  for (const ProgramRoot& root : roots) {
    compiler.add(root);
    if (!compiler.failure().empty()) return refuse(compiler.failure());
  }
  drop_what_is_not_needed(*code);
  Program program;
  program.code_ = code;
  return program;
}

std::span<const ProgramInput> Program::inputs() const { return code_->inputs; }
std::size_t Program::outputs() const { return code_->outputs.size(); }
std::span<const ParticleId> Program::free_particles() const { return code_->free_particles; }

bool Program::sums_over_particles() const {
  return std::ranges::any_of(code_->outputs, [this](ValueId id) { return code_->values[id].height > 0; });
}

ProgramCounts Program::counts() const {
  ProgramCounts counts;
  for (const Value& value : code_->values) {
    if (!has_operands(value.op)) continue;
    const bool in_loop = value.op == Instruction::sum || value.levels != 0;
    ++(in_loop ? counts.per_particle : counts.once);
  }
  return counts;
}

}  // namespace rigor
