// SPDX-License-Identifier: GPL-3.0-or-later
// Complex numbers as pairs: every operation, by statements that are true and by twins that are false.
#include "algebra/parts/real_parts.h"

#include <array>
#include <string>
#include <utility>

#include "algebra/parts/complex_sample.h"
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// A page with i and complex letters.
struct ComplexPage : Page {
  [[nodiscard]] Named complex(std::string name, int rank = 0) {
    return add({.name = std::move(name), .rank = rank, .complex = true});
  }
  [[nodiscard]] Term i() { return {&tree, tree.add({.op = Op::imaginary_unit})}; }
};

Term conjugate(const Term& a) { return node(Op::conjugate, {a}, a.rank()); }
Term re(const Term& a) { return node(Op::real_part, {a}, a.rank()); }
Term im(const Term& a) { return node(Op::imaginary_part, {a}, a.rank()); }

/// Refuted by a sample of complex numbers that says the same when it is put in again.
bool is_refuted_by_complex(const Question& question) {
  const Decision decision = decide(question);
  if (decision.outcome != Outcome::refuted || !decision.sample) return false;
  const Replay again = replay_closely(question, *decision.sample);
  return again.fault == Replay::Fault::none && again.differ && again.sides.left == decision.sample->left &&
         again.sides.right == decision.sample->right;
}

}  // namespace

TEST_CASE("i squares to -1, and its powers repeat", "[algebra]") {
  ComplexPage page;
  CHECK(is_proved(page.claim(pow(page.i(), 2), -page.number("1"))));
  CHECK(is_proved(page.claim(pow(page.i(), -3), page.i())));
  CHECK(is_refuted_by_complex(page.claim(pow(page.i(), 3), page.i())));
  CHECK(is_proved(page.claim(root(-page.number("4")), 2 * page.i())));
}

TEST_CASE("products, quotients and powers of complex numbers", "[algebra]") {
  ComplexPage page;
  const Named z = page.complex("z");
  const Named w = page.complex("w");
  CHECK(is_proved(page.claim(pow(z + w, 3), pow(z, 3) + 3 * pow(z, 2) * w + 3 * z * pow(w, 2) + pow(w, 3))));
  CHECK(is_proved(page.claim(z / w, z * conjugate(w) / pow(absolute(w), 2))));
  CHECK(is_refuted_by_complex(page.claim(z / w, z * w / pow(absolute(w), 2))));
  CHECK(is_proved(page.claim(pow(z, -2), 1 / (z * z))));
  CHECK(is_proved(page.claim(pow(page.i() * z, 2), -pow(z, 2))));
  CHECK(is_refuted_by_complex(page.claim(pow(page.i() * z, 2), pow(z, 2))));
}

TEST_CASE("conjugates, parts and moduli", "[algebra]") {
  ComplexPage page;
  const Named z = page.complex("z");
  const Named w = page.complex("w");
  const Named x = page.scalar("x");
  CHECK(is_proved(page.claim(conjugate(z * w), conjugate(z) * conjugate(w))));
  CHECK(is_refuted_by_complex(page.claim(conjugate(z * w), conjugate(z) * w)));
  CHECK(is_proved(page.claim(z, re(z) + page.i() * im(z))));
  CHECK(is_refuted_by_complex(page.claim(z, re(z) - page.i() * im(z))));
  CHECK(is_proved(page.claim(re(page.i() * z), -im(z))));
  CHECK(is_proved(page.claim(absolute(z * w), absolute(z) * absolute(w))));
  CHECK(is_proved(page.claim(root(conjugate(z) * z), absolute(z))));
  CHECK(is_refuted_by_complex(page.claim(pow(absolute(z), 2), pow(z, 2))));
  CHECK(is_proved(page.claim(pow(absolute(x), 2), pow(x, 2))));
  CHECK(is_proved(page.claim(conjugate(x), x)));
  CHECK(is_refuted_by_complex(page.claim(conjugate(z), z)));
}

TEST_CASE("exponentials, sines and cosines", "[algebra]") {
  ComplexPage page;
  const Named z = page.complex("z");
  const Named w = page.complex("w");
  const Named x = page.scalar("x");
  CHECK(is_proved(page.claim(exp(page.i() * x), cos(x) + page.i() * sin(x))));
  CHECK(is_refuted_by_complex(page.claim(exp(page.i() * x), cos(x) - page.i() * sin(x))));
  CHECK(is_proved(page.claim(exp(z + w), exp(z) * exp(w))));
  CHECK(is_proved(page.claim(pow(sin(z), 2) + pow(cos(z), 2), page.number("1"))));
  CHECK(is_proved(page.claim(sin(z + w), sin(z) * cos(w) + cos(z) * sin(w))));
  CHECK_FALSE(is_proved(page.claim(sin(z + w), sin(z) * cos(w) - cos(z) * sin(w))));
  CHECK(is_proved(page.claim(absolute(exp(page.i() * x)), page.number("1"))));
  CHECK_FALSE(is_proved(page.claim(absolute(exp(page.i() * z)), page.number("1"))));
}

TEST_CASE("complex vectors and tensors", "[algebra]") {
  ComplexPage page;
  const Named a = page.complex("A", 1);
  const Named b = page.complex("B", 1);
  const Named r = page.vector("r");
  const Named t = page.complex("T", 2);
  const IndexId k = page.index("k");
  CHECK(is_proved(page.claim(pow(length(a), 2), dot(conjugate(a), a))));
  CHECK(is_refuted_by_complex(page.claim(pow(length(a), 2), dot(a, a))));
  CHECK(is_proved(page.claim(cross(a, b), -cross(b, a))));
  CHECK(is_refuted_by_complex(page.claim(cross(a, conjugate(a)), page.zero_vector())));
  CHECK(is_proved(page.claim(dot(a, r), sum({k}, at(a, k) * at(r, k)))));
  CHECK(is_proved(page.claim(conjugate(dot(t, r)), dot(conjugate(t), r))));
  CHECK(is_proved(page.claim(component(conjugate(a), k), conjugate(at(a, k)), {k})));
  CHECK(is_refuted_by_complex(page.claim(component(conjugate(a), k), at(a, k), {k})));
}

TEST_CASE("definitions and assumptions hold for both parts", "[algebra]") {
  ComplexPage page;
  const Named z = page.complex("z");
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.define(z, x + page.i() * y);
  CHECK(is_proved(page.claim(pow(absolute(z), 2), pow(x, 2) + pow(y, 2))));
  CHECK(is_refuted_by_complex(page.claim(pow(absolute(z), 2), pow(x, 2) - pow(y, 2))));
  const Named w = page.complex("w");
  page.given(w * page.i(), x + page.zero());
  CHECK(is_proved(page.claim(re(w), page.zero())));
  CHECK(is_refuted_by_complex(page.claim(im(w), x)));
}

TEST_CASE("what is not decided of complex numbers says why", "[algebra]") {
  ComplexPage page;
  const Named z = page.complex("z");
  const Named x = page.scalar("x");
  CHECK(reason_open(page.claim(root(z), z)) == "a root is taken of a number that may not be real");
  CHECK(reason_open(page.claim(z, Relation::less, page.number("1"))) ==
        "an order is one of real numbers, and a side may not be real");
  page.define(x, z * page.number("2"));
  CHECK(reason_open(page.claim(x, 2 * z)) ==
        "`x` is read as a real number, but what defines it may not be real");
}

TEST_CASE("a complex number that is not 0 has a part that is not", "[algebra]") {
  ComplexPage page;
  const Named z = page.complex("z");
  CHECK(is_proved(page.claim(pow(absolute(z), 2) + page.number("1"), Relation::unequal, page.zero())));
  CHECK(is_refuted_by_complex(page.claim(pow(z, 2) + page.number("1"), Relation::unequal, page.zero())));
}

TEST_CASE("complex numbers as text and back", "[algebra]") {
  for (const auto& [re, im, text] : {std::array<std::string, 3>{"0", "0", "0"},
                                     {"1", "0", "1"},
                                     {"0", "1", "i"},
                                     {"0", "-1", "-i"},
                                     {"3", "-2", "3 - 2i"},
                                     {"-1/2", "3/4", "-1/2 + (3/4)i"},
                                     {"0", "-5/2", "-(5/2)i"}}) {
    INFO(text);
    CHECK(complex_text(re, im) == text);
    CHECK(parts_of_text(text) == std::pair(re, im));
  }
}
