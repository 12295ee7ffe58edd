// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/escape.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("nothing ends an element or an attribute of XML before its time") {
  CHECK(xml_text("]]> & <a b=\"c\" d='e'>") == "]]&#62; &#38; &#60;a b=&#34;c&#34; d=&#39;e&#39;&#62;");
  CHECK(xml_text("a\nb\tc\r") == "a&#10;b&#9;c&#13;");
}

TEST_CASE("what XML cannot have becomes U+FFFD") {
  CHECK(xml_text(std::string_view("\0\x01\x1b", 3)) == "\uFFFD\uFFFD\uFFFD");
  CHECK(xml_text("\xff\xc3") == "\uFFFD\uFFFD");
  CHECK(xml_text("\uFFFE") == "\uFFFD");
  CHECK(xml_text("ω∇") == "ω∇");
}

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
