// SPDX-License-Identifier: GPL-3.0-or-later
#include "torque_free_step_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/splitmix.h"
#include "bench_clock.h"
#include "numeric/kernels/free_motion_reference.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"
#include "numeric/kernels/torque_free_step.h"

namespace rigor {
namespace {

/// All different; |ω| t is the same for all.
class BenchBodies {
 public:
  BenchBodies(std::size_t count, double angle) {
    SplitMix random(count);
    const auto draw = [&] { return std::ldexp(static_cast<double>(random.next() >> 11), -53); };
    for (std::vector<double>& column : columns_) column.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Position part{draw(), draw(), draw()};
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        columns_[i][k] = part[(i + 1) % 3] + part[(i + 2) % 3];
        columns_[3 + i][k] = 2 * draw() - 1;
        square += columns_[3 + i][k] * columns_[3 + i][k];
      }
      columns_[6][k] = 1;
      columns_[10][k] = angle / std::sqrt(square);
    }
  }

  [[nodiscard]] FreeBodies first(std::size_t count) {
    FreeBodies bodies{.count = count, .times = columns_[10].data()};
    for (std::size_t i = 0; i < 3; ++i) bodies.moments[i] = columns_[i].data();
    for (std::size_t i = 0; i < 3; ++i) bodies.spin[i] = columns_[3 + i].data();
    for (std::size_t i = 0; i < 4; ++i) bodies.attitude[i] = columns_[6 + i].data();
    return bodies;
  }
  void turn_back() {
    for (double& time : columns_[10]) time = -time;
  }

 private:
  std::array<std::vector<double>, 11> columns_;  // moments, spin, attitude, time
};

/// So many bodies at once: what a compiler makes whole registers of.
constexpr std::size_t width = 32;
using Wide = std::array<double, width>;

/// ω, then q.
using WideState = std::array<Wide, 7>;

struct WideBodies {
  std::array<Wide, 3> factor{};  // dωᵢ/dt = factor ωⱼ ωₖ
  WideState state{};
  Wide time{};
};

/// A peer's step, on blocks of columns; attitudes are brought to length 1. `count` is a multiple of `width`.
template <class Step>
void step_by_columns(const FreeBodies& bodies, const Step& step) {
  WideBodies block;
  for (std::size_t at = 0; at < bodies.count; at += width) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double* const one = bodies.moments[i] + at;
      const double* const two = bodies.moments[(i + 1) % 3] + at;
      const double* const three = bodies.moments[(i + 2) % 3] + at;
      for (std::size_t k = 0; k < width; ++k) block.factor[i][k] = (two[k] - three[k]) / one[k];
      std::copy_n(bodies.spin[i] + at, width, block.state[i].begin());
    }
    for (std::size_t i = 0; i < 4; ++i)
      std::copy_n(bodies.attitude[i] + at, width, block.state[3 + i].begin());
    std::copy_n(bodies.times + at, width, block.time.begin());
    step(block);
    const WideState& s = block.state;
    Wide inverse;
    for (std::size_t k = 0; k < width; ++k)
      inverse[k] =
          1 / std::sqrt(s[3][k] * s[3][k] + s[4][k] * s[4][k] + s[5][k] * s[5][k] + s[6][k] * s[6][k]);
    for (std::size_t i = 0; i < 3; ++i) std::copy_n(s[i].begin(), width, bodies.spin[i] + at);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < width; ++k) bodies.attitude[i][at + k] = s[3 + i][k] * inverse[k];
  }
}

void rates_of(const std::array<Wide, 3>& factor, const WideState& s, WideState& rate) {
  for (std::size_t k = 0; k < width; ++k) {
    rate[0][k] = factor[0][k] * s[1][k] * s[2][k];
    rate[1][k] = factor[1][k] * s[2][k] * s[0][k];
    rate[2][k] = factor[2][k] * s[0][k] * s[1][k];
    rate[3][k] = -.5 * (s[4][k] * s[0][k] + s[5][k] * s[1][k] + s[6][k] * s[2][k]);
    rate[4][k] = .5 * (s[3][k] * s[0][k] + s[5][k] * s[2][k] - s[6][k] * s[1][k]);
    rate[5][k] = .5 * (s[3][k] * s[1][k] + s[6][k] * s[0][k] - s[4][k] * s[2][k]);
    rate[6][k] = .5 * (s[3][k] * s[2][k] + s[4][k] * s[1][k] - s[5][k] * s[0][k]);
  }
}

void runge_kutta_step(WideBodies& block) {
  static constexpr std::array<double, 4> node{0, .5, .5, 1};
  static constexpr std::array<double, 4> weight{1 / 6., 1 / 3., 1 / 3., 1 / 6.};
  const WideState start = block.state;
  WideState rate{};
  WideState stage{};
  for (std::size_t n = 0; n < 4; ++n) {
    for (std::size_t i = 0; i < 7; ++i)
      for (std::size_t k = 0; k < width; ++k)
        stage[i][k] = start[i][k] + node[n] * block.time[k] * rate[i][k];
    rates_of(block.factor, stage, rate);
    for (std::size_t i = 0; i < 7; ++i)
      for (std::size_t k = 0; k < width; ++k) block.state[i][k] += weight[n] * block.time[k] * rate[i][k];
  }
}

constexpr std::size_t most_order = 40;

/// Taylor's series to the power `order` of the time.
void taylor_step(WideBodies& block, std::size_t order) {
  std::array<WideState, most_order + 1> c;
  c[0] = block.state;
  WideState sum = c[0];
  Wide power;
  power.fill(1);
  for (std::size_t n = 0; n < order; ++n) {
    std::array<Wide, 3> spin{};
    std::array<Wide, 4> turn{};
    for (std::size_t m = 0; m <= n; ++m) {
      const WideState& a = c[m];
      const WideState& b = c[n - m];
      for (std::size_t k = 0; k < width; ++k) {
        spin[0][k] += a[1][k] * b[2][k];
        spin[1][k] += a[2][k] * b[0][k];
        spin[2][k] += a[0][k] * b[1][k];
        turn[0][k] -= a[4][k] * b[0][k] + a[5][k] * b[1][k] + a[6][k] * b[2][k];
        turn[1][k] += a[3][k] * b[0][k] + a[5][k] * b[2][k] - a[6][k] * b[1][k];
        turn[2][k] += a[3][k] * b[1][k] + a[6][k] * b[0][k] - a[4][k] * b[2][k];
        turn[3][k] += a[3][k] * b[2][k] + a[4][k] * b[1][k] - a[5][k] * b[0][k];
      }
    }
    const double inverse = 1 / static_cast<double>(n + 1);
    for (std::size_t k = 0; k < width; ++k) power[k] *= block.time[k];
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t k = 0; k < width; ++k) {
        c[n + 1][i][k] = i < 3 ? block.factor[i][k] * spin[i][k] * inverse : .5 * turn[i - 3][k] * inverse;
        sum[i][k] += c[n + 1][i][k] * power[k];
      }
    }
  }
  block.state = sum;
}

/// The closed form for all times, set up for each body and used once.
void step_one_at_a_time(const FreeBodies& bodies) {
  for (std::size_t k = 0; k < bodies.count; ++k) {
    const Position moments{bodies.moments[0][k], bodies.moments[1][k], bodies.moments[2][k]};
    const Position spin{bodies.spin[0][k], bodies.spin[1][k], bodies.spin[2][k]};
    const Position next = TorqueFree::make(moments, spin)->spin(bodies.times[k]);
    const AttitudeQuaternion turn = TorqueFreeAttitude::make(moments, spin)->at(bodies.times[k]);
    AttitudeQuaternion before{};
    for (std::size_t i = 0; i < 4; ++i) before[i] = bodies.attitude[i][k];
    bodies.attitude[0][k] =
        before[0] * turn[0] - before[1] * turn[1] - before[2] * turn[2] - before[3] * turn[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t l = (i + 2) % 3;
      bodies.spin[i][k] = next[i];
      bodies.attitude[1 + i][k] = before[0] * turn[1 + i] + before[1 + i] * turn[0] +
                                  before[1 + j] * turn[1 + l] - before[1 + l] * turn[1 + j];
    }
  }
}

constexpr std::size_t with_reference = 64;

/// After one step from the attitude (1, 0, 0, 0).
std::vector<ReferenceMotion> references_of(BenchBodies bodies) {
  const FreeBodies all = bodies.first(with_reference);
  std::vector<ReferenceMotion> references;
  for (std::size_t k = 0; k < with_reference; ++k) {
    const Position moments{all.moments[0][k], all.moments[1][k], all.moments[2][k]};
    const Position spin{all.spin[0][k], all.spin[1][k], all.spin[2][k]};
    references.push_back(moved(moments, at_rest_of(spin), all.times[k], true));
  }
  return references;
}

/// Of the spin over |ω| or of the quaternion, whichever is greater, of any of the bodies.
double worst_error(const FreeBodies& found, const std::vector<ReferenceMotion>& references) {
  double worst = 0;
  for (std::size_t k = 0; k < references.size(); ++k) {
    const ReferenceMotion& exact = references[k];
    Digits70 along = 0;
    for (std::size_t i = 0; i < 4; ++i) along += exact.turn[i] * found.attitude[i][k];
    Digits70 spin = 0;
    Digits70 size = 0;
    Digits70 turn = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Digits70 error = exact.spin[i] - found.spin[i][k];
      spin += error * error;
      size += exact.spin[i] * exact.spin[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Digits70 error = (along < 0 ? Digits70(-exact.turn[i]) : exact.turn[i]) - found.attitude[i][k];
      turn += error * error;
    }
    const double error = static_cast<double>(sqrt(std::max<Digits70>(spin / size, turn)));
    if (!(error <= worst)) worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  return worst;
}

class TorqueFreeStepRows {
 public:
  std::vector<KernelRow> run() {
    measure("1,000,000 bodies, |ω| t = 0.3", 1'000'000, .3);
    measure("4,096 bodies, |ω| t = 0.3", some, .3);
    measure("4,096 bodies, |ω| t = 0.03", some, .03);
    return std::move(rows_);
  }

 private:
  static constexpr std::size_t some = 4096;

  void measure(const std::string& family, std::size_t count, double angle) {
    const BenchBodies bodies(count, angle);
    const std::vector<ReferenceMotion> references = references_of(bodies);
    const auto add = [&](const std::string& name, std::size_t moving, const auto& step,
                         const std::string& remark = {}) {
      BenchBodies own = bodies;
      step(own.first(moving));
      const double error = worst_error(own.first(moving), references);
      own.turn_back();
      step(own.first(moving));
      // There and back, so that all steps stay as long.
      const double time = least_nanoseconds([&] {
        own.turn_back();
        step(own.first(moving));
      });
      rows_.push_back({"torque-free step", name, family, time / static_cast<double>(moving), error, remark});
      return error;
    };
    add("kernel", count, [](const FreeBodies& all) { step_free_bodies(all); });
    add("closed form, one at a time", some, step_one_at_a_time, "of 4,096 bodies");
    add("RK4 by columns", count, [](const FreeBodies& all) { step_by_columns(all, runge_kutta_step); });
    add(
        "Taylor series by columns", count,
        [order = order_for(bodies, references)](const FreeBodies& all) {
          step_by_columns(all, [order](WideBodies& block) { taylor_step(block, order); });
        },
        "the least order that reaches 1e-15");
  }

  /// Of Taylor's series: the least with an error of 1e-15 at most.
  static std::size_t order_for(const BenchBodies& bodies, const std::vector<ReferenceMotion>& references) {
    for (std::size_t order = 4; order < most_order; ++order) {
      BenchBodies own = bodies;
      const FreeBodies few = own.first(with_reference);
      step_by_columns(few, [order](WideBodies& block) { taylor_step(block, order); });
      if (worst_error(few, references) <= 1e-15) return order;
    }
    return most_order;
  }

  std::vector<KernelRow> rows_;
};

}  // namespace

std::vector<KernelRow> torque_free_step_rows() { return TorqueFreeStepRows().run(); }

}  // namespace rigor
