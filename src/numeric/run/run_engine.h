// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a plan on one kind of number. All memory is taken when it is made: running allocates nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "numeric/program/run_plan.h"
#include "numeric/run/run_kernels.h"

namespace rigor {

/// data[sample · sample_stride + particle · particle_stride], or, of particles too many to be held as T, what
/// `read` puts there for those from `begin` on.
template <class T>
struct BoundInput {
  const T* data = nullptr;
  std::size_t sample_stride = 0;
  std::size_t particle_stride = 0;
  std::function<void(std::size_t begin, std::span<T> into)> read = {};
};

inline constexpr std::size_t cache_line = 64;  // which no load of the widest lanes may straddle, for speed
template <class T>
inline constexpr std::size_t numbers_in_a_line = NumberTraits<T>::has_lanes ? cache_line / sizeof(T) : 0;

/// From so many particles on, a sum over them for each sample reads a copy of the samples' columns, and adds
/// up in one of the results. Columns lie anywhere: their loads and stores straddle cache lines, and those
/// whose sizes are powers of two lie whole pages apart, where they drive each other out of the nearest cache;
/// both cost up to twice the time, as addresses happen to fall. The copies are aligned and lie close
/// together.
inline constexpr std::size_t particles_worth_copies = 4;

/// How many samples of doubles are taken at once: many, because each run of a step costs its call, and few
/// enough for so many slots to stay in the nearest cache. No result depends on it.
///
/// Slots lie one behind the other. A processor may take a load for one of a store that it has not finished
/// where only their addresses in a page agree, and then begins again: a step that stores at a place in a page
/// and soon loads from that place in another takes up to five times as long, on some pages. Slots of whole
/// `lane_count`s put such a load at least sixteen widest lanes before or behind the store, or in the same
/// iteration, which loads before it stores.
[[nodiscard]] inline std::size_t fitting_samples(std::size_t slots) {
  constexpr std::size_t numbers_in_cache = 3072;  // of 4,096
  constexpr std::size_t most = 512;
  const std::size_t fitting = numbers_in_cache / std::max<std::size_t>(slots, 1);
  const std::size_t nearest = (fitting + lane_count / 2 - 1) / lane_count * lane_count;
  return std::clamp<std::size_t>(nearest, lane_count, most);
}

template <class T>
class Engine {
 public:
  Engine(const Code& code, Plan plan, std::size_t particles)
      : plan_(std::move(plan)),
        particles_(particles),
        inputs_(code.inputs.size()),
        free_(code.free_particles.size(), 0),
        slots_(plan_.slots(), nullptr) {
    std::size_t buffers = plan_.lanes == Lanes::samples ? plan_.outputs : 0;
    for (const PlanInput& input : plan_.inputs) buffers += input.wide ? 1 : 0;
    const std::size_t narrow = plan_.narrow_registers + plan_.constants.size();
    copies_ = plan_.lanes == Lanes::samples && particles_ >= particles_worth_copies &&
              std::ranges::find(plan_.each, Kernel::loop, &PlanStep::kernel) != plan_.each.end();
    if (std::is_same_v<T, double> && plan_.lanes == Lanes::samples)
      samples_at_once_ = fitting_samples(registers_of_samples() + buffers);
    const std::size_t width = samples_at_once_;  // of a wide slot
    numbers_.assign((plan_.wide_registers + buffers) * width + narrow + numbers_in_a_line<T>, T(0));
    T* next = numbers_.data();
    while (reinterpret_cast<std::uintptr_t>(next) % cache_line != 0 &&
           next != numbers_.data() + numbers_in_a_line<T>)
      ++next;
    std::size_t slot = 0;
    for (std::size_t i = 0; i < plan_.wide_registers; ++i, next += width) slots_[slot++] = next;
    T* wide_buffer = next;
    next += buffers * width;
    for (std::size_t i = 0; i < plan_.narrow_registers; ++i) slots_[slot++] = next++;
    for (const std::uint32_t constant : plan_.constants) {
      *next = number_of<T>(code.constants[constant]);
      slots_[slot++] = next++;
    }
    const auto add_buffer = [&](bool wide) {
      buffers_.push_back(wide ? wide_buffer : nullptr);
      if (wide) wide_buffer += width;
    };
    for (const PlanInput& input : plan_.inputs) add_buffer(input.wide);
    for (std::size_t i = 0; i < plan_.outputs; ++i) add_buffer(plan_.lanes == Lanes::samples);
    const auto bind_steps = [](const std::vector<PlanStep>& steps, std::vector<StepFunction<T>>& functions) {
      for (const PlanStep& step : steps)
        functions.push_back(step.kernel == Kernel::loop ? nullptr : kernels::function_for<T>(step));
    };
    bind_steps(plan_.once, once_);
    bind_steps(plan_.each, each_);
  }

  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Must outlive the runs. Every input has to be bound.
  void bind(std::size_t input, const BoundInput<T>& to) {
    inputs_[input] = to;
    if (!to.read) return;
    windows_.resize(plan_.inputs.size());
    for (std::size_t which = 0; which < plan_.inputs.size(); ++which)
      if (plan_.inputs[which].input == input) windows_[which] = {std::vector<T>(window_size)};
  }
  /// Which particle (from 0) a free particle variable is.
  void set_free_particle(std::size_t variable, std::uint32_t particle) { free_[variable] = particle; }

  /// What depends on no sample. To be called before `run`, and again when an input of it has changed.
  void run_once() {
    sample_ = 0;
    lanes_here_ = lane_count;
    set_inputs(plan_.once_inputs);
    execute(plan_.once, once_, 0, plan_.once.size());
  }

  /// results[output · stride + sample] for so many samples.
  void run(std::size_t samples, T* results, std::size_t stride) {
    const std::size_t width = plan_.lanes == Lanes::samples ? samples_at_once_ : 1;
    for (sample_ = 0; sample_ < samples; sample_ += width)
      run_batch(std::min(width, samples - sample_), results + sample_, stride);
  }

  /// One sample again and again, for plans whose lanes are not samples: `prepare_point` after binding, then
  /// `run_point` as often as the numbers that inputs are bound to change.
  void prepare_point() {
    sample_ = 0;
    lanes_here_ = lane_count;
    set_inputs(plan_.each_inputs);
  }

  void run_point(T* results) {
    T** const outputs = slots_.data() + plan_.first_output();
    for (std::size_t i = 0; i < plan_.outputs; ++i) outputs[i] = results + i;
    execute(plan_.each, each_, 0, plan_.each.size());
  }

 private:
  /// Wide registers that are used for each batch.
  [[nodiscard]] std::size_t registers_of_samples() const {
    std::vector<bool> used(plan_.wide_registers);
    for (const PlanStep& step : plan_.each)
      if ((step.wide & wide_result) != 0 && step.out < used.size()) used[step.out] = true;
    return static_cast<std::size_t>(std::ranges::count(used, true));
  }

  void run_batch(std::size_t samples, T* results, std::size_t stride) {
    lanes_here_ = plan_.lanes == Lanes::samples ? static_cast<int>(samples) : lane_count;
    const bool buffered = plan_.lanes == Lanes::samples && (copies_ || lanes_here_ % lane_step != 0);
    T** const outputs = slots_.data() + plan_.first_output();
    for (std::size_t i = 0; i < plan_.outputs; ++i)
      outputs[i] = buffered ? buffers_[plan_.inputs.size() + i] : results + i * stride;
    set_inputs(plan_.each_inputs, copies_);
    execute(plan_.each, each_, 0, plan_.each.size());
    if (!buffered) return;
    for (std::size_t i = 0; i < plan_.outputs; ++i) std::copy_n(outputs[i], samples, results + i * stride);
  }

  void execute(const std::vector<PlanStep>& steps, const std::vector<StepFunction<T>>& functions,
               std::size_t begin, std::size_t end) {
    T* const* const slots = slots_.data();
    for (std::size_t at = begin; at < end; ++at) {
      const PlanStep& step = steps[at];
      if (step.kernel == Kernel::loop) {
        loop(steps, functions, at);
        at = step.end - 1;
      } else {
        functions[at](slots, step, lanes_here_);
      }
    }
  }

  void loop(const std::vector<PlanStep>& steps, const std::vector<StepFunction<T>>& functions,
            std::size_t at) {
    const PlanStep& step = steps[at];
    const auto inputs = std::span(plan_.loop_inputs).subspan(step.inputs, step.input_count);
    const std::size_t width = step.over_lanes ? lane_count : 1;
    const int lanes_outside = lanes_here_;
    for (std::size_t particle = 0; particle < particles_; particle += width) {
      particle_[step.level] = particle;
      if (step.over_lanes) lanes_here_ = static_cast<int>(std::min(width, particles_ - particle));
      set_inputs(inputs);
      execute(steps, functions, at + 1, step.end);
    }
    lanes_here_ = lanes_outside;
  }

  void set_inputs(std::span<const std::uint32_t> which, bool copied = false) {
    for (const std::uint32_t each : which) set_input(each, copied);
  }

  /// Points the slot of an input at the numbers for this sample and these particles. Lanes that do not lie
  /// side by side, or not all of them, are gathered; lanes without a sample or particle are 0.
  void set_input(std::uint32_t which, bool copied) {
    const PlanInput& input = plan_.inputs[which];
    const BoundInput<T>& from = inputs_[input.input];
    std::size_t particle = 0;
    if (input.particle >= InputParticle::first_free) {
      particle = free_[input.particle - InputParticle::first_free];
    } else if (input.particle != InputParticle::none) {
      particle = particle_[input.particle];
    }
    const T* first = from.read ? in_window(windows_[which], from, particle)
                               : from.data + sample_ * from.sample_stride + particle * from.particle_stride;
    T*& slot = slots_[plan_.first_input() + which];
    const std::size_t stride = input.lanes_are_particles ? from.particle_stride : from.sample_stride;
    const int count = lanes_here_;
    if (!input.wide || (!copied && stride == 1 && count % lane_step == 0)) {
      slot = const_cast<T*>(first);  // operands are only read
      return;
    }
    slot = buffers_[which];
    if (stride == 1)
      std::copy_n(first, count, slot);
    else
      for (int i = 0; i < count; ++i) slot[i] = first[static_cast<std::size_t>(i) * stride];
    for (int i = count; i % lane_step != 0; ++i) slot[i] = T(0);
  }

  /// Some particles' numbers, from one that begins lanes on.
  struct Window {
    std::vector<T> numbers;
    std::size_t begin = static_cast<std::size_t>(-1);  // none yet
  };
  static constexpr std::size_t window_size = 4 * lane_count;

  const T* in_window(Window& window, const BoundInput<T>& from, std::size_t particle) {
    const std::size_t begin = particle / window_size * window_size;
    if (window.begin != begin) {
      from.read(begin, std::span(window.numbers).first(std::min(window_size, particles_ - begin)));
      window.begin = begin;
    }
    return window.numbers.data() + (particle - begin);
  }

  Plan plan_;
  std::size_t particles_;
  std::vector<BoundInput<T>> inputs_;
  std::vector<std::size_t> free_;
  std::vector<StepFunction<T>> once_;
  std::vector<StepFunction<T>> each_;
  std::vector<T> numbers_;   // wide registers, narrow registers, constants, then a buffer for each wide input
                             // and each output
  std::vector<T*> buffers_;  // by input of the plan, then by output
  std::vector<T*> slots_;
  std::vector<Window> windows_;  // by input of the plan; empty if none is needed
  std::size_t sample_ = 0;
  std::size_t particle_[deepest_level + 1] = {};
  std::size_t samples_at_once_ = lane_count;
  bool copies_ = false;          // of what all particles read and add to: see `particles_worth_copies`
  int lanes_here_ = lane_count;  // that count: samples of the batch, or particles of a loop over lanes
};

}  // namespace rigor
