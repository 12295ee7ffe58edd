// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over any number of particles.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a sum over particles does not know the name of its variable", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  const Decision decision = decide(page.claim(over(a, m(a) * r(a)), over(b, r(b) * m(b))));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.route == "component normal form, moments of any number of particles");
  CHECK(is_refuted(page.claim(over(a, m(a) * r(a)), over(b, r(b)))));
}

TEST_CASE("a statement has to hold for every number of particles", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const ParticleId a = page.particle("\\alpha");
  const Term count = over(a, page.number("1"));
  CHECK(is_refuted(page.claim(count, page.number("2"))));
  const Term first = over(a, m(a));
  const Term second = over(a, pow(m(a), 2));
  const Term third = over(a, pow(m(a), 3));
  SECTION("true for one particle only") { CHECK(is_refuted(page.claim(pow(first, 2), second))); }
  SECTION("true for up to two particles (Newton's identity)") {
    const Decision decision = decide(page.claim(2 * third, 3 * first * second - pow(first, 3)));
    REQUIRE(decision.outcome == Outcome::refuted);
    CHECK(decision.sample->particles == 3);
  }
  SECTION("with the number of particles in it") {
    const ParticleId b = page.particle("\\beta");
    const Term spread = over(a, over(b, pow(m(a) - m(b), 2)));
    CHECK(is_proved(page.claim(spread, 2 * count * second - 2 * pow(first, 2))));
    CHECK(is_refuted(page.claim(spread, 4 * second - 2 * pow(first, 2))));  // with 2 for N
  }
}

TEST_CASE("the kinetic energy of a rotation is half of ω·I·ω", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named w = page.vector("\\omega");
  const Named inertia = page.tensor("I");
  const ParticleId a = page.particle("\\alpha");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const auto body = [&](const Term& square) {
    return over(a, m(a) * (square * page.delta(i, j) - at(r(a), i) * at(r(a), j)));
  };
  const Term energy = over(a, m(a) * squared(cross(w, r(a)))) / 2;
  const Term half = sum({i, j}, at(inertia, i, j) * at(w, i) * at(w, j)) / 2;
  SECTION("with the right tensor") {
    page.define(inertia, body(squared(r(a))), {i, j});
    CHECK(is_proved(page.claim(energy, half)));
    CHECK(is_refuted(page.claim(energy, 2 * half)));
    CHECK(is_proved(page.claim(at(inertia, i, j), at(inertia, j, i), {i, j})));
    CHECK(is_proved(page.claim(dot(inertia, w), over(a, m(a) * cross(r(a), cross(w, r(a)))))));
    CHECK(is_refuted(page.claim(dot(inertia, w), over(a, m(a) * cross(cross(w, r(a)), r(a))))));
  }
  SECTION("with a wrong one") {
    page.define(inertia, body(2 * squared(r(a))), {i, j});
    CHECK(is_refuted(page.claim(energy, half)));
  }
}

TEST_CASE("a statement for each particle has that particle's own quantities", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named v = page.vectors("v");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  const Term torque = cross(r(a), over(b, m(b) * v(b)));
  CHECK(is_proved(page.claim(torque, over(b, m(b) * cross(r(a), v(b))), {}, {a})));
  CHECK(is_refuted(page.claim(torque, over(b, m(b) * cross(r(b), v(b))), {}, {a})));
  CHECK(is_refuted(page.claim(at(r(a), 1), at(r(b), 1), {}, {a, b})));
  const Decision decision = decide(page.claim(dot(r(a), r(b)), squared(r(a)), {}, {a, b}));
  REQUIRE(decision.outcome == Outcome::refuted);
  CHECK(decision.sample->free_particles == std::vector<std::uint32_t>{1, 2});
}

TEST_CASE("sums in sums are taken from the inside out", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  const Term pairs = over(a, over(b, m(a) * m(b) * squared(r(a) - r(b))));
  const Term squares = 2 * over(a, m(a)) * over(b, m(b) * squared(r(b)));
  CHECK(is_proved(page.claim(pairs, squares - 2 * squared(over(a, m(a) * r(a))))));
  CHECK(is_refuted(page.claim(pairs, squares - squared(over(a, m(a) * r(a))))));
  CHECK(is_proved(page.claim(over(a, m(a) * over(a, m(a))), pow(over(b, m(b)), 2))));
}

TEST_CASE("quotients and roots inside a sum", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named x = page.vector("x");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  CHECK(is_proved(page.claim(over(a, m(a) / length(r(a))), over(b, m(b) * length(r(b)) / squared(r(b))))));
  CHECK(is_refuted(page.claim(over(a, m(a) / length(r(a))), over(b, m(b) * length(r(b))))));
  CHECK(is_proved(page.claim(over(a, squared(r(a)) / squared(r(a))), over(a, page.number("1")))));
  CHECK(is_proved(page.claim(over(a, m(a) / length(x - r(a))), over(b, m(b) / length(r(b) - x)))));
  CHECK(is_refuted(page.claim(over(a, m(a) / length(x - r(a))), over(b, m(b) / length(r(b) + x)))));
  const Term both = over(a, over(b, m(a) * m(b) * length(r(a) - r(b))));
  CHECK(reason_open(page.claim(both, both * page.number("1") + page.zero())).find("both particles") !=
        std::string::npos);
}

TEST_CASE("unit vectors of particles", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named n = page.add({.name = "n", .rank = 1, .per_particle = true, .unit = true});
  const ParticleId a = page.particle("\\alpha");
  CHECK(is_proved(page.claim(over(a, m(a) * squared(n(a))), over(a, m(a)))));
  CHECK(is_refuted(page.claim(over(a, m(a) * at(n(a), 1)), over(a, m(a)))));
}
