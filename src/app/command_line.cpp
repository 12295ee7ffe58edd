// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <utility>

#include "base/version.h"

namespace rigor {
namespace {

std::string footer() {
  std::string text =
      "Example:\n"
      "  rigor check notes/rigid-bodies.md --sidecar notes/physics.rigor\n"
      "\n"
      "Exit codes:\n";
  for (const ExitCodeInfo& entry : exit_code_table())
    text += fmt::format("  {:>2}  {}\n", number_of(entry.code), entry.meaning);
  text.pop_back();
  return text;
}

std::vector<std::string> topic_names() {
  std::vector<std::string> names;
  for (const DebugTopicInfo& entry : debug_topic_table()) names.emplace_back(entry.name);
  return names;
}

std::string describe_topics() {
  std::string text = "Print to the error stream:";
  for (const DebugTopicInfo& entry : debug_topic_table())
    text += fmt::format("{} `{}` ({})", &entry == debug_topic_table().data() ? "" : ",", entry.name,
                        entry.meaning);
  return text;
}

CLI::Validator one_of(std::string what, std::vector<std::string> names) {
  const auto complain = [what, names](const std::string& word) {
    if (std::find(names.begin(), names.end(), word) != names.end()) return std::string();
    return fmt::format("unknown {} `{}`; known: {}", what, word, fmt::join(names, ", "));
  };
  return CLI::Validator(complain, "");
}

DebugTopic topic_of(const std::string& name) {
  const auto table = debug_topic_table();
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; })
      ->topic;
}

ColorWhen color_of(const std::string& word) {
  if (word == "always") return ColorWhen::always;
  return word == "never" ? ColorWhen::never : ColorWhen::automatic;
}

CommandLine usage_error(std::string reason, std::string_view command = "check") {
  if (reason.starts_with("A ") || reason.starts_with("The ")) reason[0] += 'a' - 'A';
  return {.text = fmt::format("rigor: {}\nTry `rigor {} --help`.\n", reason, command),
          .code = ExitCode::usage};
}

/// The command line's grammar and the words that were read.
struct Grammar {
  CLI::App app{"rigor checks the equations in physics notes.", "rigor"};
  CheckCommand command;
  ReplayCommand replay;
  std::string sidecar;
  std::string color = "auto";
  std::vector<std::string> topics;
  CLI::Option* sidecar_option = nullptr;
  CLI::App* replay_app = nullptr;

  Grammar() {
    app.set_version_flag("--version", fmt::format("rigor {}", version), "Print the version and exit");
    app.require_subcommand(1);
    app.footer(footer());
    CLI::App& check = *app.add_subcommand("check", "Check every displayed equation of some notes");
    check.footer(footer());
    check.add_option("FILE", command.files, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
    check.add_flag("--json", command.json, "Print one JSON object instead of text");
    sidecar_option = check.add_option("--sidecar", sidecar,
                                      "Directives beside the notes (default: NAME.rigor, if it exists)");
    sidecar_option->type_name("FILE");
    check.add_flag("--strict", command.strict, "Count warnings as errors");
    check.add_flag("--dimensions", command.dimensions, "Print what was found of each symbol's dimension");
    add_color(check);
    check.add_option("--debug", topics, describe_topics())
        ->type_name("TOPIC")
        ->allow_extra_args(false)
        ->check(one_of("topic", topic_names()));
    replay_app = app.add_subcommand("replay", "Put the samples of a report into the notes again");
    replay_app->footer(footer());
    replay_app->add_option("REPORT", replay.report, "What `rigor check --json` printed")
        ->required()
        ->type_name("");
    add_color(*replay_app);
  }

  void add_color(CLI::App& to) {
    to.add_option("--color", color, "`auto`, `always` or `never`")
        ->type_name("WHEN")
        ->check(one_of("colour setting", {"auto", "always", "never"}));
  }
};

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  if (const std::string_view first = argc > 1 ? argv[1] : "";
      !first.empty() && first[0] != '-' && first != "check" && first != "replay") {
    const std::string_view meant = first.starts_with('r') ? "replay" : "check";
    return usage_error(fmt::format("`{}` is no command; did you mean `{}`?", first, meant), meant);
  }
  Grammar grammar;
  try {
    grammar.app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    std::ostringstream text;
    grammar.app.exit(asked, text, text);
    return {.text = text.str()};
  } catch (const CLI::ParseError& error) {
    return usage_error(error.what(), grammar.replay_app->parsed() ? "replay" : "check");
  }
  if (grammar.replay_app->parsed()) {
    grammar.replay.color = color_of(grammar.color);
    return {.replay = std::move(grammar.replay)};
  }
  CheckCommand& command = grammar.command;
  if (grammar.sidecar_option->count() > 0) command.sidecar = grammar.sidecar;
  if (command.sidecar && command.files.size() > 1)
    return usage_error(
        fmt::format("`--sidecar` belongs to one file, and {} are given", command.files.size()));
  command.color = color_of(grammar.color);
  for (const std::string& name : grammar.topics) command.debug.push_back(topic_of(name));
  return {.check = std::move(command)};
}

}  // namespace rigor
