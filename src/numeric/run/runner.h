// SPDX-License-Identifier: GPL-3.0-or-later
// A program for a tight loop, such as the right-hand side of a differential equation: one sample at a time,
// nothing is allocated in a call. What depends only on fixed values is computed when the runner is made.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "numeric/program/program.h"
#include "numeric/program/samples.h"

namespace rigor {

template <class T>
class Engine;

class Runner {
 public:
  /// `varying`: the components whose values each call gives, in this order; those that the program does not
  /// have are ignored. All other inputs have one value for all samples in `fixed`. `at` as for `evaluate`.
  Runner(const Program& program, const Samples& fixed, std::span<const ProgramInput> varying,
         std::span<const std::uint32_t> at = {});
  Runner(Runner&&) noexcept;
  Runner& operator=(Runner&&) noexcept;
  ~Runner();

  /// Reads a value for each of `varying`, writes the program's results.
  void operator()(const double* values, double* results);

 private:
  std::unique_ptr<Engine<double>> engine_;
  std::vector<std::vector<double>> fixed_;
  std::vector<double> values_;
};

}  // namespace rigor
