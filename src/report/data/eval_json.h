// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluated forms for other programs.
#pragma once

#include <string>

#include "report/text/eval_text.h"

namespace rigor {

/// One JSON object; docs/json.md describes it.
[[nodiscard]] std::string evaluation_json(const EvaluatedNotes& notes, const SourceMap& sources);

}  // namespace rigor
