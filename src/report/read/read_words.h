// SPDX-License-Identifier: GPL-3.0-or-later
// How a row was read, in words.
#pragma once

#include <string>

#include "check/shown/read_row.h"
#include "source/source_map.h"

namespace rigor {

/// `identity, to be proved for all values of its letters; announced by "hence"`
[[nodiscard]] std::string role_words(const ReadRow& row);

/// `vector, constant, one for each particle`
[[nodiscard]] std::string kind_words(const ReadLetter& letter);

/// What says so, and where: "`rigor: constant m` in line 3; first in line 12". Lines of other files are said
/// with their path. Empty: nothing is known.
[[nodiscard]] std::string source_words(const ReadLetter& letter, FileId file, const SourceMap& sources);

}  // namespace rigor
