// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/splitmix.h"

#include "catch.h"

using namespace rigor;

TEST_CASE("the generator gives the published sequence for seed 1234567", "[algebra]") {
  SplitMix random(1234567);
  CHECK(random.next() == 6457827717110365317u);
  CHECK(random.next() == 3203168211198807973u);
  CHECK(random.next() == 9817491932198370423u);
}
