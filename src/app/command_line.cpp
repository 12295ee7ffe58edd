// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <utility>

#include "base/version.h"
#include "source/suggest.h"

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
  CheckCommand check;
  ReplayCommand replay;
  EvalCommand eval;
  BenchCommand bench;
  SceneCommand scene;
  std::string sidecar;
  std::string color = "auto";
  std::vector<std::string> topics;
  CLI::App* check_app = nullptr;
  CLI::App* replay_app = nullptr;
  CLI::App* eval_app = nullptr;
  CLI::App* bench_app = nullptr;
  CLI::App* scene_app = nullptr;

  Grammar() {
    app.set_version_flag("--version", fmt::format("rigor {}", version), "Print the version and exit");
    app.require_subcommand(1);
    app.footer(footer());
    add_check();
    replay_app = command("replay", "Put the samples of a report into the notes again");
    replay_app->add_option("REPORT", replay.report, "What `rigor check --json` printed")
        ->required()
        ->type_name("");
    add_color(*replay_app);
    eval_app = command("eval", "Evaluate every written form: value, error, condition, time");
    add_forms(*eval_app, eval.forms);
    eval_app->add_flag("--json", eval.json, "Print one JSON object instead of text");
    eval_app->add_flag("!--no-times", eval.times, "Measure no time, so that two runs print the same bytes");
    bench_app = command("bench", "Draw time against error for all forms of a chain in all precisions");
    add_forms(*bench_app, bench.forms);
    bench_app->add_option("--into", bench.folder, "Write the pictures and a table in Markdown into a folder")
        ->type_name("FOLDER");
    add_scene();
  }

  CLI::App* command(const char* name, const char* what) {
    CLI::App* made = app.add_subcommand(name, what);
    made->footer(footer());
    return made;
  }

  void add_check() {
    check_app = command("check", "Check every displayed equation of some notes");
    check_app->add_option("FILE", check.files, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
    check_app->add_flag("--json", check.json, "Print one JSON object instead of text");
    add_sidecar(*check_app);
    check_app->add_flag("--strict", check.strict, "Count warnings as errors");
    check_app->add_flag("--dimensions", check.dimensions, "Print what was found of each symbol's dimension");
    add_color(*check_app);
    check_app->add_option("--debug", topics, describe_topics())
        ->type_name("TOPIC")
        ->allow_extra_args(false)
        ->check(one_of("topic", topic_names()));
  }

  void add_forms(CLI::App& to, FormsCommand& forms) {
    to.add_option("FILE", forms.file, "Notes: LaTeX (.tex) or Markdown")->required()->type_name("");
    to.add_option("--body", forms.bodies,
                  "A sample body: its name, its file, or a folder of such files; may be repeated")
        ->type_name("NAME|FILE")
        ->allow_extra_args(false);
    to.add_option("--at", forms.places,
                  "Only the equations with this tag or in this section; may be repeated")
        ->type_name("TAG|HEADING")
        ->allow_extra_args(false);
    add_sidecar(to);
    add_color(to);
  }

  void add_scene() {
    scene_app = command("scene", "Compute the quantities that a scene asks of a body");
    scene_app->add_option("FILE", scene.files, "A scene in TOML")->required()->type_name("");
    scene_app->add_flag("--json", scene.json, "Print one JSON object instead of text");
    scene_app->add_flag("--explain", scene.explain,
                        "Say what was computed, what was not, and how long it took");
    add_color(*scene_app);
  }

  void add_sidecar(CLI::App& to) {
    to.add_option("--sidecar", sidecar, "Directives beside the notes (default: NAME.rigor, if it exists)")
        ->type_name("FILE");
  }

  void add_color(CLI::App& to) {
    to.add_option("--color", color, "`auto`, `always` or `never`")
        ->type_name("WHEN")
        ->check(one_of("colour setting", {"auto", "always", "never"}));
  }

  [[nodiscard]] std::optional<std::string> sidecar_of(const CLI::App& command) const {
    return command.count("--sidecar") > 0 ? std::optional(sidecar) : std::nullopt;
  }

  /// What was read, as a value.
  CommandLine line() {
    if (replay_app->parsed()) {
      replay.color = color_of(color);
      return {.replay = std::move(replay)};
    }
    if (scene_app->parsed()) {
      scene.color = color_of(color);
      return {.scene = std::move(scene)};
    }
    for (FormsCommand* forms : {&eval.forms, &bench.forms}) {
      forms->color = color_of(color);
      forms->sidecar = sidecar_of(forms == &eval.forms ? *eval_app : *bench_app);
    }
    if (eval_app->parsed()) return {.eval = std::move(eval)};
    if (bench_app->parsed()) return {.bench = std::move(bench)};
    check.sidecar = sidecar_of(*check_app);
    if (check.sidecar && check.files.size() > 1)
      return usage_error(
          fmt::format("`--sidecar` belongs to one file, and {} are given", check.files.size()));
    check.color = color_of(color);
    for (const std::string& name : topics) check.debug.push_back(topic_of(name));
    return {.check = std::move(check)};
  }

  [[nodiscard]] std::string command_given() const {
    for (const CLI::App* each : {replay_app, eval_app, bench_app, scene_app}) {
      if (each->parsed()) return each->get_name();
    }
    return "check";
  }
};

const std::vector<std::string>& command_names() {
  static const std::vector<std::string> names{"check", "replay", "eval", "bench", "scene"};
  return names;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  const auto& names = command_names();
  if (!first.empty() && first[0] != '-' && std::find(names.begin(), names.end(), first) == names.end()) {
    const std::string meant = suggest(first, names).value_or("check");
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
    return usage_error(error.what(), grammar.command_given());
  }
  return grammar.line();
}

}  // namespace rigor
