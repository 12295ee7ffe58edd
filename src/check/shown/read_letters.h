// SPDX-License-Identifier: GPL-3.0-or-later
// The letters of a row, each with what says what it is.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/event/notes.h"
#include "check/ledger/ledger.h"
#include "check/shown/read_row.h"

namespace rigor {

/// Where the notes first write a letter, by its base as `take_apart` gives it.
struct FirstWritten {
  std::optional<Span> at = {};
  std::optional<Span> vector = {};   // bold, under an arrow or a hat
  std::optional<Span> tensor = {};   // sans serif, under a double arrow
  std::optional<Span> indexed = {};  // with a letter as an index
};
using FirstPlaces = std::map<std::string, FirstWritten>;

/// In the displays. Cost: linear in the notes.
[[nodiscard]] FirstPlaces first_places(const Notes& notes, const Names& names);

/// What the notes say of letters anywhere.
struct LettersOfNotes {
  const Notes& notes;
  FirstPlaces places;
  std::map<std::size_t, const PlacedDirective*> directives;  // by number
};
[[nodiscard]] LettersOfNotes letters_of_notes(const Notes& notes, const Names& names);

/// Of one relation: quantities in the order in which they stand, then indices and particle labels. `ordered`:
/// those that may be matrices or operators.
[[nodiscard]] std::vector<ReadLetter> letters_of_row(const ExprTree& tree, const Names& names,
                                                     const LettersOfNotes& known, const Statement& statement,
                                                     std::size_t which, const std::set<SymbolId>& ordered);

}  // namespace rigor
