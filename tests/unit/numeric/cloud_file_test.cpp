// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/cloud_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.h"
#include "numeric/kernels/point_clouds.h"
#include "numeric/mesh/cloud_text.h"
#include "peak_memory.h"

namespace rigor {
namespace {

/// A file that is gone afterwards.
class CloudFile {
 public:
  CloudFile(const std::string& name, const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() / fmt::format("rigor-{}-{}", ::getpid(), name)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~CloudFile() { std::filesystem::remove(path_); }
  CloudFile(const CloudFile&) = delete;
  CloudFile& operator=(const CloudFile&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST_CASE("the inertia of a cloud's file is that of its points, to the last bit") {
  const PointCloud cloud = cube_cloud(10'001, 1e6, 21);
  const std::vector<double> records = cloud.records();
  std::string text;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    for (std::size_t i = 0; i < 4; ++i) text += fmt::format("{} ", records[4 * k + i]);
    text += "\n";
  }
  const CloudFile binary("cloud.bin", {reinterpret_cast<const char*>(records.data()), 8 * records.size()});
  const CloudFile words("cloud.TXT", text);
  const auto expected = known_inertia(*sharp_mass_sums(cloud.points(), {2}));
  for (const std::string& path : {binary.path(), words.path()}) {
    const auto body = read_cloud("cloud", path);
    REQUIRE(body);
    CHECK(body->known->mass == expected->mass);
    CHECK(body->known->inertia == expected->inertia);
    CHECK(body->known->low == expected->low);
    CHECK(ExactMassSums(cloud).error_of(mass_sums(points_of(*body))->inertia) <= 0x1p-50);
  }
}

TEST_CASE("numbers of a cloud's text stand between blanks or single commas") {
  const auto columns = parse_cloud("\t1 2,3 , 4\r\n# 5 6 7 8\n+1e-3 -.5,0,1#9\n,\n");
  REQUIRE_FALSE(columns);
  CHECK(columns.error().reason == "line 4: there is no number before a comma");
  const auto good = parse_cloud("\t1 2,3 , 4\r\n# 5 6 7 8\n+1e-3 -.5,0,1#9");
  REQUIRE(good);
  CHECK((*good)[0] == std::vector<double>{1, 1e-3});
  CHECK((*good)[1] == std::vector<double>{2, -0.5});
  CHECK((*good)[2] == std::vector<double>{3, 0});
  CHECK((*good)[3] == std::vector<double>{4, 1});
  CHECK(parse_cloud("").value()[0].empty());
}

TEST_CASE("a cloud's number has one sign, is followed by another after a comma, and may be too small") {
  const auto reason = [](const std::string& text) { return parse_cloud(text).error().reason; };
  CHECK(reason("1 2 3 4\n+-1 2 3 4") == "line 2: `+-1` is not a finite number");
  CHECK(reason("++1 2 3 4") == "line 1: `++1` is not a finite number");
  CHECK(reason("+ 2 3 4") == "line 1: `+` is not a finite number");
  CHECK(reason("1,2,3,4,") == "line 1: there is no number after the last comma");
  CHECK(reason("1,2,3,4 , # five\n") == "line 1: there is no number after the last comma");
  CHECK(reason("1,2, ,4") == "line 1: there is no number between two commas");
  CHECK(reason("1 2 3 1e400") == "line 1: `1e400` is not a finite number");
  const auto small = parse_cloud("1e-400 -1e-5000 4.9e-324 1 \r\n");
  REQUIRE(small);
  CHECK((*small)[0][0] == 0);
  CHECK((*small)[1][0] == 0);
  CHECK((*small)[2][0] == 0x1p-1074);
}

TEST_CASE("the points of a cloud's file are in memory once while they are read") {
  if (!memory_is_our_own) return;
  const PointCloud cloud = cube_cloud(1'000'000, 1e3, 22);
  const std::vector<double> records = cloud.records();
  const CloudFile binary("large.bin", {reinterpret_cast<const char*>(records.data()), 8 * records.size()});
  constexpr double size = 32e6 / (1 << 20);
  CHECK(peak_memory_of([&] { return read_cloud("cloud", binary.path()).has_value(); }) < 1.3 * size);

  std::string text;
  for (std::size_t k = 0; k < cloud.size(); ++k)
    text += fmt::format("{}\n", fmt::join(&records[4 * k], &records[4 * k] + 4, ","));
  const CloudFile words("large.csv", text);
  const double length = static_cast<double>(text.size()) / (1 << 20);
  CHECK(peak_memory_of([&] { return read_cloud("cloud", words.path()).has_value(); }) < 1.3 * length);
}

TEST_CASE("what is no regular file is no cloud") {
  const std::string folder = std::filesystem::temp_directory_path().string();
  const CloudFile file("cloud.bin", "");
  CHECK(read_cloud("none", file.path()).error().reason == "the file is empty");
  CHECK(read_cloud("none", folder + "/none/cloud.bin").error().reason == "no such file or directory");
  std::filesystem::create_directory(file.path() + ".bin");
  CHECK(read_cloud("none", file.path() + ".bin").error().reason == "is a directory");
  std::filesystem::remove(file.path() + ".bin");
  CHECK(read_cloud("none", folder).error().reason == "a cloud's name ends in `.bin`, `.txt` or `.csv`");
}

}  // namespace
}  // namespace rigor
