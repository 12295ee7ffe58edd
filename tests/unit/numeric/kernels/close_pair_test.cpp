// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/close_pair_lanes.h"

#include <vector>

#include "catch.h"
#include "numeric/kernels/moment_families.h"
#include "numeric/lane/moments_lanes.h"

namespace rigor::baseline {
namespace {

SymmetricTensor<double> symmetric(const SharpTensor& tensor) {
  SymmetricTensor<double> a;
  for (std::size_t i = 0; i < 3; ++i) {
    a.diagonal[i] = tensor[i][i];
    a.off[i] = tensor[(i + 1) % 3][(i + 2) % 3];
  }
  return a;
}

/// A pair that is taken up again with axes that are tilted by so much.
struct TakenUp {
  NearlyDiagonal<double> before;
  NearlyDiagonal<double> after;
  Sharpened<double> sharpened;

  TakenUp(const SharpTensor& tensor, double tilt) {
    const SymmetricTensor<double> a = symmetric(tensor);
    const Reduced<double> r = reduced<true>(a);
    const Rotation<double> m = rotation_of(nearly_diagonalising(r.b));
    before = solved(transformed<true>(r.b, m), m);
    after = before;
    Frame<double> frame = frame_of(m, before);
    for (int i = 0; i < 3; ++i) frame.pair[0][i] += tilt * frame.separate[i];
    sharpened = sharpen<true>(a, r, true, after, frame);
  }
};

TEST_CASE("a pair that is taken up again is believed only where it agrees with what is proved") {
  for (const SharpTensor& tensor : close_pairs(0x1p-75, 32)) {
    const TakenUp right(tensor, 0);
    CHECK(right.sharpened.good);
    CHECK(right.after.difference != right.before.difference);
    // The third eigenvalue is mixed into the pair: the gap is large enough to be believed, and wrong.
    const TakenUp wrong(tensor, 1e-3);
    CHECK_FALSE(wrong.sharpened.good);
    CHECK(wrong.after.difference == wrong.before.difference);
    for (int p = 0; p < 2; ++p) CHECK(wrong.after.values[p].low == wrong.before.values[p].low);
  }
}

}  // namespace
}  // namespace rigor::baseline
