// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/completion.h"

#include <fmt/format.h>

#include <string_view>

namespace rigor {
namespace {

// `--color=al` reaches the function as three words.
constexpr std::string_view head = R"(# Completion of {0} in bash, made by `{0} completion`.
_{0}() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} option='' command='' word
  local -i before=$((COMP_CWORD - 1))
  COMPREPLY=()
  if [[ $cur == '=' ]]; then
    cur=''
  elif [[ ${{COMP_WORDS[before]}} == '=' ]]; then
    before=$((before - 1))
  fi
  [[ ${{COMP_WORDS[before]}} == -* ]] && option=${{COMP_WORDS[before]}}
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    [[ $word == -* ]] || {{ command=$word; break; }}
  done
)";

std::string names_of(const std::vector<OptionWords>& options) {
  std::string names;
  for (const OptionWords& option : options)
    for (const std::string& name : option.names) names += " " + name;
  return names;
}

std::string reply_words(std::string_view words) {
  return fmt::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$cur\")", words);
}

std::string reply_paths(char action) {
  return fmt::format("compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -{} -- \"$cur\")",
                     action);
}

std::string reply(const OptionWords& option) {
  std::string choices;
  for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : " ") + choice;
  switch (option.kind) {
    case ValueKind::file:
      return reply_paths('f') + "; return";
    case ValueKind::folder:
      return reply_paths('d') + "; return";
    case ValueKind::choice:
      return reply_words(choices) + "; return";
    case ValueKind::other:
      return "return";  // nothing to offer
    case ValueKind::none:
      return "";
  }
  return "";
}

/// `case "$command $option"`: what follows an option that takes a value.
std::string values(const ProgramWords& program) {
  std::string text = "  case \"$command $option\" in\n";
  for (const CommandWords& command : program.commands) {
    for (const OptionWords& option : command.options) {
      if (option.kind == ValueKind::none) continue;
      std::string patterns;
      for (const std::string& name : option.names)
        patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : "|", command.name, name);
      text += fmt::format("    {}) {} ;;\n", patterns, reply(option));
    }
  }
  return text + "  esac\n";
}

/// `case "$command"`: options after a dash, else the command's own words.
std::string words(const ProgramWords& program) {
  std::string commands;
  for (const CommandWords& command : program.commands) commands += " " + command.name;
  std::string options = "  if [[ $cur == -* ]]; then\n    case $command in\n";
  std::string operands = "  else\n    case $command in\n";
  options += fmt::format("      '') {} ;;\n", reply_words(names_of(program.options).substr(1)));
  operands += fmt::format("      '') {} ;;\n", reply_words(commands.substr(1)));
  for (const CommandWords& command : program.commands) {
    if (const std::string names = names_of(command.options); !names.empty())
      options += fmt::format("      {}) {} ;;\n", command.name, reply_words(names.substr(1)));
    if (command.operands.empty()) continue;
    const bool is_command = command.operands.front().value == "COMMAND";
    operands += fmt::format("      {}) {} ;;\n", command.name,
                            is_command ? reply_words(commands.substr(1)) : reply_paths('f'));
  }
  return options + "    esac\n" + operands + "    esac\n  fi\n";
}

}  // namespace

std::string bash_completion(const ProgramWords& program) {
  return fmt::format(head, program.name) + values(program) + words(program) +
         fmt::format("}}\ncomplete -F _{0} {0}\n", program.name);
}

}  // namespace rigor
