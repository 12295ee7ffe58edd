// SPDX-License-Identifier: GPL-3.0-or-later
// What an equation would say about the symbol on its left side, if it were a definition or a rule for a
// derivative. This file decides nothing and brings nothing into scope.
#pragma once

#include <optional>

#include "elaborate/name/scope.h"
#include "elaborate/reading/typed.h"
#include "expr/statement/statement.h"
#include "latex/token/syntax.h"

namespace rigor {

/// The left side is one bare symbol with distinct index letters, or none, and nothing free on the right that
/// it does not carry.
[[nodiscard]] std::optional<Definition> as_definition(ExprTree& tree, const NameScope& scope,
                                                      const Typed& left, const Typed& right);
/// Would the equation define what is on its left side, if it had one reading?
[[nodiscard]] bool would_define(ExprTree& tree, const NameScope& scope, const Typed& left,
                                const Typed& right);
/// Does the right side lead back to the symbol on the left?
[[nodiscard]] bool is_circular(const ExprTree& tree, const NameScope& scope, const Typed& left,
                               const Typed& right);
/// `(\Omega_1)^2` names a number by its square; `v^2 = u^2 + 2as` is a law.
[[nodiscard]] bool stands_in_brackets(const SyntaxTree& syntax, SyntaxId power);

/// How often the symbol is differentiated by the time and by the place.
[[nodiscard]] int derivative_order(const SymbolTable& symbols, SymbolId symbol);
/// Does a definition say already what the symbol is, or how it changes? A second one would be followed
/// instead of the first: that both hold is an assumption. Of two rules, the one of lower order stays.
[[nodiscard]] bool is_determined(const SymbolTable& symbols, const NameScope& scope, SymbolId symbol);
/// `given \dot{\mathbf r} = …`: a derivative is replaced wherever it stands.
[[nodiscard]] bool is_rule(ExprTree& tree, const NameScope& scope, const Typed& left, const Typed& right);

}  // namespace rigor
