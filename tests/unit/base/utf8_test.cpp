// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/utf8.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("code points are counted, not bytes") {
  CHECK(count_code_points("") == 0);
  CHECK(count_code_points("abc") == 3);
  CHECK(count_code_points("ωé𝐀") == 3);
}

TEST_CASE("a byte that is not UTF-8 is read as a question mark and passed") {
  const std::string_view text = "a\xE9z";
  std::size_t offset = 1;
  CHECK(next_code_point(text, offset) == U'?');
  CHECK(offset == 2);
  CHECK(next_code_point(text, offset) == U'z');
  CHECK(offset == 3);
}

TEST_CASE("a code point that the text cuts off is passed byte by byte") {
  const std::string_view text = "\xE2\x82";
  std::size_t offset = 0;
  CHECK(next_code_point(text, offset) == U'?');
  CHECK(next_code_point(text, offset) == U'?');
  CHECK(offset == 2);
}

TEST_CASE("wide characters take two cells and combining marks none") {
  CHECK(cells(std::string_view("力")) == 2);
  CHECK(cells(std::string_view("e\u0301")) == 1);
  CHECK(cells(std::string_view("ω²")) == 2);
}

TEST_CASE("what could steer a terminal is not printed") {
  CHECK(printable("a\tb\r\nc") == "a b  c");
  CHECK(printable("\x1b[31mred\x7f") == "?[31mred?");
  CHECK(printable("a\u202Eb\u0085c") == "a?b?c");
  CHECK(printable("\xFFω") == "?ω");
}

TEST_CASE("a text is cut only where it is longer than the width") {
  CHECK(shorten("abcde", 5) == "abcde");
  CHECK(shorten("abcdef", 5) == "abcd…");
  CHECK(shorten("abcdef", 1) == "…");
  CHECK(shorten("abcdef", 0).empty());
  CHECK(shorten("", 0).empty());
}

TEST_CASE("a wide character that does not fit leaves its cell empty") {
  CHECK(shorten("力力力", 6) == "力力力");
  CHECK(shorten("力力力", 5) == "力力…");
  CHECK(shorten("力力力", 4) == "力…");
}

}  // namespace
}  // namespace rigor
