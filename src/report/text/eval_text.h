// SPDX-License-Identifier: GPL-3.0-or-later
// What the forms of notes are worth in floating point, as text, as JSON, and as advice which one to compute.
#pragma once

#include <string>
#include <vector>

#include "numeric/advice/chain_results.h"
#include "report/text/terminal.h"

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

/// Where a chain stands: `notes.md:12 (6)`.
[[nodiscard]] std::string place_of(const WrittenFormChain& chain, const SourceMap& sources);

}  // namespace rigor
