// SPDX-License-Identifier: GPL-3.0-or-later
// The characters of a hole, and how an answer is set in their place.
#pragma once

#include <string>

#include "source/source_map.h"

namespace rigor {

/// What surrounds a hole.
struct HolePlace {
  bool alone = false;           // on its side
  bool is_argument = false;     // of `^`, `_`, `\frac`…: one group
  bool behind_control = false;  // `\times\square`: a letter would go on with the name
  bool beside_digit = false;    // `2\square`: digits would melt
  bool before_letter = false;   // `\square x`, which is one name with `\omega` for the square
};

/// Does the stretch hold the sign of a hole itself, and not the call of a macro that makes one?
[[nodiscard]] bool is_written_hole(const SourceMap& sources, Span span);

[[nodiscard]] HolePlace place_of(const SourceMap& sources, Span span, bool alone);

/// The answer with the brackets, braces and blanks that it needs there.
[[nodiscard]] std::string placed(const std::string& latex, const HolePlace& place);

/// Without blanks and `\,`: to be compared.
[[nodiscard]] std::string bare(const std::string& latex);

}  // namespace rigor
