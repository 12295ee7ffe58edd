// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/github.h"

#include <algorithm>
#include <sstream>

#include "catch.h"
#include "hostile_report.h"

namespace rigor {
namespace {

TEST_CASE("a refutation is an annotation at its place") {
  SourceMap sources;
  const Report report = example_report(sources);
  const std::string text = to_github(report, sources, {});
  CHECK(
      text.starts_with("::error file=notes/products.md,line=3,endLine=3,col=30,endColumn=31,title=refuted::"
                       "the sides differ%0Asample: \\mathbf{A} = (1, 0, 0), "));
  CHECK(text.find("\n2 steps: 1 proved") != std::string::npos);
}

TEST_CASE("an expected refutation is none, a warning is an error only when strict") {
  SourceMap sources;
  Report report = example_report(sources);
  Step& step = report.files[0].steps[1];
  step.expected_refuted = true;
  step.diagnostics.push_back({DiagnosticKind::bold_index, step.span, "bold", {}, {}});
  const std::string text = to_github(report, sources, {});
  CHECK(text.find("refuted::") == std::string::npos);
  CHECK(text.starts_with("::warning file="));
  CHECK(to_github(report, sources, {.rule = usual_rule(true)}).starts_with("::error file="));
}

TEST_CASE("a path inside the folder is said from there") {
  SourceMap sources;
  Report report = example_report(sources);
  SourceMap moved;
  moved.add("/repository/notes/products.md", example_text);
  CHECK(to_github(report, moved, {.folder = "/repository"}).starts_with("::error file=notes/products.md,"));
  CHECK(to_github(report, moved, {.folder = "/other"})
            .starts_with("::error file=/repository/notes/products.md,"));
}

TEST_CASE("whatever notes hold, a command is one line") {
  SourceMap sources;
  const Report report = hostile_report(sources);
  std::istringstream text(to_github(report, sources, {}));
  int commands = 0;
  for (std::string line; std::getline(text, line);) {
    if (line.find("0 steps") != std::string::npos || line.find("2 steps") != std::string::npos) continue;
    CHECK((line.starts_with("::error file=") || line.starts_with("::warning file=")));
    CHECK(std::none_of(line.begin(), line.end(), [](char c) { return c >= 0 && c < 0x20; }));
    ++commands;
  }
  CHECK(commands == 3);
}

}  // namespace
}  // namespace rigor
