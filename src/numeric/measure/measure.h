// SPDX-License-Identifier: GPL-3.0-or-later
// What a program costs in each arithmetic, and how wrong it is for the given doubles. A vector or tensor
// counts as one result, by its largest component: relative error = max_k |computed_k − exact_k| / max_k
// |exact_k|. Exact values have 40 digits at least (`reference.h`). For float the samples are rounded to float
// first and the exact values are those of the rounded numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "numeric/measure/evaluate.h"

namespace rigor {

/// Over samples.
struct Spread {
  double worst = 0.0;
  double median = 0.0;  // the upper one of two
};

inline constexpr double unit_roundoff = 0x1p-53;  // of double

struct ErrorMeasure {
  Arithmetic arithmetic = Arithmetic::plain;
  std::size_t compared = 0;  // samples whose exact value is known and not 0
  Spread relative;           // overflow and NaN count as infinite
  Spread ulps;       // |error| in units in the last place (of this arithmetic) of the largest exact component
  Spread bits_kept;  // −log₂ of the relative error, from 0 to the length of the significand
  double right_bits = 0;  // that length: 24, 53, 64, 106
  // Counts of samples.
  std::size_t overflows = 0;     // infinite, or beyond, where the exact value is in the range of double
  std::size_t not_a_number = 0;  // where there is an exact value
  std::size_t wrong_signs = 0;  // of scalars: exact and computed value have opposite signs, or 0 was computed
  std::size_t zeros = 0;        // the exact value is 0: out of the statistics above
  double worst_at_zero = 0.0;   // the largest |computed| there, infinite for what is not finite
  std::size_t undefined = 0;    // no exact value
  std::size_t unknown = 0;      // the exact value is not known to enough digits
  double nanoseconds = 0.0;     // a sample; 0: not measured
};

struct FormMeasure {
  std::array<ErrorMeasure, arithmetic_count> arithmetics;
  Spread condition;                 // over the samples that have one
  std::size_t condition_known = 0;  // for so many; 0: it would take too long
  std::size_t measured = 0;         // samples whose errors were measured: the first ones; 0: a single one
                                    // would take more than `MeasureOptions::operations`
};

struct MeasureOptions {
  double milliseconds = 2.0;  // for the time of each arithmetic, once at least; 0: time is not measured
  std::size_t operations = 4'000'000;  // with many digits, for errors and condition
};

/// Operations for one sample, loops within loops included: with N particles an operation in k of them counts
/// N^k. At least 1; the largest number where it would be more. `operation`, `function`: what one of these
/// counts; functions are sin, exp and the like.
[[nodiscard]] std::size_t work_of(const Program& program, const Samples& samples, std::size_t operation = 1,
                                  std::size_t function = 1);
[[nodiscard]] std::size_t work_of(const Program& program, std::size_t particles, std::size_t operation = 1,
                                  std::size_t function = 1);
/// N^k for so many levels (`LevelMask`), or the largest number.
[[nodiscard]] std::size_t tuples_of(unsigned levels, std::size_t particles);

/// For one form. The time is the least one of several runs over the samples, which are repeated up to 1,024
/// if there is more than one; what they have in common is computed in each run.
[[nodiscard]] FormMeasure measure(const Program& program, const Samples& samples,
                                  const MeasureOptions& options = {}, std::span<const std::uint32_t> at = {});

/// The least time of a run over all samples, in nanoseconds a sample.
[[nodiscard]] double time_of(const Program& program, const Samples& samples, Arithmetic arithmetic,
                             double milliseconds, std::span<const std::uint32_t> at = {});

}  // namespace rigor
