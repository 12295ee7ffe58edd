// SPDX-License-Identifier: GPL-3.0-or-later
// Answers put into a file in the place of the holes.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/span.h"

namespace rigor {

/// What is put in the place of some bytes.
struct PlacedText {
  Span span;
  std::string text;
};

/// The text with these bytes replaced, all others kept; the spans do not overlap and come in any order.
[[nodiscard]] std::string with_replacements(std::string text, std::vector<PlacedText> replacements);

/// A file with another content, or the old one if anything fails: a new file in the same folder takes its
/// place and its permissions. A link is followed. The reason where it cannot be written.
[[nodiscard]] Result<void> replace_file(const std::string& path, const std::string& content);

}  // namespace rigor
