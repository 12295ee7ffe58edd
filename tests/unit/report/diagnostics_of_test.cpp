// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/diagnostics_of.h"

#include <utility>

#include "catch.h"

namespace rigor {
namespace {

Diagnostic at(std::uint32_t file, std::uint32_t begin, std::string message = "") {
  return {DiagnosticKind::undecided, Span{file, begin, begin}, std::move(message), {}, {}};
}

TEST_CASE("diagnostics are sorted by file and place, and know their step") {
  FileReport file;
  file.steps.resize(2);
  file.steps[0].diagnostics = {at(0, 30), at(1, 0)};
  file.steps[1].diagnostics = {at(0, 20)};
  file.diagnostics = {at(0, 20, "of the file"), at(0, 5)};
  const auto placed = diagnostics_of(file);
  REQUIRE(placed.size() == 5);
  CHECK(placed[0].diagnostic == &file.diagnostics[1]);
  CHECK(placed[0].step == nullptr);
  CHECK(placed[1].step == &file.steps[1]);
  CHECK(placed[2].diagnostic == &file.diagnostics[0]);
  CHECK(placed[3].step == &file.steps[0]);
  CHECK(placed[4].diagnostic == &file.steps[0].diagnostics[1]);
}

TEST_CASE("what is said of several steps in the same words stands there once") {
  FileReport file;
  file.steps.resize(3);
  file.steps[0].diagnostics = {at(0, 7, "one")};
  file.steps[1].diagnostics = {at(0, 7, "one")};
  file.steps[2].diagnostics = {at(0, 7, "two")};
  const auto placed = diagnostics_of(file);
  REQUIRE(placed.size() == 2);
  CHECK(placed[0].step == &file.steps[0]);
  CHECK(placed[1].step == &file.steps[2]);
}

TEST_CASE("a file without diagnostics has none") { CHECK(diagnostics_of({}).empty()); }

}  // namespace
}  // namespace rigor
