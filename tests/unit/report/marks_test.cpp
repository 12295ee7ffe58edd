// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/marks.h"

#include "base/md5.h"
#include "catch.h"
#include "check/entry/check.h"

namespace rigor {
namespace {

std::string marks_of(const std::string& path, const std::string& text) {
  SourceMap sources;
  const FileReport report = check_text(sources, path, text);
  return to_marks(report, sources);
}

TEST_CASE("each display has its lines, the worst verdict in it and its steps") {
  const std::string text =
      "\\[ \\mathbf{A}\\times\\mathbf{A} = 0 \\]\n\n"
      "\\begin{align}\n  \\mathbf{A}\\cdot\\mathbf{B} &= \\mathbf{B}\\cdot\\mathbf{A} \\\\\n"
      "  &= -\\mathbf{B}\\cdot\\mathbf{A}\n\\end{align}\n"
      "$$ \\mathbf{C} = \\mathbf{A}\\times\\mathbf{B} $$\n"
      "\\[ \\mathbf{A} = \\int\\mathbf{B}\\,d\\theta \\]\n";
  CHECK(marks_of("notes/a.tex", text) == "rigor-marks 2\nabsent a.rigor\nfile " + md5(text) +
                                             " a.tex\n"
                                             "display 1 1 proved 1 1\n"
                                             "display 3 6 refuted 1 2\n"
                                             "display 7 7 given 1 1\n"
                                             "display 8 8 open 1 1\n");
}

TEST_CASE("what is skipped or malformed is not checked") {
  const std::string text = "% rigor: skip\n\\[ \\mathbf{A}\\times\\mathbf{B} = 0 \\]\n\\[ A_i = B_j \\]\n";
  const std::string marks = marks_of("a.tex", text);
  CHECK(marks.find("display 2 2 open 1 1\ndisplay 3 3 open 1 1\n") != std::string::npos);
}

TEST_CASE("a step that is proved and malformed is not checked") {
  const std::string marks = marks_of("a.tex", "% rigor: units a: L, t: T\n\\[ a + t = t + a \\]\n");
  CHECK(marks.find("display 2 2 open 1 1\n") != std::string::npos);
}

TEST_CASE("a display without steps has its line") {
  const std::string marks = marks_of("a.tex", "\\[ \\mathbf{A}+\\mathbf{B} \\] \\[ \\mathbf{C} \\]\n");
  CHECK(marks.find("display 1 1 silent 0 0\ndisplay 1 1 silent 0 0\n") != std::string::npos);
}

TEST_CASE(
    "a macro beside a display, or a brace that is closed elsewhere, makes it unclear which is typeset "
    "there") {
  const std::string display = "\\[ A^2 = A^2 \\]";
  for (const std::string& line : {"\\ignore{" + display + "} \\law", "\\iffalse " + display + " \\fi\\law",
                                  display + "}", "\\law" + display, "\\footnote{" + display}) {
    CAPTURE(line);
    CHECK(marks_of("a.tex", "{ words {\n" + line + "\n").find("display 2 2 proved") == std::string::npos);
  }
  for (const std::string& line : {"\\item so " + display + " with $\\omega$, 50\\% % \\law",
                                  "words\\footnote{as " + display + " says}"}) {
    CAPTURE(line);
    CHECK(marks_of("a.tex", line + "\n").find("display 1 1 proved 1 1") != std::string::npos);
  }
}

TEST_CASE("every file that was read has its digest, whether or not it has displays") {
  SourceMap sources;
  const FileReport report = check_text(sources, "notes/a.tex", "words\n");
  sources.add("notes/../b.rigor", "let\n");
  CHECK(to_marks(report, sources) == "rigor-marks 2\nabsent a.rigor\nfile " + md5("words\n") +
                                         " a.tex\nfile " + md5("let\n") + " ../b.rigor\n");
}

TEST_CASE("notes without displays are a file without marks") {
  CHECK(marks_of("a.tex", "words\n") == "rigor-marks 2\nabsent a.rigor\nfile " + md5("words\n") + " a.tex\n");
}

}  // namespace
}  // namespace rigor
