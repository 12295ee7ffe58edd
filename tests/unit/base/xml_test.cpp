// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/xml.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("nothing ends an element or an attribute of XML before its time") {
  CHECK(xml_escaped("]]> & <a b=\"c\" d='e'>") == "]]&gt; &amp; &lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;");
  CHECK(xml_escaped("a\nb\tc\r") == "a&#10;b&#9;c&#13;");
}

TEST_CASE("what XML cannot have becomes U+FFFD") {
  CHECK(xml_escaped(std::string_view("\0\x01\x1b", 3)) == "\uFFFD\uFFFD\uFFFD");
  CHECK(xml_escaped("\xff\xc3") == "\uFFFD\uFFFD");
  CHECK(xml_escaped("\uFFFE") == "\uFFFD");
  CHECK(xml_escaped("ω∇") == "ω∇");
}

}  // namespace
}  // namespace rigor
