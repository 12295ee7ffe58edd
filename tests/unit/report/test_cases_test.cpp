// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/test_cases.h"

#include <algorithm>

#include "catch.h"
#include "check/entry/check.h"

namespace rigor {
namespace {

std::vector<TestCase> cases_of(const std::string& notes, bool strict = false) {
  SourceMap sources;
  return test_cases(check_text(sources, "n.md", notes), sources, {.name = "n", .strict = strict});
}

std::vector<std::string> names_of(const std::vector<TestCase>& cases) {
  std::vector<std::string> names;
  for (const TestCase& each : cases) names.push_back(each.name);
  return names;
}

TEST_CASE("a case is named after the step's tag and its number there, or else after its line") {
  CHECK(names_of(cases_of("$$1 = 1 = 2 - 1 \\tag{6}$$\n$$2 = 2$$\n$$1 = 1 = 1$$\n$$3 = 3 \\tag{6}$$\n")) ==
        std::vector<std::string>{"n (6) step 1", "n (6) step 2", "n line 2", "n line 3", "n line 3 step 2",
                                 "n (6) step 3", "n (whole file)"});
}

TEST_CASE("a display that breaks off keeps the names of its cases") {
  CHECK(names_of(cases_of("$$1 = (\\frac{1 \\tag{6}$$\n$$1 = \\frac{1 \\\\ 2 = 2 \\tag*{A} \\tag{7}$$\n")) ==
        std::vector<std::string>{"n (6) step 1", "n (A) step 1", "n (7) step 1", "n (whole file)"});
}

TEST_CASE("no two cases have the same name, whatever the tags are") {
  const std::vector<std::string> names =
      names_of(cases_of("$$1 = 1 \\tag{6}$$\n$$1 = 1 \\tag{(6)}$$\n$$1 = 1 \\tag{a;b [}$$\n"));
  CHECK(names ==
        std::vector<std::string>{"n (6) step 1", "n ((6)) step 1", "n (a;b [) step 1", "n (whole file)"});
}

TEST_CASE("proved and expected refutations pass, others fail, what is not understood is open") {
  const std::vector<TestCase> cases = cases_of(
      "$$1 = 1$$\n$$1 = 2$$\n<!-- rigor: expect refuted -->\n$$1 = 3$$\n\n$$\\oint f(s)\\,ds = 0$$\n");
  REQUIRE(cases.size() == 5);
  CHECK(cases[0].outcome == CaseOutcome::passed);
  CHECK(cases[0].text == "n.md:1:3: proved: 1 = 1\n");
  CHECK(cases[1].outcome == CaseOutcome::failed);
  CHECK(cases[1].text.starts_with("n.md:2:3: refuted: 1 = 2\n\nn.md:2:5: refuted: "));
  CHECK(cases[2].outcome == CaseOutcome::passed);
  CHECK(cases[3].outcome == CaseOutcome::open);
  CHECK(cases[4].outcome == CaseOutcome::passed);
}

TEST_CASE("what belongs to no step is a case of its own") {
  const std::vector<TestCase> cases = cases_of("<!-- rigor: vector \\mathbf{Q} -->\n$$1 = 1$$\n");
  REQUIRE(cases.size() == 2);
  CHECK(cases[0].outcome == CaseOutcome::passed);
  CHECK(cases[1].outcome == CaseOutcome::failed);
  CHECK(cases[1].text.find("[unused-directive]") != std::string::npos);
}

TEST_CASE("warnings fail where they count as errors") {
  const std::string warned = "<!-- rigor: warn unused-definition -->\n$$q = 3$$\n$$1 = 1$$\n";
  const auto failed = [](const std::vector<TestCase>& cases) {
    return std::count_if(cases.begin(), cases.end(),
                         [](const TestCase& each) { return each.outcome == CaseOutcome::failed; });
  };
  CHECK(failed(cases_of(warned, false)) == 0);
  CHECK(failed(cases_of(warned, true)) == 1);
}

TEST_CASE("cases come back out of the JSON, and what is none is refused") {
  const std::vector<TestCase> cases{{"a \"b\" \\c", CaseOutcome::failed, "x\ny"},
                                    {"d", CaseOutcome::open, ""}};
  const auto read = read_test_cases(test_cases_json(cases));
  REQUIRE(read);
  REQUIRE(read->size() == 2);
  CHECK((*read)[0].name == cases[0].name);
  CHECK((*read)[0].outcome == CaseOutcome::failed);
  CHECK((*read)[0].text == "x\ny");
  CHECK((*read)[1].outcome == CaseOutcome::open);
  for (const char* text : {"", "[]", "{}", "{\"format\": 2, \"cases\": []}",
                           R"({"format": 1, "cases": [{"name": "a", "outcome": "fine", "text": ""}]})",
                           R"({"format": 1, "cases": [{"name": 3, "outcome": "open", "text": ""}]})"})
    CHECK_FALSE(read_test_cases(text));
}

}  // namespace
}  // namespace rigor
