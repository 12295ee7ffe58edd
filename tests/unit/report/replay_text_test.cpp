// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/replay_text.h"

#include "catch.h"
#include "example_report.h"

namespace rigor {
namespace {

/// The refuted step of the example, as it was recorded and put in again.
struct Replayed {
  SourceMap sources;
  FileReport notes = example_report(sources).files[0];
  RecordedStep recorded{.file = "notes/products.md",
                        .line = 3,
                        .column = 3,
                        .source = notes.steps[1].source,
                        .example = *notes.steps[1].counterexample,
                        .step = 1,
                        .replayed = true};
  std::string first_line() {
    const std::string text = print_replay(recorded, notes, sources);
    return text.substr(0, text.find('\n'));
  }
};

TEST_CASE("a refutation that is confirmed is one line") {
  Replayed replayed;
  CHECK(is_confirmed(replayed.recorded, replayed.notes));
  CHECK(print_replay(replayed.recorded, replayed.notes, replayed.sources) ==
        "notes/products.md:3:3: confirmed: left 1, right -1\n");
}

TEST_CASE("what is not confirmed is an error with its place and its reason") {
  Replayed replayed;
  replayed.recorded.fault = "the step holds on the sample";
  CHECK(replayed.first_line() ==
        "notes/products.md:3:30: error: not confirmed: the step holds on the sample [not-confirmed]");
  replayed.recorded.fault.clear();
  replayed.notes.steps[1].verdict = Verdict::definition;
  CHECK(replayed.first_line() ==
        "notes/products.md:3:30: error: not confirmed: the step is `definition` now [not-confirmed]");
  replayed.recorded.step.reset();
  CHECK(replayed.first_line() ==
        "notes/products.md:3:3: error: not confirmed: the notes have no such step at 3:3 [not-confirmed]");
  replayed.recorded.line = 1'000'000;
  CHECK(replayed.first_line() ==
        "notes/products.md:4:1: error: not confirmed: the notes have no such step at "
        "1000000:3 [not-confirmed]");
}

TEST_CASE("what was confirmed is counted") {
  CHECK(print_tally({}) == "0 refutations: 0 confirmed");
  CHECK(print_tally({.confirmed = 1}) == "1 refutation: 1 confirmed");
  CHECK(print_tally({.confirmed = 2, .not_confirmed = 1}) == "3 refutations: 2 confirmed, 1 not confirmed");
}

}  // namespace
}  // namespace rigor
