// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/spin_law.h"

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
  CHECK(made->equations_used() == 3);
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
        "no equation there has a rate of the spin and otherwise known letters (`q` has no value)");
}

TEST_CASE("where the equations lose a rate on the way it is not a number", "[spin law]") {
  Law law;
  law.add(at(law.w, 1) * at(law.rate, 1), law.k);
  law.add(at(law.rate, 2), law.k);
  law.add(at(law.rate, 3), law.k);
  REQUIRE(law.make());
  CHECK(std::isnan(law.make()->rates({0, 1, 1})[0]));
}

}  // namespace
}  // namespace rigor
