// SPDX-License-Identifier: GPL-3.0-or-later
// Every note of pass/ and fail/ against what README.md says of it; CMake makes each a test of its own.
#include <fmt/format.h>

#include <set>

#include "catch.h"
#include "check/entry/check.h"
#include "expectations.h"
#include "program.h"

namespace rigor {
namespace {

/// Each problem is printed as a line that begins with its place.
void report_problems(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) {
    UNSCOPED_INFO(problem);
  }
  CHECK(problems.empty());
}

std::vector<std::string> differences_in(const std::string& text) {
  SourceMap sources;
  const FileReport report = check_text(sources, "note.md", text);
  return differences(report, sources);
}

TEST_CASE("every step of a note in pass holds", "[each]") {
  for (const std::string& path : notes_in("pass")) {
    DYNAMIC_SECTION(path) {
      SourceMap sources;
      const FileReport report = check_file(sources, path);
      report_problems(flaws(report, sources));
      CHECK_FALSE(report.steps.empty());
      CHECK(exit_code_of(report) == 0);
    }
  }
}

TEST_CASE("a note in fail is answered as its comments announce", "[each]") {
  for (const std::string& path : notes_in("fail")) {
    DYNAMIC_SECTION(path) {
      SourceMap sources;
      const FileReport report = check_file(sources, path);
      report_problems(differences(report, sources));
    }
  }
}

TEST_CASE("every kind of diagnostic is announced in a note or printed in a run case") {
  std::set<std::string, std::less<>> shown;
  for (const std::string& path : notes_in("fail")) {
    SourceMap sources;
    const Expectations expected = read_expectations(sources, sources.add(path, text_of(path)));
    shown.insert(expected.kinds_in_file.begin(), expected.kinds_in_file.end());
    for (const Expectations::Display& display : expected.displays) {
      shown.insert(display.kinds.begin(), display.kinds.end());
      shown.insert(display.verdicts.begin(), display.verdicts.end());  // `refuted` goes with its verdict
    }
  }
  const std::string cases = text_of("run/cases.txt");
  for (const DiagnosticInfo& info : diagnostic_table()) {
    INFO(info.name);
    CHECK((shown.contains(info.name) || cases.find(fmt::format("[{}]", info.name)) != std::string::npos));
  }
}

TEST_CASE("a note in fail announces something") {
  for (const std::string& path : notes_in("fail")) {
    INFO(path);
    CHECK(text_of(path).find(path.ends_with(".md") ? "\n<!-- expect-" : "\n% expect-") != std::string::npos);
  }
}

TEST_CASE("a verdict that differs from its comment is a difference") {
  CHECK(differences_in("<!-- expect-verdict: refuted -->\n$$\\mathbf{A}\\times\\mathbf{A} = 0$$\n") ==
        std::vector<std::string>{
            "note.md:2:3: expected refuted, got proved: \\mathbf{A}\\times\\mathbf{A} = 0"});
  CHECK(differences_in("<!-- expect-verdict: proved proved -->\n$$\\mathbf{A}\\times\\mathbf{A} = 0$$\n") ==
        std::vector<std::string>{"note.md:2:1: expected 2 steps, got 1"});
}

TEST_CASE("a diagnostic that does not come is a difference, and so is one that nothing announces") {
  CHECK(differences_in("<!-- expect-diagnostic: index-clash -->\n$$\\mathbf{A}\\times\\mathbf{A} = 0$$\n") ==
        std::vector<std::string>{"note.md:2:1: expected [index-clash], got no diagnostic"});
  CHECK(differences_in("<!-- expect-in-file: nul-byte -->\n$$\\mathbf{A}\\times\\mathbf{A} = 0$$\n") ==
        std::vector<std::string>{"note.md:1:1: expected [nul-byte], got no diagnostic"});
  const auto surprise =
      differences_in("$$\\boldsymbol{\\omega}_iL_i = \\boldsymbol{\\omega}\\cdot\\mathbf{L}$$\n");
  REQUIRE(surprise.size() == 1);
  CHECK(surprise[0].starts_with("note.md:1:3: expected nothing, got [bold-index] "));
}

TEST_CASE("a comment that announces nothing that exists is a difference") {
  const std::string display = "$$\\mathbf{A}\\times\\mathbf{A} = 0$$\n";
  CHECK(differences_in("<!-- expect-verdict: wrong -->\n" + display).front() ==
        "note.md:1: no verdicts: expect-verdict: wrong");
  CHECK(differences_in("<!-- expect-in-file: wrong -->\n" + display).front() ==
        "note.md:1: no single diagnostic kind: expect-in-file: wrong");
  CHECK(differences_in("<!-- expect-verdicts: proved -->\n" + display) ==
        std::vector<std::string>{"note.md:1: an unknown key: expect-verdicts: proved"});
  CHECK(differences_in(display + "<!-- expect-verdict: proved -->\n") ==
        std::vector<std::string>{"note.md:2: no display stands below: expect-verdict: proved"});
}

}  // namespace
}  // namespace rigor
