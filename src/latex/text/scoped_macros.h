// SPDX-License-Identifier: GPL-3.0-or-later
// The macros in force while one goes through the items of notes: those of a group end with it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "latex/macro/macros.h"
#include "latex/text/items.h"

namespace rigor {

class ScopedMacros {
 public:
  void define(const SourceMap& sources, const MacroText& text, Diagnostics& diagnostics);
  void pass(const MacroGroup& group);

  /// The tokens of a display. In LaTeX a definition inside it ends with it; in Markdown it stays, as for
  /// MathJax.
  std::optional<std::vector<Token>> expand_display(const SourceMap& sources, const Display& display,
                                                   Diagnostics& diagnostics);

  [[nodiscard]] MacroTable& table() { return table_; }

 private:
  void define_quietly(std::span<const Token> tokens);

  MacroTable table_;
  std::vector<MacroTable> before_;  // before each group in which we are
};

}  // namespace rigor
