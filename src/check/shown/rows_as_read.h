// SPDX-License-Identifier: GPL-3.0-or-later
// From the ledger of a walk that only reads to what is shown of each row.
#pragma once

#include <vector>

#include "check/event/notes.h"
#include "check/ledger/ledger.h"
#include "check/place/check_options.h"
#include "check/shown/read_row.h"

namespace rigor {

/// One for each step of the report, in its order, cyclic images apart. The ledger's tree grows. `options` has
/// a cache. Decided is only whether a row reads as an identity: a few small questions a row.
[[nodiscard]] std::vector<ReadRow> rows_as_read(Ledger& ledger, const Notes& notes, const SourceMap& sources,
                                                const FileReport& report, const CheckOptions& options);

}  // namespace rigor
