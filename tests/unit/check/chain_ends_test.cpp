// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/chain_ends.h"

#include <string>

#include "catch.h"

namespace rigor {
namespace {

Link link_of(char letter) {
  return letter == '='   ? Link::holds
         : letter == 'x' ? Link::fails
         : letter == '?' ? Link::open
                         : Link::no_equality;
}

/// Steps as signs: `=` holds, `x` fails, `?` open, `<` another relation. Sides are equal if their letters
/// are. The answer has a word for each step that fails.
std::string places(const std::string& steps, const std::string& sides, int* asked = nullptr) {
  std::vector<Link> links;
  for (const char each : steps) links.push_back(link_of(each));
  const auto across = [&](std::size_t i, std::size_t k) {
    if (asked != nullptr) ++*asked;
    return sides[i] == sides[k] ? Link::holds : Link::fails;
  };
  std::string text;
  for (const auto& place : places_in_chain(links, across)) {
    if (!place) {
      text += ".";
    } else if (place->first_wrong) {
      text += place->undone_at ? "(undone at " + std::to_string(*place->undone_at) + ")"
              : place->stays   ? "(stays)"
                               : "(first)";
    } else {
      text += place->undoes ? "(undoes " : "(further to ";
      text += std::to_string(place->first_step) + ")";
    }
  }
  return text;
}

TEST_CASE("a slip that stays is one error, and needs no further decision") {
  int asked = 0;
  CHECK(places("x==", "abbb", &asked) == "(stays)..");
  CHECK(places("==x", "aaab", &asked) == "..(stays)");
  CHECK(asked == 0);
}

TEST_CASE("a slip that is undone is told from one that stays") {
  CHECK(places("xx=", "abaa") == "(undone at 1)(undoes 0).");
  CHECK(places("x=x", "abba") == "(undone at 2).(undoes 0)");
  CHECK(places("=xx=", "aabaa") == ".(undone at 2)(undoes 1).");
}

TEST_CASE("a second slip on top of the first is a further one, and one behind it is a first one") {
  CHECK(places("xx", "abc") == "(stays)(further to 0)");
  CHECK(places("xxx", "abab") == "(undone at 1)(undoes 0)(stays)");
  CHECK(places("xxx", "abca") == "(undone at 2)(further to 0)(undoes 0)");
}

TEST_CASE("what is open says nothing of the end, unless the ends tell") {
  CHECK(places("x?", "aba") == "(undone at 1).");
  CHECK(places("x?", "abc") == "(stays).");
  CHECK(places("?=", "aaa") == "..");
}

TEST_CASE("a slip is not followed across another relation") {
  CHECK(places("x<x", "abca") == "(stays).(stays)");
  CHECK(places("===", "aaaa") == "...");
}

}  // namespace
}  // namespace rigor
