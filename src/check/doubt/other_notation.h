// SPDX-License-Identifier: GPL-3.0-or-later
// Notations in which a row is right although its ranks or indices do not fit: points, quaternions, lists of
// data, functions of a vector; labels of elements, members, components along a normal. Whoever writes them
// says so at most in words, so such a row is not malformed for certain.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "check/directive/directive.h"
#include "elaborate/name/names.h"
#include "elaborate/name/possible_ranks.h"

namespace rigor {

/// What in step `which` can have another rank than the one that it was read with.
[[nodiscard]] std::optional<OpenPart> other_kind(const SyntaxTree& syntax, const Names& names,
                                                 const ParsedChain& parsed, std::size_t which);

/// The index at `place`, which not all terms have, can be a label.
[[nodiscard]] std::optional<OpenPart> other_subscript(const SyntaxTree& syntax, const Names& names,
                                                      const ParsedChain& parsed, std::size_t which,
                                                      Span place);

}  // namespace rigor
