// SPDX-License-Identifier: GPL-3.0-or-later
// What the forms of notes are worth in floating point, as text, as JSON, and as advice which one to compute.
#pragma once

#include <string>
#include <vector>

#include "check/forms.h"
#include "numeric/chain_results.h"
#include "report/terminal.h"

namespace rigor {

/// A chain of some notes with its results.
struct EvaluatedChain {
  const WrittenFormChain* chain = nullptr;
  ChainResult result;
};

struct EvaluatedNotes {
  std::string path;
  std::vector<EvaluatedChain> chains;
};

/// Per chain and form one line a trial. The same bytes for the same results.
[[nodiscard]] std::string print_evaluation(const EvaluatedNotes& notes, const SourceMap& sources,
                                           const TerminalOptions& options = {});

/// One JSON object; docs/json.md describes it.
[[nodiscard]] std::string evaluation_json(const EvaluatedNotes& notes, const SourceMap& sources);

/// Where a chain stands: `notes.md:12 (6)`.
[[nodiscard]] std::string place_of(const WrittenFormChain& chain, const SourceMap& sources);

}  // namespace rigor
