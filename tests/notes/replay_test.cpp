// SPDX-License-Identifier: GPL-3.0-or-later
// A refutation can be replayed from the JSON alone: its values become `let` directives, and each side is
// claimed to be the number that the JSON states. The claims go through the whole program again.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "catch.h"
#include "check/entry/check.h"
#include "program.h"
#include "report/data/json.h"
#include "report/data/read_recorded.h"
#include "report/text/replay_text.h"

namespace rigor {
namespace {

using Json = nlohmann::ordered_json;

std::string number(const std::string& exact) {
  const auto slash = exact.find('/');
  if (slash == std::string::npos) return exact;
  const bool negative = exact[0] == '-';
  return fmt::format("{}\\frac{{{}}}{{{}}}", negative ? "-" : "",
                     exact.substr(negative ? 1 : 0, slash - (negative ? 1 : 0)), exact.substr(slash + 1));
}

std::string value_of(const Json& value) {
  const auto component = [&](std::size_t k) { return number(value["components"][k].get<std::string>()); };
  if (value["rank"] == 0) return component(0);
  return fmt::format("({}, {}, {})", component(0), component(1), component(2));
}

/// Scalars and vectors of plain numbers; no particles, no free index, no unit, no derivative, no definition:
/// what `let` and `claim` can say in one line each. Of a cyclic image, the sides are not written.
bool is_plain(const Json& step) {
  const Json& example = step["counterexample"];
  if (step["source"].get<std::string>().find("(cyclic image ") != std::string::npos) return false;
  if (step["source"].get<std::string>().find(" signs)") != std::string::npos) return false;
  if (step["source"].get<std::string>().find("O(") != std::string::npos) return false;  // coefficients
  if (step["source"].get<std::string>().find("\\frac{d}{d") != std::string::npos) return false;
  for (const Json& use : step["uses"]) {
    if (use.get<std::string>().starts_with("definition")) return false;
    if (use.get<std::string>().find("are differentiated by") != std::string::npos) return false;
  }
  for (const char* side : {"left", "right"}) {  // bounds, and what is rounded
    const auto text = example[side].get<std::string>();
    if (text.find("than") != std::string::npos || text.find('.') != std::string::npos) return false;
  }
  if (example["particles"] != 0 || !example["component"].empty() || example["squared_distance"]) return false;
  for (const Json& value : example["values"]) {
    const auto symbol = value["symbol"].get<std::string>();
    if (value["rank"] == 1 && value["components"].size() != 3) return false;  // a column of any size
    if (value["rank"] > 1 || symbol.starts_with("\\dot") || symbol.starts_with("\\delta ")) return false;
    if (symbol.starts_with("\\mathrm")) return false;  // a unit of measure is no letter
    if (symbol.starts_with("\\langle")) return false;  // nor is an average
    for (const Json& component : value["components"]) {
      if (component.get<std::string>().find('(') != std::string::npos) return false;  // `2*arctan(1)`
    }
  }
  return true;
}

std::string replayed(const Json& step) {
  const Json& example = step["counterexample"];
  std::string note = "<!-- rigor:\n";
  for (const Json& value : example["values"]) {
    note += fmt::format("let {} = {}\n", value["symbol"].get<std::string>(), value_of(value));
  }
  for (const char* side : {"left", "right"}) {
    note += fmt::format("claim {} = {}\n", step[side].get<std::string>(),
                        number(example[side].get<std::string>()));
  }
  const bool complex = note.find("i\n") != std::string::npos;  // `let q = 1 - 2i`
  return (complex ? "Here $i$ is the imaginary unit.\n\n" : "") + note + "-->\n";
}

/// How many of a report's refutations are confirmed and how many are not, one file.
ReplayTally replayed_report(const std::string& path, const std::string& json) {
  auto files = read_recorded(json);
  REQUIRE(files.has_value());
  REQUIRE(files->size() == 1);
  RecordedSteps& steps = files->front().steps;
  CheckOptions options;
  options.recorded = &steps;
  SourceMap sources;
  const FileReport notes = check_file(sources, path, options);
  ReplayTally tally;
  for (const RecordedStep& step : steps) {
    INFO(print_replay(step, notes, sources));
    CHECK(is_confirmed(step, notes));
    ++(is_confirmed(step, notes) ? tally.confirmed : tally.not_confirmed);
  }
  return tally;
}

}  // namespace

TEST_CASE("every refutation in the small notes and in derivations is confirmed by its own JSON", "[long]") {
  std::size_t confirmed = 0;
  for (const char* folder : {"fail", "pass", "../../derivations"}) {
    for (const std::string& path : notes_in(folder)) {
      SourceMap sources;
      Report report;
      report.files.push_back(check_file(sources, path));
      confirmed += replayed_report(path, to_json(report, sources)).confirmed;
    }
  }
  CHECK(confirmed >= 140);
}

TEST_CASE("a number that was changed in the JSON is found, in every refutation of the small notes",
          "[long]") {
  std::size_t refused = 0;
  for (const std::string& path : notes_in("fail")) {
    SourceMap sources;
    Report report;
    report.files.push_back(check_file(sources, path));
    auto files = read_recorded(to_json(report, sources));
    REQUIRE(files.has_value());
    RecordedSteps& steps = files->front().steps;
    for (RecordedStep& step : steps) step.example.left += "1";
    CheckOptions options;
    options.recorded = &steps;
    const FileReport notes = check_file(sources, path, options);
    for (const RecordedStep& step : steps) {
      INFO(path << ": " << step.source);
      CHECK_FALSE(is_confirmed(step, notes));
      ++refused;
    }
  }
  CHECK(refused >= 100);
}

TEST_CASE("every plain refutation in the small notes can be replayed from the JSON", "[long]") {
  int replays = 0;
  for (const auto& entry : std::filesystem::directory_iterator("fail")) {
    if (entry.path().extension() != ".md") continue;
    if (entry.path().stem() == "spaces") continue;  // the JSON does not say in which space a step stands
    SourceMap sources;
    Report report;
    report.files.push_back(check_file(sources, entry.path().string()));
    const Json json = Json::parse(to_json(report, sources));
    for (const Json& step : json["files"][0]["steps"]) {
      if (step["verdict"] != "refuted" || !is_plain(step)) continue;
      const std::string note = replayed(step);
      INFO(entry.path().filename().string() << "\n" << note);
      const FileReport again = check_text(sources, "replay.md", note);
      REQUIRE(again.steps.size() >= 2);
      CHECK(again.steps[again.steps.size() - 2].verdict == Verdict::proved);
      CHECK(again.steps.back().verdict == Verdict::proved);
      ++replays;
    }
  }
  CHECK(replays >= 5);
}

}  // namespace rigor
