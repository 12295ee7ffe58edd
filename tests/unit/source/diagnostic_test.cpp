// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/diagnostic.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "catch.h"

namespace rigor {
namespace {

/// The heading of each section of the documentation and the line below it. Tests run at the top of the
/// repository.
std::vector<std::pair<std::string, std::string>> documented_kinds() {
  std::ifstream file("docs/diagnostics.md");
  std::vector<std::pair<std::string, std::string>> sections;
  std::string heading;
  for (std::string line; std::getline(file, line);) {
    if (!heading.empty() && !line.empty()) {
      sections.emplace_back(heading, line);
      heading.clear();
    }
    if (line.starts_with("### ")) heading = line.substr(4);
  }
  return sections;
}

TEST_CASE("every kind has one name, in lower case with hyphens, and a summary") {
  std::set<std::string_view> names;
  for (const DiagnosticInfo& entry : diagnostic_table()) {
    CHECK(names.insert(entry.name).second);
    CHECK(entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos);
    CHECK_FALSE(entry.summary.empty());
    CHECK(&info(entry.kind) == &entry);
  }
  CHECK(info(DiagnosticKind::index_repeats).name == "index-repeats");
  CHECK(info(DiagnosticKind::nul_byte).name == "nul-byte");
}

TEST_CASE("severities are printed as words") {
  CHECK(name_of(Severity::error) == "error");
  CHECK(name_of(Severity::refuted) == "refuted");
  CHECK(name_of(Severity::undecided) == "undecided");
  CHECK(name_of(Severity::not_understood) == "not understood");
  CHECK(name_of(Severity::warning) == "warning");
}

TEST_CASE(
    "every kind has its section in docs/diagnostics.md, in the order of the registry, with severity and "
    "summary") {
  const auto sections = documented_kinds();
  const auto table = diagnostic_table();
  REQUIRE(sections.size() == table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    CHECK(sections[i].first == std::string(table[i].name));
    const std::string line =
        "*" + std::string(name_of(table[i].severity)) + "*: " + std::string(table[i].summary) + ".";
    CHECK(sections[i].second == line);
  }
}

TEST_CASE("only warnings are off unless asked for") {
  for (const DiagnosticInfo& entry : diagnostic_table())
    CHECK((!entry.off || entry.severity == Severity::warning));
  CHECK(info(DiagnosticKind::scalar_zero).off);
}

}  // namespace
}  // namespace rigor
