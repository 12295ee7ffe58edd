// SPDX-License-Identifier: GPL-3.0-or-later
// A claim of a sidecar that is refuted shows of which line of the notes it is said.
#include "check/event/sidecar_places.h"

#include "catch.h"
#include "check/entry/check.h"
#include "check/question/decision_cache.h"
#include "check/review/review.h"
#include "check/walk/walk.h"

using namespace rigor;

namespace {

/// The line of the last label of the last step's only diagnostic, and its file; 0 without a label.
std::pair<std::uint32_t, std::string> place_of(const std::string& sidecar) {
  SourceMap sources;
  const FileId notes_file = sources.add("notes.md", "# Notes\n\nIn words.\n\n$$a = a$$\n");
  const FileId beside = sources.add("notes.rigor", sidecar);
  FileReport report;
  report.file = notes_file;
  const Notes notes = read_notes(sources, notes_file, &beside, report.diagnostics);
  DecisionCache cache;
  const CheckOptions options{.cache = &cache};
  review(walk_through(sources, notes, report, options), notes, sources, report);
  for (const Step& step : report.steps) {
    if (step.diagnostics.empty()) continue;
    const std::vector<Label>& labels = step.diagnostics[0].labels;
    if (labels.empty() || labels.back().text != "said of this place") return {0, ""};
    const Span span = labels.back().span;
    return {sources.line_column(span.file, span.begin).line, sources.path(span.file)};
  }
  return {0, "no diagnostic"};
}

}  // namespace

TEST_CASE("a diagnostic about a sidecar's claim shows the place in the notes") {
  CHECK(place_of("at line 3\nscalar b\nclaim b = 2b\n") == std::pair{3u, std::string("notes.md")});
  CHECK(place_of("at section \"Notes\"\nscalar b\nclaim b = 2b\n") == std::pair{5u, std::string("notes.md")});
}

TEST_CASE("what a sidecar says from the start is about no place") {
  CHECK(place_of("scalar b\nclaim b = 2b\n") == std::pair{0u, std::string()});
}
