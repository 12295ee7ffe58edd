// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that stand for three matrices: `\sigma_i`, `\boldsymbol\sigma`, and the Pauli matrices that only
// the words name.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// Nothing where the letter belongs to no triple, or where its matrices only stand below.
[[nodiscard]] std::optional<MaybeTyped> triple_letter(Reading& reading, const WrittenSymbol& written,
                                                      Span span, const Around& around);
/// `S` of `S^2`, where `\mathbf S` is a triple and S is nothing else.
[[nodiscard]] std::optional<MaybeTyped> triple_without_index(Reading& reading, const WrittenSymbol& written,
                                                             Span span);
/// Does a letter of a triple stand in it, and are triples what this row is about?
[[nodiscard]] bool holds_triple(const Reading& reading, SyntaxId id);
/// The number of rows of the usual triple, where the row has one.
[[nodiscard]] std::optional<std::uint8_t> rows_of_usual_triple(const Reading& reading);

}  // namespace rigor
