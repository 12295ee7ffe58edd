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

const Column* Samples::find(SymbolId symbol, std::uint32_t component) const {
  const auto found = columns_.find({symbol, component});
  return found == columns_.end() ? nullptr : &found->second;
}

}  // namespace rigor
