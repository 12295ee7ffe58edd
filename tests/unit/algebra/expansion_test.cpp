// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/expansion.h"

#include <ginac/ginac.h>

#include <vector>

#include "base/splitmix.h"
#include "catch.h"

using namespace rigor;
using GiNaC::ex;

namespace {

[[nodiscard]] std::vector<ex> symbols(std::size_t count) {
  std::vector<ex> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(GiNaC::symbol("x" + std::to_string(i)));
  return all;
}

/// A tree of sums, products and powers over some symbols and rational numbers.
[[nodiscard]] ex random_tree(const std::vector<ex>& leaves, SplitMix& random, int depth) {
  const auto choice = depth == 0 ? random.below(3) : random.below(8);
  if (choice < 2) return leaves[random.below(leaves.size())];
  if (choice == 2) {
    return GiNaC::numeric(static_cast<long>(random.below(9)) - 4, static_cast<long>(random.below(3)) + 1);
  }
  const ex left = random_tree(leaves, random, depth - 1);
  if (choice == 3) return GiNaC::pow(left, static_cast<int>(random.below(3)) + 1);
  const ex right = random_tree(leaves, random, depth - 1);
  return choice < 6 ? left * right : left + right;
}

}  // namespace

TEST_CASE("multiplying out gives what GiNaC gives", "[algebra]") {
  for (const std::size_t count : {3u, 12u, 40u, 130u}) {  // in one, two and many words, and too many
    const std::vector<ex> leaves = symbols(count);
    SplitMix random(count);
    for (int i = 0; i < 200; ++i) {
      const ex tree = random_tree(leaves, random, 5);
      CHECK(expanded_polynomial(tree).is_equal(tree.expand()));
    }
    ex all = 1;
    for (const ex& leaf : leaves) all += leaf;
    CHECK(expanded_polynomial(GiNaC::pow(all, 2)).is_equal(GiNaC::pow(all, 2).expand()));
  }
}

TEST_CASE("large exponents do not run into each other", "[algebra]") {
  const std::vector<ex> x = symbols(3);
  const ex product = (x[0] + x[1]) * (x[0] - x[1]);
  for (const int exponent : {127, 128, 254, 255, 256, 300}) {
    const ex tree = GiNaC::pow(x[1], exponent) * (x[0] + x[2]) - x[2] * GiNaC::pow(x[1], exponent);
    CHECK(expanded_polynomial(tree).is_equal(x[0] * GiNaC::pow(x[1], exponent)));
  }
  CHECK(expanded_polynomial(GiNaC::pow(product, 2))
            .is_equal(GiNaC::pow(x[0], 4) - 2 * GiNaC::pow(x[0] * x[1], 2) + GiNaC::pow(x[1], 4)));
}

TEST_CASE("what is no polynomial is left to GiNaC", "[algebra]") {
  const std::vector<ex> x = symbols(2);
  CHECK(expanded_polynomial((x[0] + 1) * GiNaC::sin(x[1]))
            .is_equal(x[0] * GiNaC::sin(x[1]) + GiNaC::sin(x[1])));
  CHECK(expanded_polynomial((x[0] + 1) / x[0]).is_equal(1 + 1 / x[0]));
  CHECK(expanded_polynomial(0).is_zero());
  CHECK(expanded_polynomial(x[0] - x[0]).is_zero());
}
