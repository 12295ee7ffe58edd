// SPDX-License-Identifier: GPL-3.0-or-later
// How the program ends. 64, 66 and 70 are the numbers of <sysexits.h>.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "check/step/failure_rule.h"
#include "report/text/replay_text.h"

namespace rigor {

enum class ExitCode : std::uint8_t {
  ok = 0,
  wrong = 1,
  open = 2,
  usage = 64,
  no_input = 66,
  internal = 70,
};

struct ExitCodeInfo {
  ExitCode code;
  std::string_view meaning;
};

/// One entry for each code: what `rigor --help` prints.
[[nodiscard]] std::span<const ExitCodeInfo> exit_code_table();

[[nodiscard]] constexpr int number_of(ExitCode code) { return static_cast<int>(code); }

/// An error of our own comes before an unreadable file, that before something wrong, that before something
/// open.
[[nodiscard]] ExitCode exit_code(const Report& report, const FailureRule& rule);
/// The same order; a report that refutes nothing is confirmed.
[[nodiscard]] ExitCode exit_code(const ReplayTally& tally);

}  // namespace rigor
