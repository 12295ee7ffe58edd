// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/decide_by_record.h"

#include "catch.h"
#include "check/entry/check.h"

namespace rigor {
namespace {

/// Notes that were checked, and their refuted steps as a report records them.
struct Replayed {
  std::string text;
  RecordedSteps recorded;

  explicit Replayed(std::string notes) : text(std::move(notes)) {
    SourceMap sources;
    const FileReport report = check_text(sources, "notes.md", text);
    for (const Step& step : report.steps) {
      if (step.verdict != Verdict::refuted) continue;
      const LineColumn place = sources.line_column(step.span.file, step.span.begin);
      recorded.push_back({.file = "notes.md",
                          .line = place.line,
                          .column = place.column,
                          .source = step.source,
                          .example = *step.counterexample});
    }
    REQUIRE(recorded.size() == 1);
  }
  Counterexample& example() { return recorded[0].example; }
  /// What speaks against the recorded sample in the notes, or in others.
  std::string fault() { return fault_in(text); }
  std::string fault_in(const std::string& notes) {
    SourceMap sources;
    RecordedSteps steps = recorded;
    CheckOptions options;
    options.recorded = &steps;
    const FileReport report = check_text(sources, "notes.md", notes, options);
    if (!steps[0].step) return "no such step";
    const Verdict verdict = report.steps[*steps[0].step].verdict;
    CHECK((verdict == Verdict::refuted) == steps[0].fault.empty());
    return steps[0].fault;
  }
};

const std::string cross = "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n";

TEST_CASE("a recorded sample is put in instead of being searched for") {
  Replayed notes(cross);
  CHECK(notes.fault() == "");
  // another sample than the search finds
  notes.example().values[0].components = {"7", "0", "0"};
  notes.example().values[1].components = {"0", "1/3", "5"};
  notes.example().component[0].value = 3;
  notes.example().left = "7/3";
  notes.example().right = "-7/3";
  CHECK(notes.fault() == "");
}

TEST_CASE("one number that was changed is found") {
  Replayed notes(cross);
  const Counterexample good = notes.example();
  std::size_t place = 0;
  while (good.values[0].components[place] == "0") ++place;
  notes.example().values[0].components[place] = "2";
  CHECK(notes.fault().starts_with("the report says left "));
  notes.example() = good;
  notes.example().left = "5";
  CHECK(notes.fault().starts_with("the report says left 5, right "));
  notes.example() = good;
  notes.example().values[0].components[0] = "1/0";
  CHECK(notes.fault() == "the sample's value for `\\mathbf{A}` is not one that this symbol can have");
  notes.example() = good;
  notes.example().component[0].value = 4;
  CHECK(notes.fault() == "the sample's component does not fit the step");
  notes.example() = good;
  notes.example().particles = 1;
  CHECK(notes.fault() == "the sample's particles or component do not fit the step");
}

TEST_CASE("symbols have to be those of the step") {
  Replayed notes(cross);
  const Counterexample good = notes.example();
  notes.example().values.pop_back();
  CHECK(notes.fault() == "the sample has no value of rank 1 for `\\mathbf{B}`");
  notes.example() = good;
  notes.example().values.push_back({"m", 0, 0, {"1"}});
  CHECK(notes.fault() == "the step does not depend on `m`");
}

TEST_CASE("the sides have to differ") {
  Replayed notes("<!-- rigor: for all x -->\n$$x^2 = 2x$$\n");
  notes.example().values[0].components = {"2"};
  notes.example().left = notes.example().right = "4";
  CHECK(notes.fault() == "the step holds on the sample");
}

TEST_CASE("the assumptions in force have to hold") {
  Replayed notes("<!-- rigor:\nfor all x, y\ngiven x = 2y\n-->\n$$x = y$$\n");
  CHECK(notes.fault() == "");
  notes.example().values[0].components = {"3"};
  CHECK(notes.fault() == "the sample does not satisfy given x = 2y");
}

TEST_CASE("notes that have changed are found") {
  Replayed notes(cross);
  CHECK(notes.fault_in("\n" + cross) == "no such step");
  CHECK(notes.fault_in("<!-- rigor: vector \\mathbf{A} -->\n") == "no such step");
  Replayed given("<!-- rigor:\nfor all x, y\ngiven x = 2y\n-->\n$$x = y$$\n");
  CHECK(given.fault_in("<!-- rigor:\nfor all x, y\ngiven x = 3y\n-->\n$$x = y$$\n") ==
        "the sample does not satisfy given x = 3y");
}

TEST_CASE("a step to first order, and a condition that only a derivative of an assumption shows") {
  Replayed nearly("<!-- rigor: small x -->\n$$(1+x)^3 \\approx 1 + 2x$$\n");
  CHECK(is_of_first_order(nearly.example()));
  CHECK(nearly.fault() == "");
  nearly.example().values[0].components = {"2"};
  CHECK(nearly.fault() == "the report says left 3, right 2, but its sample gives left 6, right 4");
  Replayed motion("<!-- rigor:\nfor all x, k\nconstant k\ngiven \\ddot{x} = -k^2x\n-->\n$$\\dot{x} = kx$$\n");
  CHECK(motion.fault() == "");
}

TEST_CASE("what is said to follow has to follow") {
  Replayed notes("<!-- rigor:\nscalar x\nlet y = 2x\n-->\n$$y = x$$\n");
  REQUIRE(notes.example().follows.size() == 1);
  CHECK(notes.fault() == "");
  notes.example().follows[0].components = {"7"};
  CHECK(notes.fault() == "the value of `y` does not follow from the sample");
}

}  // namespace
}  // namespace rigor
