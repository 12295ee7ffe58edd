// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors of space-time with their indices: `F^{\mu\nu}`, `\Lambda^\mu{}_\nu`, `p_{1\mu}`, `A^0`,
// `\eta_{\mu\nu}`, `\delta^\mu_\nu`.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// What `power` is, where it is a letter with indices above; nothing where it is a power, or anything else.
[[nodiscard]] std::optional<MaybeTyped> raised_letter(Reading& reading, SyntaxId power, const Around& around);
/// The same for a letter that has indices below only.
[[nodiscard]] std::optional<MaybeTyped> lowered_letter(Reading& reading, const WrittenSymbol& written,
                                                       Span span, const Around& around);
/// `p` of `p\cdot k` in a section with p^\mu.
[[nodiscard]] bool is_four_vector(const Reading& reading, SyntaxId id);
/// x^2 beside x^\mu: x, y and z stand on the line, so that it is a square.
[[nodiscard]] bool is_coordinate_on_line(const Reading& reading, const WrittenSymbol& written);

}  // namespace rigor
