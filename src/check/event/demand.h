// SPDX-License-Identifier: GPL-3.0-or-later
// Which chains of the notes a request needs: found on the syntax, before anything is elaborated.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "check/event/notes.h"
#include "elaborate/name/names.h"

namespace rigor {

/// The letters of the notes with their labels: `r`, `T_{rot}`, as `take_apart` gives them.
[[nodiscard]] std::set<std::string> bases_in(const Notes& notes, const Names& names);
/// Those below one node, without δ, ε and the axes' unit vectors.
[[nodiscard]] std::set<std::string> bases_below(const SyntaxTree& syntax, SyntaxId root, const Names& names);

/// What a tag or a heading names.
struct NamedPlace {
  std::size_t first = 0;  // events
  std::size_t behind = 0;
  std::string tag;  // of one chain; empty: all chains of these events
};
/// A tag, as `(22)` or `22`, or a heading, whose section goes to the next one of its level or above.
[[nodiscard]] std::optional<NamedPlace> place_named(const Notes& notes, const std::string& name);
/// The names that `place_named` knows, for suggestions.
[[nodiscard]] std::vector<std::string> place_names(const Notes& notes);

/// Chains of `wanted` places; chains whose first side names a letter that these or `asked` have; and so on.
/// More than what is needed in the end, never less.
[[nodiscard]] std::set<const ParsedChain*> chains_needed(const Notes& notes, const Names& names,
                                                         const std::vector<SyntaxId>& asked,
                                                         const std::vector<NamedPlace>& wanted);

}  // namespace rigor
