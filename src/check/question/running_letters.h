// SPDX-License-Identifier: GPL-3.0-or-later
// Which letters of an integrand change with the variable of the integral, as far as the section shows; and
// which of a function with what it is written of.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "elaborate/name/names.h"

namespace rigor {

/// Another usual variable, of which the section shows nothing else: y of `\int xy\,dx`. In `\int y\,dx` it is
/// a function, where something is to be integrated.
[[nodiscard]] bool is_independent(const Names& names, const ExprTree& tree, SymbolId symbol,
                                  const Integral& integral);

/// Beside the variable, which is written, a letter is a constant unless the section writes a rate or an
/// argument of it, or a relation between it and the variable, or a usual variable for which that stands.
[[nodiscard]] bool shows_change(const Names& names, SymbolId symbol, SymbolId variable);

/// Does a relation of the section say what the letter is, with the variable in it, or with what it is tied
/// to? `but_by`: what this row alone says does not count.
[[nodiscard]] bool is_tied_to(const Names& names, SymbolId symbol, SymbolId variable,
                              std::optional<Span> but_by = {});

/// The same beside the letter that a sum counts with: nothing is usual there.
[[nodiscard]] bool counts_along(const Names& names, SymbolId symbol, SymbolId counter,
                                std::optional<Span> but_by = {});

/// Is it written as a function of this letter, and of no other?
[[nodiscard]] bool is_function_of_only(const Names& names, const ExprTree& tree, SymbolId symbol,
                                       SymbolId variable);

/// x of `u(x) = A\cos qx + B`, as the section writes it, and of `u = A\cos qx + B` beside `du/dx`: this says
/// what u is for each x, and its other letters are parameters, which a derivative by x holds.
[[nodiscard]] std::vector<SymbolId> runs_along(const Names& names, const ExprTree& tree,
                                               const Definition& function);
/// Of these, what a derivative is by.
[[nodiscard]] std::vector<SymbolId> along_which(const Names& names, const std::vector<SymbolId>& along,
                                                const Variable& by);
/// B and q, along x; not v of `E(t) = \tfrac12mv^2 + qt` beside `\dot v`. Also l of `l = mr^2\dot\theta` in
/// what runs along r: there are no rates along it. `row`: that of the claim, which bears no witness against
/// itself: c of `v_pv_g = c^2`.
[[nodiscard]] bool is_parameter(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by,
                                std::span<const SymbolId> along, Span row);

/// `\int_0^t v\,dt'` of `v = at`, `\int_0^d F\,ds` of `F = -kx`: is v meant at t or at t'?
[[nodiscard]] bool hides_variable(const Names& names, const ExprTree& tree, const Integral& integral,
                                  ExprId opened);

}  // namespace rigor
