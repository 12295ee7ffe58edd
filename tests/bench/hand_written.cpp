// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_written.h"

#include <algorithm>

namespace rigor::bench {

void cross_square(const Columns& a, const Columns& b, std::size_t samples, double* __restrict result) {
  for (std::size_t i = 0; i < samples; ++i) {
    const double x = a[1][i] * b[2][i] - a[2][i] * b[1][i];
    const double y = a[2][i] * b[0][i] - a[0][i] * b[2][i];
    const double z = a[0][i] * b[1][i] - a[1][i] * b[0][i];
    result[i] = x * x + y * y + z * z;
  }
}

void dot_squares(const Columns& a, const Columns& b, std::size_t samples, double* __restrict result) {
  for (std::size_t i = 0; i < samples; ++i) {
    const double aa = a[0][i] * a[0][i] + a[1][i] * a[1][i] + a[2][i] * a[2][i];
    const double bb = b[0][i] * b[0][i] + b[1][i] * b[1][i] + b[2][i] * b[2][i];
    const double ab = a[0][i] * b[0][i] + a[1][i] * b[1][i] + a[2][i] * b[2][i];
    result[i] = aa * bb - ab * ab;
  }
}

void energy_from_speed(const PointMasses& body, const Columns& w, std::size_t samples,
                       double* __restrict result) {
  std::fill_n(result, samples, 0.0);
  for (std::size_t k = 0; k < body.count; ++k) {
    const double rx = body.r[0][k];
    const double ry = body.r[1][k];
    const double rz = body.r[2][k];
    const double half_m = 0.5 * body.m[k];
    for (std::size_t i = 0; i < samples; ++i) {
      const double x = w[1][i] * rz - w[2][i] * ry;
      const double y = w[2][i] * rx - w[0][i] * rz;
      const double z = w[0][i] * ry - w[1][i] * rx;
      result[i] += half_m * (x * x + y * y + z * z);
    }
  }
}

void energy_from_distance(const PointMasses& body, const Columns& w, std::size_t samples,
                          double* __restrict result) {
  std::fill_n(result, samples, 0.0);
  for (std::size_t k = 0; k < body.count; ++k) {
    const double rx = body.r[0][k];
    const double ry = body.r[1][k];
    const double rz = body.r[2][k];
    const double rr = rx * rx + ry * ry + rz * rz;
    const double half_m = 0.5 * body.m[k];
    for (std::size_t i = 0; i < samples; ++i) {
      const double ww = w[0][i] * w[0][i] + w[1][i] * w[1][i] + w[2][i] * w[2][i];
      const double wr = w[0][i] * rx + w[1][i] * ry + w[2][i] * rz;
      result[i] += half_m * (ww * rr - wr * wr);
    }
  }
}

namespace {

/// Six sums in one pass; the compiler may not reorder them, so there are eight partial sums of each.
[[nodiscard]] std::array<double, 6> inertia_of(const PointMasses& body) {
  constexpr std::size_t lanes = 8;
  double sums[6][lanes] = {};
  const auto add = [&](std::size_t k, std::size_t lane) {
    const double x = body.r[0][k];
    const double y = body.r[1][k];
    const double z = body.r[2][k];
    const double m = body.m[k];
    const double rr = x * x + y * y + z * z;
    sums[0][lane] += m * (rr - x * x);
    sums[1][lane] += m * (rr - y * y);
    sums[2][lane] += m * (rr - z * z);
    sums[3][lane] -= m * x * y;
    sums[4][lane] -= m * y * z;
    sums[5][lane] -= m * z * x;
  };
  std::size_t k = 0;
  for (; k + lanes <= body.count; k += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) add(k + lane, lane);
  }
  for (; k < body.count; ++k) add(k, 0);
  std::array<double, 6> total{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double each : sums[i]) total[i] += each;
  }
  return total;
}

}  // namespace

void energy_from_inertia(const PointMasses& body, const Columns& w, std::size_t samples,
                         double* __restrict result) {
  const std::array<double, 6> t = inertia_of(body);
  const double tensor[3][3] = {{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}};
  for (std::size_t i = 0; i < samples; ++i) {
    const double spin[3] = {w[0][i], w[1][i], w[2][i]};
    double total = 0.0;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) total += tensor[j][k] * spin[j] * spin[k];
    }
    result[i] = 0.5 * total;
  }
}

void angular_momentum(const PointMasses& body, const Columns& w, std::size_t samples,
                      const std::array<double*, 3>& result) {
  double* __restrict lx = result[0];
  double* __restrict ly = result[1];
  double* __restrict lz = result[2];
  for (double* each : result) std::fill_n(each, samples, 0.0);
  for (std::size_t k = 0; k < body.count; ++k) {
    const double rx = body.r[0][k];
    const double ry = body.r[1][k];
    const double rz = body.r[2][k];
    const double m = body.m[k];
    for (std::size_t i = 0; i < samples; ++i) {
      const double x = w[1][i] * rz - w[2][i] * ry;
      const double y = w[2][i] * rx - w[0][i] * rz;
      const double z = w[0][i] * ry - w[1][i] * rx;
      lx[i] += m * (ry * z - rz * y);
      ly[i] += m * (rz * x - rx * z);
      lz[i] += m * (rx * y - ry * x);
    }
  }
}

void euler_rates(const std::array<double, 3>& moments, const Columns& w, std::size_t samples,
                 const std::array<double*, 3>& result) {
  double* __restrict x = result[0];
  double* __restrict y = result[1];
  double* __restrict z = result[2];
  for (std::size_t i = 0; i < samples; ++i) {
    x[i] = (moments[1] - moments[2]) * w[1][i] * w[2][i] / moments[0];
    y[i] = (moments[2] - moments[0]) * w[2][i] * w[0][i] / moments[1];
    z[i] = (moments[0] - moments[1]) * w[0][i] * w[1][i] / moments[2];
  }
}

}  // namespace rigor::bench
