// SPDX-License-Identifier: GPL-3.0-or-later
// Notes in Latin-1, with the quotation marks and dashes of Windows-1252.
#pragma once

#include <string>

#include "source/diagnostic.h"

namespace rigor {

/// Turns a text in Latin-1 into UTF-8, and says so; other texts stay as they are. It is one if it is not
/// UTF-8, and if `inputenc` says so or every byte above ASCII would be a letter or a mark of prose. Nothing
/// that is read as mathematics (`±`, `·`, `×`, `²`…) rests on the latter: it becomes the substitute character
/// of `mend_text`.
[[nodiscard]] Diagnostics decode_latin1(std::string& text, FileId file);

}  // namespace rigor
