// SPDX-License-Identifier: GPL-3.0-or-later
// The console examples of the README and the docs print what stands there.
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "app/command/run.h"
#include "catch.h"

namespace rigor {
namespace {

/// A command as a shell takes it apart, single quotes only.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false;
  bool started = false;
  for (const char c : command + " ") {
    if (c == '\'') {
      quoted = !quoted;
      started = true;
    } else if (c == ' ' && !quoted) {
      if (started) words.push_back(word);
      word.clear();
      started = false;
    } else {
      word += c;
      started = true;
    }
  }
  return words;
}

std::string printed_by(const std::string& command) {
  const std::vector<std::string> words = words_of(command);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream both;
  static_cast<void>(run(static_cast<int>(pointers.size()), pointers.data(), both, both));
  return both.str();
}

/// Runs the examples of a text and compares; how many there are.
std::size_t examples_that_hold(const char* path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::string line;
  std::string command;
  std::string expected;
  std::size_t examples = 0;
  bool inside = false;
  const auto compare = [&] {
    if (command.empty()) return;
    INFO(path << ": " << command);
    CHECK(printed_by(command) == expected);
    ++examples;
    command.clear();
    expected.clear();
  };
  while (std::getline(file, line)) {
    if (line == "```console") {
      inside = true;
    } else if (line == "```") {
      compare();
      inside = false;
    } else if (inside && line.starts_with("$ ")) {
      compare();
      command = line.substr(2);
    } else if (inside) {
      expected += line + "\n";
    }
  }
  return examples;
}

}  // namespace

TEST_CASE("the console examples of the README and the docs print what stands there") {
  CHECK(examples_that_hold("docs/holes.md") > 8);
  CHECK(examples_that_hold("docs/explain.md") == 1);
  CHECK(examples_that_hold("README.md") == 3);
}

}  // namespace rigor
