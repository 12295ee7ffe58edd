// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/body_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/lane/double_double.h"

namespace rigor {
namespace {

constexpr double upwards = 1 + 0x1p-20;

/// |E_ij|, entry by entry: residual, error as given, and the rounding of the residual.
InertiaTensor residual_of(const Body& body, const SecondMoments& second) {
  InertiaTensor residual{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      HighLow sum{};
      for (std::size_t k = 0; k < 6; k += 2)
        sum = sum + baseline::exact_product(body.positions[i][k], body.positions[j][k]);
      const double size = std::sqrt(std::abs(second.moments[i][i].high * second.moments[j][j].high));
      residual[i][j] =
          (std::abs((sum / HighLow{3, 0} - second.moments[i][j]).high) + second.error + 0x1p-98 * size) *
          upwards;
    }
  }
  return residual;
}

/// |n_a · E n_b| at most.
InertiaTensor along(const std::array<Position, 3>& axes, const InertiaTensor& entries) {
  InertiaTensor turned{};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
          turned[a][b] += std::abs(axes[a][i]) * std::abs(axes[b][j]) * entries[i][j];
      }
    }
  }
  return turned;
}

}  // namespace

ErrorBounds place_errors(const Body& body, std::size_t axis) {
  const BodyErrors& errors = body.errors;
  ErrorBounds bounds{.absolute = errors.shift * upwards, .relative = errors.place * upwards};
  if (errors.each[axis].empty()) return bounds;
  std::vector<double> each = errors.each[axis];
  for (double& error : each) error *= upwards;
  bounds.each = std::make_shared<const std::vector<double>>(std::move(each));
  return bounds;
}

ErrorBounds turned_place_errors(const Body& body, double turning) {
  const BodyErrors& errors = body.errors;
  constexpr double most_components = 1.7320508075688774;  // |x| + |y| + |z| over the distance: √3
  const double rounding = turning + 4 * 0x1p-53;          // sin θ and 3 roundings, and
  constexpr double lost = 0x1p-500;                       // what squares lost below the normal range
  ErrorBounds bounds{.absolute = (3 * errors.shift + rounding * lost) * upwards,
                     .of_distance = (errors.place * most_components + rounding) * upwards};
  for (std::size_t i = 0; i < 3; ++i) bounds.places[i] = ColumnValues(body.positions[i]);
  std::vector<double> each;
  for (const std::vector<double>& along : errors.each) {
    each.resize(std::max(each.size(), along.size()));
    for (std::size_t k = 0; k < along.size(); ++k) each[k] += along[k] * upwards;
  }
  if (!each.empty()) bounds.each = std::make_shared<const std::vector<double>>(std::move(each));
  return bounds;
}

double inertia_error(const Body& body) {
  const std::array<ErrorBounds, 3> errors{place_errors(body, 0), place_errors(body, 1),
                                          place_errors(body, 2)};
  double sum = 0;
  for (std::size_t k = 0; k < body.size(); ++k) {
    double square = 0;
    double change = 0;  // of the square
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = std::abs(body.positions[axis][k]);
      const double error = errors[axis].of(k, x);
      square += x * x;
      change += 2 * x * error + error * error;
    }
    sum += body.masses[k] * (change + body.errors.mass * (square + change));
  }
  // Off the diagonal x δy + y δx + δx δy is less; a centre that moves takes away no more than it adds.
  return 2 * sum * (1 + 0x1p-10);
}

std::array<std::vector<double>, 3> equimomental_errors(const Body& body, const std::array<Position, 3>& axes,
                                                       const SecondMoments& second) {
  InertiaTensor e = along(axes, residual_of(body, second));
  Position length{};  // √λ_k, ascending
  for (std::size_t k = 0; k < 3; ++k) {
    const Position r = body.position(2 * k);
    length[k] = std::sqrt((r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) / 3);
  }
  const auto is_long = [&](std::size_t k) { return length[k] * length[k] > 4 * e[k][k]; };
  for (std::size_t k = 3; k-- > 0;) {
    for (std::size_t l = k + 1; l < 3; ++l)
      if (is_long(l)) e[k][k] += 2 * e[k][l] / length[l] * (e[k][l] / length[l]);
  }
  InertiaTensor off{};  // of column k along n_a
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t a = 0; a <= k; ++a) {
      const double most = std::sqrt(length[a] * length[a] + e[a][a]);
      off[k][a] = is_long(k) ? std::min(most, (a == k ? 1 : 2) * e[a][k] / length[k]) : most;
    }
  }
  std::array<std::vector<double>, 3> errors;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t particle = 0; particle < 6; ++particle) {
      const std::size_t k = particle / 2;
      double error = 0;
      for (std::size_t a = 0; a < 3; ++a) error += std::abs(axes[a][i]) * off[k][a];
      errors[i].push_back(std::sqrt(3.0) * error * upwards);
    }
  }
  return errors;
}

}  // namespace rigor
