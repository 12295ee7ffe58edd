// SPDX-License-Identifier: GPL-3.0-or-later
// LaTeX names in drawings: `\boldsymbol{\omega}_1` becomes a bold ω with a small 1 below the line.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// SVG markup for a text in which `$…$` encloses mathematics: Greek letters, faces, accents, sub- and
/// superscripts, a few signs. Any other command is shown by its name, so that nothing is lost.
[[nodiscard]] std::string svg_label(std::string_view text);

/// About how many letters wide it is drawn, for leaving room.
[[nodiscard]] double svg_label_letters(std::string_view text);

}  // namespace rigor
