// SPDX-License-Identifier: GPL-3.0-or-later
// Where warnings are silenced and asked for, and what becomes of those that are.
#include "check/lint/lint_scopes.h"

#include <utility>

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

const std::string slip = "$$\\boldsymbol{\\omega}_iL_i = \\boldsymbol{\\omega}\\cdot\\mathbf{L}$$\n\n";

/// The lines of the warnings that are left, then those of the silenced ones behind `|`.
std::string lines(const std::string& text) {
  const Checked checked(text);
  std::string left;
  const auto line = [&](const Diagnostic& diagnostic) {
    return std::to_string(checked.sources.line_column(diagnostic.span.file, diagnostic.span.begin).line) +
           " ";
  };
  for (const Step& step : checked.report.steps)
    for (const Diagnostic& diagnostic : step.diagnostics) left += line(diagnostic);
  for (const Diagnostic& diagnostic : checked.report.diagnostics)
    left += std::string(info(diagnostic.kind).name) + " ";
  left += "|";
  for (const Diagnostic& diagnostic : checked.report.silenced) left += " " + line(diagnostic);
  while (left.ends_with(' ')) left.pop_back();
  return left;
}

}  // namespace

TEST_CASE("a warning is silenced from where `allow` stands to the end of its section") {
  const std::string allow = rigor_says("allow bold-index: as in the book");
  CHECK(lines(slip) == "1 |");
  CHECK(lines(allow + slip + slip) == "| 2  4");
  CHECK(lines(slip + allow + slip) == "1 | 4");
  CHECK(lines("# A\n" + allow + "## B\n" + slip + "# C\n" + slip) == "7 | 4");
}

TEST_CASE("`allow here` is about the next statement of its section") {
  const std::string allow = rigor_says("allow here bold-index");
  CHECK(lines(allow + slip + slip) == "4 | 2");
  CHECK(lines(allow + rigor_says("scalar a") + "$$a = a$$\n" + slip) == "4 unused-directive |");
  CHECK(lines(allow + "# A\n" + slip) == "3 unused-directive |");
}

TEST_CASE("`warn` takes an `allow` back, and need not find anything") {
  CHECK(lines(rigor_says("allow bold-index") + slip + rigor_says("warn bold-index") + slip) == "5 | 2");
  CHECK(lines(rigor_says("warn scalar-zero, mixed-parity") + "$$a + a = 2a$$\n") == "|");
}

TEST_CASE("only warnings are silenced") {
  CHECK(lines(rigor_says("allow refuted") + slip) == "2 bad-directive |");
  CHECK(lines(rigor_says("allow idle-sums") + slip) == "2 bad-directive |");
  CHECK(lines(rigor_says("allow") + slip) == "2 bad-directive |");
}

TEST_CASE("`allow here` and `allow` of one place end apart, and lines of directives hide no display") {
  const std::string both = rigor_says("allow here bold-index") + rigor_says("allow bold-index");
  CHECK(lines(both + slip + slip + "# A\n" + slip) == "unused-directive | 3  5  8");
  CHECK(lines("# A\n## B\n" + rigor_says("allow bold-index") + slip + "### C\n" + slip + "## D\n" + slip) ==
        "10 | 4  7");
}
