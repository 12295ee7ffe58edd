// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/said_kinds.h"

#include "catch.h"

namespace {

std::string said(std::string_view sentence) {
  std::string text;
  for (const rigor::SaidKind& kind : rigor::said_kinds(sentence))
    text += std::to_string(kind.maths) + ":" + std::string(kind.relations.front()) + " ";
  return text;
}

}  // namespace

TEST_CASE("an adjective speaks of the letters behind it", "[said]") {
  CHECK(said("for positive $ \n") == "0:$ > 0 ");
  CHECK(said("for a positive charge $ and negative $ \n") == "0:$ > 0 1:$ < 0 ");
  CHECK(said("with $ and nonzero constants $, $ and $, \n") == "1:$ \\ne 0 2:$ \\ne 0 3:$ \\ne 0 ");
  CHECK(said("for an acute angle $ \n") == "0:\\cos $ > 0 ");
}

TEST_CASE("an adjective speaks of the letters before it, with a verb or behind a preposition", "[said]") {
  CHECK(said("\n where $, $ are positive constants") == "1:$ > 0 0:$ > 0 ");
  CHECK(said("\n where $ is positive and $ is negative") == "0:$ > 0 1:$ < 0 ");
  CHECK(said("for $ positive, \n") == "0:$ > 0 ");
}

TEST_CASE("what negates, compares or goes on says nothing", "[said]") {
  CHECK(said("if $ is not positive, \n").empty());
  CHECK(said("where $ is positive or zero \n").empty());
  CHECK(said("where $ is positive definite \n").empty());
  CHECK(said("where $ is positive if $ \n").empty());
  CHECK(said("in the positive direction $ \n").empty());
  CHECK(said("an acute triangle with $ \n").empty());
}
