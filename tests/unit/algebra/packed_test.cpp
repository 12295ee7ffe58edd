// SPDX-License-Identifier: GPL-3.0-or-later
#include <ginac/ginac.h>

#include <limits>
#include <vector>

#include "algebra/packed/numerator.h"
#include "base/splitmix.h"
#include "catch.h"

using namespace rigor;
using GiNaC::ex;

namespace {

/// Letters x0, x1, …, that fill more than one word.
class PackedPage {
 public:
  PackedPage() {
    for (int i = 0; i < 20; ++i) letters.add(GiNaC::symbol("x" + std::to_string(i)));
  }
  [[nodiscard]] PackedPolynomial packed(const ex& value) const {
    const auto read = read_polynomial(value, letters);
    REQUIRE(read);
    return read->value;
  }
  [[nodiscard]] const ex& x(std::size_t i) const { return letters.at(i); }

  PackedLetters letters;
};

[[nodiscard]] ex random_sum(const PackedPage& page, SplitMix& random) {
  ex sum = static_cast<long>(random.below(3));
  for (int term = 0; term < 4; ++term) {
    ex product =
        GiNaC::numeric(static_cast<long>(random.below(9)) - 4, static_cast<long>(random.below(3)) + 1);
    for (int i = 0; i < 3; ++i) product *= page.x(random.below(4) * 5);
    sum += product;
  }
  return sum;
}

}  // namespace

TEST_CASE("a number leaves the machine word and comes back", "[algebra]") {
  const PackedNumber large = std::numeric_limits<std::int64_t>::max();
  const PackedNumber low = std::numeric_limits<std::int64_t>::min();
  PackedNumber sum = large;
  sum += 1;
  CHECK_FALSE(sum.is_small());
  CHECK(sum.exact() == large.exact() + 1);
  CHECK(sum == -low);
  sum += -1;
  CHECK((sum.is_small() && sum == large));
  CHECK((large * large).exact() == large.exact() * large.exact());
  CHECK((low / -1).exact() == -low.exact());
  CHECK((PackedNumber(6) / 4).exact() == Rational(3) / 2);
  CHECK((PackedNumber(6) / 4 * 2).is_small());
  PackedNumber half = PackedNumber(1) / 2;
  half += PackedNumber(-1) / 2;
  CHECK(half.is_zero());
  CHECK_FALSE((PackedNumber(1) / 2).is_zero());
}

TEST_CASE("packed sums, products, powers and quotients are those of GiNaC", "[algebra]") {
  const PackedPage page;
  SplitMix random(1);
  for (int i = 0; i < 100; ++i) {
    const ex a = random_sum(page, random);
    const ex b = random_sum(page, random);
    const PackedPolynomial of_a = page.packed(a);
    const PackedPolynomial of_b = page.packed(b);
    CHECK(to_ex(of_a + of_b, page.letters).is_equal((a + b).expand()));
    CHECK(to_ex(of_a * of_b, page.letters).is_equal((a * b).expand()));
    CHECK(to_ex(power(of_a, 3), page.letters).is_equal(GiNaC::pow(a, 3).expand()));
    CHECK((of_a - of_a).is_zero());
    CHECK(page.packed(a * (a + b) + 1) == of_a * of_a + of_a * of_b + 1);
    if (of_b.is_zero()) continue;
    CHECK(exact_quotient(of_a * of_b, of_b) == of_a);
    if (of_b.is_number()) continue;
    CHECK_FALSE(exact_quotient(of_a * of_b + 1, of_b));
  }
}

TEST_CASE("a packed polynomial is taken apart by the powers of a letter", "[algebra]") {
  const PackedPage page;
  const ex& x = page.x(2);
  const ex& y = page.x(11);
  const PackedPolynomial value = page.packed(3 * x * x * y - x * y + y * y + 5);
  CHECK(value.degree_in(2) == 2);
  CHECK(value.degree_in(19) == 0);
  CHECK(value.coefficient_of(2, 2) == page.packed(3 * y));
  CHECK(value.coefficient_of(2, 1) == page.packed(-y));
  CHECK(value.coefficient_of(2, 0) == page.packed(y * y + 5));
  CHECK(value.degrees(12)[11] == 2);
  CHECK(page.packed(x - x + 5).is_number());
  CHECK((page.packed(x + 5) - page.packed(x)).is_number());
}

TEST_CASE("what is no polynomial, or of too high a degree, is not packed", "[algebra]") {
  const PackedPage page;
  const ex& x = page.x(0);
  CHECK_FALSE(read_polynomial(1 / x, page.letters));
  CHECK_FALSE(read_polynomial(GiNaC::sqrt(x), page.letters));
  CHECK_FALSE(read_polynomial(GiNaC::symbol("stranger"), page.letters));
  CHECK_FALSE(read_polynomial(x * GiNaC::I, page.letters));
  CHECK(read_polynomial(GiNaC::pow(x, 255), page.letters));
  CHECK_FALSE(read_polynomial(GiNaC::pow(x, 256), page.letters));
  CHECK_FALSE(read_polynomial(GiNaC::pow(x + 1, 200) * GiNaC::pow(x, 56), page.letters));
  const Numerator high = Numerator(GiNaC::pow(x, 200));
  const Numerator higher = high.times(high, page.letters);
  CHECK(higher.packed(page.letters) == nullptr);
  CHECK(higher.expanded(page.letters).written().is_equal(GiNaC::pow(x, 400)));
}

TEST_CASE("a numerator is written as GiNaC writes it, and cancels no more", "[algebra]") {
  const PackedPage page;
  const PackedLetters& letters = page.letters;
  const Numerator x = page.x(0);
  const Numerator y = page.x(9);
  Numerator sum = x;
  sum.add(y, letters);
  const Numerator product = x.times(sum, letters);
  CHECK(product.written().is_equal(page.x(0) * (page.x(0) + page.x(9))));
  CHECK(product.expanded(letters).written().is_equal(product.written().expand()));
  CHECK(sum.times(-2, letters).written().is_equal(-2 * page.x(0) - 2 * page.x(9)));
  CHECK(sum.to_power(2, letters).written().is_equal(GiNaC::pow(page.x(0) + page.x(9), 2)));

  Numerator difference = product;
  difference.add(product.negated(letters), letters);
  CHECK(difference.is_zero());  // as GiNaC sees
  difference = product.expanded(letters);
  difference.add(product.negated(letters), letters);
  CHECK_FALSE(difference.is_zero());  // x·x + x·y − x·(x + y)
  CHECK(difference.expanded(letters).is_zero());
  difference = sum;
  difference.add(x.negated(letters), letters);
  CHECK(difference.is_equal(y, letters));
}

TEST_CASE("a numerator that is added to itself or shared keeps its value", "[algebra]") {
  const PackedPage page;
  const PackedLetters& letters = page.letters;
  const Numerator written = Numerator(page.x(1)).times(Numerator(page.x(2) + page.x(3)), letters);
  Numerator sum = written;
  sum.add(1, letters);
  const Numerator before = sum;
  sum.add(2, letters);
  CHECK(before.written().is_equal(written.written() + 1));
  sum.add(sum, letters);
  CHECK(sum.written().is_equal(2 * written.written() + 6));
  CHECK(sum.expanded(letters).written().is_equal((2 * written.written() + 6).expand()));
}
