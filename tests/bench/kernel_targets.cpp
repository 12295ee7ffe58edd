// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

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
  /// How often the second takes the time of the first.
  [[nodiscard]] double times_faster(const std::string& table, const std::string& name,
                                    const std::string& peer, const std::string& family = "") const {
    const double peers = time(table, peer, family);
    return peers < infinity ? peers / time(table, name, family) : 0;
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

/// Of the peer's time over the kernel's.
KernelTarget faster(std::string what, double least, double measured) {
  return {std::move(what), fmt::format("at least {:g}", least), fmt::format("{:.2f}", measured),
          measured >= least};
}

void add_particles(const Rows& rows, std::vector<KernelTarget>& targets) {
  const std::string time = "inertia of points, time";
  targets.push_back(faster("inertia of points from memory, against two passes of Eigen", 5,
                           rows.times_faster(time, "kernel", "Eigen, two passes", "memory")));
  targets.push_back(faster("inertia of 16,384 points from cache, against two passes of Eigen", 8,
                           rows.times_faster(time, "kernel", "Eigen, two passes", "16384 ")));
  targets.push_back(faster("inertia of points from memory, part of the read bandwidth", 0.85,
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
  targets.push_back(faster("torque-free spin at t = 100, against odeint at 1e-9 or better", 100,
                           both ? peer->nanoseconds / kernel->nanoseconds : 0));
  targets.push_back(
      faster("the same, more accurate: error over error", 100, both ? peer->error / kernel->error : 0));
  const double least = rows.least_error(spin, "odeint", hundred);
  targets.push_back(faster("the same, against the least error of odeint at any cost", 100,
                           both && least < infinity ? least / kernel->error : 0));
  targets.push_back(at_most("torque-free spin at the separatrix, error", 1e-14,
                            rows.error(spin, "closed form, set-up and one time", "separatrix")));
  targets.push_back(at_most("torque-free attitude at t = 100, error", 1e-14,
                            rows.error("torque-free attitude", "closed form, set-up and one time", hundred)));
}

}  // namespace

std::vector<KernelTarget> kernel_targets(std::span<const KernelRow> all) {
  const Rows rows(all);
  const std::string stability = "points to stability frequency";
  std::vector<KernelTarget> targets;
  targets.push_back(
      at_most("error of every gap and moment, all families, in u", 16, rows.error("moments", "kernel") / u));
  targets.push_back(faster("moments with gaps, against Eigen compute, random bodies", 6,
                           rows.times_faster("moments", "kernel", "Eigen compute", "random bodies")));
  targets.push_back(faster("moments with axes, against Eigen compute, random bodies", 5,
                           rows.times_faster("axes", "kernel", "Eigen compute", "random bodies")));
  targets.push_back(at_most("residual of the axes, in u", 5, rows.error("residual of axes", "kernel") / u));
  targets.push_back(
      at_most("orthonormality of the axes, in u", 8, rows.error("orthonormality of axes", "kernel") / u));
  targets.push_back(at_most("points to stability frequency, error", 1e-15, rows.error(stability, "kernel")));
  targets.push_back(faster("the same, against Eigen", 1,
                           rows.times_faster(stability, "kernel", "Eigen, two passes, compute")));
  add_particles(rows, targets);
  targets.push_back(
      at_most("mesh, error of volume, centre and second moments", 1e-15, rows.error("mesh", "kernel")));
  targets.push_back(faster("mesh, distance 0 to 1e12, against tetrahedra from the origin", 1,
                           rows.times_faster("mesh", "kernel", "tetrahedra from the origin", "distance ")));
  add_free_motion(rows, targets);
  targets.push_back(at_most("wrong decisions of physical validity, 1e6 bodies", 0,
                            rows.error("physical validity", "check_inertia")));
  return targets;
}

}  // namespace rigor
