// SPDX-License-Identifier: GPL-3.0-or-later
// The rigid-body notes of Physics 111, as they were written, with derivations/physics-111.rigor: every
// statement of the list beside them has the verdict that its tag asks for. statements.txt says where and
// which. The notes are no part of this repository; where they do not lie next to it, the tests are skipped.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "catch.h"
#include "program.h"

namespace rigor {
namespace {

constexpr std::size_t statement_count = 96;
constexpr std::size_t only_in_words = 1;

const std::string notes_path = std::string(RIGOR_ORIGINAL_NOTES) + "/rigid-bodies.md";
const std::string list_path = std::string(RIGOR_ORIGINAL_NOTES) + "/statements.md";

/// One line of statements.txt.
struct Expected {
  int number = 0;
  std::string tag;
  int line = 0;
  std::string verdict;
  std::string diagnostic;  // a kind, or empty
  std::string piece;       // of the step's source; the reason where the verdict is `words`
  [[nodiscard]] std::string text() const {
    return fmt::format("statement {} ({}): at line {} {} `{}`", number, tag, line, verdict, piece);
  }
};

Expected read_expected(const std::string& line) {
  std::istringstream words(line);
  Expected expected;
  words >> expected.number >> expected.tag >> expected.line >> expected.verdict >> std::ws;
  std::getline(words, expected.piece);
  if (expected.piece.starts_with('[')) {
    const std::size_t end = expected.piece.find("] ");
    expected.diagnostic = expected.piece.substr(1, end - 1);
    expected.piece.erase(0, end + 2);
  }
  return expected;
}

std::vector<Expected> read_table() {
  std::istringstream lines(text_of("statements.txt"));
  std::vector<Expected> table;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#') table.push_back(read_expected(line));
  return table;
}

/// `43. **[FALSE as stated]** below Eq. …`: number and tag, in the words of statements.txt.
std::map<int, std::string> read_list(const std::string& text) {
  static const std::map<std::string, std::string> words{
      {"true", "true"},          {"conditional", "conditional"}, {"FALSE as stated", "false"},
      {"notation slip", "slip"}, {"definition", "definition"},   {"gap in a proof", "gap"}};
  std::istringstream lines(text);
  std::map<int, std::string> tags;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t open = line.find(". **[");
    const std::size_t close = line.find("]**");
    if (open == std::string::npos || close == std::string::npos) continue;
    const bool numbered = open > 0 && line.find_first_not_of("0123456789") == open;
    if (numbered) tags[std::stoi(line)] = words.at(line.substr(open + 5, close - open - 5));
  }
  return tags;
}

bool notes_are_here() {
  if (std::filesystem::exists(notes_path) && std::filesystem::exists(list_path)) return true;
  WARN("skipped: " << notes_path << " or the list of its statements is not here");
  return false;
}

/// The program runs once.
const Outcome& run() {
  static const Outcome once =
      run_program({"check", "--json", "--sidecar", "../../derivations/physics-111.rigor", notes_path});
  return once;
}

/// The one file's part of the report.
const nlohmann::json& report() {
  static const nlohmann::json whole = nlohmann::json::parse(run().text);
  return whole.at("files").at(0);
}

bool fits(const nlohmann::json& step, const Expected& expected) {
  const bool here = step.at("line") == expected.line && step.at("verdict") == expected.verdict &&
                    step.at("source").get<std::string>().find(expected.piece) != std::string::npos;
  if (!here || expected.diagnostic.empty()) return here;
  const nlohmann::json& diagnostics = step.at("diagnostics");
  return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const nlohmann::json& diagnostic) {
    return diagnostic.at("kind") == expected.diagnostic;
  });
}

std::string described(const nlohmann::json& step) {
  std::string text = fmt::format("{}:{}: {} `{}`", step.at("line").get<int>(), step.at("column").get<int>(),
                                 step.at("verdict").get<std::string>(), step.at("source").get<std::string>());
  for (const nlohmann::json& diagnostic : step.at("diagnostics"))
    text += fmt::format("\n    {} [{}]", diagnostic.at("message").get<std::string>(),
                        diagnostic.at("kind").get<std::string>());
  return text;
}

/// What the report says at that line instead.
std::string steps_at(int line) {
  std::string text;
  for (const nlohmann::json& step : report().at("steps"))
    if (step.at("line") == line) text += "\n  " + described(step);
  return text.empty() ? " nothing" : text;
}

bool has(const std::vector<Expected>& entries, const std::set<std::string>& verdicts) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const Expected& entry) { return verdicts.contains(entry.verdict); });
}

/// What a tag asks for, whatever the place.
bool entries_suit_tag(const std::vector<Expected>& entries) {
  const std::string& tag = entries.front().tag;
  if (has(entries, {"words"})) return entries.size() == 1;
  if (tag == "conditional") return has(entries, {"proved"}) && has(entries, {"refuted"});
  if (tag == "false") return has(entries, {"refuted"});
  if (tag == "definition") return has(entries, {"definition", "proved"});
  return has(entries, {"proved"}) || (tag == "true" && has(entries, {"refuted"}));
}

std::map<int, std::vector<Expected>> by_number(const std::vector<Expected>& table) {
  std::map<int, std::vector<Expected>> sorted;
  for (const Expected& expected : table) sorted[expected.number].push_back(expected);
  return sorted;
}

TEST_CASE("every statement has entries that suit its tag") {
  const auto sorted = by_number(read_table());
  CHECK(sorted.size() == statement_count);
  std::size_t in_words = 0;
  for (const auto& [number, entries] : sorted) {
    INFO(entries.front().text());
    CHECK(entries_suit_tag(entries));
    for (const Expected& entry : entries) {
      CHECK(entry.tag == entries.front().tag);
      CHECK_FALSE(entry.piece.empty());
    }
    in_words += entries.front().verdict == "words" ? 1 : 0;
  }
  CHECK(in_words == only_in_words);
}

TEST_CASE("a list of statements is read by number and tag") {
  CHECK(read_list("# List\n1. **[true]** a: b\n   - c\n12. **[FALSE as stated]** d\n1. e **[true]**\n") ==
        std::map<int, std::string>{{1, "true"}, {12, "false"}});
}

TEST_CASE("the statements and tags are those of the list", "[original]") {
  if (!notes_are_here()) return;
  std::map<int, std::string> tags;
  for (const Expected& expected : read_table()) tags[expected.number] = expected.tag;
  const auto listed = read_list(text_of(list_path));
  CHECK(listed.size() == statement_count);
  for (const auto& [number, tag] : listed) {
    INFO("statement " << number);
    CHECK(tags[number] == tag);
  }
}

TEST_CASE("every statement gets the verdict that its tag asks for", "[original]") {
  if (!notes_are_here()) return;
  for (const Expected& expected : read_table()) {
    if (expected.verdict == "words") continue;
    const auto& steps = report().at("steps");
    const bool found = std::any_of(steps.begin(), steps.end(),
                                   [&](const nlohmann::json& step) { return fits(step, expected); });
    if (found) continue;
    UNSCOPED_INFO(expected.text() << "; there is" << steps_at(expected.line));
    CHECK(found);
  }
}

TEST_CASE("nothing else is refuted and nothing is left open", "[original]") {
  if (!notes_are_here()) return;
  const std::vector<Expected> table = read_table();
  for (const nlohmann::json& step : report().at("steps")) {
    const std::string verdict = step.at("verdict");
    const bool announced = std::any_of(table.begin(), table.end(),
                                       [&](const Expected& expected) { return fits(step, expected); });
    for (const nlohmann::json& diagnostic : step.at("diagnostics")) {
      UNSCOPED_INFO(described(step));
      CHECK(diagnostic.at("severity") != "error");
    }
    const bool open = verdict == "undecided" || verdict == "not-understood" || verdict == "skipped";
    if (!open && (verdict != "refuted" || announced)) continue;
    UNSCOPED_INFO(described(step));
    CHECK(verdict == "proved");
  }
  for (const nlohmann::json& diagnostic : report().at("diagnostics")) {
    UNSCOPED_INFO(diagnostic.at("message").get<std::string>());
    CHECK(diagnostic.at("severity") == "warning");
  }
  CHECK(run().code == 0);  // what is refuted was expected to be
}

}  // namespace
}  // namespace rigor
