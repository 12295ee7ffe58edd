// SPDX-License-Identifier: GPL-3.0-or-later
// Macros of packages that abbreviate notation which is read when it is written out: `\pmqty{…}` of physics is
// `\begin{pmatrix}…\end{pmatrix}`. One table; a definition of the author's comes before it.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "latex/macro/macro_stream.h"

namespace rigor {

/// What takes the place of a call: `body` has `#1` for the first of `arguments`.
struct PackageCall {
  TokenView body;
  std::vector<TakenArgument> arguments;
};

/// The call of a package's macro whose control has just been taken; its arguments are then taken, too.
/// Nothing, and nothing taken, for other controls and where something else stands behind it than the package
/// expects. Cost: linear in what stands behind, and at most 2,000 tokens are looked at.
[[nodiscard]] std::optional<PackageCall> package_call(std::string_view control, MacroStream& stream);

}  // namespace rigor
