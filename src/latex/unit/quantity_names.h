// SPDX-License-Identifier: GPL-3.0-or-later
// Which words can be the name of a quantity: "KE", "Total energy", "work done by friction". Whether they are
// one at their place is told by what stands beside them (`quantity_words.h`).
#pragma once

#include <string_view>

namespace rigor {

/// A noun phrase as far as its words show: none of them joins sentences or says that something is left out,
/// acts on what follows ("sin"), or is counted ("5 photons") or measured in ("miles per hour").
[[nodiscard]] bool can_name_quantity(std::string_view phrase);

/// "total", "fixed", "error": it can name a quantity, or say something of one.
[[nodiscard]] bool can_say_property(std::string_view phrase);

/// `Re`, `KE`, `SNR`, `K.E.`: written as a symbol is, so that factors stand beside it.
[[nodiscard]] bool is_symbol_of_letters(std::string_view phrase);

}  // namespace rigor
