// SPDX-License-Identifier: GPL-3.0-or-later
#include "validity_cases.h"

#include <fmt/format.h>

#include "bench_clock.h"
#include "numeric/kernels/plate_families.h"

namespace rigor {
namespace {

/// The test of real engines: an absolute tolerance.
bool within_tolerance(const InertiaTensor& inertia) {
  constexpr double tolerance = 1e-9;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    if (inertia[i][i] > inertia[j][j] + inertia[k][k] + tolerance) return false;
  }
  return true;
}

}  // namespace

std::vector<KernelRow> validity_rows() {
  constexpr std::size_t count = 1'000'000;
  SplitMix bits(6);
  std::vector<InertiaTensor> bodies;
  bodies.reserve(count);
  std::size_t wrong = 0;
  std::size_t wrong_with_tolerance = 0;
  for (std::size_t k = 0; k < count; ++k) {
    bodies.push_back(nearly_a_plate(bits));
    const bool valid = is_valid_exactly(bodies.back());
    wrong += check_inertia(bodies.back()).has_value() != valid ? 1 : 0;
    wrong_with_tolerance += within_tolerance(bodies.back()) != valid ? 1 : 0;
  }
  bodies.resize(2048);
  const auto time = [&](const auto& decide) {
    volatile std::size_t kept = 0;
    return least_nanoseconds([&] {
             std::size_t valid = 0;
             for (const InertiaTensor& body : bodies) valid += decide(body) ? 1 : 0;
             kept = valid;
           }) /
           static_cast<double>(bodies.size());
  };
  const std::string family = "1e6 plates at the edge";
  const auto row = [&](const char* name, double nanoseconds, std::size_t mistakes) {
    return KernelRow{"physical validity", name, family, nanoseconds, static_cast<double>(mistakes),
                     "wrong decisions"};
  };
  return {row("check_inertia",
              time([](const InertiaTensor& body) { return check_inertia(body).has_value(); }), wrong),
          row("diagonal with a tolerance of 1e-9", time(within_tolerance), wrong_with_tolerance)};
}

}  // namespace rigor
