// SPDX-License-Identifier: GPL-3.0-or-later
// From the ledger of a walk to the forms that the floating-point side evaluates.
#pragma once

#include <set>

#include "check/event/notes.h"
#include "check/form/forms.h"
#include "check/ledger/ledger.h"

namespace rigor {

/// The chains to be read for a request with `only`: those that it names, and those that define what these or
/// its expressions need. `names`: what is known of the letters where the notes begin. A name of a place that
/// the notes do not have is a diagnostic.
[[nodiscard]] std::set<const ParsedChain*> chains_of_request(const FormRequest& request, const Notes& notes,
                                                             const Names& names, Diagnostics& diagnostics);

/// The forms, the expressions asked for, and the holes, in the tree of the ledger, which grows. `start`: what
/// is known of the letters where the notes begin.
[[nodiscard]] FormsReading written_forms_of_notes(Ledger& ledger, const FormRequest& request,
                                                  const Notes& notes, const Names& start,
                                                  const SourceMap& sources, FileReport& report);

}  // namespace rigor
