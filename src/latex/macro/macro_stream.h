// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens that are still to be expanded: those of the notes and, on top of them, the bodies of macros
// being expanded.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

/// An argument as TeX takes it: without the braces around it; `span` is where it was written, with its
/// braces.
struct TakenArgument {
  Tokens tokens;
  Span span;
};

class MacroStream {
 public:
  explicit MacroStream(TokenView tokens) { layers_.push_back({{}, tokens}); }

  /// The next token, which stays or goes; nothing at the end.
  [[nodiscard]] std::optional<Token> peek();
  /// The token that is so many behind the next.
  [[nodiscard]] std::optional<Token> peek(std::size_t behind) const;
  std::optional<Token> take();
  /// The next token goes if it is this sign.
  bool take_sign(std::string_view sign);
  void skip_spaces();

  /// A brace group or one token, spaces skipped. Nothing at the end of the stream, of a paragraph or of the
  /// group that the call is in, and for a group that is never closed.
  std::optional<TakenArgument> take_argument();
  /// What is in `[…]`, spaces skipped. Needs that the next token is `[`; nothing where it is never
  /// closed.
  std::optional<TakenArgument> take_optional();

  /// The tokens come before all others.
  void push(Tokens tokens) { layers_.push_back({std::move(tokens), {}}); }
  /// Bodies inside which the next token lies. A body that has just run out still counts: `\def\a{\a}` grows
  /// deeper.
  [[nodiscard]] std::size_t depth() const { return layers_.size() - 1; }

 private:
  struct Layer {
    Tokens owned;
    TokenView given;
    std::size_t at = 0;

    [[nodiscard]] TokenView tokens() const { return owned.empty() ? given : TokenView(owned); }
  };

  std::vector<Layer> layers_;  // the last is read first
};

}  // namespace rigor
