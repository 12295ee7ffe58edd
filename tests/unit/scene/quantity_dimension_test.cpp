// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/quantity_dimension.h"

#include "catch.h"
#include "expr/build.h"

namespace rigor {
namespace {

using namespace build;

const Dimension mass = Dimension::of(BaseQuantity::mass);
const Dimension distance = Dimension::of(BaseQuantity::length);
const Dimension rate = Dimension::of(BaseQuantity::time) * -1;

struct Letters {
  Page page;
  Named m = page.scalars("m");
  Named r = page.vectors("r");
  Named w = page.vector("w");
  Named unknown = page.scalar("q");
  ParticleId a = page.particle("a");

  [[nodiscard]] QuantityDimension of(const Term& term) const {
    return quantity_dimension(page.tree, page.question.definitions, term.id,
                              [this](SymbolId symbol) -> std::optional<Dimension> {
                                if (symbol == m.symbol) return mass;
                                if (symbol == r.symbol) return distance;
                                if (symbol == w.symbol) return rate;
                                return std::nullopt;
                              });
  }
};

TEST_CASE("an energy's dimension follows from those of its letters", "[dimension]") {
  Letters letters;
  const Term energy =
      over(letters.a, letters.m(letters.a) * squared(cross(letters.w, letters.r(letters.a)))) / 2;
  CHECK(letters.of(energy).dimension->text() == "M L^2 T^{-2}");
  CHECK(si_unit(*letters.of(energy).dimension) == "kg m^2/s^2");
}

TEST_CASE("a definition is unfolded, a rate is divided by the time, a root halves", "[dimension]") {
  Letters letters;
  const Named v = letters.page.vectors("v");
  letters.page.define(v(letters.a), cross(letters.w, letters.r(letters.a)));
  CHECK(letters.of(v(letters.a)).dimension->text() == "L T^{-1}");
  CHECK(letters.of(letters.page.derivative(letters.w, By::time)).dimension->text() == "T^{-2}");
  CHECK(letters.of(root(letters.m(letters.a))).dimension->text() == "M^{1/2}");
}

TEST_CASE("where a letter's dimension is not known, that of the quantity is not", "[dimension]") {
  Letters letters;
  CHECK(!letters.of(letters.unknown * Term(letters.m(letters.a))).dimension);
  CHECK(letters.of(letters.unknown * Term(letters.m(letters.a))).clash.empty());
}

TEST_CASE("terms of different dimensions are found, a written zero fits everywhere", "[dimension]") {
  Letters letters;
  CHECK(letters.of(rigor::build::length(letters.r(letters.a)) + letters.m(letters.a)).clash ==
        "terms of m and of kg are added");
  CHECK(letters.of(Term(letters.m(letters.a)) + letters.page.zero()).clash.empty());
}

TEST_CASE("a definition in a circle has no dimension", "[dimension]") {
  Letters letters;
  const Named p = letters.page.scalar("p");
  letters.page.define(p, 2 * Term(p));
  CHECK(!letters.of(p).dimension);
}

TEST_CASE("units are written with what is divided by behind a slash", "[dimension]") {
  CHECK(si_unit(Dimension()) == "1");
  CHECK(si_unit(rate) == "1/s");
  CHECK(si_unit(mass + rate * 2 - distance) == "kg/(m s^2)");
}

}  // namespace
}  // namespace rigor
