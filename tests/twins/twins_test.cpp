// SPDX-License-Identifier: GPL-3.0-or-later
// Every proved step of derivations/ with one slip of the pen is refuted, is malformed, or is one of the few
// in reviewed/ that the slip leaves true or that Rigor does not decide.
#include "twins.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "catch.h"
#include "source/read_file.h"

namespace rigor::twins {
namespace {

constexpr const char* reviewed_folder = "tests/twins/reviewed";

/// The file of notes to look at: one for each test, since they take their time.
std::string notes_path() {
  const char* path = std::getenv("RIGOR_TWINS_OF");
  return path == nullptr ? "derivations/vector-identities.tex" : path;
}

std::string reviewed_path() {
  return fmt::format("{}/{}.txt", reviewed_folder, std::filesystem::path(notes_path()).filename().string());
}

using Row = std::array<std::size_t, outcome_count>;

std::string line_of(std::string_view name, const Row& row) {
  std::size_t sum = 0;
  std::string cells;
  for (const std::size_t count : row) {
    sum += count;
    cells += fmt::format("{:>14}", count);
  }
  return fmt::format("{:<16}{:>8}{}\n", name, sum, cells);
}

std::string table_of(const Twins& all) {
  std::array<Row, slip_count> rows{};
  Row total{};
  for (const Twin& twin : all.twins) {
    ++rows[static_cast<std::size_t>(twin.slip)][static_cast<std::size_t>(twin.outcome)];
    ++total[static_cast<std::size_t>(twin.outcome)];
  }
  std::string table = fmt::format("{:<16}{:>8}", "slip", "twins");
  for (std::size_t k = 0; k < outcome_count; ++k)
    table += fmt::format("{:>14}", name_of(static_cast<Outcome>(k)));
  table += "\n";
  for (std::size_t k = 0; k <= static_cast<std::size_t>(Slip::bars_dropped); ++k)
    table += line_of(name_of(static_cast<Slip>(k)), rows[k]);
  table += line_of("all", total);
  std::size_t open = 0;
  for (const Outcome outcome : {Outcome::undecided, Outcome::law_like, Outcome::failed})
    open += total[static_cast<std::size_t>(outcome)];
  const auto count = static_cast<double>(all.twins.size());
  return table + fmt::format("{} statements, {:.2f} % of their twins are answered\n", all.statements,
                             100.0 * (count - static_cast<double>(open)) / count);
}

/// Under each statement the twins of it that were proved, or not decided.
std::string to_review(const Twins& all) {
  std::map<std::string, std::set<std::string>> by_statement;
  for (const Twin& twin : all.twins) {
    if (twin.outcome != Outcome::proved_equal && twin.outcome != Outcome::undecided) continue;
    by_statement[twin.original].insert(
        fmt::format("  {:<14}{:<16}{}\n", name_of(twin.outcome), name_of(twin.slip), twin.twin));
  }
  std::string text;
  for (const auto& [statement, twins] : by_statement) {
    text += statement + "\n";
    for (const std::string& twin : twins) text += twin;
  }
  return text;
}

TEST_CASE("every false twin is refuted or proved equal", "[.twins]") {
  const Twins all = twins_of(notes_path());
  fmt::print("{}\n{}", notes_path(), table_of(all));
  std::fflush(stdout);
  for (const std::string& statement : all.lost) {
    UNSCOPED_INFO(statement);
    FAIL_CHECK("the short form of the notes says something else than the notes");
  }
  for (const Twin& twin : all.twins) {
    if (twin.outcome != Outcome::failed) continue;
    UNSCOPED_INFO(twin.place << ", " << name_of(twin.slip) << ", " << twin.said);
    FAIL_CHECK(twin.twin);
  }
  for (const Twin& twin : all.twins) {
    if (twin.broken_by.empty()) continue;
    UNSCOPED_INFO(twin.place << ", " << name_of(twin.slip)
                             << ", fails on a random sample: " << twin.broken_by);
    FAIL_CHECK(twin.twin);
  }
  const auto reviewed = read_file(reviewed_path());
  REQUIRE(reviewed);
  CHECK(to_review(all) == *reviewed);
}

TEST_CASE("rewrites the list of twins that are proved equal or not decided", "[.rewrite]") {
  std::ofstream(reviewed_path()) << to_review(twins_of(notes_path()));
}

TEST_CASE("prints every twin with what is said to it", "[.list]") {
  for (const Twin& twin : twins_of(notes_path()).twins) {
    fmt::print("{}\t{}\t{}\t{}\t{}\t{}\n", twin.place, name_of(twin.slip), name_of(twin.outcome), twin.said,
               twin.original, twin.twin);
  }
}

}  // namespace
}  // namespace rigor::twins
