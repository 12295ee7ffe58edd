// SPDX-License-Identifier: GPL-3.0-or-later
// What the letters of one file stand for at a place: what they are (`Symbols`), and what holds there
// (`NameScope`). This file has the functions that need both. A copy shares all that it holds, so that keeping
// a place costs a few pointers, and nothing that is said later changes what it answers. A look-up marks
// nothing: whoever asks notes the directive behind the answer (`KnownChange::directive`, `declared_by`),
// because a directive that nothing uses is an error.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elaborate/name/scope.h"
#include "elaborate/name/symbols.h"
#include "expr/calculus/differentiate.h"

namespace rigor {

struct Names {
  Symbols symbols = {};
  NameScope scope = {};
};

/// Declares kind and properties from here to the end of the section; an earlier symbol of this key is
/// forgotten, unless no equation has it yet.
SymbolId declare(Names& names, ExprTree& tree, const NameKey& key, Symbol symbol, std::size_t directive);
/// From here to the end of the section, vectors, tensors and indices belong to this space. Names that are
/// used again mean the same space. False: there are too many.
[[nodiscard]] bool enter_space(Names& names, const std::string& name, int dimension, std::size_t directive);
void declare_particles(Names& names, const std::string& letter, std::size_t directive);

/// What a directive declared, defined and assumed holds no longer.
void forget(Names& names, std::size_t directive);
/// A heading of this level closes all sections of its level and below, with what their directives declared.
void open_section(Names& names, int level);

/// How a symbol (or a derivative) changes, and the directive that says so, if one does. A symbol varies if
/// nothing is said about it.
struct KnownChange {
  Dependence dependence;
  std::optional<std::size_t> directive = {};
};
[[nodiscard]] KnownChange change(const Names& names, const ExprTree& tree, SymbolId symbol,
                                 const Variable& by);
/// Does anything say how a symbol changes: a declaration, a definition, a derivative that is written?
[[nodiscard]] bool knows_change(const Names& names, const ExprTree& tree, SymbolId symbol,
                                const Variable& by);
/// Does anything say that it changes with a letter or a rate, by its definition or by a derivative?
[[nodiscard]] bool leads_to(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by);
/// Is it the time, or the place where the notes speak of places and not of a body that moves?
[[nodiscard]] bool is_free_variable(const Names& names, const ExprTree& tree, SymbolId symbol,
                                    const Variable& by);
/// Does a ∂ or ∇ occur before it, or in what defines it, somewhere in the file?
[[nodiscard]] bool is_field(const Names& names, const ExprTree& tree, SymbolId symbol);
/// Is the scalar of this name small by a directive?
[[nodiscard]] bool is_small_scalar(const Names& names, const ExprTree& tree, const std::string& base);

/// The names in scope, for suggestions.
[[nodiscard]] std::vector<std::string> known_names(const Names& names, const ExprTree& tree);

}  // namespace rigor
