// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/debug.h"
#include "app/exit_code.h"

namespace rigor {

enum class ColorWhen : std::uint8_t { automatic, always, never };

enum class ReportFormat : std::uint8_t { text, json, junit, sarif, github };

/// `rigor check`: at least one file; a sidecar and marks only with exactly one.
struct CheckCommand {
  std::vector<std::string> files;
  std::optional<std::string> sidecar;
  ReportFormat format = ReportFormat::text;
  bool strict = false;
  bool dimensions = false;
  std::size_t jobs = 1;              // 0: as many as there are processors
  std::optional<std::string> cache;  // a folder
  std::optional<std::string> marks;  // a file for `rigor.sty`
  ColorWhen color = ColorWhen::automatic;
  std::vector<DebugTopic> debug;
};

/// `rigor replay`: a report made by `rigor check --json`.
struct ReplayCommand {
  std::string report;
  ColorWhen color = ColorWhen::automatic;
};

/// Which of the forms in one file of notes are evaluated, and on what.
struct FormsCommand {
  std::string file;
  std::vector<std::string> bodies;  // names in a `bodies` folder, files, or folders of body files
  std::vector<std::string> places;  // tags or headings; empty: all chains
  std::optional<std::string> sidecar;
  ColorWhen color = ColorWhen::automatic;
};

/// `rigor eval`: value, error, condition and time of each form.
struct EvalCommand {
  FormsCommand forms;
  bool json = false;
  bool times = true;
};

/// `rigor bench`: time against error of all forms in all precisions.
struct BenchCommand {
  FormsCommand forms;
  std::string folder;  // for the pictures and the table; empty: the table goes to the output
};

/// `rigor scene`: the quantities that a scene asks of a body.
struct SceneCommand {
  std::vector<std::string> files;
  bool json = false;
  bool explain = false;
  ColorWhen color = ColorWhen::automatic;
};

/// Either a command, or a text to print and the code to end with: `--help`, `--version`, or what is wrong.
struct CommandLine {
  std::optional<CheckCommand> check = {};
  std::optional<ReplayCommand> replay = {};
  std::optional<EvalCommand> eval = {};
  std::optional<BenchCommand> bench = {};
  std::optional<SceneCommand> scene = {};
  std::string text = {};
  ExitCode code = ExitCode::ok;
};

[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace rigor
