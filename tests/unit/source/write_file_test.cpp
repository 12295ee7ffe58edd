// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/write_file.h"

#include <unistd.h>

#include <filesystem>

#include "catch.h"
#include "source/read_file.h"

namespace rigor {
namespace {

std::string folder_of_own() {
  const auto folder = std::filesystem::temp_directory_path() / ("rigor-write-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  return folder.string();
}

TEST_CASE("a file that is replaced has the new text and leaves nothing beside it") {
  const std::string folder = folder_of_own();
  REQUIRE(write_file(folder + "/a", "old and long"));
  REQUIRE(replace_file(folder + "/a", "new"));
  CHECK(read_file(folder + "/a").value() == "new");
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
  std::filesystem::remove_all(folder);
}

TEST_CASE("what cannot be written is an error with its reason") {
  CHECK(write_file("/no/such/folder/a", "x").error().reason == "no such file or directory");
  CHECK(replace_file("/no/such/folder/a", "x").error().reason == "no such file or directory");
  const std::string folder = folder_of_own();
  CHECK_FALSE(write_file(folder, "x"));
  CHECK_FALSE(replace_file(folder, "x"));
  CHECK(std::filesystem::is_directory(folder));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rigor
