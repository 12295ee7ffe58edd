// SPDX-License-Identifier: GPL-3.0-or-later
// What stands next to the equations of a line and is none: conditions, remarks, and what cannot be read. It
// is said about all of them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "latex/split/split.h"
#include "latex/token/accounting.h"

namespace rigor {

/// Do all these symbols occur in the tokens?
[[nodiscard]] bool knows(const std::set<std::string>& symbols, TokenView tokens);

/// "where", "with": an equation after them says what a letter is.
[[nodiscard]] bool is_detail(const std::string& words);

class LineNotes {
 public:
  LineNotes(TokenView line, TokenUses& uses) : line_(line), uses_(uses) {}

  /// Signs that may change what the equations say keep them from being judged.
  void set_condition(TokenView tokens, std::string message);
  void set_condition(Span span, Obstacle obstacle);
  /// Unread, but whatever it says can only restrict the equations. `counts`: it lists values of a letter.
  void set_doubt(TokenView tokens, bool counts = false);
  /// Words that are in a list, or keep the equations from being judged.
  void note_remark(TokenView tokens, bool after_equation);
  /// Words that are in no list: they restrict the equations, or keep them from being judged.
  void note_restriction(TokenView tokens);
  /// `(\text{no sum})`, `(a, b constant)`: signs that are no equation.
  void note_aside(TokenView tokens);
  /// What `read` makes of them is assumed; false if they are no conditions.
  bool assume(TokenView tokens, std::optional<std::vector<Tokens>> (*read)(TokenView));
  /// Of `i, j = 1, 2, 3`: do the letters occur elsewhere on the line, too?
  [[nodiscard]] bool ranges_over_known(TokenView range) const;

  [[nodiscard]] bool has_condition() const { return condition_.has_value(); }
  /// Says it of the chain.
  void apply(WrittenChain& chain) const;

 private:
  TokenView line_;
  TokenUses& uses_;
  std::vector<WrittenChain> assumed_;
  std::optional<Obstacle> doubt_;
  std::optional<Obstacle> condition_;
  Span condition_span_;
  bool only_counts_ = false;
  bool no_sum_ = false;
  bool cyclic_ = false;
  bool alternatives_ = false;
};

}  // namespace rigor
