// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run.h"

#include <chrono>
#include <exception>

#include "app/cases.h"
#include "app/command_line.h"
#include "app/derive.h"
#include "app/explain.h"
#include "app/forms.h"
#include "app/progress.h"
#include "app/replay.h"
#include "app/report.h"
#include "app/scene.h"
#include "app/screen.h"
#include "base/check.h"
#include "check/check.h"
#include "report/json.h"
#include "report/terminal.h"

namespace rigor {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// Every file in its turn, with the counts of all.
Report check_all(const CheckCommand& command, SourceMap& sources, std::ostream& err) {
  const auto start = SteadyClock::now();
  Progress progress(err, screen_of(err).is_terminal);
  Report report;
  for (const std::string& path : command.files) {
    const CheckOptions options{
        .sidecar = command.sidecar,
        .progress = [&](std::size_t done, std::size_t all) { progress.update(path, done, all); },
        .repairs = command.json ? Repairs::of_all : Repairs::of_unexpected};
    report.files.push_back(check_file(sources, path, options));
    const Counts& counts = report.files.back().counts;
    for (std::size_t i = 0; i < verdict_count; ++i) report.counts[i] += counts[i];
  }
  report.milliseconds = std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
  return report;
}

/// A code, unless what belongs to it could not be written.
int written(ExitCode code, std::ostream& out, std::ostream& err) {
  if (out.flush()) return number_of(code);
  err << "rigor: the report could not be written\n";
  return number_of(ExitCode::internal);
}

int check(const CheckCommand& command, std::ostream& out, std::ostream& err) {
  SourceMap sources;
  const Report report = check_all(command, sources, err);
  for (const DebugTopic topic : command.debug)
    for (const FileReport& file : report.files) err << print_debug(topic, file, sources);
  TerminalOptions options = terminal_options(command.color, out);
  options.dimensions = command.dimensions;
  out << (command.json ? to_json(report, sources) : print_report(report, sources, options));
  return written(exit_code(report, command.strict), out, err);
}

}  // namespace

int run_guarded(std::ostream& err, const std::function<int()>& work) {
  try {
    return work();
  } catch (const InternalError& error) {
    err << "rigor: internal error: " << error.what() << "\n";
  } catch (const std::exception& error) {
    err << "rigor: unexpected error: " << error.what() << "\n";
  } catch (...) {
    err << "rigor: unexpected error\n";
  }
  return number_of(ExitCode::internal);
}

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  return run_guarded(err, [&] {
    const CommandLine line = parse_command_line(argc, argv);
    if (line.check) return check(*line.check, out, err);
    if (line.replay) return written(replay(*line.replay, out, err), out, err);
    if (line.eval) return written(evaluate_forms(*line.eval, out, err), out, err);
    if (line.report) return written(write_reports(*line.report, out, err), out, err);
    if (line.scene) return written(compute_scenes(*line.scene, out, err), out, err);
    if (line.derive) return written(derive_holes(*line.derive, out, err), out, err);
    if (line.explain) return written(explain_chains(*line.explain, out, err), out, err);
    if (line.bench) return written(bench_forms(*line.bench, out, err), out, err);
    if (line.cases) return written(write_cases(*line.cases, out, err), out, err);
    if (line.one_case) return written(tell_case(*line.one_case, out, err), out, err);
    (line.code == ExitCode::ok ? out : err) << line.text;
    return number_of(line.code);
  });
}

}  // namespace rigor
