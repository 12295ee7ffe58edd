// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "numeric/lane/lane_kernels.h"
#include "report/wording/figures.h"

namespace rigor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double u = 0x1p-53;

class Rows {
 public:
  explicit Rows(std::span<const KernelRow> rows) : rows_(rows) {}

  /// Of the families with this in their name; infinite where there are none.
  [[nodiscard]] double time(const std::string& table, const std::string& name,
                            const std::string& family = "") const {
    double sum = 0;
    for_each(table, name, family, [&](const KernelRow& row) { sum += row.nanoseconds; });
    return sum > 0 ? sum : infinity;
  }
  [[nodiscard]] double error(const std::string& table, const std::string& name,
                             const std::string& family = "") const {
    double worst = -infinity;
    for_each(table, name, family, [&](const KernelRow& row) { worst = std::max(worst, row.error); });
    return worst >= 0 ? worst : infinity;
  }
  /// How often the second takes the time of the first; nothing where the peer was not measured.
  [[nodiscard]] std::optional<double> times_faster(const std::string& table, const std::string& name,
                                                   const std::string& peer,
                                                   const std::string& family = "") const {
    const double peers = time(table, peer, family);
    if (!(peers < infinity)) return std::nullopt;
    return peers / time(table, name, family);
  }

  /// The fastest result of names that begin so, among those that are good to 1e-9; null if there is none.
  [[nodiscard]] const KernelRow* best(const std::string& table, const std::string& names,
                                      const std::string& family) const {
    const KernelRow* best = nullptr;
    for (const KernelRow& row : rows_) {
      if (row.table == table && row.name.starts_with(names) && row.family == family && row.error <= 1e-9 &&
          (best == nullptr || row.nanoseconds < best->nanoseconds))
        best = &row;
    }
    return best;
  }

  /// The least error of names that begin so; infinite where there are none.
  [[nodiscard]] double least_error(const std::string& table, const std::string& names,
                                   const std::string& family) const {
    double least = infinity;
    for (const KernelRow& row : rows_)
      if (row.table == table && row.name.starts_with(names) && row.family == family)
        least = std::min(least, row.error);
    return least;
  }

 private:
  void for_each(const std::string& table, const std::string& name, const std::string& family,
                const std::function<void(const KernelRow&)>& visit) const {
    for (const KernelRow& row : rows_)
      if (row.table == table && row.name == name && row.family.find(family) != std::string::npos) visit(row);
  }

  std::span<const KernelRow> rows_;
};

KernelTarget at_most(std::string what, double most, double measured) {
  return {std::move(what), fmt::format("at most {:g}", most), short_number(measured), measured <= most};
}

/// What is wanted in lanes of 8, 4 and 2: peers keep what the machine has when the kernels are held to less.
struct Least {
  double in_8 = 0;
  double in_4 = 0;
  double in_2 = 0;

  [[nodiscard]] double here() const {
    const std::size_t lanes = lane_kernels().lanes;
    return lanes >= 8 ? in_8 : lanes == 4 ? in_4 : in_2;
  }
};

/// Of the peer's time over the kernel's. A peer that is not there is no win.
KernelTarget faster(std::string what, double least, std::optional<double> measured) {
  return {std::move(what), fmt::format("at least {:g}", least),
          measured ? fmt::format("{:.2f}", *measured) : "missing", measured && *measured >= least};
}
KernelTarget faster(std::string what, const Least& least, std::optional<double> measured) {
  return faster(std::move(what), least.here(), measured);
}

/// Each against Eigen's two solvers; bodies of revolution as others. A ratio of single calls is that of
/// times, and so at most.
void add_moments(const Rows& rows, std::vector<KernelTarget>& targets) {
  const auto batched = [&](const std::string& what, const std::string& table, const std::string& peer,
                           const std::string& family, const Least& least) {
    targets.push_back(faster(fmt::format("{}, against {}, {}", what, peer, family), least,
                             rows.times_faster(table, "kernel", peer, family)));
  };
  const auto single = [&](const std::string& what, const std::string& table, double most) {
    const auto ratio = rows.times_faster(table, "Eigen computeDirect", "kernel, single", "random bodies");
    KernelTarget target = at_most(what, most, ratio.value_or(infinity));
    if (!ratio) target.measured = "missing";
    targets.push_back(std::move(target));
  };
  batched("moments with gaps", "moments", "Eigen compute", "random bodies", {6, 5, 2});
  batched("moments with gaps", "moments", "Eigen computeDirect", "random bodies", {1.5, 1.2, 0.4});
  batched("moments with axes", "axes", "Eigen compute", "random bodies", {5, 5, 2});
  batched("moments with axes", "axes", "Eigen computeDirect", "random bodies", {2, 1.5, 0.6});
  for (const char* family : {"turned cylinders", "turned rods", "turned spheres"})
    batched("moments with axes", "axes", "Eigen computeDirect", family, {1.2, 0.9, 0.3});
  single("one tensor, moments, time over computeDirect's", "moments", 1.5);
  single("one tensor, axes, time over computeDirect's", "axes", 1.5);
}

void add_particles(const Rows& rows, std::vector<KernelTarget>& targets) {
  const std::string time = "inertia of points, time";
  targets.push_back(faster("inertia of points from memory, against two passes of Eigen", Least{2, 1.5, 1.2},
                           rows.times_faster(time, "kernel", "Eigen, two passes", "memory")));
  targets.push_back(faster("inertia of 16,384 points from cache, against two passes of Eigen", Least{6, 4, 2},
                           rows.times_faster(time, "kernel", "Eigen, two passes", "16384 ")));
  const std::string competent = "Eigen, columns in blocks";
  targets.push_back(faster("the same from memory, against columns in blocks", Least{1.5, 1.3, 0.9},
                           rows.times_faster(time, "kernel", competent, "memory")));
  targets.push_back(faster("the same, 16,384 points, against columns in blocks", Least{2, 1.5, 1},
                           rows.times_faster(time, "kernel", competent, "16384 ")));
  targets.push_back(faster("the same, 1,024 points, against columns in blocks", Least{1.5, 1.1, 0.8},
                           rows.times_faster(time, "kernel", competent, "1024 ")));
  targets.push_back(faster("inertia of points from memory, part of the read bandwidth", Least{0.7, 0.6, 0.4},
                           rows.times_faster(time, "kernel", "read", "memory")));
  targets.push_back(at_most("inertia of points, error at any distance", 1e-15,
                            rows.error("inertia of points, error", "kernel")));
}

void add_free_motion(const Rows& rows, std::vector<KernelTarget>& targets) {
  const std::string spin = "torque-free spin";
  const std::string hundred = "I = (1, 2, 2.5), t = 100";
  const KernelRow* const peer = rows.best(spin, "odeint", hundred);
  const KernelRow* const kernel = rows.best(spin, "closed form, set-up and one time", hundred);
  const bool both = peer != nullptr && kernel != nullptr;
  targets.push_back(faster("torque-free spin at t = 100, against odeint at 1e-9 or better", Least{90, 80, 50},
                           both ? peer->nanoseconds / kernel->nanoseconds : 0));
  targets.push_back(
      faster("the same, more accurate: error over error", 100, both ? peer->error / kernel->error : 0));
  const double least = rows.least_error(spin, "odeint", hundred);
  targets.push_back(faster("the same, against the least error of odeint at any cost", 100,
                           both && least < infinity ? least / kernel->error : 0));
  targets.push_back(faster(
      "torque-free spin with set-up, against Boost.Math", 2,
      rows.times_faster(spin, "closed form, set-up and one time", "Boost.Math jacobi_elliptic", hundred)));
  targets.push_back(
      faster("the same, set up before", 2,
             rows.times_faster(spin, "closed form, one time", "Boost.Math, one time", hundred)));
  targets.push_back(at_most("torque-free spin at the separatrix, error", 1e-14,
                            rows.error(spin, "closed form, set-up and one time", "separatrix")));
  targets.push_back(at_most("torque-free attitude at t = 100, error", 1e-14,
                            rows.error("torque-free attitude", "closed form, set-up and one time", hundred)));
}

/// A step's peer of the same accuracy is Taylor's series: no other integrator comes to 1e-15 in one step.
void add_free_steps(const Rows& rows, std::vector<KernelTarget>& targets) {
  const std::string step = "torque-free step";
  targets.push_back(faster("a step of 1,000,000 bodies, against the closed form one at a time",
                           Least{60, 45, 30},
                           rows.times_faster(step, "kernel", "closed form, one at a time", "1,000,000 ")));
  targets.push_back(
      faster("a step of 4,096 bodies, |ω| t = 0.3, against Taylor's series by columns", Least{4, 3, 1.5},
             rows.times_faster(step, "kernel", "Taylor series by columns", "4,096 bodies, |ω| t = 0.3")));
  targets.push_back(at_most("a step of many bodies, error", 1e-15, rows.error(step, "kernel")));
}

}  // namespace

std::vector<KernelTarget> kernel_targets(std::span<const KernelRow> all) {
  const Rows rows(all);
  const std::string stability = "points to stability frequency";
  std::vector<KernelTarget> targets;
  targets.push_back(
      at_most("error of every gap and moment, all families, in u", 16, rows.error("moments", "kernel") / u));
  add_moments(rows, targets);
  targets.push_back(at_most("residual of the axes, in u", 5, rows.error("residual of axes", "kernel") / u));
  targets.push_back(
      at_most("orthonormality of the axes, in u", 10, rows.error("orthonormality of axes", "kernel") / u));
  targets.push_back(at_most("points to stability frequency, error", 1e-15, rows.error(stability, "kernel")));
  targets.push_back(faster("the same, against Eigen", Least{1, 1, 0.3},
                           rows.times_faster(stability, "kernel", "Eigen, two passes, compute")));
  add_particles(rows, targets);
  targets.push_back(
      at_most("mesh, error of volume, centre and second moments", 1e-15, rows.error("mesh", "kernel")));
  targets.push_back(faster("mesh, distance 0 to 1e12, against tetrahedra from the origin", Least{1, 0.8, 0.2},
                           rows.times_faster("mesh", "kernel", "tetrahedra from the origin", "distance ")));
  add_free_motion(rows, targets);
  add_free_steps(rows, targets);
  targets.push_back(at_most("wrong decisions of physical validity, 1e6 bodies", 0,
                            rows.error("physical validity", "check_inertia")));
  return targets;
}

}  // namespace rigor
