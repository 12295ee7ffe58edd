// SPDX-License-Identifier: GPL-3.0-or-later
// All formats, several processes and remembered decisions, on all notes: the same bytes but for times.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "catch.h"
#include "program.h"

namespace rigor {
namespace {

using Words = std::vector<std::string>;

Words check_of(const std::string& folder, const Words& options) {
  Words words{"check"};
  words.insert(words.end(), options.begin(), options.end());
  for (const std::string& path : notes_in(folder)) words.push_back(path);
  return words;
}

std::string without_times(const std::string& text) {
  return std::regex_replace(
      text, std::regex("\"milliseconds\": [-+.0-9e]+| time=\"[0-9.]+\"|; [0-9.]+ m?s\n$"), "");
}

/// Compared without printing megabytes.
void check_same(const Outcome& one, const Outcome& two) {
  CHECK(one.code == two.code);
  const std::string first = without_times(one.text);
  const std::string second = without_times(two.text);
  const auto differ = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  const auto at = static_cast<std::size_t>(differ.first - first.begin());
  INFO(first.substr(at < 200 ? 0 : at - 200, 400) << "\n----\n"
                                                  << second.substr(at < 200 ? 0 : at - 200, 400));
  CHECK((first == second));
}

void check_processes(const std::string& format, const std::string& folder) {
  const Outcome one = run_program(check_of(folder, {"--format", format}));
  check_same(one, run_program(check_of(folder, {"--format", format, "--jobs", "3"})));
}

TEST_CASE("text is the same from several processes as from one", "[long]") {
  check_processes("text", "pass");
}
TEST_CASE("JSON is the same from several processes as from one", "[long]") {
  check_processes("json", "fail");
}
TEST_CASE("JUnit is the same from several processes as from one") { check_processes("junit", "run"); }
TEST_CASE("SARIF is the same from several processes as from one", "[long]") {
  check_processes("sarif", "pass");
}
TEST_CASE("annotations are the same from several processes as from one") {
  check_processes("github", "../../derivations");
}

void check_remembered(const std::string& folder) {
  const auto cache = std::filesystem::temp_directory_path() / ("rigor-notes-" + std::to_string(::getpid()));
  const Outcome decided = run_program(check_of(folder, {}));
  check_same(decided, run_program(check_of(folder, {"--cache", cache.string(), "--jobs", "2"})));
  check_same(decided, run_program(check_of(folder, {"--cache", cache.string()})));
  std::filesystem::remove_all(cache);
}

TEST_CASE("proofs that are remembered print the same as those that are found", "[long]") {
  check_remembered("pass");
  check_remembered("../../derivations");
}

TEST_CASE("refutations that are remembered print the same as those that are found", "[long]") {
  check_remembered("fail");
}

TEST_CASE("the shown counts of a cache are those of its decisions") {
  const auto folder = std::filesystem::temp_directory_path() / ("rigor-count-" + std::to_string(::getpid()));
  const Words words{"check", "pass/chains.md", "--cache", folder.string(), "--debug", "cache"};
  CHECK(std::regex_search(run_program(words).text, std::regex("debug cache: pass/chains.md: [0-9]+ of ")));
  const std::string text = run_program(words).text;
  std::smatch counts;
  REQUIRE(std::regex_search(text, counts, std::regex("([0-9]+) of ([0-9]+) decisions were remembered")));
  CHECK(counts[1] == counts[2]);
  std::filesystem::remove_all(folder);
}

TEST_CASE("JUnit has as many test cases as the report has steps, and fails where the report does") {
  const Outcome good = run_program({"check", "--format", "junit", "pass/chains.md"});
  CHECK(good.code == 0);
  CHECK(good.text.find("<failure") == std::string::npos);
  const Outcome wrong = run_program({"check", "--format", "junit", "run/refuted.md"});
  CHECK(wrong.code == 1);
  CHECK(wrong.text.find("true is: ") != std::string::npos);
}

TEST_CASE("SARIF of notes that are wrong offers the repair as a fix that can be put in") {
  const Outcome outcome = run_program({"check", "--format", "sarif", "run/refuted.md"});
  const auto log = nlohmann::json::parse(outcome.text);
  const auto& result = log["runs"][0]["results"][0];
  CHECK(result["ruleId"] == "refuted");
  CHECK(result["fixes"].size() >= 1);
}

}  // namespace
}  // namespace rigor
