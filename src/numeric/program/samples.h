// SPDX-License-Identifier: GPL-3.0-or-later
// Values for the free symbols of programs, as columns of doubles (a structure of arrays): one value for all
// samples, one for each sample, or one for each particle.
#pragma once

#include <algorithm>
#include <array>
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

/// Bounds of the errors of a column's values: the sum of what is given. Where particles are many, a rule
/// takes the place of a number for each.
struct ErrorBounds {
  double absolute = 0;     // of each value
  double relative = 0;     // to its size
  double of_distance = 0;  // to the particle's distance from the origin: √(x² + y² + z²) of
  std::array<ColumnValues, 3> places = {};
  std::shared_ptr<const std::vector<double>> each = {};  // one for each value

  [[nodiscard]] bool are_zero() const;
  /// Of value n of the column.
  [[nodiscard]] double of(std::size_t n, double value) const;
};

/// values[sample · sample_stride + particle · particle_stride]; a stride of 0: the same for all.
struct Column {
  ColumnValues values;
  std::size_t sample_stride = 0;
  std::size_t particle_stride = 0;
  std::shared_ptr<const std::vector<double>> owned = {};  // what `values` shows, unless it is borrowed
  double low = 0;                                         // to be added to a value that is the same for all
  ErrorBounds errors = {};                                // of value and low part; of 0: they are exact
  std::shared_ptr<const LongNumber> digits = {};          // more of a value that is the same for all
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

  /// Of what was put there. Arithmetic with bounds reads them. Places must outlive the samples.
  void set_errors(SymbolId symbol, std::uint32_t component, ErrorBounds errors);

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
