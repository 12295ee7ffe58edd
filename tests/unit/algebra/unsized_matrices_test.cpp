// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/verdict.h"
#include "algebra/words/sized_question.h"
#include "catch.h"
#include "expr/tree/unsized.h"

using namespace rigor;
using namespace rigor::build;

namespace {

Named letter(Page& page, std::string name, Unsized kind) {
  return page.add({.name = std::move(name), .noncommuting = true, .unsized = kind});
}

Term transposed(const Term& of) { return node(Op::transpose, {of}, 0); }
Term trace(const Term& of) { return node(Op::trace, {of}, 0); }
Term determinant_of(const Term& of) { return node(Op::matrix_determinant, {of}, 0); }
Term inverse_of(const Term& of) { return node(Op::power, {of}, 0, {.op = Op::power, .exponent = -1}); }

struct Letters {
  Page page;
  Named a = letter(page, "A", Unsized::square);
  Named b = letter(page, "B", Unsized::square);
  Named m = letter(page, "M", Unsized::matrix);
  Named o = letter(page, "O", Unsized::oblong);
  Named x = letter(page, "x", Unsized::column);
  Named y = letter(page, "y", Unsized::column);
};

}  // namespace

TEST_CASE("transposes turn products, and a number is its own transpose", "[algebra]") {
  Letters of;
  CHECK(is_proved(of.page.claim(transposed(of.a * of.b), transposed(of.b) * transposed(of.a))));
  CHECK(is_refuted(of.page.claim(transposed(of.a * of.b), transposed(of.a) * transposed(of.b))));
  const Term form = transposed(of.x) * (of.a * of.y);
  CHECK(is_proved(of.page.claim(form, transposed(of.y) * (transposed(of.a) * of.x))));
  CHECK(is_refuted(of.page.claim(form, transposed(of.y) * (of.a * of.x))));
  CHECK(is_proved(of.page.claim(of.x * (transposed(of.y) * of.x), (transposed(of.x) * of.y) * of.x)));
}

TEST_CASE("traces and determinants know no more than what holds for all sizes", "[algebra]") {
  Letters of;
  CHECK(is_proved(of.page.claim(trace(of.a * of.b), trace(of.b * of.a))));
  CHECK(is_proved(of.page.claim(trace(of.x * transposed(of.y)), transposed(of.y) * of.x)));
  CHECK(is_refuted(of.page.claim(trace(of.a * of.b), trace(of.a) * trace(of.b))));
  CHECK(is_proved(of.page.claim(determinant_of(of.a * of.b), determinant_of(of.b) * determinant_of(of.a))));
  CHECK(is_refuted(of.page.claim(determinant_of(of.a + of.b), determinant_of(of.a) + determinant_of(of.b))));
  // Of a matrix that has n×m entries there is no determinant.
  const Term square = transposed(of.o) * of.o;
  CHECK_FALSE(is_proved(of.page.claim(determinant_of(square), determinant_of(of.o) * determinant_of(of.o))));
  // Cayley and Hamilton for two rows: false for three, so neither.
  const Term two = of.a * of.a - trace(of.a) * of.a + determinant_of(of.a);
  CHECK(decide(of.page.claim(two, of.page.zero())).outcome == Outcome::undecided);
}

TEST_CASE("the number of rows is what the notes say", "[algebra]") {
  Letters of;
  const Named n = of.page.scalar("n");
  const Named c = of.page.scalar("c");
  const auto determinant_in = [](const Term& a, const Term& rows) {
    return node(Op::matrix_determinant, {a, rows}, 0);
  };
  const auto trace_in = [](const Term& a, const Term& rows) { return node(Op::trace, {a, rows}, 0); };
  const Term power = node(Op::real_power, {c, n}, 0);
  CHECK(is_proved(of.page.claim(determinant_in(c * of.a, n), power * determinant_in(of.a, n))));
  CHECK(is_refuted(of.page.claim(determinant_in(c * of.a, n), c * determinant_in(of.a, n))));
  CHECK(
      is_proved(of.page.claim(trace_in(of.a + c * (of.b * inverse_of(of.b)), n), trace_in(of.a, n) + c * n)));
  const auto cayley = [&](const char* rows) {
    const Term count = of.page.number(rows);
    return of.page.claim(of.a * of.a - trace_in(of.a, count) * of.a + determinant_in(of.a, count),
                         of.page.zero());
  };
  CHECK(is_proved(cayley("2")));
  CHECK(is_refuted(cayley("3")));
}

TEST_CASE("a product of matrices that are not inverted has an inverse of its own", "[algebra]") {
  Letters of;
  const Term inverse = inverse_of(transposed(of.m) * of.m);
  const Term projection = of.m * (inverse * transposed(of.m));
  CHECK(is_proved(of.page.claim(projection * projection, projection)));
  CHECK(is_proved(of.page.claim(transposed(projection), projection)));
  CHECK_FALSE(is_proved(of.page.claim(projection, of.page.number("1"))));
  CHECK(is_proved(of.page.claim(inverse_of(of.a * of.b), inverse_of(of.b) * inverse_of(of.a))));
  const Term one = of.page.number("1");
  CHECK(is_proved(of.page.claim(of.a * inverse_of(one + of.b * of.a), inverse_of(one + of.a * of.b) * of.a)));
}

TEST_CASE("a left inverse is a right one where the matrix is square", "[algebra]") {
  const auto is_right_inverse = [](Letters& of, const Named& q) {
    of.page.given(transposed(q) * q, of.page.number("1"));
    return is_proved(of.page.claim(q * transposed(q), of.page.number("1")));
  };
  Letters square;
  CHECK(is_right_inverse(square, square.a));
  Letters oblong;
  CHECK_FALSE(is_right_inverse(oblong, oblong.o));
}

TEST_CASE("laws with inverses, and laws of numbers that matrices make, are used", "[algebra]") {
  Letters of;
  of.page.given(of.a, of.m * (of.b * inverse_of(of.m)));
  CHECK(is_proved(of.page.claim(of.a * of.m, of.m * of.b)));
  Letters unit;
  unit.page.given(transposed(unit.x) * unit.x, unit.page.number("1"));
  const Term projection = unit.x * transposed(unit.x);
  CHECK(is_proved(unit.page.claim(projection * projection, projection)));
}

TEST_CASE("rows and columns of any size fit together or not", "[expr]") {
  Letters of;
  const auto shape = [&](const Term& term) { return unsized_shape(of.page.tree, term.id); };
  CHECK(shape(transposed(of.x) * of.y) == UnsizedShape::number);
  CHECK(shape(of.x * transposed(of.y)) == UnsizedShape::matrix);
  CHECK(shape(of.a * of.x) == UnsizedShape::column);
  CHECK(shape(transposed(of.x) * of.a) == UnsizedShape::row);
  CHECK(shape(of.x * of.a) == UnsizedShape::none);
  CHECK(shape(of.x + of.a) == UnsizedShape::none);
  CHECK(shape(trace(of.a)) == UnsizedShape::number);
}
