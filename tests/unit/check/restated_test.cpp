// SPDX-License-Identifier: GPL-3.0-or-later
// Which equations say again what a law says, and how little is asked to find out.
#include "check/law/restated.h"

#include <array>
#include <filesystem>
#include <span>
#include <string>

#include "catch.h"
#include "check/question/decision_cache.h"

using namespace rigor;

namespace {

struct Letters {
  ExprTree tree;
  ExprId x = letter("x");
  ExprId y = letter("y");

  ExprId letter(const std::string& name) {
    Symbol symbol;
    symbol.name = name;
    return tree.add({.op = Op::symbol, .symbol = tree.symbols.add(symbol)});
  }
  ExprId times(const std::string& number, ExprId of) {
    const std::array factors{tree.add_number({}, number), of};
    return tree.add({.op = Op::multiply}, factors);
  }
  ExprId square(ExprId of) { return tree.add({.op = Op::power, .exponent = 2}, std::span(&of, 1)); }
  ExprId sum(ExprId left, ExprId right) {
    const std::array terms{left, right};
    return tree.add({.op = Op::add}, terms);
  }
};

bool says_again(Letters& letters, const Equation& claim, const Equation& law) {
  const auto fails = where_it_fails(letters.tree, claim, nullptr);
  return fails && restates(letters.tree, claim, *fails, law, nullptr);
}

}  // namespace

TEST_CASE("a multiple of a law restates it, and what follows from it does not") {
  Letters letters;
  const ExprId x = letters.x;
  const ExprId y = letters.y;
  const ExprId one = letters.tree.add_number({}, "1");
  const Equation law{.left = x, .right = y};
  CHECK(says_again(letters, {.left = letters.times("3", x), .right = letters.times("3", y)}, law));
  CHECK(says_again(letters, {.left = letters.times("2", y), .right = letters.times("2", x)}, law));
  CHECK_FALSE(says_again(letters, {.left = letters.times("3", x), .right = letters.times("2", y)}, law));
  CHECK_FALSE(says_again(letters, {.left = letters.sum(x, one), .right = letters.sum(y, one)}, law));
  CHECK_FALSE(says_again(letters, {.left = x, .right = x}, law));
}

TEST_CASE("laws of the same letters that are no multiples are told apart without a proof") {
  Letters letters;
  const std::string folder = (std::filesystem::temp_directory_path() / "rigor-restated").string();
  DecisionCache cache(folder, "notes.md", "test");
  const auto squares = [&](int k) {  // (x + k)^2 = x^2 + k
    const ExprId number = letters.tree.add_number({}, std::to_string(k));
    return Equation{.left = letters.square(letters.sum(letters.x, number)),
                    .right = letters.sum(letters.square(letters.x), number)};
  };
  const Equation claim = squares(1);
  const auto fails = where_it_fails(letters.tree, claim, &cache);
  REQUIRE(fails);
  for (int k = 2; k < 50; ++k) CHECK_FALSE(restates(letters.tree, claim, *fails, squares(k), &cache));
  CHECK(cache.use().asked == 1);
}
