// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/read_recorded.h"

#include <nlohmann/json.hpp>

#include "catch.h"
#include "example_report.h"
#include "report/data/json.h"

namespace rigor {
namespace {

using Json = nlohmann::ordered_json;

Json example_json() {
  SourceMap sources;
  return Json::parse(to_json(example_report(sources), sources));
}

/// What is wrong with the example after one value was replaced.
std::string fault_with(const char* pointer, const Json& value) {
  Json json = example_json();
  json[Json::json_pointer(pointer)] = value;
  const auto read = read_recorded(json.dump());
  return read ? "" : read.error().reason;
}

TEST_CASE("the refuted steps of a report are read back") {
  Json json = example_json();
  json["files"][0]["sidecar"] = "notes/products.rigor";
  const auto files = read_recorded(json.dump());
  REQUIRE(files.has_value());
  REQUIRE(files->size() == 1);
  const RecordedFile& file = files->front();
  CHECK(file.path == "notes/products.md");
  CHECK(file.sidecar == "notes/products.rigor");
  REQUIRE(file.steps.size() == 1);
  const RecordedStep& step = file.steps[0];
  CHECK(step.file == "notes/products.md");
  CHECK(step.line == 3);
  CHECK(step.column == 3);
  CHECK(step.source == "\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}");
  CHECK(step.example.left == "1");
  CHECK(step.example.right == "-1");
  REQUIRE(step.example.values.size() == 2);
  CHECK(step.example.values[1].symbol == "\\mathbf{B}");
  CHECK(step.example.values[1].components == std::vector<std::string>{"0", "1", "0"});
  REQUIRE(step.example.component.size() == 1);
  CHECK(step.example.component[0].value == 3);
}

TEST_CASE("steps of the same place and text are told apart by their order") {
  Json json = example_json();
  Json& steps = json["files"][0]["steps"];
  Json proved = steps[1];
  proved["verdict"] = "proved";
  proved["counterexample"] = nullptr;
  steps.insert(steps.begin() + 1, proved);
  const auto files = read_recorded(json.dump());
  REQUIRE(files.has_value());
  REQUIRE(files->front().steps.size() == 1);
  CHECK(files->front().steps[0].earlier == 1);
}

TEST_CASE("a text that is no report is refused with the place of what is wrong") {
  const auto reason = [](std::string_view text) { return read_recorded(text).error().reason; };
  CHECK(reason("") == "it is not JSON");
  CHECK(reason("{\"files\": [") == "it is not JSON");
  CHECK(reason("\xff\xfe") == "it is not JSON");
  CHECK(reason("3") == "files is missing");
  CHECK(reason("{}") == "files is missing");
  CHECK(reason("{\"files\": 1}") == "files is not an array");
  CHECK(reason("{\"files\": [1]}") == "files[0].file is missing");
  CHECK(fault_with("/files/0/steps/1/counterexample", nullptr) ==
        "files[0].steps[1].counterexample.particles is missing");
  CHECK(fault_with("/files/0/steps/1/counterexample/left", 1) ==
        "files[0].steps[1].counterexample.left is not a string");
  CHECK(fault_with("/files/0/steps/1/line", "3") == "files[0].steps[1].line is not a number of things");
  CHECK(fault_with("/files/0/steps/1/line", -3) == "files[0].steps[1].line is not a number of things");
  CHECK(fault_with("/files/0/steps/1/counterexample/particles", 1e300) ==
        "files[0].steps[1].counterexample.particles is not a number of things");
  CHECK(fault_with("/files/0/steps/1/counterexample/values/0/components/2", 0) ==
        "files[0].steps[1].counterexample.values[0].components[2] is not a string");
}

TEST_CASE("brackets without end are refused, not followed") {
  CHECK_FALSE(read_recorded(std::string(1'000'000, '[')).has_value());
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  CHECK_FALSE(read_recorded(deep).has_value());
}

}  // namespace
}  // namespace rigor
