// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/mapped_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "catch.h"

namespace rigor {
namespace {

/// A place of our own for a file, gone after the test.
class MappedPlace {
 public:
  explicit MappedPlace(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / (name + "-" + std::to_string(::getpid()))) {}
  ~MappedPlace() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  MappedPlace(const MappedPlace&) = delete;
  MappedPlace& operator=(const MappedPlace&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST_CASE("a mapped file has the bytes of the file, from the alignment of a double on") {
  const MappedPlace place("rigor_mapped_file_test_bytes");
  const std::string bytes = std::string("a\r\n\0b\xFF", 6) + std::string(100'000, 'x');
  std::ofstream(place.path(), std::ios::binary) << bytes;
  auto file = MappedFile::open(place.path());
  REQUIRE(file);
  CHECK(file->bytes() == bytes);
  CHECK(reinterpret_cast<std::uintptr_t>(file->bytes().data()) % alignof(double) == 0);
  const MappedFile moved = *std::move(file);
  CHECK(file->bytes().empty());
  CHECK(moved.bytes() == bytes);
  std::filesystem::remove(place.path());
  CHECK(moved.bytes() == bytes);  // for as long as the object lives
}

TEST_CASE("an empty file is mapped to no bytes") {
  const MappedPlace place("rigor_mapped_file_test_empty");
  std::ofstream(place.path(), std::ios::binary) << "";
  const auto file = MappedFile::open(place.path());
  REQUIRE(file);
  CHECK(file->bytes().empty());
}

TEST_CASE("what is no regular file is not mapped, and is not waited for") {
  const auto reason = [](const std::string& path) { return MappedFile::open(path).error().reason; };
  const MappedPlace pipe("rigor_mapped_file_test_pipe");
  REQUIRE(::mkfifo(pipe.path().c_str(), 0600) == 0);
  CHECK(reason(pipe.path()) == "not a regular file");
  CHECK(reason("/dev/null") == "not a regular file");
  CHECK(reason(std::filesystem::temp_directory_path().string()) == "is a directory");
  CHECK(reason(pipe.path() + "/none") == "not a directory");
  CHECK(reason(pipe.path() + "-none") == "no such file or directory");
}

}  // namespace
}  // namespace rigor
