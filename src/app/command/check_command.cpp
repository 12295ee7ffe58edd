// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include "algebra/engine/budget.h"
#include "app/host/notes_to_check.h"
#include "app/host/outputs.h"
#include "app/host/program_identity.h"
#include "app/host/progress.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "check/entry/check.h"
#include "check/question/decision_cache.h"
#include "report/data/baseline.h"
#include "report/data/github.h"
#include "report/data/json.h"
#include "report/data/junit.h"
#include "report/data/report_archive.h"
#include "report/data/sarif.h"
#include "report/page/marks.h"
#include "report/text/terminal.h"
#include "source/processes.h"
#include "source/read_file.h"
#include "source/render.h"
#include "source/write_file.h"

namespace rigor {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// What the command line asks for, with the settings where it says nothing.
struct CheckRun {
  const CheckCommand& command;
  NotesToCheck notes;
  std::size_t jobs = 1;  // processes at once; 0: one for each processor
  std::uint64_t effort = default_effort;
};

/// What readers of the format are shown.
Repairs repairs_shown(ReportFormat format) {
  switch (format) {
    case ReportFormat::text:
    case ReportFormat::github:
      return Repairs::of_unexpected;
    case ReportFormat::json:
      return Repairs::and_of_laws;
    default:
      return Repairs::of_all;
  }
}

/// One file, with what is remembered of it.
FileReport check_one(const CheckRun& run, const NotesToCheck::Item& notes, SourceMap& sources,
                     std::size_t processes, const ReportProgress& progress) {
  const CheckCommand& command = run.command;
  std::optional<DecisionCache> cache;
  if (command.cache) cache.emplace(*command.cache, notes.path, program_identity());
  const CheckOptions options{.sidecar = notes.sidecar,
                             .progress = progress,
                             .repairs = repairs_shown(command.format),
                             .cache = cache ? &*cache : nullptr,
                             .effort = run.effort,
                             .processes = cache ? 1 : processes};  // other processes would remember nothing
  FileReport report = notes.text ? check_text(sources, notes.path, *notes.text, options)
                                 : check_file(sources, notes.path, options);
  if (cache) {
    cache->save();
    report.cache = cache->use();
  }
  return report;
}

std::vector<FileReport> check_in_processes(const CheckRun& run, std::size_t jobs, std::size_t in_each,
                                           SourceMap& sources, Progress& progress) {
  const auto& items = run.notes.items;
  const Pieces pieces{.count = items.size(),
                      .work =
                          [&](std::size_t piece, const ReportProgress& tell) {
                            SourceMap own;
                            return pack(check_one(run, items[piece], own, in_each, tell), own);
                          },
                      .progress = [&](std::size_t piece, std::size_t done,
                                      std::size_t all) { progress.update(items[piece].path, done, all); }};
  std::vector<FileReport> files;
  for (const Result<std::string>& answer : in_processes(pieces, jobs)) {
    const std::string& path = items[files.size()].path;
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
Report check_all(const CheckRun& run, SourceMap& sources, std::ostream& err) {
  const auto start = SteadyClock::now();
  Progress progress(err, screen_of(err).is_terminal);
  Report report;
  const std::size_t asked = run.jobs == 0 ? processor_count() : run.jobs;
  const std::size_t jobs = std::min(asked, run.notes.items.size());
  const std::size_t in_each = jobs == 0 ? asked : asked / jobs;
  if (jobs > 1) {
    report.files = check_in_processes(run, jobs, in_each, sources, progress);
  } else {
    for (const NotesToCheck::Item& notes : run.notes.items) {
      const auto tell = [&](std::size_t done, std::size_t all) { progress.update(notes.path, done, all); };
      report.files.push_back(check_one(run, notes, sources, in_each, tell));
    }
  }
  for (const FileReport& file : report.files)
    for (std::size_t i = 0; i < verdict_count; ++i) report.counts[i] += file.counts[i];
  report.milliseconds = std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
  return report;
}

std::string printed(const CheckCommand& command, const Report& report, const SourceMap& sources,
                    const FailureRule& rule, const std::ostream& out) {
  std::error_code none;
  const CheckFormat format{rule, std::filesystem::current_path(none).generic_string()};
  TerminalOptions options = terminal_options(command.color, out);
  options.dimensions = command.dimensions;
  options.all_causes = command.all_causes;
  options.known = &rule.known;
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

/// What is no part of the report: what was passed over, and why.
std::vector<std::string> remarks_of(const CheckRun& run, const FailureRule& rule) {
  std::vector<std::string> remarks = run.notes.remarks;
  if (!run.command.baseline) return remarks;
  remarks.push_back(fmt::format("passed over since {} has them: {} verdict{}, {} diagnostic{}",
                                printable(*run.command.baseline), rule.known.steps.size(),
                                rule.known.steps.size() == 1 ? "" : "s", rule.known.diagnostics.size(),
                                rule.known.diagnostics.size() == 1 ? "" : "s"));
  return remarks;
}

/// Nothing, with its reason on the error stream, where the settings cannot be used.
std::optional<Settings> settings_for(const CheckCommand& command, std::ostream& err) {
  std::error_code none;
  if (!command.settings && !std::filesystem::exists(settings_name, none)) return Settings();
  SourceMap sources;
  Diagnostics diagnostics;
  Settings settings = read_settings(command.settings.value_or(settings_name), sources, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics) err << render(diagnostic, sources);
  return diagnostics.empty() ? std::optional(std::move(settings)) : std::nullopt;
}

/// What the command line says comes before what the settings say.
FailureRule rule_for(const CheckCommand& command, const Settings& settings) {
  const bool command_says = command.strict || command.fail_on;
  const auto& fail_on = command_says ? command.fail_on : settings.fail_on;
  if (fail_on) return {.wrong = *fail_on, .open = {}};
  return usual_rule(command.strict.value_or(settings.strict.value_or(false)));
}

ExitCode usage_fault(const std::string& reason, std::ostream& err) {
  const CommandLine line = usage_error(reason, "check");
  err << line.text;
  return line.code;
}

ExitCode input_fault(const std::string& reason, std::ostream& err) {
  err << fmt::format("rigor: {}\n", reason);
  return ExitCode::no_input;
}

Result<Baseline> baseline_of(const CheckCommand& command) {
  if (!command.baseline) return Baseline();
  return read_file(*command.baseline).and_then(read_baseline).map_error([&](const Error& error) {
    return Error{fmt::format("{}: {}", printable(*command.baseline), error.reason)};
  });
}

/// All that is read before anything is checked.
struct CheckPlan {
  CheckRun run;
  FailureRule rule;
  Baseline baseline;
};

/// An error: the code to end with; its reason is on the error stream.
tl::expected<CheckPlan, ExitCode> plan_check(const CheckCommand& command, std::istream& in,
                                             std::ostream& err) {
  const auto fail = [](ExitCode code) { return tl::make_unexpected(code); };
  const auto settings = settings_for(command, err);
  if (!settings) return fail(ExitCode::usage);
  auto notes = notes_to_check(command, *settings, in);
  if (!notes) return fail(input_fault(notes.error().reason, err));
  const std::size_t count = notes->items.size();
  if (count == 0) return fail(usage_fault("FILE is required", err));
  const char* const of_one = command.sidecar ? "--sidecar" : command.marks ? "--marks" : nullptr;
  if (of_one != nullptr && count > 1)
    return fail(usage_fault(fmt::format("`{}` belongs to one file, and there are {}", of_one, count), err));
  auto baseline = baseline_of(command);
  if (!baseline) return fail(input_fault(baseline.error().reason, err));
  return CheckPlan{{.command = command,
                    .notes = std::move(*notes),
                    .jobs = command.jobs.value_or(settings->jobs.value_or(1)),
                    .effort = command.effort.value_or(settings->effort.value_or(default_effort))},
                   rule_for(command, *settings),
                   std::move(*baseline)};
}

}  // namespace

ExitCode check_notes(const CheckCommand& command, std::istream& in, std::ostream& out, std::ostream& err) {
  auto plan = plan_check(command, in, err);
  if (!plan) return plan.error();
  SourceMap sources;
  const Report report = check_all(plan->run, sources, err);
  FailureRule& rule = plan->rule;
  rule.known = known_findings(report, sources, std::move(plan->baseline));
  for (const DebugTopic topic : command.debug)
    for (const FileReport& file : report.files) err << print_debug(topic, file, sources);
  tell_failures(report, err);
  ExitCode code = exit_code(report, rule);
  if (command.marks) {
    const ExitCode written = write_marks(*command.marks, report.files.front(), sources, err);
    if (written != ExitCode::ok && code != ExitCode::internal) code = written;
  }
  out << printed(command, report, sources, rule, out);
  const bool for_people = command.format == ReportFormat::text || command.format == ReportFormat::github;
  for (const std::string& remark : remarks_of(plan->run, rule)) (for_people ? out : err) << remark << "\n";
  return code;
}

}  // namespace rigor
