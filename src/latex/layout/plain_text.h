// SPDX-License-Identifier: GPL-3.0-or-later
// Mathematics on one line of Unicode text: `|A×B|² = A²B² − (A·B)²`. For people: it cannot be read back,
// since bold and italic letters look alike in it.
#pragma once

#include <string>

#include "latex/layout/layout.h"

namespace rigor {

/// Rows of a table are parted by `; `, unless the next one goes on with a relation. Never has a line break.
[[nodiscard]] std::string to_plain_text(const Box& box);

/// Of one side or statement; tokens after `expand`.
[[nodiscard]] std::string to_plain_text(TokenView tokens);

}  // namespace rigor
