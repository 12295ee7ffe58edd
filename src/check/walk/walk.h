// SPDX-License-Identifier: GPL-3.0-or-later
// The walk through one file's notes: what holds where, and a verdict for every row.
#pragma once

#include "check/event/notes.h"
#include "check/ledger/ledger.h"
#include "check/step/report.h"
#include "check/walk/state.h"
#include "source/source_map.h"

namespace rigor {

/// Follows the notes once, from beginning to end. Steps and diagnostics go to the report, all else into the
/// ledger, which refers to `notes`.
[[nodiscard]] Ledger walk_through(const SourceMap& sources, const Notes& notes, FileReport& report,
                                  const CheckOptions& options, WalkRequest request = {});

/// What is known of the letters where the notes begin. Symbols that this makes go to `tree`.
[[nodiscard]] Names names_at_beginning(const SourceMap& sources, const Notes& notes, ExprTree& tree);

}  // namespace rigor
