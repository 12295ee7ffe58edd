// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/write_back.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.h"

namespace rigor {

TEST_CASE("replacements come in any order, and all other bytes stay") {
  CHECK(with_replacements("a ? b ?\r\n", {{{0, 6, 7}, "second"}, {{0, 2, 3}, "x"}}) == "a x b second\r\n");
  CHECK(with_replacements("abc", {}) == "abc");
}

TEST_CASE("a file keeps its permissions and leaves nothing beside it") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("rigor-write-back-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto path = folder / "notes.md";
  std::ofstream(path) << "old";
  using std::filesystem::perms;
  std::filesystem::permissions(path, perms::owner_read | perms::owner_write);
  REQUIRE(replace_file(path.string(), "new"));
  std::ifstream file(path);
  CHECK(std::string{std::istreambuf_iterator<char>(file), {}} == "new");
  CHECK(std::filesystem::status(path).permissions() == (perms::owner_read | perms::owner_write));
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a file that is missing is not made") {
  CHECK_FALSE(replace_file("no/such/file.md", "new"));
  CHECK_FALSE(std::filesystem::exists("no/such/file.md"));
}

}  // namespace rigor
