// SPDX-License-Identifier: GPL-3.0-or-later
// The words of each command. A command has a function of its own, `add_…`, that says which words it knows and
// what they make of the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/grammar/command_line.h"
#include "app/grammar/words.h"

namespace rigor {

/// All commands, and the words that were read. Functions that `command` was given hold their words.
class Grammar {
 public:
  Grammar();
  Grammar(const Grammar&) = delete;
  Grammar& operator=(const Grammar&) = delete;

  /// A command of its own. `what` is one line; `examples` are command lines without the program's name;
  /// `line` is called when its words were read.
  CLI::App& command(const char* name, const char* what, const std::vector<std::string>& examples,
                    std::function<CommandLine()> line);

  [[nodiscard]] CLI::App& app() { return app_; }
  /// The command that was given; `check` if none was.
  [[nodiscard]] std::string given() const;
  /// What was read, as a value.
  [[nodiscard]] CommandLine line() const;
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] bool has(const std::string& name) const;
  /// All of it, for the manual page and the completion. Changes nothing.
  [[nodiscard]] ProgramWords words();

 private:
  struct Command {
    CLI::App* words;
    std::vector<std::string> examples;
    std::function<CommandLine()> line;
  };
  CLI::App app_{"rigor checks the equations in physics notes.", "rigor"};
  std::vector<Command> commands_;
};

void add_check(Grammar& grammar);
void add_replay(Grammar& grammar);
void add_eval(Grammar& grammar);
void add_bench(Grammar& grammar);
void add_scene(Grammar& grammar);
void add_derive(Grammar& grammar);
void add_explain(Grammar& grammar);
void add_read(Grammar& grammar);
void add_suggest(Grammar& grammar);
void add_report(Grammar& grammar);
void add_cases(Grammar& grammar);
void add_case(Grammar& grammar);
void add_help(Grammar& grammar);
void add_manual(Grammar& grammar);
void add_completion(Grammar& grammar);

// What several commands have in common.

void add_sidecar(CLI::App& to, std::optional<std::string>& sidecar);
void add_color(CLI::App& to, ColorWhen& color);
/// Only these words; anything else is `unknown WHAT`. They are the validator's name, between separators.
inline constexpr char choice_separator = '|';
[[nodiscard]] CLI::Validator one_of(std::string what, std::vector<std::string> names);

}  // namespace rigor
