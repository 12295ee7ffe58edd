// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "catch.h"
#include "exchange.h"
#include "source/read_file.h"

namespace {

using namespace rigor;
using exchange::Tally;

/// All notes of a folder, sorted.
std::vector<std::string> notes_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string end = entry.path().extension().string();
    if (entry.is_regular_file() && (end == ".md" || end == ".tex")) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

using Trial = Tally (*)(const SourceMap&, const exchange::TokenDisplay&);

Tally tried_in(const std::string& path, Trial trial) {
  auto text = read_file(path);
  REQUIRE(text);
  static_cast<void>(mend_text(*text, 0));
  SourceMap sources;
  const FileId file = sources.add(path, std::move(*text));
  Tally tally;
  for (const exchange::TokenDisplay& display : exchange::displays_of(sources, file))
    tally.add(trial(sources, display));
  return tally;
}

void print(const std::string& path, const Tally& tally) {
  fmt::print(
      "{}: {} displays, {} statements ({} not understood), {} tokens, {} exchanged, {} left over, {} without "
      "a "
      "difference\n",
      path, tally.displays, tally.statements, tally.not_understood, tally.tokens, tally.exchanged,
      tally.left_over, tally.no_difference.size());
  for (const std::string& place : tally.no_difference) fmt::print("  {}\n", place);
}

}  // namespace

TEST_CASE("every token of the notes belongs to something, and its exchange makes a difference") {
  for (const std::string folder : {"derivations", "tests/notes"}) {
    Tally all;
    for (const std::string& path : notes_in(folder)) {
      const Tally tally = tried_in(path, exchange::exchange_tokens);
      INFO(path);
      CHECK(tally.left_over == 0);
      CHECK(tally.no_difference == std::vector<std::string>{});
      all.add(tally);
    }
    print(folder, all);
    CHECK(all.displays > 50);
  }
}

TEST_CASE("a script or a word that is added to a letter makes a difference") {
  for (const std::string folder : {"derivations", "tests/notes/pass"}) {
    Tally all;
    for (const std::string& path : notes_in(folder)) {
      const Tally tally = tried_in(path, exchange::insert_signs);
      INFO(path);
      CHECK(tally.no_difference == std::vector<std::string>{});
      all.add(tally);
    }
    fmt::print("{}: {} signs added\n", folder, all.inserted);
    CHECK(all.inserted > 1000);
  }
}

// RIGOR_TOKENS_OF="FILE…" rigor_tokens_tests "[.tokens]": a tally for each file.
TEST_CASE("every token of the notes that are named makes a difference", "[.tokens]") {
  const char* named = std::getenv("RIGOR_TOKENS_OF");
  REQUIRE(named != nullptr);
  std::istringstream paths{named};
  Tally all;
  for (std::string path; paths >> path;) {
    const Tally tally = tried_in(path, exchange::exchange_tokens);
    print(path, tally);
    all.add(tally);
  }
  print("all", all);
  CHECK(all.left_over == 0);
  CHECK(all.no_difference.empty());
}
