// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/rows.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// Cells with ` & ` and rows with ` // ` between; a row's tag and label in brackets, `text:` where \intertext
/// stands above.
std::string rows(const std::string& text) {
  Stretch stretch(text);
  std::string result;
  for (const Row& row : read_rows(stretch.tokens, stretch.diagnostics, stretch.uses)) {
    if (!result.empty()) result += " // ";
    if (row.after_text) result += "text: ";
    for (const Tokens& cell : row.cells) {
      if (&cell != row.cells.data()) result += " & ";
      result += text_of(cell);
    }
    for (const std::string& name : {row.tag, row.label}) result += name.empty() ? "" : " [" + name + "]";
  }
  return stretch.complaints() + result;
}

}  // namespace

TEST_CASE("rows end at a line break, cells at an alignment mark") {
  CHECK(rows("a &= b \\\\ &= c") == "a & = b //  & = c");
  CHECK(rows("a \\cr b \\newline c") == "a // b // c");
  CHECK(rows("a && b") == "a &  & b");
}

TEST_CASE("there is always a row, and empty rows vanish") {
  CHECK(rows("") == "");
  CHECK(rows("a \\\\ \\\\ b \\\\") == "a // b");
}

TEST_CASE("a length behind a line break vanishes, another bracket stays") {
  CHECK(rows("a \\\\[2pt] b") == "a // b");
  CHECK(rows("a \\\\[-0.5em] b") == "a // b");
  CHECK(rows("a \\\\*[1ex] b") == "a // b");
  CHECK(rows("a \\\\[\\smallskipamount] b") == "a // b");
  CHECK(rows("a \\\\ [A, B] = c") == "a // [A, B] = c");
  CHECK(rows("a \\\\ [2] b") == "a // [2] b");
}

TEST_CASE("tags and labels leave the row that they name") {
  CHECK(rows("a \\tag{6} \\\\ b \\label{eq:b}") == "a [(6)] // b [eq:b]");
  CHECK(rows("\\tag*{X} a") == "a [X]");
  CHECK(rows("\\label{eq:a} a \\tag{2.3a}") == "a [(2.3a)] [eq:a]");
}

TEST_CASE("a tag on an empty row belongs to the row above") {
  CHECK(rows("a \\\\ \\tag{6}") == "a [(6)]");
  CHECK(rows("a \\\\ \\label{x}") == "a [x]");
}

TEST_CASE("the rows of an inner alignment are rows of the display") {
  for (const char* name : {"aligned", "split", "gathered", "align*", "multlined"}) {
    const std::string inner = std::string("{") + name + "}";
    CHECK(rows("\\begin" + inner + "a &= b \\\\ &= c\\end" + inner) == "a & = b //  & = c");
  }
  CHECK(rows("\\begin{aligned}[t]a\\end{aligned}") == "a");
  CHECK(rows("\\begin{alignedat}{2}a &= b\\end{alignedat}") == "a & = b");
}

TEST_CASE("the rows of a matrix and of a definition by cases stay inside it") {
  CHECK(rows("\\begin{pmatrix}a & b \\\\ c & d\\end{pmatrix} \\\\ e") ==
        "\\begin{pmatrix}a & b \\\\ c & d\\end{pmatrix} // e");
  CHECK(rows("f = \\begin{cases}a & b \\\\ c & d\\end{cases}") ==
        "f = \\begin{cases}a & b \\\\ c & d\\end{cases}");
  CHECK(rows("{a & b}") == "{a & b}");
}

TEST_CASE("cases that are a whole row are a system of equations") {
  CHECK(rows("\\begin{cases}a = b \\\\ c = d\\end{cases}") == "a = b // c = d");
  CHECK(rows("\\begin{cases}a &= b \\\\ c &= d\\end{cases} \\tag{3}") == "a & = b // c & = d [(3)]");
  CHECK(rows("\\begin{cases}a = b \\\\ c = d\\end{cases}.") == "a = b // c = d.");
}

TEST_CASE("sizes before a bracket vanish, and a sized bar knows its side") {
  CHECK(rows("\\left( a \\right)") == "( a )");
  CHECK(rows("\\bigl[ a \\Bigr]") == "[ a ]");
  CHECK(rows("\\left| a \\right|") == "\\lvert a \\rvert");
  CHECK(rows("\\bigl\\| a \\bigr\\|") == "\\lVert a \\rVert");
  CHECK(rows("\\left. a \\right|") == "a \\rvert");
  CHECK(rows("\\left. a \\right|_b") == "{ a }\\vert_b");  // it closes no bracket around it
  CHECK(rows("\\big| a \\big|") == "| a |");
}

TEST_CASE("a sized bar has the span of its size as well") {
  Stretch stretch("\\left| a \\right|");
  const std::vector<Row> read = read_rows(stretch.tokens, stretch.diagnostics, stretch.uses);
  CHECK(stretch.written(read[0].cells[0].front().span) == "\\left|");
}

TEST_CASE("what only takes space vanishes with its argument, what is coloured stays") {
  CHECK(rows("a\\phantom{bc} + d\\vspace{2pt}") == "a + d");
  CHECK(rows("\\textcolor{red}{a}") == "{a}");
  CHECK(rows("a = b\\footnote{c = d}") == "a = b");
}

TEST_CASE("a horizontal space with a length is a wide space") {
  CHECK(rows("a \\hspace{1cm} b") == "a \\quad b");
  CHECK(rows("a \\hspace*{1cm} b") == "a \\quad b");
}

TEST_CASE("words between rows end the row and are remembered") {
  CHECK(rows("a \\\\ \\intertext{and so} b") == "a // text: b");
  CHECK(rows("a \\shortintertext{and so} b \\\\ c") == "a // text: b // c");
}

TEST_CASE("an environment that is not closed is reported at its begin, one not opened at its end") {
  CHECK(rows("a \\begin{aligned}b") == "3 unbalanceda b");
  CHECK(rows("a \\end{aligned} b") == "3 unbalanceda \\end{aligned} b");
  CHECK(rows("\\begin{aligned}a\\end{split}\\end{aligned}").starts_with("17 unbalanced"));
}
