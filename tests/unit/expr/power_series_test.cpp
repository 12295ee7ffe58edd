// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/power_series.h"

#include <string>

#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// A page whose x goes to 0; only what is written as 0 is known to be 0.
class Expanding : public Page {
 public:
  Named x = scalar("x");
  Named a = scalar("a");
  Named v = vector("v");

  std::string expanded(const Term& of, int terms = 3) {
    const auto is_zero = [this](ExprId id) -> std::optional<bool> {
      if (tree[id].op == Op::number) return tree.is_zero_literal(id);
      return tree[id].op == Op::symbol ? std::optional(false) : std::nullopt;
    };
    PowerSeriesExpansion expansion(tree, x.symbol, terms, is_zero);
    const auto series = expansion.of(of.id);
    if (!series) return "none";
    std::string text = std::to_string(series->first) + ":";
    for (const auto& term : series->terms) text += " " + (term ? dump(tree, *term) : "0");
    return text;
  }
};

}  // namespace

TEST_CASE("what the letter does not stand in is of order 0", "[expr]") {
  Expanding page;
  CHECK(page.expanded(page.a) == "0: a 0 0");
  CHECK(page.expanded(page.number("0")) == "0: 0 0 0");
}

TEST_CASE("sums and products multiply out", "[expr]") {
  Expanding page;
  CHECK(page.expanded(page.x) == "1: 1 0 0");
  CHECK(page.expanded(page.a + page.x) == "0: a 1 0");
  CHECK(page.expanded(page.x * page.x) == "2: 1 0 0");
  CHECK(page.expanded(page.x * page.v) == "1: v 0 0");
  CHECK(page.expanded(pow(page.a + page.x, 2)) == "0: (multiply a a) (add a a) 1");
}

TEST_CASE("a divisor that vanishes at 0 lowers the order", "[expr]") {
  Expanding page;
  CHECK(page.expanded(page.a / page.x) == "-1: a 0 0");
  CHECK(page.expanded(pow(page.x, -2)) == "-2: 1 0 0");
  CHECK(page.expanded(1 / (page.number("1") + page.x)) == "0: 1 (negate 1) (negate (negate 1))");
}

TEST_CASE("functions follow from their derivatives", "[expr]") {
  Expanding page;
  CHECK(page.expanded(function(Function::exp, page.x)) == "0: 1 1 (divide 1 2)");
  CHECK(page.expanded(function(Function::sin, page.x)) == "0: 0 1 0");
  CHECK(page.expanded(function(Function::cos, page.x)) == "0: 1 0 (negate (divide 1 2))");
}

TEST_CASE("a root or a function that is not smooth at 0 has no expansion", "[expr]") {
  Expanding page;
  const Term root = node(Op::root, {page.x}, 0);
  CHECK(page.expanded(root) == "none");
  CHECK(page.expanded(absolute(page.x)) == "none");
  CHECK(page.expanded(function(Function::sin, 1 / page.x)) == "none");
}

TEST_CASE("where it is not known whether a divisor vanishes, there is none", "[expr]") {
  Expanding page;
  CHECK(page.expanded(1 / (page.a - page.a + page.x)) == "none");
}
