// SPDX-License-Identifier: GPL-3.0-or-later
// The examples of docs/notation.md and the one of README.md, run as they are printed there.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.h"
#include "check/entry/check.h"
#include "program.h"
#include "report/text/terminal.h"

namespace rigor {
namespace {

/// A fenced block. The words behind the language say what is expected of it.
struct Block {
  std::size_t line = 0;  // of its fence, from 1
  std::string language;
  std::vector<std::string> expected;
  std::string text;
};

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<Block> blocks_in(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  std::string fence;  // of the open block; empty outside
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::string marks = line.substr(0, line.find_first_not_of('`'));
    if (!fence.empty() && marks.size() >= fence.size() && marks == line) {
      fence.clear();
    } else if (!fence.empty()) {
      blocks.back().text += line + "\n";
    } else if (marks.size() >= 3) {
      fence = marks;
      Block block{number, "", words_of(line.substr(marks.size())), ""};
      if (!block.expected.empty()) {
        block.language = block.expected.front();
        block.expected.erase(block.expected.begin());
      }
      blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

void add_kinds(const Diagnostics& diagnostics, std::vector<std::string>& words) {
  for (const Diagnostic& diagnostic : diagnostics) {
    const bool goes_with_verdict =
        diagnostic.kind == DiagnosticKind::refuted || diagnostic.kind == DiagnosticKind::undecided;
    if (!goes_with_verdict) words.push_back(fmt::format("[{}]", info(diagnostic.kind).name));
  }
}

/// In the form of an example's first line: verdicts, each followed by what is said of the step.
std::vector<std::string> answer(const FileReport& report) {
  std::vector<std::string> words;
  for (const Step& step : report.steps) {
    words.emplace_back(name_of(step.verdict));
    add_kinds(step.diagnostics, words);
  }
  add_kinds(report.diagnostics, words);
  return words;
}

/// A file that is gone when the test is over.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("rigor-notation-{}-{}.rigor", ::getpid(), static_cast<const void*>(this))) {
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST_CASE("every example of docs/notation.md is answered as its first line says") {
  std::size_t examples = 0;
  std::string sidecar;
  for (const Block& block : blocks_in(text_of("../../docs/notation.md"))) {
    if (block.language == "rigor") {
      sidecar = block.text;
      continue;
    }
    INFO("docs/notation.md:" << block.line);
    REQUIRE((block.language == "markdown" || block.language == "tex"));
    const TemporaryFile file(sidecar);
    CheckOptions options;
    if (!sidecar.empty()) options.sidecar = file.path();
    sidecar.clear();
    SourceMap sources;
    // In pass/, since one example reads a file of pass/input/.
    const std::string path = block.language == "tex" ? "pass/notation.tex" : "pass/notation.md";
    CHECK(answer(check_text(sources, path, block.text, options)) == block.expected);
    ++examples;
  }
  CHECK(examples > 0);
}

/// Without the time at the end, which is another one in each run.
std::string without_time(std::string text) {
  const auto semicolon = text.rfind(';');
  return semicolon == std::string::npos ? text : text.substr(0, semicolon);
}

TEST_CASE("README.md shows what the program prints") {
  const std::vector<Block> blocks = blocks_in(text_of("../../README.md"));
  REQUIRE(blocks.size() >= 2);
  REQUIRE(blocks[0].language == "markdown");
  SourceMap sources;
  Report report;
  report.files.push_back(check_text(sources, "cross.md", blocks[0].text));
  report.counts = report.files[0].counts;
  CHECK(without_time(print_report(report, sources)) == without_time(blocks[1].text));
}

}  // namespace
}  // namespace rigor
