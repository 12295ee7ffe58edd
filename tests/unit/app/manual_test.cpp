// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/manual.h"

#include <algorithm>
#include <sstream>

#include "app/grammar/grammar.h"
#include "app/small_program.h"
#include "catch.h"

namespace rigor {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("a manual page has name, synopsis, options, examples and exit codes") {
  const std::string page = manual_page(small_program());
  CHECK(page.starts_with(".TH PROG 1 "));
  CHECK(has(page, ".SH NAME\nprog \\- does things\n"));
  CHECK(has(page, "\\&\\fBprog look\\fR [\\fIOPTIONS\\fR] \\fIFILE\\fR...\n"));
  CHECK(has(page, "\\&\\fBprog leave\\fR\n"));
  CHECK(has(page, ".TP\n\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\n"));
  CHECK(has(page, "\\&\\fBprog look \\-\\-at \\(aq(6)\\(aq a.md\\fR\n"));
  CHECK(has(page, ".SH EXIT STATUS\n.TP\n.B 0\n"));
}

TEST_CASE("what stands between back-ticks is bold, and signs that roff reads are escaped") {
  const std::string page = manual_page(small_program());
  CHECK(has(page, "\\&\\fBauto\\fR or \\fBnever\\fR\n"));
  CHECK(has(page, "\n\\&.starts with a full stop \\(rs \\(ti\n"));
}

TEST_CASE("no line of the program's own manual page begins with a request that roff does not know") {
  std::istringstream lines(manual_page(Grammar().words()));
  const std::vector<std::string> known{".TH", ".SH", ".SS", ".TP", ".PP", ".RS", ".RE", ".nf", ".fi", ".B"};
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    if (!line.starts_with('.') && !line.starts_with('\'')) continue;
    CHECK(std::find(known.begin(), known.end(), line.substr(0, line.find(' '))) != known.end());
  }
}

}  // namespace
}  // namespace rigor
