// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/samples.h"

#include "base/check.h"

namespace rigor {

void Samples::set(SymbolId symbol, std::uint32_t component, double value) {
  columns_[{symbol, component}] = {{value}, 0, 0};
}

void Samples::set_each(SymbolId symbol, std::uint32_t component, std::vector<double> values) {
  RIGOR_CHECK(values.size() == samples_, values.size(), samples_);
  columns_[{symbol, component}] = {std::move(values), 1, 0};
}

void Samples::set_particles(SymbolId symbol, std::uint32_t component, std::vector<double> values) {
  RIGOR_CHECK(values.size() == particles_, values.size(), particles_);
  columns_[{symbol, component}] = {std::move(values), 0, 1};
}

void Samples::set_particles_each(SymbolId symbol, std::uint32_t component, std::vector<double> values) {
  RIGOR_CHECK(values.size() == particles_ * samples_, values.size(), particles_, samples_);
  columns_[{symbol, component}] = {std::move(values), 1, samples_};
}

Samples Samples::only(std::span<const std::size_t> which) const {
  Samples chosen(which.size(), particles_);
  for (const auto& [key, column] : columns_) {
    Column& own = chosen.columns_[key];
    own = column;
    if (column.sample_stride == 0) continue;
    const std::size_t particles = column.particle_stride == 0 ? 1 : particles_;
    own.sample_stride = 1;
    own.particle_stride = column.particle_stride == 0 ? 0 : which.size();
    own.values.clear();
    for (std::size_t particle = 0; particle < particles; ++particle) {
      for (const std::size_t sample : which)
        own.values.push_back(
            column.values[sample * column.sample_stride + particle * column.particle_stride]);
    }
  }
  return chosen;
}

Samples Samples::rounded_to_float() const {
  Samples rounded = *this;
  for (auto& [key, column] : rounded.columns_) {
    for (double& value : column.values) value = static_cast<double>(static_cast<float>(value));
  }
  return rounded;
}

const Column* Samples::find(SymbolId symbol, std::uint32_t component) const {
  const auto found = columns_.find({symbol, component});
  return found == columns_.end() ? nullptr : &found->second;
}

}  // namespace rigor
