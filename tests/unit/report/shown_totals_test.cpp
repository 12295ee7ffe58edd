// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/shown_totals.h"

#include "catch.h"
#include "check/entry/check.h"

namespace rigor {
namespace {

std::string words_of(const std::string& notes) {
  SourceMap sources;
  ShownTotals totals;
  add_to(totals, check_text(sources, "n.md", notes));
  return attention_words(totals, "<", ">");
}

constexpr const char* proved = "$$\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}$$\n\n";

}  // namespace

TEST_CASE("the head of a page says what needs attention and counts in good English") {
  CHECK(words_of(proved) == "1 step, and nothing needs attention");
  CHECK(words_of("$$1 = 2$$\n" + std::string(proved)) == "2 steps: <1 needs attention>");
  CHECK(words_of("$$1 = 2$$\n\n$$1 = 3$$\n") == "2 steps: <2 need attention>");
  CHECK(words_of("Only words.\n") == "There is no step to check; 1 warning about the notes as a whole");
}

TEST_CASE("nothing is said to be well where the file as a whole has a problem") {
  CHECK(words_of(std::string(proved) + "<!-- rigor: nonsense x -->\n") ==
        "1 step: none needs attention, but there is <1 problem with the notes as a whole>");
  CHECK(words_of(std::string(proved) + "\\[ a = b\n") ==
        "1 step: none needs attention, but there is <1 problem with the notes as a whole>");
  CHECK(words_of("$$1 = 2$$\n\n<!-- rigor: nonsense x -->\n") ==
        "1 step: <1 needs attention>, and there is <1 problem with the notes as a whole>");
  FileReport failed;
  failed.failure = "the process ended";
  ShownTotals totals;
  add_to(totals, failed);
  CHECK(attention_words(totals) == "There is no step to check, but 1 problem with the notes as a whole");
}

TEST_CASE("only the number of definitions changes its word") {
  CHECK(counted(Verdict::definition, 1) == "1 definition");
  CHECK(counted(Verdict::definition, 8) == "8 definitions");
  CHECK(counted(Verdict::not_understood, 8) == "8 not understood");
}

}  // namespace rigor
