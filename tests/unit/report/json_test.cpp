// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/json.h"

#include <nlohmann/json.hpp>

#include "base/version.h"
#include "catch.h"
#include "example_report.h"

namespace rigor {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(const Report& report, const SourceMap& sources) { return Json::parse(to_json(report, sources)); }

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& entry : object.items()) keys.push_back(entry.key());
  return keys;
}

using Keys = std::vector<std::string>;

TEST_CASE("the keys of the report, a file, the counts and a step are the documented ones, in order") {
  SourceMap sources;
  const Json json = parsed(example_report(sources), sources);
  CHECK(keys_of(json) == Keys{"rigor", "format", "files", "counts", "causes"});
  CHECK(json["rigor"] == std::string(version));
  const Json& file = json["files"][0];
  CHECK(keys_of(file) == Keys{"file", "steps", "diagnostics", "silenced", "counts", "sidecar", "dimensions",
                              "laws", "failure"});
  const Keys verdicts{"proved",         "refuted", "given", "definition", "undecided",
                      "not-understood", "skipped", "law",   "suspect"};
  CHECK(keys_of(json["counts"]) == verdicts);
  CHECK(file["counts"] == json["counts"]);
  CHECK(keys_of(file["steps"][0]) ==
        Keys{"line",           "column",  "end_line",   "end_column",  "tag",     "label", "section",
             "source",         "left",    "relation",   "right",       "verdict", "route", "uses",
             "counterexample", "repairs", "conditions", "diagnostics", "file",    "chain", "milliseconds"});
}

TEST_CASE("a step that is proved") {
  SourceMap sources;
  const Json step = parsed(example_report(sources), sources)["files"][0]["steps"][0];
  CHECK(step == Json::parse(R"json({
    "line": 2, "column": 3, "end_line": 2, "end_column": 56, "tag": "1", "label": "", "section": "Products",
    "source": "\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}",
    "left": "\\mathbf{A}\\cdot\\mathbf{B}", "relation": "=", "right": "\\mathbf{B}\\cdot\\mathbf{A}",
    "verdict": "proved", "route": "component normal form", "uses": ["definition A (1)"],
    "counterexample": null, "repairs": [], "conditions": [], "diagnostics": [], "file": "notes/products.md",
    "chain": null, "milliseconds": 0.123})json"));
}

TEST_CASE("a step that is refuted has all that is needed to replay its counterexample") {
  SourceMap sources;
  const Json step = parsed(example_report(sources), sources)["files"][0]["steps"][1];
  CHECK(step["verdict"] == "refuted");
  CHECK(step["uses"] == Json::array());
  CHECK(step["counterexample"].dump() ==
        R"({"particles":0,"values":[)"
        R"({"symbol":"\\mathbf{A}","particle":0,"rank":1,"components":["1","0","0"],"beyond":false},)"
        R"({"symbol":"\\mathbf{B}","particle":0,"rank":1,"components":["0","1","0"],"beyond":false}],)"
        R"("component":[{"index":"","value":3}],"left":"1","right":"-1","squared_distance":false,)"
        R"("follows":[]})");
  CHECK(step["diagnostics"].dump() ==
        R"([{"kind":"refuted","severity":"refuted","line":3,"column":30,"end_line":3,"end_column":31,)"
        R"("file":"notes/products.md","message":"the sides differ","labels":[],"help":[]}])");
}

TEST_CASE("labels and help of a diagnostic are arrays, and a severity of two words has a hyphen") {
  SourceMap sources;
  Report report = example_report(sources);
  const FileId sidecar = sources.add("notes/products.rigor", "vector A\n");
  report.files[0].diagnostics.push_back({DiagnosticKind::unknown_change,
                                         Span{sidecar, 7, 8},
                                         "`A` is not declared",
                                         {{Span{0, 2, 4}, "used here"}},
                                         {"declare it"}});
  const Json found = parsed(report, sources)["files"][0]["diagnostics"][0];
  CHECK(found["severity"] == "not-understood");
  CHECK(found["file"] == "notes/products.rigor");
  CHECK(found["column"] == 8);
  CHECK(found["labels"].dump() == R"([{"line":1,"column":3,"end_line":1,"end_column":5,)"
                                  R"("file":"notes/products.md","text":"used here"}])");
  CHECK(found["help"] == Json::parse(R"(["declare it"])"));
}

TEST_CASE("bytes that are not UTF-8 do not break the JSON") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].path = "notes/\xE9.md";
  CHECK(parsed(report, sources)["files"][0]["file"] == "notes/\uFFFD.md");
}

TEST_CASE("the place of a step in its chain") {
  SourceMap sources;
  Report report = example_report(sources);
  report.files[0].steps[1].chain = ChainPlace{.first_wrong = true, .undone_at = 4};
  CHECK(parsed(report, sources)["files"][0]["steps"][1]["chain"].dump() ==
        R"({"first_wrong":true,"undone_at":4,"stays":false,"undoes":false,"first_step":null})");
  report.files[0].steps[1].chain = ChainPlace{.undoes = true, .first_step = 2};
  CHECK(parsed(report, sources)["files"][0]["steps"][1]["chain"].dump() ==
        R"({"first_wrong":false,"undone_at":null,"stays":false,"undoes":true,"first_step":2})");
}

TEST_CASE("the sidecar of a file is named, and is null where there is none") {
  SourceMap sources;
  Report report = example_report(sources);
  CHECK(parsed(report, sources)["files"][0]["sidecar"] == nullptr);
  report.files[0].sidecar = "notes/products.rigor";
  CHECK(parsed(report, sources)["files"][0]["sidecar"] == "notes/products.rigor");
}

TEST_CASE("a report of no file is an object all the same, and ends with a line break") {
  const std::string text = to_json({}, {});
  CHECK(text.ends_with("}\n"));
  CHECK(Json::parse(text)["files"] == Json::array());
}

TEST_CASE("the same report gives the same bytes") {
  SourceMap sources;
  const Report report = example_report(sources);
  CHECK(to_json(report, sources) == to_json(report, sources));
}

}  // namespace
}  // namespace rigor
