// SPDX-License-Identifier: GPL-3.0-or-later
// What an earlier report found, so that only what is new fails.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"
#include "check/step/failure_rule.h"

namespace rigor {

/// How often each finding is there. A finding is known by its file, the text of its step, its verdict and the
/// kind of its diagnostic, not by its line.
struct Baseline {
  std::map<std::string, std::uint32_t> findings = {};
};

/// From what `rigor check --json` printed; never throws, whatever the text is.
[[nodiscard]] Result<Baseline> read_baseline(std::string_view json);

/// Of findings that are alike, as many as the earlier report has, the first ones.
[[nodiscard]] KnownFindings known_findings(const Report& report, const SourceMap& sources, Baseline baseline);

}  // namespace rigor
