// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/runner.h"

#include <algorithm>

#include "base/check.h"
#include "numeric/run/run_engine.h"

namespace rigor {

extern template class Engine<double>;

Runner::Runner(const Program& program, const Samples& fixed, std::span<const ProgramInput> varying,
               std::span<const std::uint32_t> at)
    : values_(varying.size(), 0.0) {
  const auto inputs = program.inputs();
  std::vector<std::uint8_t> varies;
  for (const ProgramInput& input : inputs) {
    const auto same = [&](const ProgramInput& other) {
      return other.symbol == input.symbol && other.component == input.component;
    };
    varies.push_back(std::ranges::any_of(varying, same) ? 1 : 0);
  }
  const Lanes lanes = fixed.particles() >= many_particles ? Lanes::particles : Lanes::one;
  engine_ = std::make_unique<Engine<double>>(program.code(), make_plan(program.code(), lanes, varies),
                                             fixed.particles());
  fixed_.resize(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (varies[i] != 0) continue;
    const Column* column = fixed.find(inputs[i].symbol, inputs[i].component);
    RIGOR_CHECK(column != nullptr && column->sample_stride == 0, static_cast<std::uint32_t>(inputs[i].symbol),
                inputs[i].component);
    fixed_[i].assign(column->values.begin(), column->values.end());
    engine_->bind(i, {fixed_[i].data(), 0, column->particle_stride});
  }
  for (std::size_t k = 0; k < varying.size(); ++k) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (varying[k].symbol == inputs[i].symbol && varying[k].component == inputs[i].component)
        engine_->bind(i, {&values_[k], 0, 0});
    }
  }
  RIGOR_CHECK(at.size() >= program.free_particles().size(), at.size(), program.free_particles().size());
  for (std::size_t i = 0; i < program.free_particles().size(); ++i) {
    RIGOR_CHECK(at[i] < fixed.particles(), at[i], fixed.particles());
    engine_->set_free_particle(i, at[i]);
  }
  engine_->run_once();
  engine_->prepare_point();
}

Runner::Runner(Runner&&) noexcept = default;
Runner& Runner::operator=(Runner&&) noexcept = default;
Runner::~Runner() = default;

void Runner::operator()(const double* values, double* results) {
  std::copy_n(values, values_.size(), values_.data());
  engine_->run_point(results);
}

}  // namespace rigor
