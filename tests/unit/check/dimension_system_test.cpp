// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimension_system.h"

#include "catch.h"

namespace rigor {
namespace {

constexpr Unknown x = 0;
constexpr Unknown v = 1;
constexpr Unknown t = 2;

DimensionForm form(std::map<Unknown, SmallRational> unknowns, const Dimension& fixed = {}) {
  return {std::move(unknowns), fixed, false};
}
const Dimension length = Dimension::of(BaseQuantity::length);
const Dimension time = Dimension::of(BaseQuantity::time);

TEST_CASE("what follows from equations is found, whatever their order") {
  for (const bool declared_first : {true, false}) {
    DimensionSystem system;
    if (!declared_first) CHECK_FALSE(system.add(form({{x, 1}}), form({{v, 1}, {t, 1}}), 0));
    CHECK_FALSE(system.add(form({{x, 1}}), form({}, length), 1));
    CHECK_FALSE(system.add(form({{t, 1}}), form({}, time), 2));
    if (declared_first) CHECK_FALSE(system.add(form({{x, 1}}), form({{v, 1}, {t, 1}}), 0));
    CHECK(system.reduce(form({{v, 2}})).form.fixed == (length - time) * 2);
    CHECK(system.reduce(form({{v, 1}})).form.unknowns.empty());
  }
}

TEST_CASE("a contradiction names the equations that it needs and no others") {
  DimensionSystem system;
  CHECK_FALSE(system.add(form({{5, 1}}), form({}, time), 7));
  CHECK_FALSE(system.add(form({{x, 1}}), form({{v, 1}, {t, 1}}), 8));
  CHECK_FALSE(system.add(form({{t, 1}}), form({}, time), 9));
  const auto contradiction = system.add(form({{x, 1}}), form({{v, 1}, {t, 2}}), 10);
  REQUIRE(contradiction);
  CHECK(contradiction->ratio == Dimension() - time);
  CHECK(contradiction->reasons.size() == 2);
  CHECK(contradiction->reasons.contains(8));
  CHECK(contradiction->reasons.contains(9));
}

TEST_CASE("what contradicts is not taken in") {
  DimensionSystem system;
  CHECK_FALSE(system.add(form({{x, 1}}), form({}, length), 0));
  CHECK(system.add(form({{x, 1}}), form({}, time), 1));
  CHECK(system.reduce(form({{x, 1}})).form.fixed == length);
}

TEST_CASE("equations on top of others leave these as they are") {
  DimensionSystem below;
  CHECK_FALSE(below.add(form({{x, 1}}), form({{v, 1}, {t, 1}}), 0));
  DimensionSystem above(&below);
  CHECK_FALSE(above.add(form({{v, 1}}), form({}, length), 1));
  CHECK_FALSE(above.add(form({{t, 1}}), form({}, time), 2));
  CHECK(above.reduce(form({{x, 1}})).form.fixed == length + time);
  CHECK_FALSE(below.reduce(form({{x, 1}})).form.unknowns.empty());
}

TEST_CASE("a written 0 has any dimension") {
  DimensionSystem system;
  DimensionForm zero;
  zero.any = true;
  CHECK_FALSE(system.add(form({}, length), zero, 0));
}

TEST_CASE("exponents beyond all measure are left out") {
  DimensionSystem system;
  for (Unknown k = 0; k < 200; ++k) CHECK_FALSE(system.add(form({{k, 64}}), form({{k + 1, 1}}), k));
  CHECK_FALSE(system.add(form({{200, 1}}), form({}, length), 200));
}

}  // namespace
}  // namespace rigor
