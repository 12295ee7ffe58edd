// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of our own, and cofactors that are found with them.
#include "algebra/ring/sparse_polynomial.h"

#include <ginac/ginac.h>

#include "algebra/ring/membership.h"
#include "catch.h"

using namespace rigor;
using GiNaC::ex;

namespace {

/// Three letters, and what is written in them.
struct Letters {
  GiNaC::symbol x{"x"};
  GiNaC::symbol y{"y"};
  GiNaC::symbol z{"z"};
  std::vector<ex> all{x, y, z};
  SparseReader reader{all};
  SparseArithmetic arithmetic{3, 10'000};

  [[nodiscard]] SparsePolynomial operator()(const ex& value) const { return *reader.read(value.expand()); }
};

}  // namespace

TEST_CASE("polynomials are read, and nothing else is", "[algebra]") {
  const Letters p;
  CHECK(p(0).empty());
  CHECK(p(3 * p.x * p.y * p.y - ex(1) / 2).size() == 2);
  CHECK(degree(p(3 * p.x * p.y * p.y - p.z), 1) == 2);
  CHECK_FALSE(p.reader.read(1 / p.x));
  CHECK_FALSE(p.reader.read(GiNaC::symbol("w")));
  CHECK_FALSE(p.reader.read(GiNaC::pow(p.x, largest_sparse_exponent + 1)));
}

TEST_CASE("products, powers and coefficients are those of GiNaC", "[algebra]") {
  Letters p;
  const ex a = p.x + 2 * p.y - 3;
  const ex b = p.x * p.x - p.y * p.z + ex(1) / 3;
  CHECK(p.arithmetic.product(p(a), p(b)) == p(a * b));
  CHECK(p.arithmetic.power(p(a), 3) == p(a * a * a));
  CHECK(p.arithmetic.power(p(a), 0) == p(1));
  CHECK(p.arithmetic.coefficient(p(a * b), 0, 2) == p((a * b).expand().coeff(p.x, 2)));
  SparsePolynomial none = p(a);
  p.arithmetic.add(none, p(a), -1);
  CHECK(none.empty());
}

TEST_CASE("a division leaves a rest of smaller degree", "[algebra]") {
  Letters p;
  const ex value = GiNaC::pow(p.x, 4) * p.y + p.x * p.z - 7;
  const ex divisor = 2 * p.x * p.x - p.y * p.x + 1;
  SparsePolynomial rest = p(value);
  const SparsePolynomial whole = p.arithmetic.divide_in(0, rest, p(divisor));
  CHECK(degree(rest, 0) < 2);
  SparsePolynomial again = rest;
  p.arithmetic.add_product(again, whole, p(divisor));
  CHECK(again == p(value));
  CHECK(p.arithmetic.quotient(p(value * divisor), p(divisor)) == p(value));
  CHECK_FALSE(p.arithmetic.quotient(p(value * divisor + 1), p(divisor)));
  CHECK_FALSE(p.arithmetic.quotient(p(value), SparsePolynomial{}));
}

TEST_CASE("arithmetic ends when its operations are used up", "[algebra]") {
  const Letters p;
  SparseArithmetic little(3, 5);
  CHECK_THROWS_AS(little.power(p(p.x + p.y + p.z), 2), TooLong);
  SparseArithmetic much(3, 1000);
  const SparsePolynomial high = p(GiNaC::pow(p.x, 60));
  CHECK_THROWS_AS(much.product(high, high), TooLong);
}

TEST_CASE("the cofactors of a combination are found, and those of no other", "[algebra]") {
  Letters p;
  const std::vector<ex> given{p.x * p.y - 1, p.y * p.y - p.z, p.x - p.z};
  std::vector<SparsePolynomial> equations;
  for (const ex& each : given) equations.push_back(p(each));
  const ex value = (p.x + 2 * p.y) * given[0] - p.z * given[1] + ex(3) / 5 * given[2];
  const auto found = cofactors(p(value), equations);
  REQUIRE(found);
  REQUIRE(found->size() == 3);
  SparsePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) p.arithmetic.add_product(sum, (*found)[k], equations[k]);
  CHECK(sum == p(value));
  CHECK_FALSE(cofactors(p(value + 1), equations));
  CHECK(cofactors(p(given[1]), equations)->at(1) == p(1));
}
