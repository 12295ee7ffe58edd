// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/differentiate.h"

#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// A page with what varies (a, b, v, w, I) and a constant k.
class Varying : public Page {
 public:
  Named a = scalar("a");
  Named b = scalar("b");
  Named k = scalar("k");
  Named v = vector("v");
  Named w = vector("w");
  Named inertia = symmetric("I");

  std::string derived(const Term& of, By by = By::time, Slot axis = {}) {
    const auto dependence_of = [this](SymbolId symbol) {
      if (symbol == k.symbol) return Dependence{Dependence::Kind::constant};
      return symbol == variable_ ? Dependence{Dependence::Kind::variable, axis_of_variable_} : Dependence{};
    };
    DerivativeBudget budget;
    Differentiator differentiator(tree, by, dependence_of, budget, axis);
    const auto result = differentiator.derivative(of.id);
    return result ? dump(tree, *result) : "nothing";
  }
  void vary_by(const Named& symbol, std::uint8_t axis = 0) {
    variable_ = symbol.symbol;
    axis_of_variable_ = axis;
  }

 private:
  SymbolId variable_{0xffffffffu};
  std::uint8_t axis_of_variable_ = 0;
};

}  // namespace

TEST_CASE("numbers, bases and constants do not change", "[expr]") {
  Varying page;
  CHECK(page.derived(page.number("2")) == "nothing");
  CHECK(page.derived(page.basis(1)) == "nothing");
  CHECK(page.derived(page.delta(1, 2)) == "nothing");
  CHECK(page.derived(page.k) == "nothing");
  CHECK(page.derived(page.k * page.k + page.number("3")) == "nothing");
}

TEST_CASE("a written zero has the rank of what does not change", "[expr]") {
  Varying page;
  DerivativeBudget budget;
  Differentiator differentiator(
      page.tree, By::time, [](SymbolId) { return Dependence{Dependence::Kind::constant}; }, budget);
  CHECK(dump(page.tree, differentiator.derivative_or_zero(Term(page.a).id)) == "0");
  CHECK(dump(page.tree, differentiator.derivative_or_zero(Term(page.v).id)) == "(tuple 0 0 0)");
  CHECK(page.tree[differentiator.derivative_or_zero(Term(page.inertia).id)].rank == 2);
}

TEST_CASE("a symbol's rate is a symbol, the variable's is 1", "[expr]") {
  Varying page;
  CHECK(page.derived(page.a) == "\\dot{a}");
  CHECK(page.derived(at(page.v, 2)) == "\\dot{v}[2]");
  page.vary_by(page.a);
  CHECK(page.derived(page.a) == "1");
}

TEST_CASE("sums and linear forms are differentiated term by term", "[expr]") {
  Varying page;
  CHECK(page.derived(page.a + page.k) == "\\dot{a}");
  CHECK(page.derived(page.a - page.b) == "(add \\dot{a} (negate \\dot{b}))");
  const IndexId i = page.index("i");
  CHECK(page.derived(sum({i}, at(page.v, i) * at(page.v, i))) ==
        "(index-sum i (add (multiply \\dot{v}[i] v[i]) (multiply v[i] \\dot{v}[i])))");
}

TEST_CASE("products keep their order", "[expr]") {
  Varying page;
  CHECK(page.derived(page.a * page.k) == "(multiply \\dot{a} k)");
  CHECK(page.derived(cross(page.v, page.w)) == "(add (cross \\dot{v} w) (cross v \\dot{w}))");
  CHECK(page.derived(dot(page.v, page.w)) == "(add (dot \\dot{v} w) (dot v \\dot{w}))");
}

TEST_CASE("a quotient changes with its dividend and against its divisor", "[expr]") {
  Varying page;
  CHECK(page.derived(page.a / page.k) == "(divide \\dot{a} k)");
  CHECK(page.derived(page.k / page.b) == "(negate (divide (multiply \\dot{b} k) (power b 2)))");
  CHECK(page.derived(page.v / page.b) ==
        "(add (divide \\dot{v} b) (negate (divide (multiply \\dot{b} v) (power b 2))))");
}

TEST_CASE("powers, roots, lengths and absolute values follow the chain rule", "[expr]") {
  Varying page;
  CHECK(page.derived(pow(page.a, 3)) == "(multiply 3 (power a 2) \\dot{a})");
  CHECK(page.derived(pow(page.a, 1)) == "\\dot{a}");
  CHECK(page.derived(pow(page.a, 0)) == "nothing");
  CHECK(page.derived(pow(page.a, -1)) == "(multiply (negate 1) (power a -2) \\dot{a})");
  CHECK(page.derived(root(page.a)) == "(divide \\dot{a} (multiply 2 (root a)))");
  CHECK(page.derived(length(page.v)) == "(divide (dot v \\dot{v}) (length v))");
  CHECK(page.derived(absolute(page.a)) == "(divide (multiply a \\dot{a}) (absolute a))");
}

TEST_CASE("functions follow the chain rule, cosine with a minus", "[expr]") {
  Varying page;
  CHECK(page.derived(sin(page.a)) == "(multiply (cos a) \\dot{a})");
  CHECK(page.derived(cos(page.a)) == "(negate (multiply (sin a) \\dot{a}))");
  CHECK(page.derived(exp(page.k * page.a)) == "(multiply (exp (multiply k a)) (multiply k \\dot{a}))");
  CHECK(page.derived(sin(page.k)) == "nothing");
}

TEST_CASE("tuples change by components", "[expr]") {
  Varying page;
  CHECK(page.derived(tuple(page.a, page.k, page.b)) == "(tuple \\dot{a} 0 \\dot{b})");
  CHECK(page.derived(tuple(page.k, page.k, page.k)) == "nothing");
  CHECK(page.derived(component(cross(page.v, page.k * Term(page.w)), 1)).starts_with("(component[1] "));
}

TEST_CASE("a determinant changes row by row", "[expr]") {
  Varying page;
  const Term a = page.a;
  const Term k = page.k;
  CHECK(page.derived(page.determinant({a, k, k, k, k, k, k, k, a})) ==
        "(add (determinant \\dot{a} 0 0 k k k k k a) (determinant a k k k k k 0 0 \\dot{a}))");
}

TEST_CASE("∂ of a field has the axis behind its own", "[expr]") {
  Varying page;
  const Slot second{2, {}};
  CHECK(page.derived(page.a, By::space, second) == "\\partial a[2]");
  CHECK(page.derived(page.v, By::space, second) ==
        "(tuple \\partial v[1,2] \\partial v[2,2] \\partial v[3,2])");
  const Slot s{0, page.index("s")};
  CHECK(page.derived(at(page.v, 3), By::space, s) == "\\partial v[3,s]");
}

TEST_CASE("the position changes with itself, a coordinate along its axis", "[expr]") {
  Varying page;
  const Slot s{0, page.index("s")};
  page.vary_by(page.v);
  CHECK(page.derived(page.v, By::space, s) == "e[s]");
  CHECK(page.derived(at(page.v, 1), By::space, s) == "delta[1,s]");
  page.vary_by(page.a, 3);
  CHECK(page.derived(page.a, By::space, s) == "delta[3,s]");
}

TEST_CASE("symbols are replaced wherever they stand, and nothing else is touched", "[expr]") {
  Varying page;
  const Term whole = sin(page.a) * (page.b + page.k);
  const auto by_number = [&](ExprId id) -> std::optional<ExprId> {
    if (page.tree[id].symbol != page.b.symbol) return std::nullopt;
    return page.number("7").id;
  };
  CHECK(dump(page.tree, replaced(page.tree, whole.id, by_number)) == "(multiply (sin a) (add 7 k))");
  CHECK(replaced(page.tree, sin(page.a).id, by_number) != whole.id);
  const Term untouched = sin(page.a);
  CHECK(replaced(page.tree, untouched.id, by_number) == untouched.id);
}

TEST_CASE("a component of a tuple or a symbol is taken where it stands open", "[expr]") {
  Varying page;
  const Slot second{2, {}};
  const Slot i{0, page.index("i")};
  const std::span<const Slot> at_second(&second, 1);
  CHECK(dump(page.tree, component_of(page.tree, tuple(page.a, page.b, page.k).id, at_second)) == "b");
  CHECK(dump(page.tree, component_of(page.tree, Term(page.v).id, at_second)) == "v[2]");
  CHECK(dump(page.tree, component_of(page.tree, cross(page.v, page.w).id, at_second)) ==
        "(component[2] (cross v w))");
  CHECK(dump(page.tree, component_of(page.tree, tuple(page.a, page.b, page.k).id, std::span(&i, 1))) ==
        "(component[i] (tuple a b k))");
}

TEST_CASE("derivatives beyond the largest order are given up", "[expr]") {
  for (const auto& [by, most] : {std::pair(By::time, most_rates), std::pair(By::space, most_axes)}) {
    Varying page;
    DerivativeBudget budget;
    Differentiator differentiator(
        page.tree, by, [](SymbolId) { return Dependence{}; }, budget, Slot{1, {}});
    ExprId id = Term(page.a).id;
    for (int k = 0; k < most; ++k) id = *differentiator.derivative(id);
    CHECK_FALSE(budget.exceeded);
    CHECK_FALSE(differentiator.derivative(id));
    REQUIRE(budget.exceeded);
    CHECK(budget.exceeded->starts_with("derivatives of an order above"));
    CHECK_FALSE(differentiator.derivative(Term(page.b).id));  // nothing more is made
    budget.exceeded.reset();
    CHECK_FALSE(differentiator.derivative(id));  // nor is it known to be zero
    CHECK(budget.exceeded);
  }
}

TEST_CASE("derivatives of a product are given up before they fill the memory", "[expr]") {
  Varying page;
  Term product = page.a * page.b;
  for (int k = 0; k < 3; ++k) product = product * product;
  DerivativeBudget budget;
  Differentiator differentiator(
      page.tree, By::time, [](SymbolId) { return Dependence{}; }, budget);
  const std::size_t before = page.tree.size();
  ExprId id = product.id;
  int order = 0;
  while (!budget.exceeded && order < most_rates) {
    ++order;
    id = differentiator.derivative_or_zero(id);
  }
  CHECK(budget.exceeded);
  CHECK(order < most_rates);
  CHECK(page.tree.size() - before < DerivativeBudget{}.nodes);
}

TEST_CASE("conjugates and parts of complex numbers change as these do", "[expr]") {
  Varying page;
  const Named z = page.add({.name = "z", .complex = true});
  const Term conjugate = node(Op::conjugate, {z}, 0);
  CHECK(page.derived(conjugate) == "(conjugate \\dot{z})");
  CHECK(page.derived(node(Op::real_part, {z}, 0)) == "(re \\dot{z})");
  CHECK(page.derived(absolute(z)) == "(divide (re (multiply (conjugate z) \\dot{z})) (absolute z))");
  CHECK(page.derived(absolute(page.a)) == "(divide (multiply a \\dot{a}) (absolute a))");
  CHECK(page.tree.symbols[page.derivative(z, By::time).symbol].complex);
}

TEST_CASE("a conjugate has no derivative by a complex variable", "[expr]") {
  Varying page;
  const Named z = page.add({.name = "z", .complex = true});
  page.vary_by(z);
  const auto derived_by_z = [&](const Term& of) {
    DerivativeBudget budget;
    const auto dependence = [&](SymbolId symbol) {
      return Dependence{symbol == z.symbol ? Dependence::Kind::variable : Dependence::Kind::constant};
    };
    Differentiator differentiator(page.tree, {By::letter, z.symbol}, dependence, budget);
    const auto result = differentiator.derivative(of.id);
    return budget.exceeded ? *budget.exceeded : result ? dump(page.tree, *result) : "nothing";
  };
  const std::string refused = "a conjugate or a modulus has no derivative by a complex variable";
  CHECK(derived_by_z(pow(z, 2)) == "(multiply 2 (power z 1) 1)");
  CHECK(derived_by_z(node(Op::conjugate, {z}, 0)) == refused);
  CHECK(derived_by_z(absolute(z)) == refused);
}
