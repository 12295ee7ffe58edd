// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a plan on one kind of number. All memory is taken when it is made: running allocates nothing.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "numeric/program/run_plan.h"
#include "numeric/run/run_kernels.h"

namespace rigor {

/// data[sample · sample_stride + particle · particle_stride]
template <class T>
struct BoundInput {
  const T* data = nullptr;
  std::size_t sample_stride = 0;
  std::size_t particle_stride = 0;
};

template <class T>
class Engine {
 public:
  Engine(const Code& code, Plan plan, std::size_t particles);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Must outlive the runs. Every input has to be bound.
  void bind(std::size_t input, const BoundInput<T>& to) { inputs_[input] = to; }
  /// Which particle (from 0) a free particle variable is.
  void set_free_particle(std::size_t variable, std::uint32_t particle) { free_[variable] = particle; }

  /// What depends on no sample. To be called before `run`, and again when an input of it has changed.
  void run_once();
  /// results[output · stride + sample] for so many samples.
  void run(std::size_t samples, T* results, std::size_t stride);

  /// One sample again and again, for plans whose lanes are not samples: `prepare_point` after binding, then
  /// `run_point` as often as the numbers that inputs are bound to change.
  void prepare_point();
  void run_point(T* results);

 private:
  void run_batch(std::size_t samples, T* results, std::size_t stride);
  void execute(const std::vector<PlanStep>& steps, const std::vector<StepFunction<T>>& functions,
               std::size_t begin, std::size_t end);
  void loop(const std::vector<PlanStep>& steps, const std::vector<StepFunction<T>>& functions,
            std::size_t at);
  void set_inputs(std::span<const std::uint32_t> which);
  void set_input(std::uint32_t which);

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
  std::size_t sample_ = 0;
  std::size_t particle_[deepest_level + 1] = {};
  int samples_here_ = 1;    // of the batch
  int particles_here_ = 0;  // of a loop over lanes
};

}  // namespace rigor

#include "numeric/run/run_engine_parts.h"
