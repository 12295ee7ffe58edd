// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/report_archive.h"

#include "catch.h"
#include "check/entry/check.h"
#include "hostile_report.h"
#include "report/data/json.h"
#include "report/text/terminal.h"

namespace rigor {
namespace {

const std::string notes =
    "# Products\n\n<!-- rigor: units m: M -->\n\n"
    "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A} \\tag{1}$$\n\n$$A_{i} = B_{j}$$\n\n$$E "
    "= mc^2$$\n";

TEST_CASE("a report that was packed prints the same, behind others") {
  SourceMap sources;
  Report report;
  report.files.push_back(check_text(sources, "a.md", notes));
  report.files.push_back(check_text(sources, "b.md", notes));
  SourceMap other;
  Report back;
  for (const char* path : {"a.md", "b.md"}) {
    SourceMap own;
    const FileReport file = check_text(own, path, notes);
    auto unpacked = unpack(pack(file, own), other);
    REQUIRE(unpacked);
    back.files.push_back(*std::move(unpacked));
  }
  for (Report* each : {&report, &back}) {
    for (FileReport& file : each->files)
      for (Step& step : file.steps) step.milliseconds = 0.0;
  }
  CHECK(to_json(report, sources) == to_json(back, other));
  CHECK(print_report(report, sources) == print_report(back, other));
  CHECK(report.files[0].steps.size() == 3);
  CHECK(back.files[1].displays == report.files[1].displays);
}

TEST_CASE("no part of a packed report and no other bytes are taken for one") {
  SourceMap sources;
  const Report report = hostile_report(sources);
  const std::string bytes = pack(report.files[0], sources);
  SourceMap into;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_FALSE(unpack(std::string_view(bytes).substr(0, size), into));
  CHECK_FALSE(unpack(bytes + "\n", into));
  CHECK_FALSE(unpack("", into));
  CHECK_FALSE(unpack(std::string(400, '\xff'), into));
  CHECK(into.size() == 0);
}

}  // namespace
}  // namespace rigor
