// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions, in proofs and in samples.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// A body and its centre of mass.
struct Body {
  Page page;
  Named m = page.scalars("m");
  Named r = page.vectors("r");
  Named v = page.vectors("v");
  Named center = page.vector("R");
  Named speed = page.vector("V");
  ParticleId a = page.particle("\\alpha");
  Term mass = over(a, m(a));

  void give_center_of_mass() { page.given(over(a, m(a) * r(a)), page.zero_vector()); }
};

}  // namespace

TEST_CASE("parallel axes need the centre of mass", "[algebra]") {
  Body body;
  Page& page = body.page;
  const auto& [p, m, r, v, center, speed, a, mass] = body;
  const Named s = page.vector("s");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const auto tensor = [&](const Term& x) {
    return over(body.a, body.m(body.a) * (squared(x) * page.delta(i, j) - component(x, i) * component(x, j)));
  };
  const Term of_mass = mass * (squared(s) * page.delta(i, j) - at(s, i) * at(s, j));
  CHECK(is_refuted(page.claim(tensor(r(a) + s), tensor(r(a)) + of_mass, {i, j})));
  body.give_center_of_mass();
  const Decision decision = decide(page.claim(tensor(r(a) + s), tensor(r(a)) + of_mass, {i, j}));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.assumptions == std::vector<std::size_t>{0});
  CHECK(is_refuted(page.claim(tensor(r(a) + s), tensor(r(a)) - of_mass, {i, j})));
}

TEST_CASE("the centre of mass does not make the spin vanish", "[algebra]") {
  Body body;
  Page& page = body.page;
  const auto& [p, m, r, v, center, speed, a, mass] = body;
  body.give_center_of_mass();
  page.given(over(a, m(a) * v(a)), page.zero_vector());
  const Term momentum = over(a, m(a) * cross(center + r(a), speed + v(a)));
  const Term spin = over(a, m(a) * cross(r(a), v(a)));
  const Decision decision = decide(page.claim(momentum, mass * cross(center, speed) + spin));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.assumptions == std::vector<std::size_t>{0, 1});
  CHECK(is_refuted(page.claim(momentum, mass * cross(center, speed))));
  CHECK(is_refuted(page.claim(spin, page.zero_vector())));
}

TEST_CASE("only the assumptions that a proof needs are named", "[algebra]") {
  Body body;
  Page& page = body.page;
  const auto& [p, m, r, v, center, speed, a, mass] = body;
  page.given(over(a, m(a) * v(a)), page.zero_vector());
  body.give_center_of_mass();
  const Decision decision = decide(page.claim(over(a, m(a) * (center + r(a))), mass * center));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.assumptions == std::vector<std::size_t>{1});
  CHECK(decide(page.claim(r(a) + v(a), v(a) + r(a), {}, {a})).assumptions.empty());
}

TEST_CASE("perpendicular vectors", "[algebra]") {
  Page page;
  const Named r = page.vector("r");
  const Named v = page.vector("v");
  CHECK(is_refuted(page.claim(squared(cross(r, v)), squared(r) * squared(v))));
  page.given(dot(r, v), page.zero());
  CHECK(is_proved(page.claim(squared(cross(r, v)), squared(r) * squared(v))));
  CHECK(is_proved(page.claim(cross(r, cross(r, v)), -(squared(r) * v))));
  CHECK(is_refuted(page.claim(cross(r, cross(r, v)), squared(r) * v)));
  CHECK(is_refuted(page.claim(r, page.zero_vector())));
}

TEST_CASE("a vector that is given in terms of others", "[algebra]") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const Named c = page.vector("c");
  page.given(a + b + c, page.zero_vector());
  CHECK(is_proved(page.claim(cross(a, b), cross(b, c))));
  CHECK(is_refuted(page.claim(cross(a, b), cross(c, b))));
  CHECK(is_proved(page.claim(squared(c), squared(a) + squared(b) + 2 * dot(a, b))));
  CHECK(is_refuted(page.claim(squared(c), squared(a) + squared(b) - 2 * dot(a, b))));
}

TEST_CASE("a vector of given length", "[algebra]") {
  Page page;
  const Named n = page.vector("n");
  const Named a = page.vector("A");
  const Term claim = dot(a, n) * n - cross(n, cross(n, a));
  CHECK(is_refuted(page.claim(a, claim)));
  SECTION("by its square") { page.given(squared(n), page.number("1")); }
  SECTION("by its length") { page.given(length(n), page.number("1")); }
  SECTION("by a dot product") { page.given(dot(n, n), page.number("1")); }
  CHECK(is_proved(page.claim(a, claim)));
  CHECK(is_refuted(page.claim(a, dot(a, n) * n + cross(n, cross(n, a)))));
}

TEST_CASE("an assumption for each particle holds inside sums", "[algebra]") {
  Body body;
  Page& page = body.page;
  const auto& [p, m, r, v, center, speed, a, mass] = body;
  const Named w = page.vector("\\omega");
  const ParticleId b = page.particle("\\beta");
  page.given(v(a), cross(w, r(a)), {}, {a});
  const Term energy = over(b, m(b) * squared(v(b)));
  CHECK(is_proved(page.claim(energy, over(b, m(b) * squared(cross(w, r(b)))))));
  CHECK(is_refuted(page.claim(energy, over(b, m(b) * pow(dot(w, r(b)), 2)))));
  CHECK(is_proved(page.claim(dot(r(b), v(b)), page.zero(), {}, {b})));
  CHECK(is_refuted(page.claim(dot(r(a), v(b)), page.zero(), {}, {a, b})));
  const Decision decision = decide(page.claim(dot(w, over(a, m(a) * v(a))), page.zero()));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.assumptions == std::vector<std::size_t>{0});
}

TEST_CASE("a particle's own share of a sum is not any particle's", "[algebra]") {
  // F_α = Σ_β m_β / (x_α − x_β + 1): the sum is another one for each α
  Page page;
  const Named m = page.scalars("m");
  const Named x = page.scalars("x");
  const Named f = page.scalars("F");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  page.given(f(a), over(b, m(b) / (x(a) - x(b) + page.number("1"))), {}, {a});
  CHECK(is_refuted(page.claim(f(a), f(b), {}, {a, b})));
}

TEST_CASE("the total mass as an assumption", "[algebra]") {
  Body body;
  Page& page = body.page;
  const auto& [p, m, r, v, center, speed, a, mass] = body;
  const Named total = page.scalar("M");
  page.given(total, over(a, m(a)));
  page.given(total * center, over(a, m(a) * r(a)));
  const Decision decision = decide(page.claim(over(a, m(a) * (r(a) - center)), page.zero_vector()));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.assumptions == std::vector<std::size_t>{0, 1});
  CHECK(is_refuted(page.claim(over(a, m(a) * (r(a) + center)), page.zero_vector())));
}

TEST_CASE("several conditions that cannot be solved for are left open, not guessed", "[algebra]") {
  // x y = 0 and x z = 0 hold where x = 0 too: y = z = 0 does not follow, nor does y z = 0
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named z = page.scalar("z");
  page.given(x * y, page.zero());
  page.given(x * z, page.zero());
  CHECK(is_refuted(page.claim(y * z, page.zero())));
  CHECK(is_proved(page.claim(x * y * z, page.zero())));
  CHECK(is_refuted(page.claim(y, page.zero())));
}

TEST_CASE("a product that is zero has two cases, and both are kept", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(x * (y - x), page.zero());
  CHECK(is_refuted(page.claim(y, x)));
  CHECK(is_proved(page.claim(x * y, x * x)));
}

TEST_CASE("assumptions that no sample meets are known", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named s = page.scalar("s");
  CHECK(satisfying_sample(page.question));
  page.given(dot(a, a), 2 * s);
  CHECK(satisfying_sample(page.question));
  SECTION("a contradiction") { page.given(s, s + page.number("1")); }
  SECTION("a negative square") { page.given(s, -page.number("2")); }
  CHECK_FALSE(satisfying_sample(page.question));
}
