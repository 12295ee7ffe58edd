// SPDX-License-Identifier: GPL-3.0-or-later
// A report as SARIF 2.1.0 (OASIS), which code hosts and editors show at the lines: a rule for each kind of
// diagnostic, a result for each diagnostic, with a fix where the text that a true statement replaces is
// known. What the notes themselves excuse (`expect`, `allow`) is there, suppressed. `docs/formats.md`
// describes it.
#pragma once

#include <string>

#include "report/wording/check_format.h"
#include "source/source_map.h"

namespace rigor {

/// UTF-8 whatever the notes hold; the same bytes for the same report. Columns count code points.
[[nodiscard]] std::string to_sarif(const Report& report, const SourceMap& sources,
                                   const CheckFormat& options);

}  // namespace rigor
