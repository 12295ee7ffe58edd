// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/mass_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "numeric/kernels/point_pass.h"
#include "numeric/kernels/point_sample.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

/// Bounds k of the header: errors of second, first and zeroth moments before the move, and the last rounding.
struct MomentRoundings {
  std::array<double, 3> of_order;
  double last;
};
constexpr MomentRoundings plain_roundings{{14 * u, 12 * u, 10 * u}, u};
constexpr MomentRoundings sharp_roundings{{0x1p-95, 0x1p-95, 0x1p-95}, u};

/// Sums about a centre, and what follows from them; in scaled units.
struct PointMoments {
  HighLow mass;
  SharpPosition centre;
  SharpTensor inertia;
  double greatest = 0;        // entry
  double error = 0;           // relative to it
  double underflow = 0;       // the part of it that is due to underflow
  double moved_fraction = 0;  // greatest ε_i
};

HighLow number(const PointSums& sums, std::size_t q) { return {sums.high[q], sums.low[q]}; }

/// The place of d_i d_j among the sums.
std::size_t second_moment(std::size_t i, std::size_t j) {
  return i == j ? PointSums::square + i : PointSums::product + 3 - i - j;
}

bool is_finite(const PointSums& sums) {
  return std::ranges::all_of(sums.high, [](double x) { return std::isfinite(x); });
}

double sum_of_squares(const PointSums& sums) {
  return sums.high[PointSums::square] + sums.high[PointSums::square + 1] + sums.high[PointSums::square + 2];
}

/// No intermediate result left the range: where a product m d underflows, it loses at most 2^-538 √T for
/// T = Σ m d², because m ≥ 2^-1074; against T ≥ 2^-800 that is nothing, for any number of points.
bool is_in_range(const PointSums& sums) {
  if (!is_finite(sums) || sums.is_wide) return false;
  const double mass = sums.high[PointSums::mass];
  const double squares = sum_of_squares(sums);
  return mass >= 0x1p-900 && mass <= 0x1p900 && squares >= 0x1p-800 && squares <= 0x1p900;
}

/// δI_ij of the header, the greatest.
double greatest_error(const std::array<double, 3>& extent, const std::array<double, 3>& moved,
                      const std::array<double, 3>& k) {
  std::array<double, 3> diagonal{};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double error =
          extent[i] * extent[j] * (k[0] + k[1] * (moved[i] + moved[j]) + k[2] * moved[i] * moved[j]);
      if (i == j)
        diagonal[i] = error;
      else
        greatest = std::max(greatest, error);
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    greatest = std::max(greatest, diagonal[(i + 1) % 3] + diagonal[(i + 2) % 3]);
  return greatest;
}

/// The move from the centre s to the centre of mass, in double-double: some 40 u² on top of what the sums
/// have.
PointMoments moved_to_centre(const PointSums& sums, const SharpPosition& s,
                             const MomentRoundings& roundings) {
  PointMoments result;
  result.mass = number(sums, PointSums::mass);
  SharpPosition shift;
  std::array<double, 3> extent{};
  std::array<double, 3> moved{};
  for (std::size_t i = 0; i < 3; ++i) {
    const HighLow first = number(sums, PointSums::first + i);
    shift[i] = first / result.mass;
    result.centre[i] = s[i] + shift[i];
    extent[i] = std::sqrt(sums.high[PointSums::square + i]);
    const double part = std::sqrt(result.mass.high) * std::abs(shift[i].high);
    moved[i] = extent[i] > 0 ? std::min(1.0, part / extent[i]) : 0;
    result.moved_fraction = std::max(result.moved_fraction, moved[i] * moved[i]);
  }
  SharpTensor second;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      second[i][j] = number(sums, second_moment(i, j)) - number(sums, PointSums::first + i) * shift[j];
      second[j][i] = second[i][j];
    }
    if (second[i][i].high < 0) second[i][i] = {};  // Σ m d² ≥ 0: what is less is rounding
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.inertia[i][j] =
          i == j ? second[(i + 1) % 3][(i + 1) % 3] + second[(i + 2) % 3][(i + 2) % 3] : -second[i][j];
      result.greatest = std::max(result.greatest, std::abs(result.inertia[i][j].high));
    }
  }
  const double error = greatest_error(extent, moved, roundings.of_order);
  result.error = error == 0 ? 0 : error / result.greatest * (1 + 0x1p-40) + roundings.last;
  return result;
}

/// Passes until the bound is met: about the sampled centre, about the centre that it gives, and in
/// double-double, there until the move to the centre takes away little.
class MomentFinder {
 public:
  MomentFinder(const PointColumns& points, const SumOptions& options) : points_(points), options_(options) {}

  struct FoundMoments {
    PointMoments moments;
    PointScale scale;
    bool compensated = false;
  };

  Result<FoundMoments> find(bool compensated) {
    constexpr int plain_passes = 2;
    constexpr int most_sharp_passes = 16;  // each leaves 2^-90 of the distance of the centre before
    constexpr double most_moved = 0.25;
    if (points_.count == 0) return refuse("the body has no particles");
    RIGOR_CHECK(points_.stride == 1 || points_.stride == 4, points_.stride);
    centre_ = sampled_centre(points_, scale_);
    for (int pass = compensated ? plain_passes : 0; pass < plain_passes; ++pass) {
      const auto moments = about_centre(lane_kernels().sum_points, plain_roundings);
      if (!moments) return tl::unexpected(moments.error());
      if (moments->error <= plain_error_limit) return FoundMoments{*moments, scale_, false};
      for (std::size_t i = 0; i < 3; ++i) centre_[i] = {moments->centre[i].high, 0};
    }
    for (int pass = 1;; ++pass) {
      const auto moments = about_centre(lane_kernels().sum_points_sharply, sharp_roundings);
      if (!moments) return tl::unexpected(moments.error());
      if (moments->moved_fraction <= most_moved) return FoundMoments{*moments, scale_, true};
      if (pass == most_sharp_passes) return refuse("the masses differ too much for a centre of mass");
      centre_ = moments->centre;
    }
  }

 private:
  Result<PointMoments> about_centre(SumPoints sum, const MomentRoundings& roundings) {
    PointSums sums = point_pass(sum, points_, scale_, centre_, options_.threads);
    const bool in_range = is_in_range(sums);
    if (!checked_ && (sums.has_sign || !in_range)) {
      if (const auto checked = check_points(points_); !checked) return tl::unexpected(checked.error());
      checked_ = true;
    }
    if (!scaled_ && !in_range) {
      scale_points(is_finite(sums));
      sums = point_pass(sum, points_, scale_, centre_, options_.threads);
      RIGOR_CHECK(is_finite(sums), scale_.length, scale_.mass);
    }
    PointMoments moments = moved_to_centre(sums, centre_, roundings);
    if (scaled_ && !coincident_) moments.underflow = underflow_error(moments);
    moments.error += moments.underflow;
    return moments;
  }

  /// The centre is kept where it came from sums.
  void scale_points(bool keeps_centre) {
    const PointReach reach = reach_of(points_);
    scale_ = reach.scale;
    coincident_ = reach.coincident;
    scaled_ = true;
    if (keeps_centre)
      for (HighLow& x : centre_) x = {std::ldexp(x.high, scale_.length), std::ldexp(x.low, scale_.length)};
    else
      centre_ = sampled_centre(points_, scale_);
  }

  /// Of scaled points. Distances are below 4: a mass or a product that underflows loses at most 2^-1070 of a
  /// sum, a coordinate 2^-1072 √(M I) of an entry of I by the Cauchy–Schwarz inequality.
  [[nodiscard]] double underflow_error(const PointMoments& moments) const {
    return static_cast<double>(points_.count) * 0x1p-1068 / moments.greatest +
           0x1p-1070 * std::sqrt(moments.mass.high) / std::sqrt(moments.greatest);
  }

  const PointColumns& points_;
  const SumOptions& options_;
  SharpPosition centre_{};
  PointScale scale_{};
  bool checked_ = false;
  bool scaled_ = false;
  bool coincident_ = false;
};

HighLow scaled(const HighLow& x, int exponent) {
  if (exponent == 0) return x;  // as a rule, and `ldexp` takes its time
  return {std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}

SharpPosition unscaled_centre(const MomentFinder::FoundMoments& found) {
  SharpPosition centre;
  for (std::size_t i = 0; i < 3; ++i) centre[i] = scaled(found.moments.centre[i], -found.scale.length);
  return centre;
}

/// The bound of `SharpMassSums`, relative to the greatest entry.
double sharp_error(const PointMoments& moments, double greatest) {
  if (moments.greatest == 0) return 0;  // all points are at one place
  if (!(greatest >= 0x1p-900)) return std::numeric_limits<double>::infinity();
  return 0x1p-91 + moments.underflow;
}

Result<SharpMassSums> unscaled(const MomentFinder::FoundMoments& found) {
  const auto& [moments, scale, compensated] = found;
  SharpMassSums result;
  result.error = sharp_error(moments, std::ldexp(moments.greatest, -scale.mass - 2 * scale.length));
  result.mass = scaled(moments.mass, -scale.mass);
  if (!std::isfinite(result.mass.high)) return refuse("the sum of the masses overflows");
  result.centre = unscaled_centre(found);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.inertia[i][j] = scaled(moments.inertia[i][j], -scale.mass - 2 * scale.length);
      if (!std::isfinite(result.inertia[i][j].high)) return refuse("the inertia tensor overflows");
    }
  }
  return result;
}

}  // namespace

PointColumns point_records(const double* records, std::size_t count) {
  return {{records, records + 1, records + 2}, records + 3, count, 4};
}

Result<MassSums> mass_sums(const PointColumns& points, const SumOptions& options) {
  const auto found = MomentFinder(points, options).find(false);
  if (!found) return tl::unexpected(found.error());
  const auto sums = unscaled(*found);
  if (!sums) return tl::unexpected(sums.error());
  MassSums result;
  result.mass = sums->mass.high;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = sums->centre[i].high;
    for (std::size_t j = 0; j < 3; ++j) result.inertia[i][j] = sums->inertia[i][j].high;
  }
  const double greatest = std::ldexp(found->moments.greatest, -found->scale.mass - 2 * found->scale.length);
  result.error = found->moments.error;
  if (result.error > 0) result.error += 0x1p-1074 / greatest;  // the last rounding of what is not normal
  result.compensated = found->compensated;
  return result;
}

Result<SharpMassSums> sharp_mass_sums(const PointColumns& points, const SumOptions& options) {
  return MomentFinder(points, options).find(true).and_then(unscaled);
}

Result<SharpPosition> sharp_centre_of_mass(const PointColumns& points, const SumOptions& options) {
  return MomentFinder(points, options).find(true).map(unscaled_centre);
}

}  // namespace rigor
