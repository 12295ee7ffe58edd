// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/shown_notes.h"

#include "catch.h"
#include "check/entry/check.h"

namespace rigor {

namespace {

/// The shown equations of a report, in their order.
std::vector<ShownEquation> equations_of(const ShownNotes& notes) {
  std::vector<ShownEquation> equations;
  for (const ShownItem& item : notes.items) {
    if (const auto* equation = std::get_if<ShownEquation>(&item)) equations.push_back(*equation);
  }
  return equations;
}

/// What the macro says at the equation: its tokens.
std::string meaning_at(const ShownNotes& notes, const ShownEquation& equation, const std::string& macro) {
  std::string text;
  for (const Token& token : notes.macros.at(equation.macros).at(macro).body) text += token.text;
  return text;
}

}  // namespace

TEST_CASE("what a step uses is a word, LaTeX and a place") {
  const Use tagged = use_of("definition I_{ij} (8)");
  CHECK(tagged.word == "definition");
  CHECK(tagged.latex == "I_{ij}");
  CHECK(tagged.place == "(8)");
  const Use placed = use_of("definition (\\Omega_1)^2 in line 312");
  CHECK(placed.latex == "(\\Omega_1)^2");
  CHECK(placed.place == "line 312");
  const Use given = use_of("given f (x)");
  CHECK(given.latex == "f (x)");
  CHECK(given.place.empty());
  CHECK(use_of("convention: `A` is a length").place == "`A` is a length");
  const Use law = use_of("law in line 12");
  CHECK(law.word == "law");
  CHECK(law.latex.empty());
  CHECK(law.place == "in line 12");
  CHECK(use_of("result (3)").place == "(3)");
}

TEST_CASE("each step stands at its display and statements of directives before the next one") {
  SourceMap sources;
  const FileReport report = check_text(
      sources, "n.md", "# One\n\n$$a = b$$\n\n<!-- rigor: given a = 2 -->\n\n$$a = b = 2$$\n\n$$\\loop$$\n");
  const ShownNotes notes = show_notes(sources, report);
  std::size_t steps = 0;
  std::size_t stated = 0;
  for (const ShownItem& item : notes.items) {
    const auto* equation = std::get_if<ShownEquation>(&item);
    if (equation == nullptr) continue;
    steps += equation->steps.size();
    if (!equation->displayed) ++stated;
  }
  CHECK(notes.items.size() == 5);
  CHECK(stated == 1);
  CHECK(steps == report.steps.size());
  CHECK_FALSE(std::get<ShownEquation>(notes.items[2]).displayed);
}

TEST_CASE("an expected refutation needs no attention and an unexpected proof does") {
  Step step;
  step.verdict = Verdict::refuted;
  CHECK(needs_attention(step));
  step.expected_refuted = true;
  CHECK_FALSE(needs_attention(step));
  step.verdict = Verdict::proved;
  CHECK(needs_attention(step));
  step.expected_refuted = false;
  CHECK_FALSE(needs_attention(step));
  CHECK(verdict_words(step) == "proved");
}

TEST_CASE("each equation has the macros that are in force at it") {
  SourceMap sources;
  const FileReport report = check_text(sources, "n.tex",
                                       "\\newcommand{\\s}{-}\n\\[ 1 = \\s 1 \\]\n% rigor: given a = \\s 2\n"
                                       "\\renewcommand{\\s}{+}\n\\[ 1 = \\s 1 \\]\n"
                                       "\\[ \\def\\s{*} 1 = 1 \\]\n\\[ 2 = 2 \\]\n");
  const ShownNotes notes = show_notes(sources, report);
  const std::vector<ShownEquation> equations = equations_of(notes);
  REQUIRE(equations.size() == 5);
  CHECK(meaning_at(notes, equations[0], "s") == "-");
  CHECK_FALSE(equations[1].displayed);
  CHECK(meaning_at(notes, equations[1], "s") == "-");
  CHECK(meaning_at(notes, equations[2], "s") == "+");
  CHECK(meaning_at(notes, equations[3], "s") == "*");
  CHECK(meaning_at(notes, equations[4], "s") == "+");  // a display is a group
  CHECK(notes.macros.size() == 4);
}

}  // namespace rigor
