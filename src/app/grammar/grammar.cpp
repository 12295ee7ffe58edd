// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/grammar.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "algebra/engine/engine_version.h"
#include "base/among.h"
#include "base/version.h"

namespace rigor {
namespace {

std::string footer(const std::vector<std::string>& examples) {
  std::string text = examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& example : examples) text += fmt::format("  rigor {}\n", example);
  text += "\nExit codes:\n";
  for (const ExitCodeInfo& entry : exit_code_table())
    text += fmt::format("  {:>2}  {}\n", number_of(entry.code), entry.meaning);
  text.pop_back();
  return text;
}

}  // namespace

Grammar::Grammar() {
  app_.set_version_flag("--version", fmt::format("rigor {}\nwith {}", version, engine_version()),
                        "Print the version and exit");
  app_.require_subcommand(1);
  app_.footer(footer({"check notes/rigid-bodies.md --sidecar notes/physics.rigor"}));
  add_check(*this);
  add_replay(*this);
  add_eval(*this);
  add_bench(*this);
  add_scene(*this);
  add_derive(*this);
  add_explain(*this);
  add_read(*this);
  add_suggest(*this);
  add_report(*this);
  add_cases(*this);
  add_case(*this);
  add_help(*this);
  add_manual(*this);
  add_completion(*this);
}

CLI::App& Grammar::command(const char* name, const char* what, const std::vector<std::string>& examples,
                           std::function<CommandLine()> line) {
  CLI::App* words = app_.add_subcommand(name, what);
  words->footer(footer(examples));
  commands_.push_back({words, examples, std::move(line)});
  return *words;
}

std::string Grammar::given() const {
  for (const Command& command : commands_) {
    if (command.words->parsed()) return command.words->get_name();
  }
  return "check";
}

CommandLine Grammar::line() const {
  const auto parsed =
      std::ranges::find_if(commands_, [](const Command& command) { return command.words->parsed(); });
  return parsed->line();  // one of them is required
}

std::vector<std::string> Grammar::names() const {
  std::vector<std::string> names;
  for (const Command& command : commands_) names.push_back(command.words->get_name());
  return names;
}

bool Grammar::has(const std::string& name) const {
  const std::vector<std::string> all = names();
  return is_one_of(name, all);
}

void add_sidecar(CLI::App& to, std::optional<std::string>& sidecar) {
  to.add_option_function<std::string>(
        "--sidecar", [&sidecar](const std::string& path) { sidecar = path; },
        "Directives for the notes (default: NAME.rigor, if it exists)")
      ->type_name("FILE");
}

void add_color(CLI::App& to, ColorWhen& color) {
  to.add_option_function<std::string>(
        "--color",
        [&color](const std::string& word) {
          color = word == "always"  ? ColorWhen::always
                  : word == "never" ? ColorWhen::never
                                    : ColorWhen::automatic;
        },
        "`auto`, `always` or `never`")
      ->type_name("WHEN")
      ->check(one_of("colour setting", {"auto", "always", "never"}));
}

CLI::Validator one_of(std::string what, std::vector<std::string> names) {
  std::string joined = fmt::format("{}", fmt::join(names, std::string(1, choice_separator)));
  const auto complain = [what = std::move(what), names = std::move(names)](const std::string& word) {
    if (is_one_of(word, names)) return std::string();
    return fmt::format("unknown {} `{}`; known: {}", what, word, fmt::join(names, ", "));
  };
  return CLI::Validator(complain, "", std::move(joined));
}

CommandLine usage_error(std::string reason, std::string_view command) {
  if (reason.starts_with("A ") || reason.starts_with("The ")) reason[0] += 'a' - 'A';
  return {.text = fmt::format("rigor: {}\nTry `rigor {} --help`.\n", reason, command),
          .code = ExitCode::usage};
}

}  // namespace rigor
