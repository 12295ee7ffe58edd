// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/run_registers.h"

#include <algorithm>

namespace rigor {

std::uint32_t Registers::Pool::take() {
  if (free.empty()) return size++;
  const std::uint32_t chosen = free.back();
  free.pop_back();
  return chosen;
}

void Registers::begin(bool kept) {
  phase_begin_ = ranges_.size();
  kept_ = kept;
}

RegisterId Registers::define(bool wide, std::size_t position) {
  const auto at = static_cast<std::uint32_t>(position);
  const auto depth = static_cast<std::uint32_t>(loops_.size());
  ranges_.push_back({wide, kept_ && !wide && depth == 0, at, at, depth, 0});
  return static_cast<RegisterId>(ranges_.size() - 1);
}

void Registers::use(RegisterId id, std::size_t position) {
  Range& range = ranges_[id];
  if (id < phase_begin_) return;  // kept from the phase before
  range.last = std::max(range.last, static_cast<std::uint32_t>(position));
  if (range.depth < loops_.size()) loops_[range.depth].push_back(id);
}

void Registers::close_loop(std::size_t position) {
  for (const RegisterId id : loops_.back())
    ranges_[id].last = std::max(ranges_[id].last, static_cast<std::uint32_t>(position));
  loops_.pop_back();
}

void Registers::end() {
  std::vector<RegisterId> by_end;
  for (std::size_t id = phase_begin_; id < ranges_.size(); ++id)
    by_end.push_back(static_cast<RegisterId>(id));
  std::ranges::sort(by_end, [this](RegisterId a, RegisterId b) {
    return ranges_[a].last != ranges_[b].last ? ranges_[a].last < ranges_[b].last : a < b;
  });
  std::size_t expired = 0;
  const auto free_next = [&] {
    const Range& over = ranges_[by_end[expired++]];
    if (!over.kept) (over.wide ? wide_ : narrow_).free.push_back(over.chosen);
  };
  for (std::size_t id = phase_begin_; id < ranges_.size(); ++id) {
    Range& range = ranges_[id];
    // What ends where this begins is an operand of the same step, or ended with a loop: it may be
    // overwritten.
    while (expired < by_end.size() && ranges_[by_end[expired]].last <= range.first &&
           ranges_[by_end[expired]].first < range.first)
      free_next();
    range.chosen = (range.wide ? wide_ : narrow_).take();
  }
  while (expired < by_end.size()) free_next();
}

void Registers::settle(Plan& plan) const {
  plan.wide_registers = wide_.size;
  plan.narrow_registers = narrow_.size;
  const auto final_slot = [&](SlotId slot) -> SlotId {
    const std::uint32_t index = slot & 0x0fffffffu;
    switch (static_cast<PlaceKind>(slot >> 28)) {
      case PlaceKind::reg:
        return ranges_[index].chosen + (ranges_[index].wide ? 0 : plan.wide_registers);
      case PlaceKind::constant:
        return plan.first_constant() + index;
      case PlaceKind::input:
        return plan.first_input() + index;
      case PlaceKind::output:
        return plan.first_output() + index;
    }
    return slot;
  };
  for (std::vector<PlanStep>* steps : {&plan.once, &plan.each}) {
    for (PlanStep& step : *steps) {
      if (step.kernel == Kernel::loop) continue;
      step.out = final_slot(step.out);
      for (SlotId& out : step.also_out)
        if (step.kernel == Kernel::cross) out = final_slot(out);
      if (step.factor != no_slot) step.factor = final_slot(step.factor);
      for (std::size_t i = 0; i < step.operands; ++i) step.in[i] = final_slot(step.in[i]);
    }
  }
}

}  // namespace rigor
