// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/entry/read_rows.h"

#include <algorithm>

#include "catch.h"

namespace rigor {
namespace {

NotesReading reading_of(const std::string& text) {
  SourceMap sources;
  return read_rows_of_text(sources, "notes.md", text);
}

const ReadLetter& letter_in(const ReadRow& row, const std::string& name) {
  const auto found = std::ranges::find(row.letters, name, &ReadLetter::name);
  REQUIRE(found != row.letters.end());
  return *found;
}

}  // namespace

TEST_CASE("a row is shown with the sums that the summation convention leaves out") {
  const NotesReading reading =
      reading_of("$$\\mathbf L = \\mathbf r\\times\\mathbf p$$\n\n$$L_iL_i = L_jL_j$$\n");
  REQUIRE(reading.rows.size() == 2);
  CHECK(reading.rows[1].statement == "\\sum_i L_i L_i = \\sum_j L_j L_j");
  const ReadLetter& index = letter_in(reading.rows[1], "i");
  CHECK(index.kind == LetterKind::index);
  CHECK(index.summed);
  CHECK(index.repeated);
}

TEST_CASE("a sum that is written is no sum over a letter that stands twice") {
  const NotesReading reading = reading_of("$$\\sum_i A_iB_i = \\mathbf A\\cdot\\mathbf B$$\n");
  REQUIRE(reading.rows.size() == 1);
  for (const ReadLetter& letter : reading.rows[0].letters) CHECK_FALSE(letter.repeated);
}

TEST_CASE("the role of a row is that of a definition, a law, a conclusion or an identity") {
  const NotesReading reading = reading_of(
      "$$\\mathbf L = \\mathbf r\\times\\mathbf p$$\n\n$$F = ma$$\n\nHence\n\n$$F + g = 0$$\n\n$$(a+b)^2 = "
      "a^2 + 2ab + b^2$$\n");
  REQUIRE(reading.rows.size() == 4);
  CHECK(reading.rows[0].role == RowRole::definition);
  CHECK(reading.rows[1].role != RowRole::unread);
  CHECK(reading.rows[2].role == RowRole::conclusion);
  CHECK(reading.rows[2].announced == "hence");
  CHECK(reading.rows[3].role == RowRole::identity);
}

TEST_CASE("a later link of a chain that is no identity is a conclusion") {
  const NotesReading reading = reading_of("$$m\\ddot x = -kx = F$$\n");
  REQUIRE(reading.rows.size() == 2);
  CHECK(reading.rows[0].role == RowRole::law);
  CHECK(reading.rows[1].role == RowRole::conclusion);
  CHECK(reading.rows[1].link == 2);
}

TEST_CASE("a row rests on the laws above that share a letter with it, and on no others") {
  const NotesReading reading =
      reading_of("$$m\\ddot x = -kx$$\n\n$$p\\ddot y = -qy$$\n\nHence\n\n$$\\ddot x = -4x$$\n");
  REQUIRE(reading.rows.size() == 3);
  REQUIRE(reading.rows[2].grounds.size() == 1);
  CHECK(reading.rows[2].grounds[0].kind == Ground::Kind::law);
  CHECK(reading.rows[2].grounds[0].name == "law in line 1");
  CHECK(reading.rows[0].grounds.empty());
}

TEST_CASE("a letter is shown with the directive that says what it is") {
  const NotesReading reading =
      reading_of("<!-- rigor: constant q -->\n\n$$q\\,\\hat{\\mathbf n}\\cdot\\mathbf E = 3$$\n");
  REQUIRE(reading.rows.size() == 1);
  const ReadLetter& q = letter_in(reading.rows[0], "q");
  CHECK(q.constant);
  REQUIRE(q.sources.size() == 1);
  CHECK(q.sources[0].kind == SourceKind::directive);
  CHECK(q.sources[0].text == "constant q");
  CHECK(letter_in(reading.rows[0], "\\hat{n}").kind == LetterKind::unit_vector);
  CHECK(letter_in(reading.rows[0], "\\mathbf{E}").kind == LetterKind::vector);
}

TEST_CASE("a row that is not read has no statement, and its step says why") {
  const NotesReading reading = reading_of("$$\\mathbf a = \\mathbf A\\times\\mathbf B\\times\\mathbf C$$\n");
  REQUIRE(reading.rows.size() == 1);
  CHECK(reading.rows[0].role == RowRole::unread);
  CHECK(reading.rows[0].statement.empty());
  CHECK_FALSE(reading.report.steps[reading.rows[0].step].diagnostics.empty());
}

TEST_CASE("a condition behind a row is shown next to it") {
  const NotesReading reading = reading_of("$$\\sqrt{p^2} = p \\quad\\text{for } p > 0$$\n");
  REQUIRE_FALSE(reading.rows.empty());
  CHECK(std::ranges::count(reading.rows[0].restricted, "it holds where `p > 0`") == 1);
}

}  // namespace rigor
