// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>

#include "algebra/engine/budget.h"
#include "app/grammar/fail_on.h"
#include "app/grammar/grammar.h"
#include "app/grammar/limits.h"
#include "base/among.h"

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

/// Reads a whole number into `value`; returns what is wrong with the word, if anything is.
template <class Number>
std::string whole_from(const std::optional<std::string>& word, std::uint64_t least, std::uint64_t most,
                       std::string_view name, std::string_view what, std::optional<Number>& value) {
  if (!word) return "";
  Number number = 0;
  const auto read = std::from_chars(word->data(), word->data() + word->size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == word->data() + word->size();
  if (!whole || number < least || number > most)
    return fmt::format("`{}` is a number {}from {} to {}, not `{}`", name, what, least, most, *word);
  value = number;
  return "";
}

DebugTopic topic_of(const std::string& name) {
  const auto table = debug_topic_table();
  return std::ranges::find(table, name, &DebugTopicInfo::name)->topic;
}

void add_path(CLI::App& to, const char* name, std::optional<std::string>& path, const char* type,
              const std::string& what) {
  to.add_option_function<std::string>(
        name, [&path](const std::string& given) { path = given; }, what)
      ->type_name(type);
}

struct CheckWords {
  CheckCommand command;
  std::vector<std::string> topics;
  std::optional<std::string> format;
  bool json = false;
  std::optional<std::string> fail_on;
  std::optional<std::string> jobs;
  std::optional<std::string> effort;
};

/// What is wrong with the words as a whole, if anything is.
std::string fault_of(const CheckWords& words) {
  const CheckCommand& command = words.command;
  if (command.sidecar && command.files.size() > 1)
    return fmt::format("`--sidecar` belongs to one file, and {} are given", command.files.size());
  if (command.marks && command.files.size() > 1)
    return fmt::format("`--marks` belongs to one file, and {} are given", command.files.size());
  if (words.json && words.format.value_or("json") != "json")
    return fmt::format("`--json` is `--format json`, but `--format {}` is given", *words.format);
  if (command.cache == "" || command.marks == "") return "`--cache` and `--marks` need a name";
  if (command.strict && words.fail_on) return "`--strict` and `--fail-on` both say what fails";
  if (command.stdin_name && !is_one_of("-", command.files))
    return "`--stdin-name` belongs to `-`, which is not given";
  return "";
}

CommandLine check_line(CheckWords& words) {
  CheckCommand& command = words.command;
  if (const std::string wrong = fault_of(words); !wrong.empty()) return usage_error(wrong, "check");
  if (words.fail_on) {
    const auto read = read_fail_on(*words.fail_on);
    if (!read) return usage_error("--fail-on: " + read.error().reason, "check");
    command.fail_on = *read;
  }
  command.format = format_of_name(words.json ? "json" : words.format.value_or("text"));
  for (const std::string& wrong :
       {whole_from(words.jobs, 0, most_jobs, "--jobs", "", command.jobs),
        whole_from(words.effort, 1, most_effort, "--effort", "of units ", command.effort)})
    if (!wrong.empty()) return usage_error(wrong, "check");
  for (const std::string& name : words.topics) command.debug.push_back(topic_of(name));
  return {.check = std::move(command)};
}

}  // namespace

void add_check(Grammar& grammar) {
  const auto words = std::make_shared<CheckWords>();
  CLI::App& app =
      grammar.command("check", "Check every displayed equation of some notes",
                      {"check notes/rigid-bodies.md --sidecar notes/physics.rigor",
                       "check notes --fail-on refuted,suspect --baseline accepted.json",
                       "check --format junit --jobs 0 --cache .rigor-cache notes/*.tex > results.xml",
                       "check notes.tex --marks notes.verdicts"},
                      [words] { return check_line(*words); });
  CheckCommand& check = words->command;
  app.add_option("FILE", check.files,
                 "Notes: LaTeX (.tex) or Markdown; all notes below a folder; `-`: the standard input")
      ->type_name("");
  app.add_option_function<std::string>(
         "--format", [words](const std::string& name) { words->format = name; },
         "`text`, `json`, `junit`, `sarif` or `github`")
      ->type_name("FORMAT")
      ->check(one_of("format", names_of_formats()));
  app.add_flag("--json", words->json, "The same as `--format json`");
  add_sidecar(app, check.sidecar);
  add_path(app, "--stdin-name", check.stdin_name, "FILE",
           "Call the standard input so: the ending says what it is written in");
  add_path(app, "--settings", check.settings, "FILE",
           "What the command line leaves open (default: rigor.toml here, if it exists)");
  app.add_flag_callback(
      "--strict", [words] { words->command.strict = true; }, "Count warnings and suspects as errors");
  app.add_flag_callback(
      "--no-strict", [words] { words->command.strict = false; }, "Do not, whatever the settings say");
  add_path(app, "--fail-on", words->fail_on, "LIST",
           "End with 1 if one of these was found, else with 0: refuted, suspect, undecided, not-understood, "
           "open (both of these), error, warning");
  add_path(app, "--baseline", check.baseline, "FILE",
           "Pass over what this report of `check --json` has, too");
  app.add_flag("--dimensions", check.dimensions, "Print the dimension that was found for each symbol");
  app.add_flag("--all-causes", check.all_causes, "List each cause why something is open");
  add_path(app, "--jobs,-j", words->jobs, "N", "Use this many processes at once; 0: one for each processor");
  add_path(app, "--effort", words->effort, "N",
           fmt::format("Give up on a step after this many units of work ({})", default_effort));
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
