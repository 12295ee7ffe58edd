// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/shown_notes.h"

#include "catch.h"
#include "check/check.h"

namespace rigor {

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

}  // namespace rigor
