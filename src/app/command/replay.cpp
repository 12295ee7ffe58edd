// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <filesystem>
#include <string>

#include "app/host/screen.h"
#include "base/utf8.h"
#include "check/entry/check.h"
#include "report/data/read_recorded.h"
#include "report/text/replay_text.h"
#include "source/read_file.h"
#include "source/render.h"

namespace rigor {
namespace {

/// What to put before a path of the report so that it names a file here: nothing, or the report's folder.
std::string folder_of(const std::string& path, const std::string& report) {
  std::error_code error;
  const std::filesystem::path here(path);
  if (here.is_absolute() || std::filesystem::exists(here, error)) return "";
  const std::filesystem::path beside = std::filesystem::path(report).parent_path();
  return !beside.empty() && std::filesystem::exists(beside / here, error) ? beside.string() + "/" : "";
}

/// One of the notes: each of its refutations in the report's order.
void replay_notes(RecordedFile& recorded, const std::string& report_path, const TerminalOptions& options,
                  ReplayTally& tally, std::ostream& out) {
  const std::string folder = folder_of(recorded.path, report_path);
  for (RecordedStep& step : recorded.steps) step.file.insert(0, folder);
  CheckOptions check_options;
  check_options.recorded = &recorded.steps;
  check_options.repairs = Repairs::none;
  if (!recorded.sidecar.empty())
    check_options.sidecar = folder_of(recorded.sidecar, report_path) + recorded.sidecar;
  SourceMap sources;
  const FileReport notes = check_file(sources, folder + recorded.path, check_options);
  if (notes.unreadable) {
    tally.unreadable = true;
    tally.not_confirmed += recorded.steps.size();
    for (const Diagnostic& diagnostic : notes.diagnostics) out << render(diagnostic, sources);
    return;
  }
  for (const RecordedStep& step : recorded.steps) {
    ++(is_confirmed(step, notes) ? tally.confirmed : tally.not_confirmed);
    out << print_replay(step, notes, sources, options);
  }
}

}  // namespace

ExitCode replay(const ReplayCommand& command, std::ostream& out, std::ostream& err) {
  ReplayTally tally;
  const auto text = read_file(command.report);
  if (!text) {
    err << "rigor: " << printable(command.report) << ": " << text.error().reason << "\n";
    return ExitCode::no_input;
  }
  auto files = read_recorded(*text);
  if (!files) {
    err << "rigor: " << printable(command.report)
        << ": not a report of `rigor check --json`: " << printable(files.error().reason) << "\n";
    tally.malformed = true;
    return exit_code(tally);
  }
  const TerminalOptions options = terminal_options(command.color, out);
  for (RecordedFile& file : *files) replay_notes(file, command.report, options, tally, out);
  out << print_tally(tally) << "\n";
  return exit_code(tally);
}

}  // namespace rigor
