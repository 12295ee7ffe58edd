// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/along_axes.h"

#include <array>

#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a sum over components is written out along the axes, and is equal to them") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const IndexId i = page.index("i");
  const Term product = sum({i}, at(a, i) * at(b, i));
  const auto written = along_axes(page.tree, product.id, {}, {});
  REQUIRE(written);
  CHECK(dump(page.tree, *written) == "(add (multiply a[1] b[1]) (multiply a[2] b[2]) (multiply a[3] b[3]))");
  CHECK(outcome(page, product, {&page.tree, *written}) == Outcome::proved);
  CHECK(outcome(page, product, at(a, 1) * at(b, 1)) == Outcome::refuted);
}

TEST_CASE("a component of a cross product has its two terms") {
  Page page;
  const Term product = cross(page.vector("a"), page.vector("b"));
  const std::array<std::uint8_t, 1> third{3};
  const auto written = along_axes(page.tree, product.id, {}, third);
  REQUIRE(written);
  CHECK(outcome(page, component(product, 3), {&page.tree, *written}) == Outcome::proved);
  CHECK(outcome(page, component(product, 1), {&page.tree, *written}) == Outcome::refuted);
}

TEST_CASE("a sign with a free letter that is not given is not written out") {
  Page page;
  CHECK_FALSE(along_axes(page.tree, page.delta(page.index("i"), 1).id, {}, {}));
}
