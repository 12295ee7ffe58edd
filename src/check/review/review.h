// SPDX-License-Identifier: GPL-3.0-or-later
// The last look at notes that are decided. No verdict changes here.
#pragma once

#include "check/ledger/ledger.h"
#include "check/place/check_options.h"
#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// To each wrong step, what it may have been meant to say and when it would hold, as far as that is asked
/// for.
void suggest_repairs(const Ledger& ledger, const Notes& notes, const CheckOptions& options,
                     FileReport& report);

/// Dimensions that disagree, lints, and directives that nothing uses.
void review(const Ledger& ledger, const Notes& notes, const SourceMap& sources, FileReport& report);

}  // namespace rigor
