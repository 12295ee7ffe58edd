// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/shape.h"

#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a shape knows neither summed letters nor the order of terms and factors") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const Term left = sum({i}, at(a, i) * at(b, i));
  const Term right = sum({j}, at(b, j) * at(a, j));
  CHECK(shape_of(page.tree, left.id) == shape_of(page.tree, right.id));
  CHECK(shape_of(page.tree, left.id) != shape_of(page.tree, sum({i}, at(a, i) * at(a, i)).id));
  CHECK(shape_of(page.tree, left.id) != shape_of(page.tree, (-left).id));
}

TEST_CASE("a cross product has its order in its shape") {
  Page page;
  const Term a = page.vector("a");
  const Term b = page.vector("b");
  CHECK(shape_of(page.tree, cross(a, b).id) != shape_of(page.tree, cross(b, a).id));
}
