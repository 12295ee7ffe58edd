// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/run_plan.h"

#include <algorithm>
#include <bit>
#include <map>
#include <tuple>
#include <utility>

#include "base/among.h"
#include "numeric/program/run_fuse.h"
#include "numeric/program/run_registers.h"

namespace rigor {
namespace {

/// `once` has no sample; `each` may use what `once` left in registers.
enum class Phase : std::uint8_t { once, each };

/// Where it is in the list, at whose end it is put if it does not.
template <class Value>
[[nodiscard]] std::uint32_t place_in(std::vector<Value>& list, const Value& value) {
  const auto found = std::ranges::find(list, value);
  const auto at = static_cast<std::uint32_t>(found - list.begin());
  if (found == list.end()) list.push_back(value);
  return at;
}

/// Of which cross products are made: so that no time is lost on long forms.
constexpr std::size_t most_differences = 24;

class Planner {
 public:
  Planner(const Code& code, Lanes lanes, std::span<const std::uint8_t> varies) : code_(code) {
    plan_.lanes = lanes;
    plan_.outputs = static_cast<std::uint32_t>(code.outputs.size());
    const std::size_t count = code.values.size();
    block_.assign(count, 0);
    visited_.assign(count, 0);
    taken_in_.assign(count, 0);
    register_.assign(count, 0);
    output_of_.assign(count, 0);
    written_.assign(count, 0);
    pending_.assign(count, 0);
    find_masks(varies);
    count_uses();
  }

  [[nodiscard]] Plan plan() {
    begin(Phase::once, plan_.once);
    emit_block(0, code_.outputs);
    registers_.end();
    begin(Phase::each, plan_.each);
    if (plan_.lanes == Lanes::samples) {
      for (std::uint32_t i = 0; i < plan_.outputs; ++i) output_of_[code_.outputs[i]] = i + 1;
    }
    emit_block(0, code_.outputs);
    emit_outputs();
    registers_.end();
    registers_.settle(plan_);
    return std::move(plan_);
  }

 private:
  struct OpenLoop {
    int level = 0;
    std::vector<std::uint32_t> inputs;
  };

  [[nodiscard]] const Value& at(ValueId id) const { return code_.values[id]; }
  [[nodiscard]] bool varies(ValueId id) const { return (masks_[id] & 1u) != 0; }
  /// The innermost loop that a value is computed in; 0: none.
  [[nodiscard]] static int home_level(unsigned mask) { return std::bit_width(mask >> 1); }
  [[nodiscard]] bool belongs(ValueId id, int level) const {
    if (home_level(masks_[id]) != level) return false;
    return level > 0 || varies(id) == (phase_ == Phase::each);
  }

  void find_masks(std::span<const std::uint8_t> varies) {
    masks_.resize(code_.values.size());
    wide_.resize(code_.values.size());
    for (std::size_t i = 0; i < code_.values.size(); ++i) {
      const Value& value = code_.values[i];
      unsigned mask = value.levels;
      if (value.op == Instruction::input) mask |= varies.empty() || varies[value.a] != 0 ? 1u : 0u;
      if (has_operands(value.op)) mask |= masks_[value.a] & 1u;
      if (has_second_operand(value.op)) mask |= masks_[value.b] & 1u;
      masks_[i] = static_cast<std::uint8_t>(mask);
    }
  }

  /// How often each value is an operand of what is needed, or a result.
  void count_uses() {
    uses_.assign(code_.values.size(), 0);
    for (const ValueId output : code_.outputs) ++uses_[output];
    for (std::size_t i = code_.values.size(); i-- > 0;) {
      const Value& value = code_.values[i];
      if (uses_[i] == 0 || !has_operands(value.op)) continue;
      ++uses_[value.a];
      if (has_second_operand(value.op)) ++uses_[value.b];
    }
  }

  void begin(Phase phase, std::vector<PlanStep>& steps) {
    phase_ = phase;
    steps_ = &steps;
    root_inputs_ = phase == Phase::once ? &plan_.once_inputs : &plan_.each_inputs;
    const bool over_particles = phase == Phase::once || plan_.lanes == Lanes::particles;
    lane_bit_ = over_particles ? 2u : plan_.lanes == Lanes::samples ? 1u : 0u;
    if (plan_.lanes == Lanes::none) lane_bit_ = 0;
    for (std::size_t i = 0; i < masks_.size(); ++i) wide_[i] = (masks_[i] & lane_bit_) != 0 ? 1 : 0;
    registers_.begin(phase == Phase::once);
  }

  /// Sums of a height come first, since they wait for what is less high only; those at one level share a
  /// loop. `totals`: the sums whose loop this block is the body of; else the results of the program are asked
  /// for.
  void emit_block(int level, std::span<const ValueId> demand, std::span<const ValueId> totals = {}) {
    const std::uint32_t block = ++current_block_;
    std::vector<ValueId> local;
    collect(level, demand, local);
    for (const ValueId id : local) taken_in_[id] = 0;
    const FusionScope scope{&code_, uses_, block_, wide_, block};
    std::vector<FusedStep> fused(local.size());
    for (std::size_t i = local.size(); i-- > 0;) {
      if (taken_in_[local[i]] == 0 && at(local[i]).op != Instruction::sum)
        fused[i] = fuse(scope, local[i], taken_in_);
    }
    // What is computed for a sum alone is added to it by its own step.
    for (std::size_t i = 0; i < local.size(); ++i) {
      const auto total = std::ranges::find(totals, local[i], [this](ValueId sum) { return at(sum).a; });
      if (total == totals.end() || taken_in_[local[i]] != 0 || fused[i].ending != Ending::none ||
          !scope.is_private(local[i], wide_[local[i]] != 0))
        continue;
      taken_in_[local[i]] = 1;
      summands_.emplace(local[i], fused[i]);
    }
    std::map<ValueId, FusedStep> own;
    for (std::size_t i = 0; i < local.size(); ++i) {
      pending_[local[i]] = taken_in_[local[i]] == 0 ? 1 : 0;
      if (taken_in_[local[i]] == 0) own.emplace(local[i], fused[i]);
    }
    find_crosses(own);
    for (std::size_t i = 0; i < local.size();) {
      const Value& first = at(local[i]);
      if (first.op != Instruction::sum) {
        if (pending_[local[i]] != 0) emit_pending(local[i], fused[i]);
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < local.size() && at(local[end]).op == Instruction::sum &&
             at(local[end]).height == first.height && at(local[end]).level == first.level)
        ++end;
      emit_loop(first.level, std::span(local).subspan(i, end - i));
      for (std::size_t sum = i; sum < end; ++sum) pending_[local[sum]] = 0;
      i = end;
    }
  }

  /// The values of this block that are needed for others, operands before what uses them.
  void collect(int level, std::span<const ValueId> demand, std::vector<ValueId>& local) {
    std::vector<ValueId> open(demand.begin(), demand.end());
    while (!open.empty()) {
      const ValueId id = open.back();
      open.pop_back();
      const Value& value = at(id);
      if (visited_[id] == current_block_ || !has_operands(value.op)) continue;
      visited_[id] = current_block_;
      if (belongs(id, level)) {
        block_[id] = current_block_;
        local.push_back(id);
      } else if (home_level(masks_[id]) < level ||
                 (level == 0 && phase_ == Phase::each && !varies(id) && home_level(masks_[id]) == 0)) {
        continue;  // it is known already
      }
      open.push_back(value.a);
      if (has_second_operand(value.op)) open.push_back(value.b);
    }
    const auto key = [this](ValueId id) {
      const Value& value = at(id);
      const bool is_sum = value.op == Instruction::sum;
      return std::tuple(value.height, !is_sum, is_sum ? value.level : std::uint8_t{0}, id);
    };
    std::ranges::sort(local, [&](ValueId a, ValueId b) { return key(a) < key(b); });
  }

  [[nodiscard]] PlanStep placed(const FusedStep& fused) {
    PlanStep step{
        .kernel = fused.kernel, .ending = fused.ending, .negated = fused.negated, .minus = fused.minus};
    for (std::size_t i = 0; i < fused.operands; ++i) add_operand(step, fused.in[i]);
    if (fused.factor) step.factor = place_of(*fused.factor);
    return step;
  }

  /// Three components of one cross product, of which one step computes all.
  struct Cross {
    FusedStep step;
    std::array<ValueId, 3> components{};
  };

  /// Among these values.
  void find_crosses(const std::map<ValueId, FusedStep>& steps) {
    std::vector<ValueId> differences;
    for (const auto& [id, step] : steps)
      if (step.kernel == Kernel::product_difference && differences.size() < most_differences)
        differences.push_back(id);
    for (std::size_t i = 0; i < differences.size(); ++i) {
      for (std::size_t j = i + 1; j < differences.size(); ++j)
        for (std::size_t k = j + 1; k < differences.size(); ++k)
          find_cross(steps, {differences[i], differences[j], differences[k]});
    }
  }

  void find_cross(const std::map<ValueId, FusedStep>& steps, const std::array<ValueId, 3>& ids) {
    for (const ValueId id : ids)
      if (crosses_.contains(id) || wide_[id] != wide_[ids[0]]) return;
    std::array<std::size_t, 3> order{};
    const auto step = cross_of({steps.at(ids[0]), steps.at(ids[1]), steps.at(ids[2])}, order);
    if (!step || !has_choice(*step)) return;
    for (const ValueId id : ids)
      crosses_.emplace(id, Cross{*step, {ids[order[0]], ids[order[1]], ids[order[2]]}});
  }

  /// Is the first vector wide, or are both, or none?
  [[nodiscard]] bool has_choice(const FusedStep& cross) const {
    int first = 0;
    int second = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      first += wide_[cross.in[k]];
      second += wide_[cross.in[3 + k]];
    }
    return (first == 3 && (second == 0 || second == 3)) || (first == 0 && second == 0);
  }

  /// With the other components of its cross product, if all that they need is known.
  void emit_pending(ValueId id, const FusedStep& fused) {
    const auto found = crosses_.find(id);
    if (found != crosses_.end()) {
      const auto& [cross, components] = found->second;
      const auto is_known = [this](ValueId operand) { return pending_[operand] == 0; };
      if (std::all_of(cross.in.begin(), cross.in.begin() + cross.operands, is_known) &&
          std::ranges::none_of(components, is_known)) {
        PlanStep step = placed(cross);
        step.out = place_of_result(components[0]);
        for (std::size_t k = 0; k < 2; ++k) step.also_out[k] = place_of_result(components[k + 1]);
        if (wide_[id] != 0) step.wide |= wide_result;
        append(step);
        for (const ValueId component : components) pending_[component] = 0;
        return;
      }
    }
    emit_value(id, fused);
    pending_[id] = 0;
  }

  [[nodiscard]] SlotId place_of_result(ValueId id) {
    if (output_of_[id] != 0 && wide_[id] != 0) {
      written_[id] = 1;
      return place(PlaceKind::output, output_of_[id] - 1);
    }
    register_[id] = registers_.define(wide_[id] != 0, steps_->size());
    return place(PlaceKind::reg, register_[id]);
  }

  void emit_value(ValueId id, const FusedStep& fused) {
    PlanStep step = placed(fused);
    if (wide_[id] != 0) step.wide |= wide_result;
    step.out = place_of_result(id);
    append(step);
  }

  void emit_loop(int level, std::span<const ValueId> sums) {
    const bool over_lanes = lane_bit_ == 2u && level == 1;
    std::vector<SlotId> totals;
    std::vector<ValueId> bodies;
    for (const ValueId sum : sums) {
      const bool wide = over_lanes || wide_[sum] != 0;
      bodies.push_back(at(sum).a);
      if (wide && !over_lanes && loops_.empty() && output_of_[sum] != 0) {
        written_[sum] = 1;
        totals.push_back(place(PlaceKind::output, output_of_[sum] - 1));
      } else {
        register_[sum] = registers_.define(wide, steps_->size());
        totals.push_back(place(PlaceKind::reg, register_[sum]));
      }
      append({.kernel = Kernel::clear, .wide = wide ? wide_result : std::uint16_t{0}, .out = totals.back()});
    }
    const std::size_t loop = steps_->size();
    append({.kernel = Kernel::loop, .level = static_cast<std::uint8_t>(level), .over_lanes = over_lanes});
    registers_.open_loop();
    loops_.push_back({level, {}});
    const std::vector<ValueId> own(sums.begin(), sums.end());
    emit_block(level, bodies, own);
    accumulate_all(own, totals, over_lanes);
    PlanStep& opened = (*steps_)[loop];
    opened.inputs = static_cast<std::uint32_t>(plan_.loop_inputs.size());
    opened.input_count = static_cast<std::uint32_t>(loops_.back().inputs.size());
    plan_.loop_inputs.insert(plan_.loop_inputs.end(), loops_.back().inputs.begin(),
                             loops_.back().inputs.end());
    opened.end = static_cast<std::uint32_t>(steps_->size());
    loops_.pop_back();
    registers_.close_loop(steps_->size());
    for (std::size_t i = 0; i < own.size() && over_lanes; ++i) {
      registers_.use(register_[own[i]], steps_->size());
      register_[own[i]] = registers_.define(false, steps_->size());
      append({.kernel = Kernel::fold,
              .wide = 1,
              .operands = 1,
              .out = place(PlaceKind::reg, register_[own[i]]),
              .in = {totals[i]}});
    }
  }

  /// The components of a cross product in one step.
  void accumulate_all(std::span<const ValueId> sums, std::span<const SlotId> totals, bool over_lanes) {
    std::map<ValueId, FusedStep> steps;
    for (const ValueId sum : sums)
      if (const auto own = summands_.find(at(sum).a); own != summands_.end()) steps.insert(*own);
    find_crosses(steps);
    std::vector<std::uint8_t> done(sums.size(), 0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (done[i] != 0) continue;
      const auto cross = crosses_.find(at(sums[i]).a);
      if (cross == crosses_.end() || !steps.contains(at(sums[i]).a)) {
        accumulate(sums[i], totals[i], over_lanes);
        continue;
      }
      PlanStep step = placed(cross->second.step);
      step.ending = Ending::add;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found =
            std::ranges::find(sums, cross->second.components[k], [this](ValueId sum) { return at(sum).a; });
        const auto of = static_cast<std::size_t>(found - sums.begin());
        done[of] = 1;
        (k == 0 ? step.out : step.also_out[k - 1]) = totals[of];
        if (written_[sums[of]] == 0) registers_.use(register_[sums[of]], steps_->size());
      }
      if (over_lanes || wide_[sums[i]] != 0) step.wide |= wide_result;
      append(step);
    }
  }

  void accumulate(ValueId sum, SlotId total, bool over_lanes) {
    const auto own = summands_.find(at(sum).a);
    PlanStep step =
        placed(own != summands_.end() ? own->second
                                      : FusedStep{.kernel = Kernel::copy, .operands = 1, .in = {at(sum).a}});
    step.ending = Ending::add;
    step.out = total;
    if (written_[sum] == 0) registers_.use(register_[sum], steps_->size());
    if (over_lanes || wide_[sum] != 0) step.wide |= wide_result;
    append(step);
  }

  /// What was not written where it is wanted.
  void emit_outputs() {
    for (std::uint32_t i = 0; i < plan_.outputs; ++i) {
      const ValueId id = code_.outputs[i];
      if (output_of_[id] == i + 1 && written_[id] != 0) continue;
      PlanStep step{.kernel = Kernel::copy, .out = place(PlaceKind::output, i)};
      add_operand(step, id);
      if (plan_.lanes == Lanes::samples) step.wide |= wide_result;
      append(step);
    }
  }

  [[nodiscard]] SlotId place_of(ValueId id) {
    const Value& value = at(id);
    if (value.op == Instruction::input) return input_place(id);
    if (value.op == Instruction::constant) {
      return place(PlaceKind::constant, place_in(plan_.constants, value.a));
    }
    if (output_of_[id] != 0 && written_[id] != 0) return place(PlaceKind::output, output_of_[id] - 1);
    registers_.use(register_[id], steps_->size());
    return place(PlaceKind::reg, register_[id]);
  }

  [[nodiscard]] SlotId input_place(ValueId id) {
    const Value& value = at(id);
    const PlanInput wanted{value.a, value.b, wide_[id] != 0, lane_bit_ == 2u};
    std::vector<std::uint32_t>* list = root_inputs_;
    for (OpenLoop& loop : loops_) {
      if (wanted.particle == static_cast<std::uint32_t>(loop.level)) list = &loop.inputs;
    }
    const std::uint32_t input = place_in(plan_.inputs, wanted);
    if (!is_one_of(input, *list)) list->push_back(input);
    return place(PlaceKind::input, input);
  }

  void add_operand(PlanStep& step, ValueId id) {
    if (wide_[id] != 0) step.wide = static_cast<std::uint16_t>(step.wide | 1u << step.operands);
    step.in[step.operands++] = place_of(id);
  }

  void append(const PlanStep& step) { steps_->push_back(step); }

  const Code& code_;
  Plan plan_;
  Registers registers_;
  std::vector<std::uint8_t> masks_;        // by value: levels, and bit 0 if it varies from sample to sample
  std::vector<std::uint32_t> uses_;        // by value
  std::vector<std::uint32_t> block_;       // by value: where it was collected
  std::vector<std::uint32_t> visited_;     // by value: for which block
  std::vector<std::uint8_t> wide_;         // by value, in this phase
  std::vector<std::uint8_t> taken_in_;     // by value
  std::vector<RegisterId> register_;       // by value
  std::vector<std::uint32_t> output_of_;   // by value: an output that it can be written to directly, plus 1
  std::vector<std::uint8_t> written_;      // by value: it was
  std::map<ValueId, FusedStep> summands_;  // what is computed in the step that adds it to its sum
  std::map<ValueId, Cross> crosses_;       // by component
  std::vector<std::uint8_t> pending_;      // by value: its step has not been put yet
  std::vector<OpenLoop> loops_;
  std::vector<std::uint32_t>* root_inputs_ = nullptr;
  std::vector<PlanStep>* steps_ = nullptr;
  std::uint32_t current_block_ = 0;
  Phase phase_ = Phase::once;
  unsigned lane_bit_ = 0;
};

}  // namespace

Plan make_plan(const Code& code, Lanes lanes, std::span<const std::uint8_t> varies) {
  return Planner(code, lanes, varies).plan();
}

}  // namespace rigor
