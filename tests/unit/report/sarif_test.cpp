// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/sarif.h"

#include <nlohmann/json.hpp>

#include "catch.h"
#include "hostile_report.h"

namespace rigor {
namespace {

using nlohmann::json;

/// What the schema of SARIF 2.1.0 asks of the parts that we write.
void check_structure(const json& log) {
  CHECK(log["version"] == "2.1.0");
  REQUIRE(log["runs"].size() == 1);
  const json& run = log["runs"][0];
  CHECK(run["columnKind"] == "unicodeCodePoints");
  const json& rules = run["tool"]["driver"]["rules"];
  CHECK(rules.size() == diagnostic_table().size());
  for (const json& rule : rules) CHECK_FALSE(rule["help"]["text"].get<std::string>().empty());
  for (const json& result : run["results"]) {
    CHECK(rules[result["ruleIndex"].get<std::size_t>()]["id"] == result["ruleId"]);
    CHECK_FALSE(result["message"]["text"].get<std::string>().empty());
    const std::string level = result["level"];
    CHECK((level == "error" || level == "warning" || level == "note"));
    const json& place = result["locations"][0]["physicalLocation"];
    const std::string uri = place["artifactLocation"]["uri"];
    CHECK(uri.find_first_of(" \n<>\"&,:") == std::string::npos);
    const json& region = place["region"];
    CHECK(region["startLine"] >= 1);
    CHECK(region["startColumn"] >= 1);
    CHECK(region["endLine"] >= region["startLine"]);
    CHECK((region["endLine"] > region["startLine"] || region["endColumn"] >= region["startColumn"]));
    CHECK(result["partialFingerprints"]["rigorStatement/v1"].get<std::string>().size() > 32);
  }
}

json sarif(const Report& report, const SourceMap& sources, const CheckFormat& options = {}) {
  return json::parse(to_sarif(report, sources, options));
}

TEST_CASE("a refutation is a result at its place") {
  SourceMap sources;
  const json log = sarif(example_report(sources), sources);
  check_structure(log);
  const json& result = log["runs"][0]["results"][0];
  CHECK(result["ruleId"] == "refuted");
  CHECK(result["level"] == "error");
  CHECK(result["locations"][0]["physicalLocation"]["region"]["startColumn"] == 30);
  CHECK_FALSE(result.contains("suppressions"));
  CHECK_FALSE(result.contains("fixes"));
}

TEST_CASE("what the notes excuse is suppressed") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].steps[1].expected_refuted = true;
  report.files[0].silenced.push_back({DiagnosticKind::bold_index, report.files[0].steps[0].span, "bold"});
  const json log = sarif(report, sources);
  check_structure(log);
  REQUIRE(log["runs"][0]["results"].size() == 2);
  for (const json& result : log["runs"][0]["results"]) CHECK(result["suppressions"][0]["kind"] == "inSource");
}

TEST_CASE("a fix replaces the text that was read, and there is none where that is not known") {
  SourceMap sources;
  Report report = example_report(sources);
  Step& step = report.files[0].steps[1];
  step.repairs = {{false, "", "a sign", "\\mathbf{B} \\times\\mathbf{A}", "-\\mathbf{B}\\times\\mathbf{A}"},
                  {false, "", "a sign", "\\vec{B}\\times\\vec{A}", "-\\vec{B}\\times\\vec{A}"},
                  {true, "", "a sign", "\\mathbf{A}\\times\\mathbf{B}", "-\\mathbf{A}\\times\\mathbf{B}"}};
  const json log = sarif(report, sources);
  const json& fixes = log["runs"][0]["results"][0]["fixes"];
  REQUIRE(fixes.size() == 2);
  const json& replacement = fixes[0]["artifactChanges"][0]["replacements"][0];
  CHECK(replacement["insertedContent"]["text"] == "-\\mathbf{B}\\times\\mathbf{A}");
  CHECK(replacement["deletedRegion"]["startColumn"] == 32);
  CHECK(replacement["deletedRegion"]["endColumn"] == 58);
  CHECK(fixes[1]["artifactChanges"][0]["replacements"][0]["deletedRegion"]["startColumn"] == 3);
}

TEST_CASE("lines that are added above change no fingerprint, and equal findings have different ones") {
  SourceMap sources;
  const Report report = hostile_report(sources);
  const json log = sarif(report, sources);
  check_structure(log);
  SourceMap moved;
  Report later = hostile_report(moved);
  for (Step& step : later.files[0].steps) step.diagnostics[0].span = {0, 12, 13};
  const json other = sarif(later, moved);
  std::vector<std::string> before;
  std::vector<std::string> after;
  const auto undecided = [](const json& from, std::vector<std::string>& to) {
    for (const json& result : from["runs"][0]["results"])
      if (result["ruleId"] == "undecided") to.push_back(result["partialFingerprints"]["rigorStatement/v1"]);
  };
  undecided(log, before);
  undecided(other, after);
  CHECK(before == after);
}

TEST_CASE("a file that was not checked is a notification, and the run has no success") {
  SourceMap sources;
  const json run = sarif(hostile_report(sources), sources)["runs"][0];
  CHECK(run["invocations"][0]["executionSuccessful"] == false);
  CHECK(run["invocations"][0]["toolExecutionNotifications"].size() == 1);
  CHECK(run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
            .get<std::string>()
            .starts_with(
                "a%20b/%5D%5D%3E%20%26%20%3Cx%20y%3D%22z%22%3E%20%3A%3Aerror%3A%3A%0A%250A%01%FF%2C%3A.md"));
}

}  // namespace
}  // namespace rigor
