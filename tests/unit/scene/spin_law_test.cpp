// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/spin_law.h"

#include <array>
#include <cmath>

#include "catch.h"
#include "expr/build.h"

namespace rigor {
namespace {

using namespace build;

/// Equations in the components of ω and its rate, and a letter k with the value 2.
struct Law {
  Page page;
  Named w = page.vector("w");
  Named rate = page.derivative(w, By::time);
  Named k = page.scalar("k");
  std::vector<LawEquation> equations;
  LetterValues values;

  Law() { values.set(k.symbol, {{2.0}, {}}); }

  void add(const Term& left, const Term& right, std::vector<IndexId> indices = {}) {
    equations.push_back({left.id, right.id, std::move(indices), {}});
  }
  [[nodiscard]] Result<SpinLaw> make(const Vector3& at = {1, 2, 3}) const {
    return SpinLaw::make(page.tree, equations, {w.symbol}, values, 0, at);
  }
};

void check_rates(const Vector3& computed, const Vector3& expected) {
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(computed[i] - expected[i]) <= 1e-13 * (1 + std::abs(expected[i])));
}

TEST_CASE("rates that stand alone are read off", "[spin law]") {
  Law law;
  law.add(at(law.rate, 1), at(law.w, 2) * at(law.w, 3));
  law.add(at(law.rate, 2), law.k * at(law.w, 1));
  law.add(law.page.zero(), at(law.rate, 3));
  const auto made = law.make();
  REQUIRE(made);
  check_rates(made->rates({5, 6, 7}), {42, 10, 0});
  check_rates(made->rates({1e9, 6e9, 7e9}), {42e18, 2e9, 0});
}

TEST_CASE("rates that are coupled are solved for", "[spin law]") {
  Law law;
  law.add(at(law.rate, 1) + at(law.rate, 2), law.page.number("3"));
  law.add(at(law.rate, 1) - at(law.rate, 2), at(law.w, 1));
  law.add(law.k * at(law.rate, 3) + at(law.rate, 1), law.page.zero());
  const auto made = law.make();
  REQUIRE(made);
  check_rates(made->rates({1, 0, 0}), {2, 1, -1});
}

TEST_CASE("an equation of vectors, or with a free index, is three equations", "[spin law]") {
  Law vector;
  vector.add(vector.rate, vector.k * Term(vector.w));
  REQUIRE(vector.make());
  check_rates(vector.make()->rates({1, 2, 3}), {2, 4, 6});

  Law indexed;
  const IndexId i = indexed.page.index("i");
  indexed.add(at(indexed.rate, i), indexed.k * at(indexed.w, i), {i});
  REQUIRE(indexed.make());
  check_rates(indexed.make()->rates({1, 2, 3}), {2, 4, 6});
}

TEST_CASE("an equation more that agrees does no harm, one that does not is a contradiction", "[spin law]") {
  Law law;
  law.add(law.rate, law.k * Term(law.w));
  law.add(at(law.w, 1) * at(law.rate, 1), law.k * pow(at(law.w, 1), 2));
  REQUIRE(law.make());
  check_rates(law.make()->rates({1, 2, 3}), {2, 4, 6});
  law.add(at(law.rate, 1), at(law.w, 1));
  REQUIRE(!law.make());
  CHECK(law.make().error().reason == "the equations contradict each other");
}

TEST_CASE("too few equations, and equations that say the same, leave a component open", "[spin law]") {
  Law law;
  law.add(at(law.rate, 1), at(law.w, 1));
  law.add(at(law.rate, 2), at(law.w, 1));
  law.add(law.k * at(law.rate, 2), law.k * at(law.w, 1));
  REQUIRE(!law.make());
  CHECK(law.make().error().reason == "the equations do not determine the rate of the spin's component 3");
}

TEST_CASE("equations that are not affine in the rates are refused", "[spin law]") {
  Law law;
  law.add(pow(at(law.rate, 1), 2), law.k);
  law.add(at(law.rate, 2), law.k);
  law.add(at(law.rate, 3), law.k);
  REQUIRE(!law.make());
  CHECK(law.make().error().reason == "the equations are not affine in the rates of the spin");
}

TEST_CASE("a letter without a value is named", "[spin law]") {
  Law law;
  law.add(law.rate, law.page.scalar("q") * Term(law.w));
  REQUIRE(!law.make());
  CHECK(law.make().error().reason ==
        "no equation there has a rate of the spin and otherwise only known letters (`q` has no value)");
}

TEST_CASE("where the equations lose a rate on the way it is not a number", "[spin law]") {
  Law law;
  law.add(at(law.w, 1) * at(law.rate, 1), law.k);
  law.add(at(law.rate, 2), law.k);
  law.add(at(law.rate, 3), law.k);
  REQUIRE(law.make());
  CHECK(std::isnan(law.make()->rates({0, 1, 1})[0]));
}

TEST_CASE("what drives the spin harder than its own square does not round the rates", "[spin law]") {
  Law law;
  const Named drive = law.page.scalar("q");
  const Named moment = law.page.scalar("I");
  law.values.set(drive.symbol, {{1.0}, {}});
  law.values.set(moment.symbol, {{0.004410}, {}});
  law.add(moment * at(law.rate, 1), drive + moment * at(law.w, 2) * at(law.w, 3));
  law.add(at(law.rate, 2), law.k * at(law.w, 1));
  law.add(at(law.rate, 3), law.page.zero());
  for (const double spin : {0.0, 1e-6, 1e-30, 1e-150}) {
    INFO(spin);
    const auto made = law.make({spin, 0, 0});
    REQUIRE(made);
    check_rates(made->rates({spin, 0, 0}), {1 / 0.004410, 2 * spin, 0});
  }
}

TEST_CASE("both sides of an identity say nothing of the rates, however they round", "[spin law]") {
  Law law;
  const std::array parts{law.page.scalar("a"), law.page.scalar("b"), law.page.scalar("c")};
  for (std::size_t i = 0; i < 3; ++i) law.values.set(parts[i].symbol, {{std::array{0.1, 0.2, 0.3}[i]}, {}});
  law.add(parts[0] * at(law.rate, 1) + parts[1] * at(law.rate, 1), parts[2] * at(law.rate, 1));
  law.add(law.rate, law.k * Term(law.w));
  REQUIRE(law.make());
  check_rates(law.make()->rates({1, 2, 3}), {2, 4, 6});
}

TEST_CASE("equations that contradict each other only on the way give no rates there", "[spin law]") {
  Law law;
  law.add(at(law.rate, 1), at(law.w, 2) * at(law.w, 3));
  law.add(at(law.rate, 1), -(law.page.number("5") * at(law.w, 2) * at(law.w, 3)));
  law.add(at(law.rate, 2), law.k);
  law.add(at(law.rate, 3), law.page.zero());
  const auto made = law.make({0, 0, 1});
  REQUIRE(made);
  CHECK(made->rates({0, 0, 1})[1] == 2);
  CHECK(made->fault_at({0, 0, 1}) == "");
  CHECK(std::isnan(made->rates({0, 1e-3, 1})[0]));
  CHECK(made->fault_at({0, 1e-3, 1}) == "the equations contradict each other there");
}

TEST_CASE("an equation that is affine only at the first spin gives no rates elsewhere", "[spin law]") {
  Law law;
  law.add(at(law.rate, 1) + at(law.w, 2) * pow(at(law.rate, 1), 2), law.k);
  law.add(at(law.rate, 2), law.k);
  law.add(at(law.rate, 3), law.k);
  const auto made = law.make({1, 0, 0});
  REQUIRE(made);
  CHECK(made->rates({1, 0, 0})[0] == 2);
  CHECK(std::isnan(made->rates({1, 1, 0})[0]));
}

TEST_CASE("equations that are not finite are no law, and give no rates on the way", "[spin law]") {
  Law law;
  law.add(at(law.rate, 1), law.k / at(law.w, 1));
  law.add(at(law.rate, 2), law.k);
  law.add(at(law.rate, 3), law.k);
  REQUIRE(!law.make({0, 1, 1}));
  CHECK(law.make({0, 1, 1}).error().reason == "the equations are not finite at the initial spin");
  REQUIRE(law.make());
  CHECK(std::isnan(law.make()->rates({0, 1, 1})[0]));
  CHECK(law.make()->fault_at({0, 1, 1}) == "the equations are not finite there");
}

}  // namespace
}  // namespace rigor
