// SPDX-License-Identifier: GPL-3.0-or-later
// Which constants a letter can stand for, by its name and by the words around it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/constant/physical_constants.h"

namespace rigor {

/// The words of a text in small letters, singular, each between blanks: ` an electron of mass $ `. Without
/// the electron of `electron volt`.
[[nodiscard]] std::string spoken_words(std::string_view text);

/// Do the words name it?
[[nodiscard]] bool speaks_of(const PhysicalConstant& constant, std::string_view spoken);

/// Is the name of the letter enough to know it: `k_B`, `\hbar`?
[[nodiscard]] bool is_own_name(const PhysicalConstant& constant, std::string_view name);

/// Is its name usual, so that the words need not say which particle or body is meant?
[[nodiscard]] bool is_usual_name(const PhysicalConstant& constant, std::string_view name);

/// `name`: of a symbol, `m_{\text{e}}`. `spoken`: all words in reach. In the order of the table.
[[nodiscard]] std::vector<const PhysicalConstant*> constants_of(std::string_view name,
                                                                std::string_view spoken);

}  // namespace rigor
