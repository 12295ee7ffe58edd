// SPDX-License-Identifier: GPL-3.0-or-later
// Which words around an equation may restrict it. A refutation says that an equation fails for some values;
// it is given only where the words around it are neutral, so that those values are meant.
//
// The rules go by function words, and English has few of them: prepositions and subordinators ("near",
// "provided", "at"), imperatives and participles that choose ("neglect", "assuming"), negations, and
// adjectives that restrict. Nouns are known the other way round: "let $m$ be the mass" restricts nothing,
// "let $\mathbf n$ be the normal" may.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigor {

/// In the sentence that leads into a display and goes on after it. Small letters; mathematics is `$`, a
/// display
/// `\n`.
[[nodiscard]] std::optional<std::string> restriction_in_sentence(std::string_view sentence);
/// In a whole sentence above the display, which may share a letter with it (`shares`) or have no letters at
/// all.
[[nodiscard]] std::optional<std::string> restriction_above(std::string_view sentence, bool has_letters,
                                                           bool shares);
/// In a whole sentence after the display, in its paragraph: "This holds only at the surface."
[[nodiscard]] std::optional<std::string> restriction_behind(std::string_view sentence, bool has_letters,
                                                            bool shares);
/// In a heading: "Near the surface", "Two-dimensional flow".
[[nodiscard]] std::optional<std::string> restriction_in_heading(std::string_view heading);

}  // namespace rigor
