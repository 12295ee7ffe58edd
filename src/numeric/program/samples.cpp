// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/samples.h"

#include <cmath>

#include "base/check.h"

namespace rigor {

namespace {

Column column_of(std::vector<double> values, std::size_t sample_stride, std::size_t particle_stride) {
  const auto owned = std::make_shared<const std::vector<double>>(std::move(values));
  return {ColumnValues(*owned), sample_stride, particle_stride, owned};
}

}  // namespace

bool ErrorBounds::are_zero() const {
  const bool any_each = each != nullptr && std::ranges::any_of(*each, [](double e) { return e != 0; });
  return absolute == 0 && relative == 0 && of_distance == 0 && !any_each;
}

double ErrorBounds::of(std::size_t n, double value) const {
  double bound = absolute + relative * std::abs(value);
  if (of_distance != 0) {
    double square = 0;
    for (const ColumnValues& x : places) square += x[n] * x[n];
    bound += of_distance * std::sqrt(square);
  }
  return each == nullptr ? bound : bound + (*each)[n];
}

void Samples::put(SymbolId symbol, std::uint32_t component, std::vector<double> values,
                  std::size_t sample_stride, std::size_t particle_stride) {
  columns_[{symbol, component}] = column_of(std::move(values), sample_stride, particle_stride);
}

void Samples::set(SymbolId symbol, std::uint32_t component, double value) {
  put(symbol, component, {value}, 0, 0);
}

void Samples::set(SymbolId symbol, std::uint32_t component, const HighLow& value) {
  set(symbol, component, value.high);
  columns_[{symbol, component}].low = value.low;
}

void Samples::set_digits(SymbolId symbol, std::uint32_t component, LongNumber digits) {
  columns_.at({symbol, component}).digits = std::make_shared<const LongNumber>(std::move(digits));
}

void Samples::set_each(SymbolId symbol, std::uint32_t component, std::vector<double> values) {
  RIGOR_CHECK(values.size() == samples_, values.size(), samples_);
  put(symbol, component, std::move(values), 1, 0);
}

void Samples::set_particles(SymbolId symbol, std::uint32_t component, std::vector<double> values) {
  RIGOR_CHECK(values.size() == particles_, values.size(), particles_);
  put(symbol, component, std::move(values), 0, 1);
}

void Samples::borrow_particles(SymbolId symbol, std::uint32_t component, std::span<const double> values) {
  RIGOR_CHECK(values.size() == particles_, values.size(), particles_);
  columns_[{symbol, component}] = {ColumnValues(values), 0, 1};
}

void Samples::set_particles_each(SymbolId symbol, std::uint32_t component, std::vector<double> values) {
  RIGOR_CHECK(values.size() == particles_ * samples_, values.size(), particles_, samples_);
  put(symbol, component, std::move(values), 1, samples_);
}

void Samples::set_errors(SymbolId symbol, std::uint32_t component, ErrorBounds errors) {
  Column& column = columns_.at({symbol, component});
  const std::size_t count = column.values.size();
  RIGOR_CHECK(errors.each == nullptr || errors.each->size() == count, errors.each->size(), count);
  RIGOR_CHECK(errors.of_distance == 0 || errors.places[0].size() == count, errors.places[0].size(), count);
  column.errors = std::move(errors);
}

Samples Samples::only(std::span<const std::size_t> which) const {
  Samples chosen(which.size(), particles_);
  for (const auto& [key, column] : columns_) {
    if (column.sample_stride == 0) {
      chosen.columns_[key] = column;
      chosen.columns_[key].errors = {};
      continue;
    }
    const std::size_t particles = column.particle_stride == 0 ? 1 : particles_;
    std::vector<double> values;
    for (std::size_t particle = 0; particle < particles; ++particle) {
      for (const std::size_t sample : which)
        values.push_back(column.values[sample * column.sample_stride + particle * column.particle_stride]);
    }
    chosen.columns_[key] = column_of(std::move(values), 1, column.particle_stride == 0 ? 0 : which.size());
  }
  return chosen;
}

Samples Samples::rounded_to_float() const {
  Samples rounded(samples_, particles_);
  for (const auto& [key, column] : columns_) {
    std::vector<double> values;
    for (const double value : column.values) values.push_back(static_cast<double>(static_cast<float>(value)));
    rounded.columns_[key] = column_of(std::move(values), column.sample_stride, column.particle_stride);
  }
  return rounded;
}

const Column* Samples::find(SymbolId symbol, std::uint32_t component) const {
  const auto found = columns_.find({symbol, component});
  return found == columns_.end() ? nullptr : &found->second;
}

}  // namespace rigor
