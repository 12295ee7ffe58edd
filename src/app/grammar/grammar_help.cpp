// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/grammar/completion.h"
#include "app/grammar/grammar.h"
#include "app/grammar/manual.h"
#include "source/suggest.h"

namespace rigor {

void add_help(Grammar& grammar) {
  const auto topic = std::make_shared<std::string>();
  CLI::App& app =
      grammar.command("help", "Print the help of a command", {"help check"}, [topic]() -> CommandLine {
        std::vector<const char*> words{"rigor"};
        if (!topic->empty()) words.push_back(topic->c_str());
        words.push_back("--help");
        return parse_command_line(static_cast<int>(words.size()), words.data());
      });
  const auto known = [&grammar](const std::string& name) {
    if (grammar.has(name)) return std::string();
    return fmt::format("`{}` is not a command; did you mean `{}`?", name,
                       suggest(name, grammar.names()).value_or("check"));
  };
  app.add_option("COMMAND", *topic, "One of the commands; without it, all are listed")
      ->type_name("")
      ->check(CLI::Validator(known, ""));
}

void add_manual(Grammar& grammar) {
  grammar.command("manual", "Print the manual page, for man", {"manual | man -l -"},
                  [&grammar]() -> CommandLine { return {.text = manual_page(grammar.words())}; });
}

void add_completion(Grammar& grammar) {
  grammar.command("completion", "Print the completion of these words, for bash",
                  {"completion > ~/.local/share/bash-completion/completions/rigor"},
                  [&grammar]() -> CommandLine { return {.text = bash_completion(grammar.words())}; });
}

}  // namespace rigor
