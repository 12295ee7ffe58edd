// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh file as lines of words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace rigor {

/// Words between blanks. `next` stays on the line or goes on to the next one.
class MeshWords {
 public:
  explicit MeshWords(std::string_view text) : text_(text) {}

  [[nodiscard]] std::uint32_t line() const { return line_; }
  /// The next word of this line; empty at its end. `#` ends a line.
  std::string_view next_on_line();
  /// The next word on any line; empty at the end of the text.
  std::string_view next();
  /// To the start of the next line; false at the end of the text.
  bool next_line();

  /// `line 3: …`
  [[nodiscard]] tl::unexpected<Error> refuse(std::string_view reason) const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
};

/// A finite decimal number that is the whole word, with one sign at most. What is too small for a double is
/// rounded to the nearest one, to 0 as a rule; what is too great is no number.
[[nodiscard]] std::optional<double> finite_number(std::string_view word);

/// At most 24 characters of a word, what is not printable ASCII as `?`.
[[nodiscard]] std::string shown(std::string_view word);

}  // namespace rigor
