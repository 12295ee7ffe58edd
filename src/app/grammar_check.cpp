// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/grammar.h"

namespace rigor {
namespace {

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

DebugTopic topic_of(const std::string& name) {
  const auto table = debug_topic_table();
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; })
      ->topic;
}

}  // namespace

void add_check(Grammar& grammar) {
  struct Words {
    CheckCommand command;
    std::vector<std::string> topics;
  };
  const auto words = std::make_shared<Words>();
  CLI::App& app = grammar.command(
      "check", "Check every displayed equation of some notes",
      {"check notes/rigid-bodies.md --sidecar notes/physics.rigor"}, [words]() -> CommandLine {
        CheckCommand& command = words->command;
        if (command.sidecar && command.files.size() > 1)
          return usage_error(
              fmt::format("`--sidecar` belongs to one file, and {} are given", command.files.size()),
              "check");
        for (const std::string& name : words->topics) command.debug.push_back(topic_of(name));
        return {.check = std::move(command)};
      });
  CheckCommand& check = words->command;
  app.add_option("FILE", check.files, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  app.add_flag("--json", check.json, "Print one JSON object instead of text");
  add_sidecar(app, check.sidecar);
  app.add_flag("--strict", check.strict, "Count warnings as errors");
  app.add_flag("--dimensions", check.dimensions, "Print what was found of each symbol's dimension");
  add_color(app, check.color);
  app.add_option("--debug", words->topics, describe_topics())
      ->type_name("TOPIC")
      ->allow_extra_args(false)
      ->check(one_of("topic", topic_names()));
}

void add_replay(Grammar& grammar) {
  const auto replay = std::make_shared<ReplayCommand>();
  CLI::App& app = grammar.command("replay", "Put the samples of a report into the notes again",
                                  {"check notes.tex --json > report.json", "replay report.json"},
                                  [replay]() -> CommandLine { return {.replay = std::move(*replay)}; });
  app.add_option("REPORT", replay->report, "What `rigor check --json` printed")->required()->type_name("");
  add_color(app, replay->color);
}

}  // namespace rigor
