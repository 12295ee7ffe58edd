// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// The LaTeX of a sign or of a letter that is not ASCII, with amssymb: `\times ` for ×; empty where there is
/// none.
[[nodiscard]] std::string typeset_sign(std::string_view text);

}  // namespace rigor
