// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/causes.h"

#include "catch.h"

namespace rigor {
namespace {

Diagnostic unread(std::string message, std::vector<std::string> help = {}) {
  return {DiagnosticKind::unsupported, {0, 0, 1}, std::move(message), {}, std::move(help)};
}

Report report_of(SourceMap& sources, const std::vector<Diagnostics>& steps) {
  Report report;
  FileReport& file = report.files.emplace_back();
  file.path = "n.md";
  file.file = sources.add("n.md", std::string(steps.size(), '\n'));
  for (std::uint32_t k = 0; k < steps.size(); ++k) {
    Step& step = file.steps.emplace_back();
    step.span = {file.file, k, k};
    step.diagnostics = steps[k];
  }
  return report;
}

TEST_CASE("steps are grouped by what is said of them, whatever it quotes") {
  SourceMap sources;
  const Report report = report_of(sources, {{unread("`a`, `b` and `c` are not read")},
                                            {unread("`d` are not read"), unread("a root")},
                                            {unread("a root")}});
  const std::vector<Cause> causes = causes_of(report);
  REQUIRE(causes.size() == 2);
  CHECK(causes[0].words == "`…` are not read");
  CHECK(causes[0].steps == 2);
  CHECK(causes[0].alone == 1);
  CHECK(causes[1].words == "a root");
  CHECK(causes[1].places.size() == 2);
}

TEST_CASE("one directive is one cause, another letter another, and both come before what none settles") {
  SourceMap sources;
  const std::string help = "`rigor: constant m` or `rigor: variable m` says so; `rigor: given …` can say how";
  const Report report =
      report_of(sources, {{unread("a root")},
                          {unread("a root")},
                          {unread("nothing says whether `m` changes", {help})},
                          {unread("`m` can change", {help})},
                          {unread("nothing says whether `c` changes", {"`rigor: constant c` says so"})}});
  const std::vector<Cause> causes = causes_of(report);
  REQUIRE(causes.size() == 3);
  CHECK(causes[0].words == "nothing says whether `m` changes");
  CHECK(causes[0].directives == std::vector<std::string>{"constant m", "variable m"});
  CHECK(causes[0].steps == 2);
  CHECK(causes[1].directives == std::vector<std::string>{"constant c"});
  CHECK(causes[2].directives.empty());
}

TEST_CASE("warnings and what is known leave nothing open") {
  SourceMap sources;
  const Report report = report_of(
      sources, {{unread("a root")}, {{DiagnosticKind::redefinition, {0, 0, 1}, "`a` is defined twice"}}});
  KnownFindings known;
  known.diagnostics.insert(&report.files[0].steps[0].diagnostics[0]);
  CHECK(causes_of(report).size() == 1);
  CHECK(causes_of(report, known).empty());
}

TEST_CASE("a table is at most a screen, unless all of it is asked for") {
  SourceMap sources;
  std::vector<Diagnostics> steps;
  for (const char* word : {"one", "two", "three", "four", "five", "six", "seven", "eight"})
    steps.push_back({unread(word)});
  const Report report = report_of(sources, steps);
  const std::string short_table = print_causes(report, sources, {}, false);
  CHECK(short_table.find("six: line 6\n") != std::string::npos);
  CHECK(short_table.find("seven") == std::string::npos);
  CHECK(short_table.ends_with("  and 2 other causes (--all-causes)\n"));
  CHECK(print_causes(report, sources, {}, true).find("eight: line 8\n") != std::string::npos);
  steps.resize(2);
  SourceMap few;
  CHECK(print_causes(report_of(few, steps), few, {}, true).empty());
}

}  // namespace
}  // namespace rigor
