// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/division.h"

#include <algorithm>
#include <random>
#include <vector>

#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/ring/fraction.h"
#include "algebra/ring/line_image.h"
#include "catch.h"

using namespace rigor;

namespace {

using GiNaC::ex;

/// Polynomials of up to four terms in three letters.
class RandomPolynomials {
 public:
  explicit RandomPolynomials(std::uint32_t seed) : random_(seed) {}

  ex next() {
    for (;;) {
      ex sum = 0;
      for (int term = 0; term < 4; ++term) {
        ex product = GiNaC::numeric(number(-3, 3), number(1, 3));
        for (const ex& letter : letters_) product *= GiNaC::pow(letter, number(0, 2));
        sum += product;
      }
      if (term_count(sum.expand()) > 1) return sum.expand();
    }
  }

 private:
  int number(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }

  std::mt19937 random_;
  std::vector<ex> letters_ = {GiNaC::symbol("x"), GiNaC::symbol("y"), GiNaC::symbol("z")};
};

[[nodiscard]] bool may_divide(const ex& divisor, const ex& value) {
  PackedLetters letters;
  add_letters(letters, divisor);
  add_letters(letters, value);
  const auto below = read_polynomial(divisor, letters);
  const auto above = read_polynomial(value, letters);
  REQUIRE(below);
  REQUIRE(above);
  return rigor::may_divide(below->value, above->value, letters);
}

}  // namespace

TEST_CASE("the look along a line never denies a divisor, and seldom misses one that is none", "[algebra]") {
  RandomPolynomials random(1);
  int missed = 0;
  for (int i = 0; i < 200; ++i) {
    const ex a = random.next();
    const ex b = random.next();
    CHECK(may_divide(a, (a * b).expand()));
    ex quotient;
    const bool divides = GiNaC::divide(b, a, quotient);
    if (divides) CHECK(may_divide(a, b));
    if (!divides && may_divide(a, b)) ++missed;
  }
  CHECK(missed == 0);
}

TEST_CASE("the look along a line never denies a square, and finds most that have none", "[algebra]") {
  RandomPolynomials random(2);
  int without = 0;
  int missed = 0;
  for (int i = 0; i < 100; ++i) {
    const ex a = random.next();
    const ex b = random.next();
    CHECK(may_repeat_a_factor((a * a * b).expand()));
    const std::vector<ex> factors = factors_of(GiNaC::sqrfree(b));
    const bool repeats = std::any_of(factors.begin(), factors.end(),
                                     [](const ex& each) { return GiNaC::is_a<GiNaC::power>(each); });
    if (repeats) continue;
    ++without;
    if (may_repeat_a_factor(b)) ++missed;
  }
  CHECK(without > 20);
  CHECK(missed == 0);
}

TEST_CASE("numbers, multiples of the prime and what is no polynomial are left to GiNaC", "[algebra]") {
  const GiNaC::symbol x("x");
  const GiNaC::numeric prime(2'147'483'647);
  CHECK(may_divide(prime * x, 3 * x));
  CHECK(may_divide(x + 1, x / prime + 1));
  CHECK(may_repeat_a_factor(GiNaC::sin(x)));
  CHECK(may_divide(x + 1, 0));
  CHECK_FALSE(may_divide(x * x, x));
  CHECK_FALSE(may_repeat_a_factor(5));
  CHECK_FALSE(may_repeat_a_factor(x));
}

TEST_CASE("a division is counted, and one that is ruled out costs little", "[algebra]") {
  const GiNaC::symbol x("x");
  const GiNaC::symbol y("y");
  const ex divisor = x + y + 1;
  const ex value = GiNaC::pow(divisor, 5).expand();
  Budget denied;
  Budget made;
  ex quotient;
  CHECK_FALSE(divides(x - y, value, quotient, &denied));
  CHECK(divides(divisor, value, quotient, &made));
  CHECK((quotient - GiNaC::pow(divisor, 4)).expand().is_zero());
  CHECK(denied.used() > 0);
  CHECK(made.used() > 10 * denied.used());
  Budget none(1);
  CHECK_THROWS_AS(divides(divisor, value, quotient, &none), Undecidable);
}

TEST_CASE("a square is found among terms", "[algebra]") {
  const GiNaC::symbol x("x");
  const GiNaC::symbol y("y");
  CHECK(with_repeated_factors((x * x + 2 * x * y + y * y), nullptr).is_equal(GiNaC::pow(x + y, 2)));
  const ex plain = x * x + y * y;
  CHECK(with_repeated_factors(plain, nullptr).is_equal(plain));
}

TEST_CASE("a division of high degree is longer than one of as many terms", "[algebra]") {
  const GiNaC::symbol x("x");
  const GiNaC::symbol y("y");
  const ex divisor = x + y;
  const ex low = GiNaC::pow(x, 2) + x * y;
  const ex high = GiNaC::pow(x, 80) + GiNaC::pow(x, 79) * y;
  CHECK(size_of_division(divisor, low) == 4);
  CHECK(size_of_division(divisor, high) > 4 * size_of_division(divisor, low));
  Budget few;
  Budget many;
  ex quotient;
  CHECK(divides(divisor, low, quotient, &few));
  CHECK(divides(divisor, high, quotient, &many));
  CHECK(many.used() > 4 * few.used());
}
