// SPDX-License-Identifier: GPL-3.0-or-later
// Which letters of notes stand for the masses and the positions of a body's particles, where nobody says so.
#pragma once

#include <optional>
#include <span>

#include "base/result.h"
#include "expr/tree/tree.h"
#include "numeric/program/program.h"

namespace rigor {

struct BodyLetters {
  std::optional<SymbolId> mass;      // a free scalar of each particle
  std::optional<SymbolId> position;  // a free vector of each particle
};

/// Among what the programs read: the only one of its kind, or of several the one that is called `m`, and
/// `r` or else `x`; derivatives are neither. Nothing is found where nothing of the kind is read; several with
/// other names are an error that names them.
[[nodiscard]] Result<BodyLetters> body_letters(const ExprTree& tree,
                                               std::span<const Program* const> programs);

}  // namespace rigor
