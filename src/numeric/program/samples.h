// SPDX-License-Identifier: GPL-3.0-or-later
// Values for the free symbols of programs, as columns of doubles (a structure of arrays): one value for all
// samples, one for each sample, or one for each particle.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "expr/tree/symbol.h"
#include "numeric/exact/long_number.h"
#include "numeric/kernels/high_low.h"

namespace rigor {

/// Numbers that somebody else holds; becomes a vector where one is wanted.
struct ColumnValues : std::span<const double> {
  ColumnValues() = default;
  explicit ColumnValues(std::span<const double> values) : std::span<const double>(values) {}
  operator std::vector<double>() const { return {begin(), end()}; }  // NOLINT: meant to convert
  friend bool operator==(const ColumnValues& a, const ColumnValues& b) { return std::ranges::equal(a, b); }
  friend bool operator==(const ColumnValues& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b);
  }
};

/// values[sample · sample_stride + particle · particle_stride]; a stride of 0: the same for all.
struct Column {
  ColumnValues values;
  std::size_t sample_stride = 0;
  std::size_t particle_stride = 0;
  std::shared_ptr<const std::vector<double>> owned = {};   // what `values` shows, unless it is borrowed
  double low = 0;                                          // to be added to a value that is the same for all
  std::shared_ptr<const std::vector<double>> errors = {};  // bounds, of each value or of all; none: exact
  std::shared_ptr<const LongNumber> digits = {};           // more of a value that is the same for all

  /// Of how far the exact number may be from value n and the low part.
  [[nodiscard]] double error(std::size_t n) const {
    if (errors == nullptr) return 0;
    return errors->size() == 1 ? errors->front() : (*errors)[n];
  }
};

class Samples {
 public:
  Samples(std::size_t samples, std::size_t particles) : samples_(samples), particles_(particles) {}

  [[nodiscard]] std::size_t samples() const { return samples_; }
  [[nodiscard]] std::size_t particles() const { return particles_; }

  /// The same for all samples (and particles).
  void set(SymbolId symbol, std::uint32_t component, double value);
  /// The same to about 106 bits: arithmetic of more than 53 bits computes with high + low.
  void set(SymbolId symbol, std::uint32_t component, const HighLow& value);
  /// More digits of what was set, for all samples: arithmetic with bounds computes with these instead.
  void set_digits(SymbolId symbol, std::uint32_t component, LongNumber digits);
  /// One for each sample.
  void set_each(SymbolId symbol, std::uint32_t component, std::vector<double> values);
  /// One for each particle, the same for all samples.
  void set_particles(SymbolId symbol, std::uint32_t component, std::vector<double> values);
  /// The same without a copy: the values must outlive the samples.
  void borrow_particles(SymbolId symbol, std::uint32_t component, std::span<const double> values);
  /// One for each particle of each sample: values[particle · samples + sample].
  void set_particles_each(SymbolId symbol, std::uint32_t component, std::vector<double> values);

  /// Bounds of the errors of what was put there: one for each value, or one for all. Arithmetic with bounds
  /// reads them.
  void set_errors(SymbolId symbol, std::uint32_t component, std::vector<double> errors);

  /// Some of the samples, in the given order; one may be taken several times. Without errors.
  [[nodiscard]] Samples only(std::span<const std::size_t> which) const;
  /// The same with every number as the nearest float.
  [[nodiscard]] Samples rounded_to_float() const;

  [[nodiscard]] const Column* find(SymbolId symbol, std::uint32_t component) const;

 private:
  void put(SymbolId symbol, std::uint32_t component, std::vector<double> values, std::size_t sample_stride,
           std::size_t particle_stride);

  std::size_t samples_;
  std::size_t particles_;
  std::map<std::pair<SymbolId, std::uint32_t>, Column> columns_;
};

}  // namespace rigor
