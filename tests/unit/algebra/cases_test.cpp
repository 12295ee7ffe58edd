// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions whose equations have no numeric coefficient to solve for.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

[[nodiscard]] bool is_not_proved(const Question& question) { return !is_proved(question); }

/// A symmetric tensor I and its rows.
struct Tensor {
  Page page;
  Named tensor = page.symmetric("I");
  Named mu = page.scalar("\\mu");
  Named nu = page.scalar("\\nu");
  IndexId i = page.index("i");
  IndexId j = page.index("j");

  void given_product(const Named& with, const Term& is) {
    page.given(sum({j}, at(tensor, i, j) * at(with, j)), is, {i});
  }
  [[nodiscard]] Term characteristic(int sign) {
    std::vector<Term> rows;
    for (const int a : {1, 2, 3}) {
      for (const int b : {1, 2, 3}) {
        const Term diagonal = mu * page.delta(a, b);
        rows.push_back(at(tensor, a, b) + (sign > 0 ? diagonal : -diagonal));
      }
    }
    return page.determinant(rows);
  }
};

}  // namespace

TEST_CASE("a direction that a tensor keeps makes the characteristic determinant vanish", "[algebra]") {
  Tensor body;
  Page& page = body.page;
  const Named n = page.unit("n");
  body.given_product(n, body.mu * at(n, body.i));
  CHECK(is_proved(page.claim(body.characteristic(-1), page.zero())));
  CHECK(is_not_proved(page.claim(body.characteristic(1), page.zero())));
  CHECK(is_not_proved(page.claim(at(n, 1), page.zero())));
  CHECK(is_proved(page.claim(body.mu, dot(n, dot(body.tensor, n)))));
  CHECK(is_not_proved(page.claim(body.mu, 2 * dot(n, dot(body.tensor, n)))));
}

TEST_CASE("principal axes of different moments are perpendicular", "[algebra]") {
  Tensor body;
  Page& page = body.page;
  const Named u = page.vector("u");
  const Named v = page.vector("v");
  body.given_product(u, body.mu * at(u, body.i));
  body.given_product(v, body.nu * at(v, body.i));
  CHECK(is_proved(page.claim((body.mu - body.nu) * dot(u, v), page.zero())));
  CHECK(is_not_proved(page.claim((body.mu + body.nu) * dot(u, v), page.zero())));
  CHECK(is_not_proved(page.claim(dot(u, v), page.zero())));
  page.given(body.mu, Relation::unequal, body.nu);
  CHECK(is_proved(page.claim(dot(u, v), page.zero())));
  CHECK(is_not_proved(page.claim(dot(u, v), page.number("1"))));
}

TEST_CASE("a symmetric tensor has no complex moments", "[algebra]") {
  Tensor body;
  Page& page = body.page;
  const Named x = page.vector("x");
  const Named y = page.vector("y");
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  body.given_product(x, a * at(x, body.i) - b * at(y, body.i));
  body.given_product(y, a * at(y, body.i) + b * at(x, body.i));
  CHECK(is_proved(page.claim(b * (dot(x, x) + dot(y, y)), page.zero())));
  CHECK(is_not_proved(page.claim(b * (dot(x, x) - dot(y, y)), page.zero())));
  CHECK(is_not_proved(page.claim(dot(x, x) + dot(y, y), page.zero())));
}

TEST_CASE("parallel vectors", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  page.given(cross(a, b), page.zero_vector());
  CHECK(is_proved(page.claim(pow(dot(a, b), 2), squared(a) * squared(b))));
  CHECK(is_refuted(page.claim(pow(dot(a, b), 2), 2 * squared(a) * squared(b))));
  CHECK(is_refuted(page.claim(dot(a, b), squared(a))));
}

TEST_CASE("Euler's equations keep the energy, and give the rates", "[algebra]") {
  Page page;
  std::vector<Named> moment;
  std::vector<Named> w;
  std::vector<Named> rate;
  for (const std::string k : {"1", "2", "3"}) {
    moment.push_back(page.scalar("I_" + k));
    w.push_back(page.scalar("\\omega_" + k));
    rate.push_back(page.scalar("\\dot\\omega_" + k));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    page.given(moment[i] * rate[i], (moment[j] - moment[k]) * w[j] * w[k]);
  }
  const auto power = [&](std::size_t i) { return moment[i] * w[i] * rate[i]; };
  CHECK(is_proved(page.claim(power(0) + power(1) + power(2), page.zero())));
  CHECK(is_refuted(page.claim(power(0) + power(1) - power(2), page.zero())));
  CHECK(is_proved(page.claim(rate[0], (moment[1] - moment[2]) / moment[0] * w[1] * w[2])));
  CHECK(is_refuted(page.claim(rate[0], (moment[2] - moment[1]) / moment[0] * w[1] * w[2])));
  const auto momentum = [&](std::size_t i) { return moment[i] * w[i] * moment[i] * rate[i]; };
  CHECK(is_proved(page.claim(momentum(0) + momentum(1) + momentum(2), page.zero())));
}

TEST_CASE("what stands in a denominator is not zero", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named z = page.scalar("z");
  page.given(x * y, x * z);
  CHECK(is_refuted(page.claim(y, z)));
  CHECK(is_proved(page.claim(y / x, z / x)));
  page.given(z, page.number("1") / x);
  CHECK(is_proved(page.claim(y, z)));
  CHECK(is_proved(page.claim(x * y, page.number("1"))));
}

TEST_CASE("no case is forgotten", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named z = page.scalar("z");
  page.given(x * y, x);
  page.given(x * z, page.zero());
  CHECK(is_proved(page.claim(x * (y - page.number("1") + z), page.zero())));
  CHECK(is_refuted(page.claim(y, page.number("1"))));
  CHECK(is_refuted(page.claim(z, page.zero())));
}

TEST_CASE("a case in which everything that is solved for is zero", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named z = page.scalar("z");
  page.given(x * x, x * y);
  page.given(y * z, page.zero());
  CHECK(is_proved(page.claim(x * (y - page.number("1")) * z, page.zero())));
  CHECK(is_refuted(page.claim(x * (y - page.number("1")), page.zero())));
}

TEST_CASE("an assumption may single out the one direction that a chart misses", "[algebra]") {
  Page page;
  const Named n = page.unit("n");
  const Named x = page.scalar("x");
  page.given((at(n, 3) + page.number("1")) * x, page.zero());
  CHECK(is_not_proved(page.claim(x, page.zero())));
  CHECK(is_proved(page.claim((dot(n, n) + at(n, 3)) * x, page.zero())));
}

TEST_CASE("a particle's direction that an assumption is about", "[algebra]") {
  Page page;
  const Named n = page.add({.name = "n", .rank = 1, .per_particle = true, .unit = true});
  const Named v = page.vectors("v");
  const Named s = page.scalars("s");
  const ParticleId a = page.particle("\\alpha");
  page.given(v(a), s(a) * n(a), {}, {a});
  CHECK(is_proved(page.claim(squared(v(a)), squared(s(a)), {}, {a})));
  CHECK(is_proved(page.claim(over(a, squared(v(a))), over(a, squared(s(a))))));
  CHECK(is_refuted(page.claim(over(a, squared(v(a))), over(a, s(a)))));
}
