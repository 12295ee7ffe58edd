// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for each instruction set, and for this machine: see CMakeLists.txt.
#include "hand_written.h"

#include <algorithm>

namespace rigor::bench::RIGOR_INSTRUCTION_SET {
namespace {

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

// The compiler takes `__restrict` from parameters only.
void add_angular_momentum(const std::array<double, 3>& r, double m, const double* __restrict w1,
                          const double* __restrict w2, const double* __restrict w3, std::size_t samples,
                          double* __restrict lx, double* __restrict ly, double* __restrict lz) {
  const double rx = r[0];
  const double ry = r[1];
  const double rz = r[2];
  for (std::size_t i = 0; i < samples; ++i) {
    const double x = w2[i] * rz - w3[i] * ry;
    const double y = w3[i] * rx - w1[i] * rz;
    const double z = w1[i] * ry - w2[i] * rx;
    lx[i] += m * (ry * z - rz * y);
    ly[i] += m * (rz * x - rx * z);
    lz[i] += m * (rx * y - ry * x);
  }
}

void euler_rates(const std::array<double, 3>& moments, const double* __restrict w1,
                 const double* __restrict w2, const double* __restrict w3, std::size_t samples,
                 double* __restrict x, double* __restrict y, double* __restrict z) {
  const double i1 = moments[0];
  const double i2 = moments[1];
  const double i3 = moments[2];
  for (std::size_t i = 0; i < samples; ++i) {
    x[i] = (i2 - i3) * w2[i] * w3[i] / i1;
    y[i] = (i3 - i1) * w3[i] * w1[i] / i2;
    z[i] = (i1 - i2) * w1[i] * w2[i] / i3;
  }
}

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
  for (double* each : result) std::fill_n(each, samples, 0.0);
  for (std::size_t k = 0; k < body.count; ++k)
    add_angular_momentum({body.r[0][k], body.r[1][k], body.r[2][k]}, body.m[k], w[0], w[1], w[2], samples,
                         result[0], result[1], result[2]);
}

void euler_rates(const std::array<double, 3>& moments, const Columns& w, std::size_t samples,
                 const std::array<double*, 3>& result) {
  euler_rates(moments, w[0], w[1], w[2], samples, result[0], result[1], result[2]);
}

}  // namespace

extern const HandWritten loops;
const HandWritten loops = {.cross_square = cross_square,
                           .dot_squares = dot_squares,
                           .energy_from_speed = energy_from_speed,
                           .energy_from_distance = energy_from_distance,
                           .energy_from_inertia = energy_from_inertia,
                           .angular_momentum = angular_momentum,
                           .euler_rates = euler_rates};

}  // namespace rigor::bench::RIGOR_INSTRUCTION_SET
