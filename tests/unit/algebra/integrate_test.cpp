// SPDX-License-Identifier: GPL-3.0-or-later
// An antiderivative is differentiated by another file, and the exact side compares.
#include "expr/calculus/integrate.h"

#include <vector>

#include "algebra/verdict.h"
#include "catch.h"
#include "expr/calculus/differentiate.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// A page with the variable x, constants a and b, and a function f.
class Integrand : public Page {
 public:
  Named x = scalar("x");
  Named a = scalar("a");
  Named b = scalar("b");
  Named f = scalar("f");
  Variable by{By::letter, x.symbol};
  Named rate{&tree, tree.symbols.derivative(f.symbol, by), no_particle};

  Running running() {
    return {.variable = x.symbol,
            .changes = [this](SymbolId each) { return each == f.symbol || each == rate.symbol; },
            .antiderivative = [this](ExprId id) -> std::optional<ExprId> {
              return tree[id].symbol == rate.symbol ? std::optional(Term(f).id) : std::nullopt;
            }};
  }

  /// The sum of the antiderivatives of its terms.
  std::optional<Term> integrated(const Term& of) {
    const Running over = running();
    const auto terms = integrand_terms(tree, of.id, over);
    if (!terms) return std::nullopt;
    Term sum = zero();
    for (const IntegrandTerm& term : *terms) {
      const auto found = primitive(tree, term, over, {});
      if (!found) return std::nullopt;
      sum = sum + Term{&tree, product_of(tree, term.constant, {})} * Term{&tree, found->value};
    }
    return sum;
  }

  Term derived(const Term& of) {
    const auto dependence_of = [this](SymbolId symbol) {
      using Kind = Dependence::Kind;
      if (symbol == x.symbol) return Dependence{Kind::variable};
      return Dependence{symbol == f.symbol ? Kind::varies : Kind::constant};
    };
    DerivativeBudget budget;
    return {&tree, Differentiator(tree, by, dependence_of, budget).derivative_or_zero(of.id)};
  }
};

}  // namespace

TEST_CASE("the derivative of an antiderivative is the integrand, and not another one", "[algebra]") {
  Integrand page;
  const Term x = page.x;
  const Term a = page.a;
  const Term b = page.b;
  const Term f = page.f;
  const Term rate = page.rate;
  const std::vector<Term> integrands{a,
                                     pow(x, 5) - 2 * x / 3,
                                     b / pow(x, 3),
                                     pow(a * x + b, 4) / 2,
                                     pow(x, 2) / pow(a * x + b, 5),
                                     x * root(x),
                                     1 / root(a * x + b),
                                     pow(x, 2) * root(x + b),
                                     pow(x + 1 / x, 4),
                                     pow(x, 3) * exp(a * x + b),
                                     exp(x) / exp(a * x),
                                     x * sin(a * x),
                                     pow(x, 3) * cos(b - a * x),
                                     pow(sin(a * x), 3),
                                     pow(sin(x), 2) * pow(cos(x), 2),
                                     sin(a * x) * cos(b * x),
                                     exp(a * x) * sin(b * x),
                                     exp(-x) * pow(cos(x), 2),
                                     1 / x,
                                     1 / (x + a),
                                     1 / (page.number("1") + pow(x, 2)),
                                     a * rate,
                                     pow(f, 3) * rate + x};
  for (const Term& integrand : integrands) {
    INFO(dump(page.tree, integrand.id));
    const auto found = page.integrated(integrand);
    REQUIRE(found);
    CHECK(is_proved(page.claim(page.derived(*found), integrand)));
    CHECK_FALSE(is_proved(page.claim(page.derived(*found), integrand + x * a)));
    CHECK_FALSE(is_proved(page.claim(page.derived(*found), -integrand)));
  }
}

TEST_CASE("what has no antiderivative here has none", "[algebra]") {
  Integrand page;
  const Term x = page.x;
  const Term f = page.f;
  for (const Term& integrand : {exp(pow(x, 2)), sin(x) / x, root(pow(x, 2) + page.a), Term(f), f * f}) {
    INFO(dump(page.tree, integrand.id));
    CHECK_FALSE(page.integrated(integrand).has_value());
  }
}

TEST_CASE("what an integrand divides by is told where it is linear", "[algebra]") {
  Integrand page;
  const Term x = page.x;
  const Running running = page.running();
  const auto divisors = [&](const Term& of) {
    return linear_divisors(page.tree, integrand_terms(page.tree, of.id, running)->front(), running, {})
        .size();
  };
  CHECK(divisors(1 / pow(x, 2)) == 1);
  CHECK(divisors(x / ((x + page.a) * pow(x - page.b, 3))) == 2);
  CHECK(divisors(1 / root(x)) == 0);
  CHECK(divisors(pow(x, 2) / page.a) == 0);
}
