// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/isolated_letter.h"

#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

namespace {

class Gas : public Page {
 public:
  Named p = scalar("p");
  Named v = scalar("V");
  Named n = scalar("n");
  Named t = scalar("T");

  std::string solved(const Term& left, const Term& right, const Named& letter) {
    const auto found = isolated_letter(tree, left.id, right.id, letter.symbol);
    if (!found) return "nothing";
    std::string text = dump(tree, found->value);
    for (const ExprId each : found->divided_by) text += ", not 0: " + dump(tree, each);
    return text;
  }
};

}  // namespace

TEST_CASE("an equation is solved for a letter that stands in it once", "[isolated]") {
  Gas gas;
  CHECK(gas.solved(gas.p * gas.v, gas.n * gas.t, gas.p) == "(divide (multiply n T) V), not 0: V");
  CHECK(gas.solved(gas.p * gas.v, gas.n * gas.t, gas.t) == "(divide (multiply p V) n), not 0: n");
  CHECK(gas.solved(gas.p / gas.v, gas.n / gas.t, gas.p) == "(multiply (divide n T) V)");
  CHECK(gas.solved(gas.p / gas.v, gas.n, gas.v) == "(divide p n), not 0: n");
  CHECK(gas.solved(gas.p + gas.v, gas.n, gas.p) == "(add n (negate V))");
  CHECK(gas.solved(gas.n, exp(gas.p * gas.v), gas.p) == "(divide (log n) V), not 0: V");
}

TEST_CASE("what leaves a choice or repeats the letter is not solved", "[isolated]") {
  Gas gas;
  CHECK(gas.solved(pow(gas.p, 2), gas.n, gas.p) == "nothing");
  CHECK(gas.solved(sin(gas.p), gas.n, gas.p) == "nothing");
  CHECK(gas.solved(gas.p * gas.v, gas.p + gas.n, gas.p) == "nothing");
  CHECK(gas.solved(gas.p * gas.v, gas.n, gas.t) == "nothing");
  CHECK(gas.solved(gas.p * gas.derivative(gas.p, By::time), gas.n, gas.p) == "nothing");
}
