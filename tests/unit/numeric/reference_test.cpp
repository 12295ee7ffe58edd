// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/reference.h"

#include <cmath>

#include "catch.h"
#include "numeric/on_sample.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a reference keeps what cancels in double", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(2, 0);
  samples.set_each(x.symbol, 0, {1e8, 1e150});
  samples.set_each(y.symbol, 0, {1e8 + 1.0, 3.0});
  const Reference result = reference(compiled(page, (pow(x, 2) - pow(y, 2)) + 2 * x), samples);
  CHECK(result.known[0] == Known::value);
  CHECK(result.values[0] == -1.0);
  CHECK(result.known[1] == Known::value);
}

TEST_CASE("a reference reaches beyond the range of double on the way", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e-200);
  const Reference result = reference(compiled(page, pow(x, 3) / pow(x, 3)), samples);
  CHECK(result.values[0] == 1.0);
}

TEST_CASE("what is 0 is known to be 0, and what has no value to have none", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Program same = compiled(page, pow(x + page.number("1"), 2) - (pow(x, 2) + 2 * x + page.number("1")));
  const Program third = compiled(page, x / 3 - x * (1 / page.number("3")));
  const Program none = compiled(page, root(-x));
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 0.3);
  CHECK(reference(same, samples).known[0] == Known::zero);
  CHECK(reference(third, samples).known[0] == Known::zero);
  CHECK(reference(none, samples).known[0] == Known::undefined);
}

TEST_CASE("a small rest of large numbers is not called 0", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e300);
  samples.set(y.symbol, 0, 0x1p-1000);
  const Reference result = reference(compiled(page, (x + y) - x), samples);
  CHECK(result.known[0] == Known::value);
  CHECK(result.values[0] == 0x1p-1000);
}
