// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/exit_code.h"

#include <array>

namespace rigor {
namespace {

constexpr auto exit_codes = std::to_array<ExitCodeInfo>({
    {ExitCode::ok, "every claim is proved, or as expected; each hole is answered, each replay confirmed"},
    {ExitCode::wrong,
     "something is refuted, malformed or not confirmed; nothing fits a hole; a scene is wrong"},
    {ExitCode::open, "something is undecided, not understood or not answered, and nothing is wrong"},
    {ExitCode::usage, "the command line or a settings file is wrong"},
    {ExitCode::no_input, "a file is missing or unreadable, or cannot be written"},
    {ExitCode::internal, "an error of rigor itself"},
});

}  // namespace

std::span<const ExitCodeInfo> exit_code_table() { return exit_codes; }

ExitCode exit_code(const Report& report, const FailureRule& rule) {
  const Tally found = tally(report, rule);
  if (found.failed) return ExitCode::internal;
  if (found.unreadable) return ExitCode::no_input;
  if (found.wrong) return ExitCode::wrong;
  return found.open ? ExitCode::open : ExitCode::ok;
}

ExitCode exit_code(const ReplayTally& tally) {
  if (tally.unreadable) return ExitCode::no_input;
  return tally.malformed || tally.not_confirmed > 0 ? ExitCode::wrong : ExitCode::ok;
}

}  // namespace rigor
