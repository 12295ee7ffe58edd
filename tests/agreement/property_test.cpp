// SPDX-License-Identifier: GPL-3.0-or-later
// No statement that is proved fails on random exact samples that meet its assumptions: in all notes of ours.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "random_samples.h"

namespace rigor::agreement {
namespace {

constexpr std::uint64_t seed = 0x70726f70;

/// How many samples for each statement; a long run asks for more.
std::uint32_t wanted_samples() {
  const char* wanted = std::getenv("RIGOR_PROPERTY_SAMPLES");
  return wanted == nullptr ? 100 : static_cast<std::uint32_t>(std::strtoul(wanted, nullptr, 10));
}

std::vector<std::string> all_notes() {
  std::vector<std::string> paths;
  for (const char* folder : {"derivations", "tests/notes/pass", "tests/notes/fail"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".md" || extension == ".tex") paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

struct Tally {
  std::size_t statements = 0;
  std::size_t orders = 0;
  std::size_t without_sample = 0;
  std::uint64_t comparisons = 0;
};

/// The samples of all proved steps of some notes; what fails is reported.
void look_at(const SourceMap& sources, const FormsReading& reading, std::uint32_t wanted, Tally& tally,
             const std::function<void(const std::string&)>& fails) {
  Limits limits;
  limits.steps = 10'000ull * wanted;
  for (const WrittenFormChain& chain : reading.forms.chains) {
    for (std::size_t k = 0; k < chain.steps.size(); ++k) {
      const WrittenStep& step = chain.steps[k];
      if (step.outcome != Outcome::proved || !step.question) continue;
      Question question = *step.question;
      question.tree = &reading.forms.tree;
      const RandomSamples samples = try_random_samples(question, wanted, seed, limits);
      ++tally.statements;
      if (question.claim.relation != Relation::equal) ++tally.orders;
      if (samples.compared == 0) ++tally.without_sample;
      tally.comparisons += samples.compared;
      if (!samples.failed) continue;
      std::string values;
      for (const SampleValue& value : samples.failed->values) {
        values += reading.forms.tree.symbols[value.symbol].name + " =";
        for (const std::string& component : value.components) values += ' ' + component;
        values += "; ";
      }
      const auto line = sources.line_column(chain.span.file, chain.span.begin).line;
      fails(std::to_string(line) + ": " + chain.forms[k].source + " " + std::string(step.kind) + " " +
            chain.forms[k + 1].source + " at " + values + "left " + samples.failed->left + ", right " +
            samples.failed->right);
    }
  }
}

}  // namespace

TEST_CASE("no statement of the notes that is proved fails on random samples", "[.property]") {
  Tally tally;
  for (const std::string& path : all_notes()) {
    SourceMap sources;
    const FormsReading reading = read_forms(sources, path, {});
    look_at(sources, reading, wanted_samples(), tally,
            [&](const std::string& what) { FAIL_CHECK(path << ":" << what); });
  }
  std::printf("%zu proved statements, %zu of them orders, on %llu samples; %zu on none\n", tally.statements,
              tally.orders, static_cast<unsigned long long>(tally.comparisons), tally.without_sample);
  CHECK(tally.statements > 500);
  CHECK(tally.comparisons > 20 * tally.statements);
}

TEST_CASE("a statement that fails on few samples is noticed", "[property]") {
  const auto failures_of = [](const std::string& text, Outcome as) {
    SourceMap sources;
    FormsReading reading = read_forms_of_text(sources, "notes.md", text, {});
    for (WrittenFormChain& chain : reading.forms.chains) {
      for (WrittenStep& step : chain.steps) {
        if (step.question) step.outcome = as;
      }
    }
    std::size_t count = 0;
    Tally tally;
    look_at(sources, reading, 100, tally, [&](const std::string&) { ++count; });
    return count;
  };
  CHECK(failures_of("<!-- rigor: scalar a -->\n$$a \\ge |a|$$", Outcome::proved) == 1);
  CHECK(failures_of("<!-- rigor: scalar a -->\n$$a \\le |a|$$", Outcome::proved) == 0);
  CHECK(failures_of("<!-- rigor: scalar a, b -->\n$$|a + b| \\ge |a| + |b|$$", Outcome::proved) == 1);
  CHECK(failures_of("<!-- rigor: scalar a, b -->\n$$(a + b)^2 = a^2 + b^2$$", Outcome::proved) == 1);
}

}  // namespace rigor::agreement
