// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include "app/host/outputs.h"
#include "app/host/processes.h"
#include "app/host/program_identity.h"
#include "app/host/progress.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "check/entry/check.h"
#include "check/question/decision_cache.h"
#include "report/data/github.h"
#include "report/data/json.h"
#include "report/data/junit.h"
#include "report/data/report_archive.h"
#include "report/data/sarif.h"
#include "report/page/marks.h"
#include "report/text/terminal.h"
#include "source/write_file.h"

namespace rigor {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// One file, with what is remembered of it.
FileReport check_one(const CheckCommand& command, const std::string& path, SourceMap& sources,
                     const ReportProgress& progress) {
  std::optional<DecisionCache> cache;
  if (command.cache) cache.emplace(*command.cache, path, program_identity());
  // Other formats than text offer repairs of what is expected to be wrong, too.
  const bool for_people = command.format == ReportFormat::text || command.format == ReportFormat::github;
  const CheckOptions options{.sidecar = command.sidecar,
                             .progress = progress,
                             .repairs = for_people ? Repairs::of_unexpected : Repairs::of_all,
                             .cache = cache ? &*cache : nullptr,
                             .effort = command.effort};
  FileReport report = check_file(sources, path, options);
  if (cache) {
    cache->save();
    report.cache = cache->use();
  }
  return report;
}

std::vector<FileReport> check_in_processes(const CheckCommand& command, std::size_t jobs, SourceMap& sources,
                                           Progress& progress) {
  const Pieces pieces{.count = command.files.size(),
                      .work =
                          [&](std::size_t piece, const ReportProgress& tell) {
                            SourceMap own;
                            return pack(check_one(command, command.files[piece], own, tell), own);
                          },
                      .progress = [&](std::size_t piece, std::size_t done,
                                      std::size_t all) { progress.update(command.files[piece], done, all); }};
  std::vector<FileReport> files;
  for (const Result<std::string>& answer : in_processes(pieces, jobs)) {
    const std::string& path = command.files[files.size()];
    std::optional<FileReport> report;
    if (answer) report = unpack(*answer, sources);
    if (!report) {
      report.emplace();
      report->path = path;
      report->file = sources.add(path, "");
      report->failure = answer ? "its process gave an answer that cannot be read" : answer.error().reason;
    }
    files.push_back(*std::move(report));
  }
  return files;
}

/// Every file, with the counts of all.
Report check_all(const CheckCommand& command, SourceMap& sources, std::ostream& err) {
  const auto start = SteadyClock::now();
  Progress progress(err, screen_of(err).is_terminal);
  Report report;
  const std::size_t asked = command.jobs == 0 ? processor_count() : command.jobs;
  const std::size_t jobs = std::min(asked, command.files.size());
  if (jobs > 1) {
    report.files = check_in_processes(command, jobs, sources, progress);
  } else {
    for (const std::string& path : command.files) {
      const auto tell = [&](std::size_t done, std::size_t all) { progress.update(path, done, all); };
      report.files.push_back(check_one(command, path, sources, tell));
    }
  }
  for (const FileReport& file : report.files)
    for (std::size_t i = 0; i < verdict_count; ++i) report.counts[i] += file.counts[i];
  report.milliseconds = std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
  return report;
}

std::string printed(const CheckCommand& command, const Report& report, const SourceMap& sources,
                    const std::ostream& out) {
  std::error_code none;
  const CheckFormat format{command.strict, std::filesystem::current_path(none).generic_string()};
  TerminalOptions options = terminal_options(command.color, out);
  options.dimensions = command.dimensions;
  switch (command.format) {
    case ReportFormat::text:
      return print_report(report, sources, options);
    case ReportFormat::json:
      return to_json(report, sources);
    case ReportFormat::junit:
      return to_junit(report, sources, format);
    case ReportFormat::sarif:
      return to_sarif(report, sources, format);
    case ReportFormat::github:
      return to_github(report, sources, format);
  }
  return "";
}

/// Marks of one file that was checked to its end; what was read is not overwritten.
ExitCode write_marks(const std::string& path, const FileReport& file, const SourceMap& sources,
                     std::ostream& err) {
  if (file.unreadable || !file.failure.empty()) return ExitCode::ok;
  if (overwritten_by(path, sources)) {
    err << fmt::format("rigor: `{}` is read here, and is not overwritten with marks\n", printable(path));
    return ExitCode::usage;
  }
  const auto written = write_file(path, to_marks(file, sources));
  if (written) return ExitCode::ok;
  err << fmt::format("rigor: `{}` cannot be written: {}\n", printable(path), written.error().reason);
  return ExitCode::no_input;
}

void tell_failures(const Report& report, std::ostream& err) {
  for (const FileReport& file : report.files) {
    if (!file.failure.empty())
      err << fmt::format("rigor: internal error: {}: {}\n", printable(file.path), printable(file.failure));
    if (file.cache && !file.cache->trouble.empty())
      err << fmt::format("rigor: warning: {}\n", printable(file.cache->trouble));
  }
}

}  // namespace

ExitCode check_notes(const CheckCommand& command, std::ostream& out, std::ostream& err) {
  SourceMap sources;
  const Report report = check_all(command, sources, err);
  for (const DebugTopic topic : command.debug)
    for (const FileReport& file : report.files) err << print_debug(topic, file, sources);
  tell_failures(report, err);
  ExitCode code = exit_code(report, command.strict);
  if (command.marks) {
    const ExitCode written = write_marks(*command.marks, report.files.front(), sources, err);
    if (written != ExitCode::ok && code != ExitCode::internal) code = written;
  }
  out << printed(command, report, sources, out);
  return code;
}

}  // namespace rigor
