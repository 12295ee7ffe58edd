// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/read_file.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "catch.h"

namespace rigor {
namespace {

/// A file that is gone after the test.
class Scratch {
 public:
  explicit Scratch(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / (name + "-" + std::to_string(::getpid()))) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST_CASE("a file is read byte for byte") {
  const Scratch scratch("rigor_read_file_test_bytes");
  const std::string bytes = std::string("a\r\n\0b\xFF", 6) + std::string(100'000, 'x');
  std::ofstream(scratch.path(), std::ios::binary) << bytes;
  const auto text = read_file(scratch.path());
  REQUIRE(text);
  CHECK(*text == bytes);
}

TEST_CASE("an empty file is an empty text") {
  const Scratch scratch("rigor_read_file_test_empty");
  std::ofstream(scratch.path(), std::ios::binary).flush();
  CHECK(read_file(scratch.path()).value() == "");
}

TEST_CASE("what is no file is an error with its reason") {
  CHECK(read_file("no/such/file.md").error().reason == "no such file or directory");
  CHECK(read_file("").error().reason == "no such file or directory");
  CHECK(read_file(std::filesystem::temp_directory_path().string()).error().reason == "is a directory");
  CHECK(read_file("/dev/zero").error().reason == "not a regular file");
}

TEST_CASE("a file of 64 MiB is read, and one byte more is an error") {
  const Scratch scratch("rigor_read_file_test_large");
  std::ofstream(scratch.path(), std::ios::binary).flush();
  std::filesystem::resize_file(scratch.path(), std::uintmax_t{64} << 20U);
  CHECK(read_file(scratch.path()).value().size() == std::size_t{64} << 20U);
  std::filesystem::resize_file(scratch.path(), (std::uintmax_t{64} << 20U) + 1);
  CHECK(read_file(scratch.path()).error().reason == "larger than 64 MiB");
}

TEST_CASE("a text of valid UTF-8 is not touched") {
  std::string text = "ω² = 𝐀·é\n";
  CHECK(mend_text(text, 0).empty());
  CHECK(text == "ω² = 𝐀·é\n");
}

TEST_CASE("every byte that is not UTF-8 becomes the substitute character, and the first is reported") {
  std::string text = "a\xE9z\xC0\x80";
  const Diagnostics found = mend_text(text, 3);
  CHECK(text == "a\x1Az\x1A\x1A");
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == DiagnosticKind::invalid_utf8);
  CHECK(found[0].span == Span{3, 1, 2});
  CHECK(found[0].message == "byte `0xE9` is not UTF-8; the text has 3 such bytes");
  CHECK(found[0].help == std::vector<std::string>{"save the file as UTF-8"});
}

TEST_CASE("one byte that is not UTF-8 is not counted") {
  std::string text = "\xE2\x82";
  text += "x\xFF";
  text = text.substr(2);
  CHECK(mend_text(text, 0).at(0).message == "byte `0xFF` is not UTF-8");
}

TEST_CASE("a surrogate and a code point that the end cuts off are not UTF-8") {
  std::string surrogate = "\xED\xA0\x80";
  CHECK(mend_text(surrogate, 0).size() == 1);
  CHECK(surrogate == "\x1A\x1A\x1A");
  std::string cut = "x\xE2\x82";
  CHECK(mend_text(cut, 0).size() == 1);
  CHECK(cut == "x\x1A\x1A");
}

TEST_CASE(
    "NUL bytes become the substitute character, and the first is reported after what stands before it") {
  std::string text("\xFF\0b\0", 4);
  const Diagnostics found = mend_text(text, 0);
  CHECK(text ==
        "\x1A\x1A"
        "b\x1A");
  REQUIRE(found.size() == 2);
  CHECK(found[0].kind == DiagnosticKind::invalid_utf8);
  CHECK(found[1].kind == DiagnosticKind::nul_byte);
  CHECK(found[1].message == "the first of 2 NUL bytes");
  CHECK(found[1].span == Span{0, 1, 2});
}

TEST_CASE("a text in UTF-16 is called so") {
  std::string text("\xFF\xFE$\0", 4);
  CHECK(mend_text(text, 0).at(0).help.at(0) == "the text seems to be UTF-16; save it as UTF-8");
}

TEST_CASE("a byte-order mark becomes blanks, so that no place moves") {
  std::string text = "\xEF\xBB\xBF# Title";
  CHECK(mend_text(text, 0).empty());
  CHECK(text == "   # Title");
}

TEST_CASE("a carriage return alone ends a line, and no place moves") {
  std::string text = "a\r\rb\r\nc\r";
  CHECK(mend_text(text, 0).empty());
  CHECK(text == "a\n\nb\r\nc\n");
}

TEST_CASE("10 MB of bytes that are not UTF-8 are mended within a second") {
  std::string text(10'000'000, '\xE2');
  const auto start = std::chrono::steady_clock::now();
  CHECK(mend_text(text, 0).size() == 1);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
  CHECK(text == std::string(10'000'000, '\x1A'));
}

}  // namespace
}  // namespace rigor
