// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "app/grammar/grammar.h"
#include "catch.h"

namespace rigor {
namespace {

/// Split as a shell does: at blanks outside quotes, up to a pipe or a redirection.
std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words{"rigor"};
  std::string word;
  char quote = '\0';
  bool inside = false;
  for (const char letter : line) {
    if (quote == '\0' && (letter == '|' || letter == '>')) break;
    if (letter == quote) {
      quote = '\0';
    } else if (quote == '\0' && (letter == '\'' || letter == '"')) {
      quote = letter;
      inside = true;
    } else if (quote == '\0' && letter == ' ') {
      if (inside) words.push_back(std::exchange(word, ""));
      inside = false;
    } else {
      word += letter;
      inside = true;
    }
  }
  if (inside) words.push_back(word);
  return words;
}

const CommandWords& command_named(const ProgramWords& program, const std::string& name) {
  const auto found = std::find_if(program.commands.begin(), program.commands.end(),
                                  [&](const CommandWords& command) { return command.name == name; });
  REQUIRE(found != program.commands.end());
  return *found;
}

TEST_CASE("each command has an example, and the command line accepts each") {
  for (const CommandWords& command : Grammar().words().commands) {
    INFO(command.name);
    CHECK_FALSE(command.examples.empty());
    for (const std::string& example : command.examples) {
      INFO(example);
      const std::vector<std::string> words = shell_words(example);
      std::vector<const char*> argv;
      for (const std::string& word : words) argv.push_back(word.c_str());
      CHECK(parse_command_line(static_cast<int>(argv.size()), argv.data()).code == ExitCode::ok);
    }
  }
}

TEST_CASE("the words of a command say what each takes") {
  const ProgramWords program = Grammar().words();
  const CommandWords& check = command_named(program, "check");
  REQUIRE(check.operands.size() == 1);
  CHECK(check.operands[0].value == "FILE");
  CHECK_FALSE(check.operands[0].required);  // a settings file may name them
  CHECK(check.operands[0].many);
  const auto option = [&](const CommandWords& command, const std::string& name) {
    for (const OptionWords& each : command.options)
      if (std::find(each.names.begin(), each.names.end(), name) != each.names.end()) return each;
    return OptionWords{};
  };
  CHECK(option(check, "--json").kind == ValueKind::none);
  CHECK(option(check, "--sidecar").kind == ValueKind::file);
  CHECK(option(check, "--color").choices == std::vector<std::string>{"auto", "always", "never"});
  CHECK(option(command_named(program, "bench"), "--into").kind == ValueKind::folder);
  CHECK(option(command_named(program, "eval"), "--at").kind == ValueKind::other);
  CHECK(option(command_named(program, "eval"), "--no-times").kind == ValueKind::none);
}

TEST_CASE("no option of any command takes a value of no kind") {
  for (const CommandWords& command : Grammar().words().commands)
    for (const OptionWords& option : command.options) {
      INFO(command.name << " " << (option.names.empty() ? "" : option.names.back()));
      CHECK((option.kind == ValueKind::none) == option.value.empty());
      CHECK_FALSE(option.what.empty());
    }
}

}  // namespace
}  // namespace rigor
