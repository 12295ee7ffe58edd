// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/term_estimate.h"

#include <ginac/ginac.h>

#include "catch.h"

namespace rigor {

TEST_CASE("a power of a sum has as many terms as monomials") {
  const GiNaC::symbol a("a");
  const GiNaC::symbol b("b");
  const GiNaC::symbol c("c");
  CHECK(most_terms_over_one_denominator(GiNaC::pow(a + b, 20)) == 21);
  CHECK(most_terms_over_one_denominator(GiNaC::pow(a + b + c, 2)) == 6);
  CHECK(most_terms_over_one_denominator((a + b) * (a - c)) == 4);
}

TEST_CASE("different denominators multiply, and equal ones do not") {
  const GiNaC::symbol x("x");
  const GiNaC::symbol y("y");
  const GiNaC::symbol z("z");
  CHECK(most_terms_over_one_denominator(x / (y + z) + z / (y + z)) == 2);
  CHECK(most_terms_over_one_denominator(1 / (x + y) + 1 / (x + z)) == 4);
  GiNaC::ex sum = 0;
  for (int k = 0; k < 40; ++k) sum += 1 / (GiNaC::symbol() + y);
  CHECK(most_terms_over_one_denominator(sum) > 1e12);
}

TEST_CASE("a fraction in a fraction is looked through") {
  const GiNaC::symbol a("a");
  const GiNaC::symbol b("b");
  const GiNaC::symbol c("c");
  CHECK(most_terms_over_one_denominator(1 / (a + 1 / (b + c))) == 3);
  GiNaC::ex nested = a + b;
  for (int k = 0; k < 200; ++k) nested = a + 1 / nested;
  CHECK(most_terms_over_one_denominator(nested) >= 2);
}

}  // namespace rigor
