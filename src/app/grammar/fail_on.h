// SPDX-License-Identifier: GPL-3.0-or-later
// The list behind `--fail-on` and in a settings file: `refuted,suspect,open`.
#pragma once

#include <set>
#include <string_view>

#include "base/result.h"
#include "source/diagnostic.h"

namespace rigor {

/// `open` is `undecided,not-understood`. An error names the word that is not known, and the nearest.
[[nodiscard]] Result<std::set<Severity>> read_fail_on(std::string_view list);

}  // namespace rigor
