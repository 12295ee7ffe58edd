// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/scoped_macros.h"

#include <utility>

#include "latex/text/format.h"

namespace rigor {

void ScopedMacros::define(const SourceMap& sources, const MacroText& text, Diagnostics& diagnostics) {
  const std::vector<Token> tokens = lex(sources, text.span);
  static_cast<void>(expand(tokens, table_, diagnostics));
  if (!text.global) return;
  Diagnostics said_already;
  for (MacroTable& table : before_) static_cast<void>(expand(tokens, table, said_already));
}

void ScopedMacros::pass(const MacroGroup& group) {
  if (group.opens) {
    before_.push_back(table_);
  } else if (!before_.empty()) {
    table_ = std::move(before_.back());
    before_.pop_back();
  }
}

std::optional<std::vector<Token>> ScopedMacros::expand_display(const SourceMap& sources,
                                                               const Display& display,
                                                               Diagnostics& diagnostics) {
  const bool latex = format_of(sources.path(display.span.file)) == Format::latex;
  return expand(lex(sources, display.body, display.quotes), table_, diagnostics,
                latex ? MacroScope::group : MacroScope::lasting);
}

}  // namespace rigor
