// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/latin1.h"

#include "catch.h"

namespace {

using namespace rigor;

std::string decoded(std::string text) {
  static_cast<void>(decode_latin1(text, 0));
  return text;
}

}  // namespace

TEST_CASE("letters and marks of Latin-1 become UTF-8, with a warning at the first") {
  std::string text = "un caf\xE9, \x93pi\xE8ge\x94";
  const Diagnostics found = decode_latin1(text, 3);
  CHECK(text == "un café, “piège”");
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == DiagnosticKind::read_as_latin1);
  CHECK(found[0].span == Span{3, 6, 7});
  CHECK(found[0].message == "byte `0xE9` is not UTF-8; the text is read as Latin-1");
}

TEST_CASE("UTF-8, and what is neither, stays as it is") {
  for (const char* text : {"plain", "café", "caf\xE9 and café", "a\xFF", "a\x81",
                           "\\usepackage[utf8]{inputenc} \xE9", "\\usepackage[latin2]{inputenc} \xE9"}) {
    INFO(text);
    CHECK(decoded(text) == text);
  }
  CHECK(decoded(std::string("\xE9\0", 2)) == std::string("\xE9\0", 2));
}

TEST_CASE("signs of mathematics are read only where the notes name the alphabet") {
  CHECK(decoded("2\xB7x \xD7 \xE9") == "2\x1Ax \x1A é");
  CHECK(decoded("\\usepackage[latin1]{inputenc} 2\xB7x") == "\\usepackage[latin1]{inputenc} 2·x");
}
