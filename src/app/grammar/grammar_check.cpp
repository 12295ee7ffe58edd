// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>

#include "app/grammar/grammar.h"

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

struct FormatName {
  ReportFormat format;
  const char* name;
};
constexpr FormatName format_names[] = {{ReportFormat::text, "text"},
                                       {ReportFormat::json, "json"},
                                       {ReportFormat::junit, "junit"},
                                       {ReportFormat::sarif, "sarif"},
                                       {ReportFormat::github, "github"}};

std::vector<std::string> names_of_formats() {
  std::vector<std::string> names;
  for (const FormatName& entry : format_names) names.emplace_back(entry.name);
  return names;
}

ReportFormat format_of_name(const std::string& name) {
  return std::ranges::find_if(format_names, [&](const FormatName& entry) { return entry.name == name; })
      ->format;
}

/// Reads a number of processes; returns what is wrong with it, if anything is.
std::string jobs_from(const std::string& word, std::size_t& jobs) {
  constexpr std::size_t most = 1024;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), jobs);
  if (read.ec == std::errc() && read.ptr == word.data() + word.size() && jobs <= most) return "";
  return fmt::format("`--jobs` is a number from 0 to {}, not `{}`", most, word);
}

/// Reads units of work; returns what is wrong with them, if anything is.
std::string effort_from(const std::string& word, std::uint64_t& effort) {
  constexpr std::uint64_t most = 1'000'000'000'000;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), effort);
  const bool whole = read.ec == std::errc() && read.ptr == word.data() + word.size();
  if (whole && effort >= 1 && effort <= most) return "";
  return fmt::format("`--effort` is a number of units from 1 to {}, not `{}`", most, word);
}

DebugTopic topic_of(const std::string& name) {
  const auto table = debug_topic_table();
  return std::ranges::find(table, name, &DebugTopicInfo::name)->topic;
}

void add_path(CLI::App& to, const char* name, std::optional<std::string>& path, const char* type,
              const char* what) {
  to.add_option_function<std::string>(
        name, [&path](const std::string& given) { path = given; }, what)
      ->type_name(type);
}

}  // namespace

void add_check(Grammar& grammar) {
  struct Words {
    CheckCommand command;
    std::vector<std::string> topics;
    std::optional<std::string> format;
    bool json = false;
    std::string jobs = "1";
    std::string effort = std::to_string(default_effort);
  };
  const auto words = std::make_shared<Words>();
  CLI::App& app = grammar.command(
      "check", "Check every displayed equation of some notes",
      {"check notes/rigid-bodies.md --sidecar notes/physics.rigor",
       "check --format junit --jobs 0 --cache .rigor-cache notes/*.tex > results.xml",
       "check notes.tex --marks notes.verdicts"},
      [words]() -> CommandLine {
        CheckCommand& command = words->command;
        if (command.sidecar && command.files.size() > 1)
          return usage_error(
              fmt::format("`--sidecar` belongs to one file, and {} are given", command.files.size()),
              "check");
        if (command.marks && command.files.size() > 1)
          return usage_error(
              fmt::format("`--marks` belongs to one file, and {} are given", command.files.size()), "check");
        if (words->json && words->format.value_or("json") != "json")
          return usage_error(
              fmt::format("`--json` is `--format json`, but `--format {}` is given", *words->format),
              "check");
        command.format = format_of_name(words->json ? "json" : words->format.value_or("text"));
        if (const std::string wrong = jobs_from(words->jobs, command.jobs); !wrong.empty())
          return usage_error(wrong, "check");
        if (const std::string wrong = effort_from(words->effort, command.effort); !wrong.empty())
          return usage_error(wrong, "check");
        if (command.cache == "" || command.marks == "")
          return usage_error("`--cache` and `--marks` need a name", "check");
        for (const std::string& name : words->topics) command.debug.push_back(topic_of(name));
        return {.check = std::move(command)};
      });
  CheckCommand& check = words->command;
  app.add_option("FILE", check.files, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
  app.add_option_function<std::string>(
         "--format", [words](const std::string& name) { words->format = name; },
         "`text`, `json`, `junit`, `sarif` or `github`")
      ->type_name("FORMAT")
      ->check(one_of("format", names_of_formats()));
  app.add_flag("--json", words->json, "The same as `--format json`");
  add_sidecar(app, check.sidecar);
  app.add_flag("--strict", check.strict, "Count warnings as errors");
  app.add_flag("--dimensions", check.dimensions, "Print the dimension that was found for each symbol");
  app.add_option("--jobs,-j", words->jobs, "Check this many files at once; 0: one for each processor")
      ->type_name("N");
  app.add_option("--effort", words->effort,
                 fmt::format("Give up on a step after this many units of work ({})", default_effort))
      ->type_name("N");
  add_path(app, "--cache", check.cache, "FOLDER",
           "Remember decisions there, so that nothing is decided twice");
  add_path(app, "--marks", check.marks, "FILE", "Write what `rigor.sty` prints in the margin");
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
