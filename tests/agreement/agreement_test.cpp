// SPDX-License-Identifier: GPL-3.0-or-later
#include "agreement.h"

#include <cstdio>
#include <cstdlib>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "scene/file/body_file.h"

namespace rigor::agreement {
namespace {

constexpr double uncertainty = 16 * 0x1p-53;

std::vector<Body> sample_bodies(SourceMap& sources) {
  std::vector<Body> bodies;
  for (const std::string& name : body_names({"derivations/bodies"})) {
    Diagnostics diagnostics;
    auto body = read_body_file("derivations/bodies/" + name + ".toml", sources, diagnostics);
    REQUIRE(body.has_value());
    if (body->size() <= 200) bodies.push_back(std::move(*body));
  }
  return bodies;
}

struct Tally {
  std::size_t proved = 0;     // steps compared on at least one trial
  std::size_t on_bodies = 0;  // of these on at least one body
  std::size_t not_tried = 0;  // no numbers that meet the assumptions were found
  std::size_t refuted = 0;
  std::size_t comparisons = 0;
  std::size_t open = 0;  // of these: a bound is infinite, or it is an order and the sides are too close
};

void check_proved(const ExprTree& tree, const Question& question, std::span<const Body> bodies,
                  Tally& tally) {
  const Trials trials = trials_for(tree, question, bodies);
  bool on_body = false;
  for (const auto& [name, samples] : trials.samples) {
    std::string detail;
    const Finding found = compare(tree, question, samples, uncertainty, detail);
    INFO("on " << name << ": " << detail);
    CHECK(found != Finding::not_related);
    ++tally.comparisons;
    if (found == Finding::open) ++tally.open;
    for (const Body& body : bodies) on_body = on_body || body.name == name;
  }
  if (on_body) ++tally.on_bodies;
  ++(trials.samples.empty() ? tally.not_tried : tally.proved);
}

Tally check_notes(const std::string& path) {
  SourceMap sources;
  const std::vector<Body> bodies = sample_bodies(sources);
  const FormsReading reading = read_forms(sources, path, {});
  REQUIRE_FALSE(reading.report.unreadable);
  Tally tally;
  for (const WrittenFormChain& chain : reading.forms.chains) {
    for (std::size_t k = 0; k < chain.steps.size(); ++k) {
      const WrittenStep& step = chain.steps[k];
      if (!step.outcome || !step.question) continue;
      INFO(path << ":" << sources.line_column(chain.span.file, chain.span.begin).line << ": "
                << chain.forms[k].source << " " << step.kind << " " << chain.forms[k + 1].source);
      if (*step.outcome == Outcome::proved) check_proved(reading.forms.tree, *step.question, bodies, tally);
      if (*step.outcome == Outcome::refuted) {
        REQUIRE(step.sample.has_value());
        std::string detail;
        const Finding found = compare_at_sample(reading.forms.tree, *step.question, *step.sample, detail);
        INFO(detail);
        const Relation relation = step.question->claim.relation;
        const bool order = relation == Relation::less || relation == Relation::less_or_equal;
        // a claimed ≠ is refuted where the sides are equal, which no bound can show
        const bool equal = relation == Relation::unequal && found == Finding::open;
        CHECK((found == Finding::not_related || equal || (order && found == Finding::open)));
        ++tally.refuted;
      }
    }
  }
  return tally;
}

/// The question of the first step of some notes that was decided.
struct Asked {
  SourceMap sources;
  FormsReading reading;
  const WrittenStep* step = nullptr;

  explicit Asked(const std::string& notes) {
    reading = read_forms_of_text(sources, "notes.md", notes, {});
    for (const WrittenFormChain& chain : reading.forms.chains) {
      for (const WrittenStep& each : chain.steps) {
        if (step == nullptr && each.question) step = &each;
      }
    }
    REQUIRE(step != nullptr);
  }
  [[nodiscard]] Finding on_trials() const {
    Finding worst = Finding::related;
    const Trials trials = trials_for(reading.forms.tree, *step->question, {});
    REQUIRE_FALSE(trials.samples.empty());
    for (const auto& [name, samples] : trials.samples) {
      std::string detail;
      const Finding found = compare(reading.forms.tree, *step->question, samples, uncertainty, detail);
      if (found == Finding::not_related) worst = found;
    }
    return worst;
  }
};

}  // namespace

TEST_CASE("a proof of what is false would be noticed") {
  CHECK(Asked("$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$").on_trials() ==
        Finding::not_related);
  CHECK(Asked("$$\\mathbf{A}\\times\\mathbf{B} = -\\mathbf{B}\\times\\mathbf{A}$$").on_trials() ==
        Finding::related);
  CHECK(Asked("<!-- rigor: scalar a, b -->\n$$a^2 + b^2 < 2ab$$").on_trials() == Finding::not_related);
  CHECK(Asked("<!-- rigor: scalar a, b -->\n$$a^2 + b^2 \\ge 2ab$$").on_trials() == Finding::related);
}

TEST_CASE("a refutation of what is true would be noticed") {
  const Asked asked("$$\\mathbf{A}\\times\\mathbf{B} = -\\mathbf{B}\\times\\mathbf{A}$$");
  const Asked wrong("$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$");
  REQUIRE(wrong.step->sample.has_value());
  std::string detail;
  CHECK(compare_at_sample(wrong.reading.forms.tree, *wrong.step->question, *wrong.step->sample, detail) ==
        Finding::not_related);
  Sample sample = *wrong.step->sample;
  for (SampleValue& value : sample.values) {
    const Symbol& symbol = wrong.reading.forms.tree.symbols[value.symbol];
    for (std::size_t k = 0; k < asked.reading.forms.tree.symbols.size(); ++k) {
      if (asked.reading.forms.tree.symbols[SymbolId(k)].name == symbol.name) value.symbol = SymbolId(k);
    }
  }
  CHECK(compare_at_sample(asked.reading.forms.tree, *asked.step->question, sample, detail) ==
        Finding::related);
}

TEST_CASE("numbers that do not meet the assumptions are not tried") {
  const Asked asked(
      "<!-- rigor:\nvector \\mathbf{A}, \\mathbf{B}\ngiven \\mathbf{A}\\cdot\\mathbf{B} = 0\n-->\n"
      "$$|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2$$");
  const Trials trials = trials_for(asked.reading.forms.tree, *asked.step->question, {});
  std::vector<std::string> names;
  for (const auto& [name, samples] : trials.samples) names.push_back(name);
  CHECK(names == std::vector<std::string>{"exact", "orthogonal"});
}

TEST_CASE("both witnesses agree on every decided step of the notes", "[.agreement]") {
  const char* path = std::getenv("RIGOR_AGREEMENT_OF");
  REQUIRE(path != nullptr);
  const Tally tally = check_notes(path);
  std::printf(
      "%s: %zu proved steps (%zu on sample bodies) in %zu comparisons, %zu of them open; %zu refuted\n", path,
      tally.proved, tally.on_bodies, tally.comparisons, tally.open, tally.refuted);
  CHECK(tally.not_tried == 0);
  CHECK(tally.proved > 10);
  CHECK(tally.comparisons > 10 * tally.open);
}

}  // namespace rigor::agreement
