// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/source_map.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("lines and columns count from 1, columns in code points") {
  SourceMap sources;
  const FileId file = sources.add("a.md", "ab\nωx\n");
  CHECK(sources.line_column(file, 0) == LineColumn{1, 1});
  CHECK(sources.line_column(file, 2) == LineColumn{1, 3});
  CHECK(sources.line_column(file, 3) == LineColumn{2, 1});
  CHECK(sources.line_column(file, 5) == LineColumn{2, 2});
}

TEST_CASE("a byte inside a code point has that code point's column") {
  SourceMap sources;
  const FileId file = sources.add("a.md", "x𝐀y");
  for (std::uint32_t offset = 1; offset < 5; ++offset)
    CHECK(sources.line_column(file, offset) == LineColumn{1, 2});
  CHECK(sources.line_column(file, 5) == LineColumn{1, 3});
}

TEST_CASE("the end of the text is a place, and everything beyond is that place") {
  SourceMap sources;
  const FileId file = sources.add("a.md", "ab\n");
  CHECK(sources.line_count(file) == 2);
  CHECK(sources.line_column(file, 3) == LineColumn{2, 1});
  CHECK(sources.line_column(file, 4'000'000'000U) == LineColumn{2, 1});
  CHECK(sources.text(Span{file, 1, 99}) == "b\n");
  CHECK(sources.text(Span{file, 98, 99}).empty());
  CHECK(sources.text(Span{file, 2, 1}).empty());
}

TEST_CASE("an empty text has one empty line") {
  SourceMap sources;
  const FileId file = sources.add("a.md", "");
  CHECK(sources.line_count(file) == 1);
  CHECK(sources.line_text(file, 1).empty());
  CHECK(sources.line_column(file, 0) == LineColumn{1, 1});
}

TEST_CASE("a line's text has no line break of either sort, and no other line has a text") {
  SourceMap sources;
  const FileId file = sources.add("a.md", "one\r\ntwo\nthree");
  CHECK(sources.line_text(file, 1) == "one");
  CHECK(sources.line_text(file, 2) == "two");
  CHECK(sources.line_text(file, 3) == "three");
  CHECK(sources.line_text(file, 0).empty());
  CHECK(sources.line_text(file, 4).empty());
  CHECK(sources.line_start(file, 2) == 5);
  CHECK(sources.line_start(file, 4) == 14);
}

TEST_CASE("the ids of a map count from 0") {
  SourceMap sources;
  CHECK(sources.size() == 0);
  CHECK(sources.add("a.md", "") == 0);
  CHECK(sources.add("b.md", "") == 1);
  CHECK(sources.size() == 2);
}

TEST_CASE("a file beyond the map is empty") {
  const SourceMap sources;
  CHECK(sources.path(7) == "(no file)");
  CHECK(sources.text(7).empty());
  CHECK(sources.line_column(7, 5) == LineColumn{1, 1});
  CHECK(sources.line_text(7, 1).empty());
  CHECK(sources.line_count(7) == 1);
}

TEST_CASE("a text stays where it is when others are added") {
  SourceMap sources;
  const std::string_view first = sources.text(sources.add("a.md", "short"));
  for (int i = 0; i < 1000; ++i) sources.add("b.md", "x");
  CHECK(first == "short");
  CHECK(sources.text(0).data() == first.data());
}

TEST_CASE("columns are right around every block of a long line") {
  std::string text = "first line\n";
  for (int i = 0; i < 20'000; ++i) text += i % 3 == 0 ? "ω" : "x";
  SourceMap sources;
  const FileId file = sources.add("a.md", text);
  std::uint32_t column = 1;
  std::uint32_t wrong = 0;
  for (std::uint32_t offset = 11; offset < text.size(); ++offset) {
    const bool starts = (static_cast<unsigned char>(text[offset]) & 0xC0U) != 0x80U;
    if (starts && sources.line_column(file, offset) != LineColumn{2, column++}) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(column == 20'001);
  CHECK(sources.line_column(file, static_cast<std::uint32_t>(text.size())) == LineColumn{2, 20'001});
}

TEST_CASE("ten thousand places at the end of a line of 10 MB are found at once") {
  SourceMap sources;
  const FileId file = sources.add("a.md", std::string(10'000'000, 'x'));
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    const LineColumn place = sources.line_column(file, 9'990'000 + i);
    if (place.column != 9'990'001 + i) FAIL("wrong column at " << i);
  }
}

}  // namespace
}  // namespace rigor
