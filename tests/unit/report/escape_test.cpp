// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/escape.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("a path is a URI byte by byte") {
  CHECK(uri_of_path("notes/a b#c%.tex") == "notes/a%20b%23c%25.tex");
  CHECK(uri_of_path("ü\xff:?") == "%C3%BC%FF%3A%3F");
  CHECK(uri_of_path("/home/a.tex") == "file:///home/a.tex");
}

TEST_CASE("a workflow command stays on its line and in its field") {
  CHECK(workflow_message("a\nb\r%::x, y") == "a%0Ab%0D%25::x, y");
  CHECK(workflow_property("a:b,c\n%") == "a%3Ab%2Cc%0A%25");
  CHECK(workflow_message("\x1b[31m\xff") == "\uFFFD[31m\uFFFD");
}

}  // namespace
}  // namespace rigor
