// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/completion.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/grammar/grammar.h"
#include "app/small_program.h"
#include "catch.h"

namespace rigor {
namespace {

/// A folder with the files `a.md` and `b c.md` and the folder `pictures`, and what bash offers there.
class Shell {
 public:
  Shell() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "pictures");
    std::ofstream(folder_ / "a.md");
    std::ofstream(folder_ / "b c.md");
  }
  ~Shell() { std::filesystem::remove_all(folder_); }
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  /// What is offered for the last of the words, joined by commas and sorted.
  [[nodiscard]] std::string offered(const ProgramWords& program,
                                    const std::vector<std::string>& words) const {
    std::string array;
    for (const std::string& word : words) array += fmt::format(" '{}'", word);
    std::ofstream(folder_ / ".script")
        << bash_completion(program)
        << fmt::format("COMP_WORDS=({})\nCOMP_CWORD={}\n_{}\n", array, words.size() - 1, program.name)
        << "printf '%s\\n' \"${COMPREPLY[@]}\" | sort | paste -sd ,\n";
    const std::string command = fmt::format("cd '{}' && bash .script 2>&1", folder_.string());
    FILE* const pipe = popen(command.c_str(), "r");
    std::array<char, 4096> text{};
    std::string output;
    while (std::fgets(text.data(), text.size(), pipe) != nullptr) output += text.data();
    CHECK(pclose(pipe) == 0);
    if (!output.empty()) output.pop_back();
    return output;
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("rigor_completion_{}", getpid());
};

TEST_CASE("bash is offered commands, options, choices and files") {
  const Shell shell;
  const ProgramWords program = small_program();
  CHECK(shell.offered(program, {"prog", ""}) == "leave,look");
  CHECK(shell.offered(program, {"prog", "lo"}) == "look");
  CHECK(shell.offered(program, {"prog", "-"}) == "--help,-h");
  CHECK(shell.offered(program, {"prog", "look", "--"}) == "--at,--color,--into,--json,--output");
  CHECK(shell.offered(program, {"prog", "look", "--color", ""}) == "auto,never");
  CHECK(shell.offered(program, {"prog", "look", "--color", "=", "ne"}) == "never");
  CHECK(shell.offered(program, {"prog", "look", "--color", "="}) == "auto,never");
  CHECK(shell.offered(program, {"prog", "look", "--into", ""}) == "pictures");
  CHECK(shell.offered(program, {"prog", "look", "-o", "b"}) == "b c.md");
  CHECK(shell.offered(program, {"prog", "look", "--at", ""}).empty());
  CHECK(shell.offered(program, {"prog", "look", "--json", "a"}) == "a.md");
  CHECK(shell.offered(program, {"prog", "leave", ""}).empty());
}

TEST_CASE("bash is offered the program's own words") {
  const Shell shell;
  const ProgramWords program = Grammar().words();
  CHECK(shell.offered(program, {"rigor", "ch"}) == "check");
  CHECK(shell.offered(program, {"rigor", "help", "sc"}) == "scene");
  CHECK(shell.offered(program, {"rigor", "check", "--si"}) == "--sidecar");
  CHECK(shell.offered(program, {"rigor", "check", "a.md", "--sidecar", "a"}) == "a.md");
  CHECK(shell.offered(program, {"rigor", "check", "--color", ""}) == "always,auto,never");
  CHECK(shell.offered(program, {"rigor", "bench", "a.md", "--into", ""}) == "pictures");
}

}  // namespace
}  // namespace rigor
