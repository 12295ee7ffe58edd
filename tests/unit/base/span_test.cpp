// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/span.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("the cover of two spans reaches from the first byte to the last, in either order") {
  const Span left{0, 3, 5};
  const Span right{0, 8, 9};
  CHECK(cover(left, right) == Span{0, 3, 9});
  CHECK(cover(right, left) == Span{0, 3, 9});
  CHECK(cover(Span{0, 3, 9}, Span{0, 4, 5}) == Span{0, 3, 9});
}

TEST_CASE("spans of two files have the first as their cover") {
  CHECK(cover(Span{1, 3, 5}, Span{0, 8, 9}) == Span{1, 3, 5});
}

}  // namespace
}  // namespace rigor
