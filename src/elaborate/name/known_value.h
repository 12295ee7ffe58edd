// SPDX-License-Identifier: GPL-3.0-or-later
// What follows for a name from the definition of another one: x(0) from `x(t) = A\cos\omega t`, E_2 and
// E_{n+1} from `E_n = n^2\epsilon`.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "elaborate/name/family.h"
#include "expr/statement/statement.h"

namespace rigor {

/// A definition that the notes give, or that follows from one.
struct FoundDefinition {
  Definition definition;
  const Origin* origin;
  bool at_instant;
  std::vector<const Origin*> put_in = {};  // definitions
  std::vector<SymbolId> along = {};        // as `NamedDefinition` has it
};

using IsHeld = std::function<bool(SymbolId)>;

/// What the preparation of a question knows.
struct KnownValues {
  /// Definitions put in, but of what is held.
  std::function<std::optional<ExprId>(ExprId, const IsHeld&)> open;
  std::function<bool(SymbolId, bool)> may_run;  // with the variable; `true`: which is the time
  /// Is the letter a parameter of the function, where that is written of this variable?
  std::function<bool(const FoundDefinition&, SymbolId, const Variable&)> is_held;
  Equation claim;
};

/// What the function is, with the value in the place of the variable. `of`: the function.
[[nodiscard]] std::optional<FoundDefinition> value_of_function(ExprTree& tree, const Names& names,
                                                               SymbolId symbol, const FunctionValue& value,
                                                               const FoundDefinition& of,
                                                               const KnownValues& known);

/// What the general member is, with the index in the place of its letter. Nothing where the letter is also
/// something else in it, where the definition leaves the member open, or makes it 0 or infinite: then the
/// name is another quantity, as ω_0 beside `\omega_n = n\omega_1`.
[[nodiscard]] std::optional<FoundDefinition> value_of_member(ExprTree& tree, const Names& names,
                                                             SymbolId symbol, const Membership& member,
                                                             const KnownValues& known);

/// What the question knows by the definition of a family. Such names are no ground for a refutation.
[[nodiscard]] std::vector<SymbolId> members_in(const Question& question, const ExprTree& tree,
                                               const Names& names);

/// As if no definition said anything of other members.
[[nodiscard]] Names without_members(Names names);

}  // namespace rigor
