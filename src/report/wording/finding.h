// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnostic amounts to where a program runs the checks, and all that is said of it, as plain text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "check/step/failure_rule.h"
#include "report/wording/diagnostics_of.h"
#include "source/source_map.h"

namespace rigor {

/// As `tally` weighs it: wrong makes the exit code 1, open 2, the others 0. Known: an earlier report has it.
enum class Weight : std::uint8_t { wrong, open, warning, expected, known };

[[nodiscard]] Weight weight_of(const PlacedDiagnostic& placed, const FailureRule& rule);

/// `notes.tex:12:28`
[[nodiscard]] std::string place_text(Span span, const SourceMap& sources);

/// After the message, a line each: notes at other places, help, the sample, the nearest true statements,
/// conditions. Every line ends with a line break.
[[nodiscard]] std::string details_of(const PlacedDiagnostic& placed, const SourceMap& sources);

/// Before the first of the repairs: `true is` of what is wrong, `near it` of what is left open.
[[nodiscard]] std::string_view heading_of_repairs(const Step& step);
/// What was changed, and near an open step what the statement follows from.
[[nodiscard]] std::string remark_on(const Repair& repair);

/// A path as seen from a folder, if it is inside it; else as it is. Nothing is asked of the file system.
[[nodiscard]] std::string path_from(const std::string& path, const std::string& folder);

}  // namespace rigor
