// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens that expansion has produced, and whether the next one is the argument of a command: TeX takes a
// macro without braces, as in `\frac\a\b`, as a whole argument, and after expansion only braces can say so.
#pragma once

#include <cstdint>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

class MacroOutput {
 public:
  void add(const Token& token);
  /// The next token would be an argument, or the start of one, of a command such as `\frac`, `\sqrt`, `\dot`,
  /// `\mathbf`.
  [[nodiscard]] bool awaits_argument() const;
  [[nodiscard]] Tokens take() { return std::move(tokens_); }

 private:
  struct Level {
    std::uint8_t awaited = 0;      // arguments of the last command that have not come
    bool may_be_optional = false;  // only the command (and a star) came: `[` opens an optional argument
    bool in_optional = false;
  };

  Tokens tokens_;
  std::vector<Level> levels_{1};  // one for each open brace
};

}  // namespace rigor
