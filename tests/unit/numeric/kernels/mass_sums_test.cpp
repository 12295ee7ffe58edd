// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/mass_sums.h"

#include <cstring>

#include "catch.h"
#include "numeric/kernels/point_clouds.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {
namespace {

using Tensor = std::array<std::array<double, 3>, 3>;
constexpr double u = 0x1p-53;
constexpr double plain_bound = 4 * u;  // 1.8 u was the worst; the bound that comes with a result is ≤ 24 u
constexpr double mass_bound = 11 * u;
constexpr double sharp_bound = 0x1p-100;

bool same_bits(const PointSums& a, const PointSums& b) {
  return std::memcmp(a.high, b.high, sizeof a.high) == 0 && std::memcmp(a.low, b.low, sizeof a.low) == 0 &&
         a.has_sign == b.has_sign && a.is_wide == b.is_wide;
}

bool same_bits(const MassSums& a, const MassSums& b) {
  return a.mass == b.mass && a.centre == b.centre && a.inertia == b.inertia && a.error == b.error;
}

/// One pass about the origin, then the parallel-axis theorem.
Tensor textbook_one_pass(const PointCloud& cloud) {
  double mass = 0;
  std::array<double, 3> first{};
  Tensor second{};
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    const double m = cloud.columns[3][k];
    mass += m;
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] += m * cloud.columns[i][k];
      for (std::size_t j = 0; j < 3; ++j) second[i][j] += m * cloud.columns[i][k] * cloud.columns[j][k];
    }
  }
  Tensor inertia{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) second[i][j] -= first[i] * first[j] / mass;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      inertia[i][j] =
          i == j ? second[(i + 1) % 3][(i + 1) % 3] + second[(i + 2) % 3][(i + 2) % 3] : -second[i][j];
  return inertia;
}

/// The centre of mass, then the sum of m (r² 1 − r r) about it.
Tensor textbook_two_passes(const PointCloud& cloud) {
  double mass = 0;
  std::array<double, 3> centre{};
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    mass += cloud.columns[3][k];
    for (std::size_t i = 0; i < 3; ++i) centre[i] += cloud.columns[3][k] * cloud.columns[i][k];
  }
  Tensor inertia{};
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    std::array<double, 3> r{};
    for (std::size_t i = 0; i < 3; ++i) r[i] = cloud.columns[i][k] - centre[i] / mass;
    const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        inertia[i][j] += cloud.columns[3][k] * ((i == j ? square : 0) - r[i] * r[j]);
  }
  return inertia;
}

std::string reason_of(const PointCloud& cloud) {
  const auto plain = mass_sums(cloud.points());
  const auto sharp = sharp_mass_sums(cloud.points());
  REQUIRE_FALSE(plain);
  REQUIRE_FALSE(sharp);
  CHECK(plain.error().reason == sharp.error().reason);
  return plain.error().reason;
}

/// Within the bound of a block's sums of both: they add numbers of one sign here, but for those of first
/// order.
bool are_close(const PointSums& a, const PointSums& b) {
  for (int q : {PointSums::mass, PointSums::square, PointSums::square + 1, PointSums::square + 2}) {
    if (std::abs(a.high[q] - b.high[q]) > 28 * 0x1p-53 * b.high[q]) return false;
  }
  return true;
}

TEST_CASE("sums over points have the same bits in lanes of any number, from columns and from records") {
  for (const std::size_t count : {1, 2, 7, 8, 9, 63, 64, 65, 127, 511, 512, 513, 1000, 8192}) {
    const PointCloud cloud = cube_cloud(count, 1e3, count);
    const std::vector<double> records = cloud.records();
    const double* const r = records.data();
    const PointPlaces columns{
        {cloud.columns[0].data(), cloud.columns[1].data(), cloud.columns[2].data(), cloud.columns[3].data()},
        1};
    const PointPlaces rows{{r, r + 1, r + 2, r + 3}, 4};
    const double high[3] = {1e3 + 0.1, -333, 700};
    const double no_low[3] = {0, 0, 0};
    const double low[3] = {1e-14, 1e-15, -1e-15};
    const LaneKernels& first = *runnable_lane_kernels()[0];
    PointSums plain;
    PointSums sharp;
    PointSums sharper;
    const LaneKernels& widest = *runnable_lane_kernels().back();
    widest.sum_points(columns, count, high, no_low, plain);
    first.sum_points_sharply(columns, count, high, no_low, sharp);
    first.sum_points_sharply(columns, count, high, low, sharper);
    for (const LaneKernels* kernels : runnable_lane_kernels()) {
      INFO(kernels->instruction_set << ", " << count);
      for (const PointPlaces& places : {columns, rows}) {
        PointSums sums;
        kernels->sum_points(places, count, high, no_low, sums);
        // The baseline has no fused multiply-add.
        const bool fused = kernels->lanes > 2;
        CHECK((fused ? same_bits(sums, plain) : are_close(sums, plain)));
        kernels->sum_points_sharply(places, count, high, no_low, sums);
        CHECK(same_bits(sums, sharp));
        kernels->sum_points_sharply(places, count, high, low, sums);
        CHECK(same_bits(sums, sharper));
        double sampled[4][8] = {};
        double expected[4][8] = {};
        if (count < 64) continue;
        kernels->sample_points(places, 3, 24, high, sampled);
        first.sample_points(columns, 3, 24, high, expected);
        CHECK(std::memcmp(sampled, expected, sizeof sampled) == 0);
      }
    }
  }
}

TEST_CASE("mass, centre and inertia of points have the same bits for any number of threads") {
  const PointCloud cloud = cube_cloud(300'001, 10, 3);
  const std::vector<double> records = cloud.records();
  const auto one = mass_sums(cloud.points());
  const auto sharp_one = sharp_mass_sums(cloud.points());
  REQUIRE((one && sharp_one));
  for (const std::size_t threads : {0U, 2U, 3U, 7U, 100U}) {
    for (const PointColumns& points : {cloud.points(), point_records(records.data(), cloud.size())}) {
      CHECK(same_bits(*mass_sums(points, {threads}), *one));
      const SharpMassSums sharp = *sharp_mass_sums(points, {threads});
      CHECK(std::memcmp(&sharp, &*sharp_one, sizeof sharp) == 0);
    }
  }
}

TEST_CASE("the inertia of points meets the bound that comes with it, in every family at every distance") {
  for (const std::size_t count : {1, 2, 3, 9, 1000, 5000}) {
    for (const PointCloud& cloud : point_clouds(count)) {
      INFO(cloud.name << ", " << count);
      const ExactMassSums exact(cloud);
      const auto sums = mass_sums(cloud.points());
      REQUIRE(sums);
      CHECK(sums->error <= plain_error_limit);
      CHECK(exact.error_of(sums->inertia) <= sums->error);
      CHECK(exact.error_of(sums->inertia) <= plain_bound);
      CHECK(abs(exact.mass - sums->mass) <= mass_bound * exact.mass);
      const WideFloat extent = sqrt(exact.greatest / exact.mass);
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(abs(exact.centre[i] - sums->centre[i]) <= u * abs(exact.centre[i]) + 4 * u * extent);
    }
  }
}

TEST_CASE("the textbook's inertia of points exceeds the bound of the sums") {
  const PointCloud far = cube_cloud(1000, 1e4, 5);
  CHECK(ExactMassSums(far).error_of(textbook_one_pass(far)) > 1e5 * plain_error_limit);
  const PointCloud farther = cube_cloud(1000, 1e8, 5);
  CHECK(ExactMassSums(farther).error_of(textbook_two_passes(farther)) > 10 * plain_error_limit);
}

TEST_CASE("sharp inertia of points keeps 100 bits in every family, plain inertia does not") {
  double worst_plain = 0;
  for (const std::size_t count : {1, 2, 3, 9, 1000, 5000}) {
    for (const PointCloud& cloud : point_clouds(count)) {
      INFO(cloud.name << ", " << count);
      const ExactMassSums exact(cloud);
      const auto sums = sharp_mass_sums(cloud.points());
      REQUIRE(sums);
      CHECK(exact.error_of(sums->inertia) <= sharp_bound);
      CHECK(exact.error_of(sums->inertia) <= sums->error);
      CHECK(sums->error <= 0x1p-90);
      CHECK(abs(exact.mass - sums->mass.high - sums->mass.low) <= sharp_bound * exact.mass);
      const WideFloat extent = sqrt(exact.greatest / exact.mass);
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(abs(exact.centre[i] - sums->centre[i].high - sums->centre[i].low) <=
              sharp_bound * (abs(exact.centre[i]) + extent));
      worst_plain = std::max(worst_plain, exact.error_of(mass_sums(cloud.points())->inertia));
    }
  }
  CHECK(worst_plain > 0x1p20 * sharp_bound);
}

TEST_CASE("where plain sums cannot meet their bound, the sums are compensated") {
  // Two points one unit in the last place apart: the centre of mass between them is no double.
  PointCloud cloud{"close pair", {}};
  cloud.add(1e12, 0, 0, 1);
  cloud.add(1e12 + 0x1p-13, 0, 0, 1);
  const ExactMassSums exact(cloud);
  const auto sums = mass_sums(cloud.points());
  REQUIRE(sums);
  CHECK(sums->compensated);
  CHECK(sums->error <= 2 * u);
  CHECK(exact.error_of(sums->inertia) <= u);
  CHECK(exact.error_of(textbook_two_passes(cloud)) > 0.5);
  CHECK_FALSE(mass_sums(cube_cloud(100, 1e8, 1).points())->compensated);
}

TEST_CASE("one point and coincident points have no inertia, wherever they are") {
  for (const std::size_t count : {1, 2, 9, 1000}) {
    PointCloud cloud{"coincident", {}};
    for (std::size_t k = 0; k < count; ++k)
      cloud.add(1e12 / 3, -1.0 / 3, 0.1, 1.0 / static_cast<double>(k + 3));
    const auto sums = mass_sums(cloud.points());
    REQUIRE(sums);
    CHECK(sums->inertia == Tensor{});
    CHECK(sums->error == 0);
    CHECK(sums->centre == std::array<double, 3>{1e12 / 3, -1.0 / 3, 0.1});
    CHECK(sharp_mass_sums(cloud.points())->inertia[0][0].high == 0);
  }
}

TEST_CASE("sums over points lose nothing where lengths and masses are very large or very small") {
  const PointCloud cloud = cube_cloud(1000, 1, 9);
  const auto sums = mass_sums(cloud.points());
  const auto sharp = sharp_mass_sums(cloud.points());
  REQUIRE((sums && sharp));
  const std::array<std::array<int, 2>, 8> exponents{
      {{498, -10}, {-498, 10}, {996, -1000}, {-996, 1010}, {0, 1000}, {0, -1000}, {400, -900}, {-510, 0}}};
  for (const auto& [length, mass] : exponents) {
    INFO(length << " " << mass);
    const PointCloud scaled = scaled_cloud(cloud, length, mass);
    const auto scaled_sums = mass_sums(scaled.points());
    const auto scaled_sharp = sharp_mass_sums(scaled.points());
    REQUIRE((scaled_sums && scaled_sharp));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(scaled_sums->centre[i] == std::ldexp(sums->centre[i], length));
      for (std::size_t j = 0; j < 3; ++j) {
        CHECK(scaled_sums->inertia[i][j] == std::ldexp(sums->inertia[i][j], mass + 2 * length));
        CHECK(scaled_sharp->inertia[i][j].high == std::ldexp(sharp->inertia[i][j].high, mass + 2 * length));
      }
    }
  }
  PointCloud massless = cloud;  // a point without mass counts for nothing, however far it is
  massless.add(1e300, -1e300, 1e300, 0);
  CHECK(ExactMassSums(cloud).error_of(mass_sums(massless.points())->inertia) <= plain_bound);
  CHECK(ExactMassSums(cloud).error_of(sharp_mass_sums(massless.points())->inertia) <= sharp_bound);
}

TEST_CASE("a point without a mass counts for nothing, also where it comes first and is far away") {
  for (const std::size_t count : {3, 20, 1000}) {
    const PointCloud near = cube_cloud(count, 2, 6);
    const ExactMassSums exact(near);
    const WideFloat extent = sqrt(exact.greatest / exact.mass);
    for (const double far : {1e300, 0x1p600, 1e308, -1e308}) {
      INFO(count << " at " << far);
      PointCloud cloud{"after a massless point", {}};
      cloud.add(far, far, 0, 0);
      for (std::size_t k = 0; k < count; ++k)
        cloud.add(near.columns[0][k], near.columns[1][k], near.columns[2][k], near.columns[3][k]);
      const auto sums = mass_sums(cloud.points());
      const auto sharp = sharp_mass_sums(cloud.points());
      const auto centre = sharp_centre_of_mass(cloud.points());
      REQUIRE((sums && sharp && centre));
      CHECK(exact.error_of(sums->inertia) <= plain_bound);
      CHECK(exact.error_of(sharp->inertia) <= sharp_bound);
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(abs(exact.centre[i] - (*centre)[i].high - (*centre)[i].low) <= sharp_bound * extent);
    }
  }
}

TEST_CASE("the centre of mass is found where the inertia overflows") {
  PointCloud cloud{"far apart", {}};
  cloud.add(-1e308, 0, 0, 1);
  cloud.add(1e308, 1e300, 0, 3);
  cloud.add(1e308, 0, 1e306, 4);
  const ExactMassSums exact(cloud);
  const auto centre = sharp_centre_of_mass(cloud.points());
  REQUIRE(centre);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(abs(exact.centre[i] - (*centre)[i].high - (*centre)[i].low) <= sharp_bound * abs(exact.centre[i]));
  CHECK(reason_of(cloud) == "the inertia tensor overflows");
}

TEST_CASE("the bound that comes with sums over points holds where masses and lengths are hardly in range") {
  const auto check = [](const PointCloud& cloud, double limit) {
    INFO(cloud.name);
    const ExactMassSums exact(cloud);
    const auto sums = mass_sums(cloud.points());
    REQUIRE(sums);
    CHECK(exact.error_of(sums->inertia) <= sums->error);
    CHECK(sums->error <= limit);
    const auto sharp = sharp_mass_sums(cloud.points());
    REQUIRE(sharp);
    CHECK(exact.error_of(sharp->inertia) <= sharp->error);
  };
  PointCloud light = cube_cloud(500, 0, 7);
  light.name = "a mass among light ones";
  for (double& mass : light.columns[3]) mass = 0x1p-1040;
  light.add(0.3, 0.2, 0.1, 1);
  check(light, 0x1p-40);  // the greatest entry is about 2^-1032, which has 43 bits
  for (std::size_t k = 0; k < 500; ++k) light.columns[3][k] = 0x1p-1020;
  check(light, plain_error_limit);
  PointCloud plate = cube_cloud(20, 0, 8);
  plate.name = "narrow, far along an axis";
  for (std::size_t k = 0; k < plate.size(); ++k) {
    plate.columns[0][k] = 0x1p300;
    plate.columns[1][k] = std::ldexp(plate.columns[1][k], -450);
    plate.columns[2][k] = std::ldexp(plate.columns[2][k], -450);
  }
  check(plate, plain_error_limit);
  plate.columns[3][3] = -0.0;  // the masses are checked before the lengths turn out to be small
  check(plate, plain_error_limit);
}

TEST_CASE("the centre is found where light points come first and the masses differ by any power of two") {
  for (const int exponent : {-100, -200, -240, -500, -900}) {
    INFO(exponent);
    PointCloud cloud{"light, then heavy", {}};
    cloud.add(1.0 / 3, 0.1, -0.7, std::ldexp(0.9, exponent));
    for (int k = 0; k < 40; ++k) cloud.add(0.6, 0.9, 0.3, 1.0 / (k + 3));
    const ExactMassSums exact(cloud);
    const auto sums = mass_sums(cloud.points());
    const auto sharp = sharp_mass_sums(cloud.points());
    REQUIRE((sums && sharp));
    CHECK(sums->error <= plain_error_limit);
    CHECK(exact.error_of(sums->inertia) <= sums->error);
    CHECK(exact.error_of(sharp->inertia) <= sharp_bound);
  }
}

TEST_CASE("the least moment of a thin body along the axes keeps its digits") {
  for (const double thickness : {1e-3, 1e-7, 1e-12}) {
    PointCloud rod = cube_cloud(1000, 0, 14);
    for (std::size_t i : {1U, 2U})
      for (double& x : rod.columns[i]) x *= thickness;
    const ExactMassSums exact(rod);
    const auto error_of_least = [&](const Tensor& inertia) {
      return static_cast<double>(WideFloat(abs(exact.inertia[0][0] - inertia[0][0]) / exact.inertia[0][0]));
    };
    const auto sums = mass_sums(rod.points());
    REQUIRE(sums);
    CHECK(error_of_least(sums->inertia) <= sums->error);
    if (thickness > 1e-4) continue;
    Tensor by_trace{};  // I_11 = ½ (tr I) − Σ m x², which cancels
    by_trace[0][0] = 0.5 * (sums->inertia[0][0] + sums->inertia[1][1] + sums->inertia[2][2]) -
                     0.5 * (sums->inertia[1][1] + sums->inertia[2][2] - sums->inertia[0][0]);
    CHECK(error_of_least(by_trace) > plain_error_limit);
  }
}

TEST_CASE("points that no body has are named in the reason, and so is what overflows") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto with = [](std::size_t column, double value) {
    PointCloud cloud = cube_cloud(20, 0, 4);
    cloud.columns[column][16] = value;
    return reason_of(cloud);
  };
  CHECK(reason_of({}) == "the body has no particles");
  CHECK(with(0, std::nan("")) == "particle 17 has x = nan m, which must be finite");
  CHECK(with(2, -infinity) == "particle 17 has z = -inf m, which must be finite");
  CHECK(with(3, -1) == "particle 17 has the mass -1 kg, which must be finite and not negative");
  CHECK(with(3, infinity) == "particle 17 has the mass inf kg, which must be finite and not negative");
  PointCloud cloud = cube_cloud(20, 0, 4);
  for (double& mass : cloud.columns[3]) mass = -0.0;
  CHECK(reason_of(cloud) == "the body has no mass");
  for (double& mass : cloud.columns[3]) mass = 1e308;
  CHECK(reason_of(cloud) == "the sum of the masses overflows");
  CHECK(reason_of(scaled_cloud(cube_cloud(20, 0, 4), 600, 0)) == "the inertia tensor overflows");
  cloud = cube_cloud(20, 0, 4);
  cloud.columns[3][16] = -0.0;
  CHECK(mass_sums(cloud.points()));
}

}  // namespace
}  // namespace rigor
