// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/scoped_macros.h"

#include <utility>

#include "latex/macro/faces.h"
#include "latex/text/format.h"

namespace rigor {

void ScopedMacros::define(const SourceMap& sources, const MacroText& text, Diagnostics& diagnostics) {
  const std::vector<Token> tokens = text.made.empty() ? lex(sources, text.span) : lex_text(text.made);
  if (text.quiet) return define_quietly(tokens);
  static_cast<void>(expand(tokens, table_, diagnostics));
  if (!text.global) return;
  Diagnostics said_already;
  for (MacroTable& table : before_) static_cast<void>(expand(tokens, table, said_already));
}

void ScopedMacros::define_quietly(std::span<const Token> tokens) {
  Diagnostics unheard;
  static_cast<void>(expand(tokens, table_, unheard));
  if (unheard.empty()) return;
  for (auto& [name, macro] : table_) {
    if (macro.use == MacroUse::unreadable) macro.use = MacroUse::unseen;
  }
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
  const bool latex = format_of(sources, display.span.file) == Format::latex;
  std::vector<Token> tokens = lex(sources, display.body, display.quotes);
  if (latex) return expand(tokens, table_, diagnostics, MacroScope::group);
  return expand(with_starred_faces(std::move(tokens)), table_, diagnostics, MacroScope::lasting);
}

}  // namespace rigor
