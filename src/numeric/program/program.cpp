// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "numeric/program/code.h"
#include "numeric/program/compile_walk.h"
#include "numeric/program/run_plan.h"

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

[[nodiscard]] std::string_view symbol_of(Instruction op) {
  switch (op) {
    case Instruction::add:
      return "+";
    case Instruction::subtract:
    case Instruction::negate:
      return "-";
    case Instruction::multiply:
      return "*";
    case Instruction::divide:
      return "/";
    case Instruction::root:
      return "root";
    case Instruction::absolute:
      return "abs";
    case Instruction::sin:
      return "sin";
    case Instruction::cos:
      return "cos";
    case Instruction::exp:
      return "exp";
    case Instruction::sum:
      return "sum";
    case Instruction::constant:
    case Instruction::input:
      break;
  }
  return "";
}

/// `%12` (by `number`), `0.5`, `I[1]{p1}`: component 1 for the particle of level 1; `{f0}` is a free
/// particle.
[[nodiscard]] std::string name_of_value(const Code& code, const ExprTree& tree, ValueId id,
                                        std::uint32_t number) {
  const Value& value = code.values[id];
  if (value.op == Instruction::constant) {
    const Constant& constant = code.constants[value.a];
    return constant.digits.empty() ? fmt::format("{}", constant.value) : constant.digits;
  }
  if (value.op != Instruction::input) return fmt::format("%{}", number);
  const ProgramInput& input = code.inputs[value.a];
  std::string name = fmt::format("{}[{}]", tree.symbols[input.symbol].name, input.component);
  if (value.b >= InputParticle::first_free) {
    name += fmt::format("{{f{}}}", value.b - InputParticle::first_free);
  } else if (value.b != InputParticle::none) {
    name += fmt::format("{{p{}}}", value.b);
  }
  return name;
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
  return std::any_of(code_->outputs.begin(), code_->outputs.end(),
                     [this](ValueId id) { return code_->values[id].height > 0; });
}

ProgramCounts Program::counts() const {
  ProgramCounts counts;
  for (const Value& value : code_->values) {
    if (!has_operands(value.op)) continue;
    const bool in_loop = value.op == Instruction::sum || value.levels != 0;
    ++(in_loop ? counts.per_particle : counts.once);
  }
  const Plan plan = make_plan(*code_, Lanes::samples);
  counts.registers = plan.wide_registers + plan.narrow_registers;
  return counts;
}

std::string Program::listing(const ExprTree& tree) const {
  std::string text;
  std::vector<std::uint32_t> number(code_->values.size(), 0);
  std::uint32_t last = 0;
  const auto name = [&](ValueId id) { return name_of_value(*code_, tree, id, number[id]); };
  for (ValueId id = 0; id < number.size(); ++id) {
    const Value& value = code_->values[id];
    if (!has_operands(value.op)) continue;
    number[id] = ++last;
    text += fmt::format("{} = {}", name(id), symbol_of(value.op));
    if (value.op == Instruction::sum) text += fmt::format(" over p{}", value.level);
    text += " " + name(value.a);
    if (has_second_operand(value.op)) text += " " + name(value.b);
    text += "\n";
  }
  for (const ValueId id : code_->outputs) text += fmt::format("result {}\n", name(id));
  return text;
}

}  // namespace rigor
