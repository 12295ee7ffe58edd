// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/family.h"

#include <map>
#include <string>

#include "catch.h"

using namespace rigor;

namespace {

using Letters = std::map<std::string, int>;

std::optional<MemberName> member(const std::string& base) { return member_name({base, 0, false}); }

Evidence said(const char* prose) {
  Evidence evidence;
  see_counting(prose, true, evidence);
  return evidence;
}

CountingLetter counting(const char* prose, const std::string& letter) { return said(prose).counting[letter]; }

}  // namespace

TEST_CASE("a subscript that is a sum of numbers and letters names a member", "[family]") {
  CHECK(member("E_{1}")->number == 1);
  CHECK(member("E_{n}")->letters == Letters{{"n", 1}});
  const auto odd = member("E_{\\text{2n+1}}");
  REQUIRE(odd);
  CHECK(odd->sequence == "E");
  CHECK(odd->letters == Letters{{"n", 2}});
  CHECK(odd->number == 1);
  CHECK(member("E_{2n}")->letters == Letters{{"n", 2}});
  CHECK(member("\\lambda_{\\text{n-m}}")->letters == Letters{{"m", -1}, {"n", 1}});
}

TEST_CASE("a label, two indices and a vector name no member", "[family]") {
  CHECK_FALSE(member("E"));
  CHECK_FALSE(member("E_{kin}"));
  CHECK_FALSE(member("E_{nm}"));
  CHECK_FALSE(member("E_{12}"));
  CHECK_FALSE(member("E_{x}"));
  CHECK_FALSE(member("E_{t}"));
  CHECK_FALSE(member("E^{(0)}_{1}"));
  CHECK_FALSE(member_name({"E_{1}", 1, false}));
}

TEST_CASE("a range says which number is the first", "[family]") {
  CHECK(counting("for $n = 1, 2, 3, \\dots$", "n").first == 1);
  CHECK(counting("with $n = 0, 1, 2, \\ldots$ and", "n").first == 0);
  CHECK(counting("for $l\\geq 2$", "l").first == 2);
  CHECK(counting("where $n$ is a positive integer", "n").first == 1);
  CHECK(counting("for all $n\\in\\mathbb{N}$", "n").first == 1);
  CHECK(counting("the quantum number $l$", "l").said);
  CHECK_FALSE(counting("the mass $m$", "m").said);
}

TEST_CASE("some numbers only are no range", "[family]") {
  CHECK(counting("for $n = 1, 3, 5, \\dots$", "n").some_only);
  CHECK(counting("for odd $n$", "n").some_only);
  CHECK(counting("in glass with $n = 1.5$", "n").some_only);
  CHECK_FALSE(counting("for $n = 1, 2, 3, \\dots$", "n").some_only);
}

TEST_CASE("words set a quantity apart from the members", "[family]") {
  CHECK(said("a field of amplitude $E_0$").quantities_apart.contains("E_{0}"));
  CHECK(said("The natural frequency is $\\omega_{0}$.").quantities_apart.contains("\\omega_{0}"));
  CHECK(said("with $E_1 = 3$").quantities_apart.contains("E_{1}"));
  CHECK_FALSE(said("the ground state energy $E_0$").quantities_apart.contains("E_{0}"));
  CHECK(said("Two bodies with $E_1$ and $E_2$ meet.").quantities_apart.contains("E_{1}"));
  CHECK_FALSE(said("between $E_2$ and $E_1$").quantities_apart.contains("E_{1}"));
}
