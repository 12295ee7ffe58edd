// SPDX-License-Identifier: GPL-3.0-or-later
// A row is called malformed only if every reading of it fails and nothing in it was left open. Otherwise the
// row is not understood.
#pragma once

#include <cstddef>

#include "check/directive/directive.h"
#include "elaborate/name/names.h"

namespace rigor {

/// Is it about an index, a rank, a bracket or an expression that breaks off?
[[nodiscard]] bool is_malformation(DiagnosticKind kind);

/// Do the same letters occur in the subscripts of both sides of the step, so that they can be labels of
/// levels that nothing sums over: `g_iB_{ik} = g_kB_{ki}`?
[[nodiscard]] bool can_be_labels(const SyntaxTree& syntax, const ParsedChain& parsed, std::size_t which);

/// Step `which` of the chain: turns errors that another reading of the row could do without into what is not
/// understood, and names what was left open.
void doubt_errors(const SyntaxTree& syntax, const Names& names, const ParsedChain& parsed, std::size_t which,
                  Diagnostics& diagnostics);

}  // namespace rigor
