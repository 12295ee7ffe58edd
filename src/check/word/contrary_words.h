// SPDX-License-Identifier: GPL-3.0-or-later
// "Incompressible" and "compressible", "monatomic" and "diatomic": a law that is stated for the one says
// nothing of the other. What is stated of the general case does: the law of damped motion holds for undamped
// motion, too. The lists are closed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// The words of a text in small letters that may have a contrary, each once.
[[nodiscard]] std::vector<std::string> case_words_of(std::string_view text);
/// Does what is said with the first word say nothing where the second one is said? "Undamped" and "damped"
/// too.
[[nodiscard]] bool is_shut_out_by(std::string_view said, std::string_view here);
/// The same of definitions. The frequency of the undamped oscillator is a letter of the damped one's law, so
/// that words with "un-" shut out nothing.
[[nodiscard]] bool is_kind_shut_out_by(std::string_view said, std::string_view here);

/// "The spin of the photon" below "the spin of the electron": the second owner of one thing.
[[nodiscard]] std::optional<std::string> other_owner(std::string_view said, std::string_view here);
/// "The spin of the electron is" and "the spin of the electron gives": both speak of one thing.
[[nodiscard]] bool names_the_same_owner(std::string_view said, std::string_view here);

}  // namespace rigor
