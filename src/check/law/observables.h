// SPDX-License-Identifier: GPL-3.0-or-later
// Operators that are self-adjoint. Those of position and momentum are, and pages write `a^\dagger` for `a =
// \hat x + i\hat p` without saying so.
#pragma once

#include <set>
#include <string>

#include "check/law/page_law.h"

namespace rigor {

/// Of laws such as `[\hat x, \hat p] = i\hbar`: for self-adjoint operators, and for hardly any others, a
/// commutator is i times what is real or self-adjoint.
[[nodiscard]] std::set<SymbolId> observables_of(const ExprTree& tree, const Laws& laws);

/// Is there an adjoint of an operator, also in what letters mean?
[[nodiscard]] bool writes_adjoints(const ExprTree& tree, const NameScope& scope, const Equation& equation);

/// `A^\dagger = A`
[[nodiscard]] PageLaw self_adjoint_law(ExprTree& tree, SymbolId letter, Span span, std::string name);

}  // namespace rigor
