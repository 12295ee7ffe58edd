// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/ctest_listing.h"

#include "catch.h"
#include "check/entry/check.h"

namespace rigor {
namespace {

TEST_CASE("a text is one argument of CMake, whatever brackets are in it") {
  CHECK(cmake_argument("a;b \"$c\" \\") == "[[a;b \"$c\" \\]]");
  CHECK(cmake_argument("a]") == "[=[a]]=]");
  CHECK(cmake_argument("]]x]=]") == "[==[]]x]=]]==]");
  CHECK(cmake_argument("\nx") == "[[\n\nx]]");
  CHECK(cmake_argument("") == "[[]]");
}

TEST_CASE("a listing has a test for each case, and knows the files that it depends on") {
  SourceMap sources;
  const FileReport file = check_text(sources, "/nowhere/n.md", "$$1 = 1 \\tag{a]b}$$\n");
  const std::string text = ctest_listing(test_cases(file, sources, {.name = "n"}), file, sources);
  const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
  CHECK(
      has("add_test([=[n (a]b) step 1]=] \"${rigor_program}\" case \"${rigor_results}\" -- [=[n (a]b) step "
          "1]=])\n"));
  CHECK(has("set_tests_properties([[n (whole file)]] PROPERTIES "));
  CHECK(has("OR [[/nowhere/n.md]] IS_NEWER_THAN \"${rigor_listing}\""));
  CHECK(has("OR EXISTS [[/nowhere/n.rigor]]"));
  CHECK_FALSE(has("OR TRUE"));
}

TEST_CASE("a listing does not last while an input is missing") {
  SourceMap sources;
  const FileReport file = check_text(sources, "/nowhere/n.tex", "\\input{part}\n$$1 = 1$$\n");
  const std::string text = ctest_listing(test_cases(file, sources, {.name = "n"}), file, sources);
  CHECK(text.find("OR TRUE") != std::string::npos);
}

}  // namespace
}  // namespace rigor
