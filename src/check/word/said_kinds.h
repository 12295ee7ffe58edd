// SPDX-License-Identifier: GPL-3.0-or-later
// Adjectives that are conditions: "for an acute angle $\varphi$", "where $m$, $k$ are positive constants",
// "with nonzero $b$". The lists are closed, and are in docs/notation.md.
#pragma once

#include <string_view>
#include <vector>

namespace rigor {

/// What "Hermitian" says.
inline constexpr std::string_view self_adjoint = "$^\\dagger = $";

/// What a sentence says about the mathematics in it, counted from 0.
struct SaidKind {
  std::size_t maths = 0;
  std::vector<std::string_view> relations;  // with `$` for the letter: `$ > 0`
};

/// `sentence` as in `ProseBeside`: small letters, `$` for mathematics in a line, `\n` for a display. Nothing
/// from a sentence that negates, doubts or chooses.
[[nodiscard]] std::vector<SaidKind> said_kinds(std::string_view sentence);

}  // namespace rigor
