// SPDX-License-Identifier: GPL-3.0-or-later
// The names after `allow` and `warn`: `bold-index, idle-sum: why`, `here bold-index`.
#pragma once

#include "check/directive/directive.h"

namespace rigor {

/// Fills in `warnings` and `here`; false, with a diagnostic, where a name is no warning. What follows a colon
/// is the reason, for readers.
[[nodiscard]] bool read_warning_names(const SourceMap& sources, Span rest, Directive& directive,
                                      Diagnostics& diagnostics);

}  // namespace rigor
