// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.h"
#include "source/diagnostic.h"

namespace rigor {

/// The bytes of a regular file of at most 64 MiB; a missing file, a directory, a device… is an error.
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Diagnostics for the first invalid UTF-8 byte and the first NUL byte of a text, each with how many there
/// are; all are replaced by the substitute character, U+001A, so that reading can go on. A byte-order mark at
/// the start becomes spaces, a carriage return that no line feed follows a line feed.
[[nodiscard]] Diagnostics mend_text(std::string& text, FileId file);

/// The same of notes, after those in Latin-1 have become UTF-8 (`latin1.h`).
[[nodiscard]] Diagnostics mend_notes(std::string& text, FileId file);

}  // namespace rigor
