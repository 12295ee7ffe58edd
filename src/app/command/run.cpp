// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/run.h"

#include <exception>

#include "app/command/commands.h"
#include "app/command/scene.h"
#include "app/grammar/command_line.h"
#include "app/hole/derive.h"
#include "base/check.h"

namespace rigor {
namespace {

/// A code, unless what belongs to it could not be written: the output is full or closed.
int written(ExitCode code, std::ostream& out, std::ostream& err) {
  if (out.flush()) return number_of(code);
  err << "rigor: the standard output cannot be written\n";
  return number_of(ExitCode::no_input);
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

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err, std::istream& in) {
  return run_guarded(err, [&] {
    const CommandLine line = parse_command_line(argc, argv);
    if (line.check) return written(check_notes(*line.check, in, out, err), out, err);
    if (line.replay) return written(replay(*line.replay, out, err), out, err);
    if (line.eval) return written(evaluate_forms(*line.eval, out, err), out, err);
    if (line.report) return written(write_reports(*line.report, out, err), out, err);
    if (line.scene) return written(compute_scenes(*line.scene, out, err), out, err);
    if (line.derive) return written(derive_holes(*line.derive, out, err), out, err);
    if (line.explain) return written(explain_chains(*line.explain, out, err), out, err);
    if (line.read) return written(show_reading(*line.read, out, err), out, err);
    if (line.suggest) return written(suggest_lines(*line.suggest, out, err), out, err);
    if (line.bench) return written(bench_forms(*line.bench, out, err), out, err);
    if (line.cases) return written(write_cases(*line.cases, out, err), out, err);
    if (line.one_case) return written(tell_case(*line.one_case, out, err), out, err);
    (line.code == ExitCode::ok ? out : err) << line.text;
    return written(line.code, out, err);
  });
}

}  // namespace rigor
