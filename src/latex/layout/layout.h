// SPDX-License-Identifier: GPL-3.0-or-later
// What a piece of mathematics looks like on the page, as boxes in one another: the way from tokens to MathML
// and to plain text. It is made of what was typed and knows no meaning, so that what the checker does not
// understand is shown as well.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

enum class BoxKind : std::uint8_t {
  row,       // parts side by side
  letter,    // `text`: one letter, or a word in upright type
  number,    // `text`: `3.14`
  sign,      // `text`: an operator, a relation, a bracket, punctuation (see `SignRole`)
  words,     // `text`: words of prose, or the name of a control that is not known
  space,     // `width`
  fraction,  // two parts; `ruled` unless it is a binomial coefficient
  root,      // the radicand, and a second part if it is not a square root
  scripts,   // base, lower, upper (an empty row where there is none); `limits`: below and above
  accent,    // one part, `text` above it; `wide`: as wide as the part; `below`: under it
  fence,     // one part between `text` and `closing`, each as high as the part, each perhaps empty
  table,     // rows of cells
  framed,    // one part in a frame
  struck,    // one part, crossed out
  hidden,    // one part that takes its space and is not seen
};

enum class SignRole : std::uint8_t {
  ordinary,
  binary,
  prefix,  // a sign of what follows: −a
  relation,
  opening,
  closing,
  bar,  // | of an absolute value: opens or closes
  punctuation,
  big,       // ∑: scripts are below and above
  integral,  // ∫: scripts are next to it
  word,      // lim, max: scripts are below
};

enum class Typeface : std::uint8_t {
  italic,
  upright,
  bold,
  bold_italic,
  sans,
  script,
  fraktur,
  blackboard,
  mono
};

/// How the cells of a table are set.
enum class TableAlignment : std::uint8_t {
  centre,     // a matrix
  left,       // cases
  pairs,      // aligned: right, left, right, left, without space between a right and the left after it
  equations,  // eqnarray: right, centre, left
  staggered,  // multline: the first row left, the last one right
};

struct Box {
  BoxKind kind = BoxKind::row;
  std::string text = {};
  std::string closing = {};
  SignRole role = SignRole::ordinary;
  Typeface face = Typeface::italic;
  TableAlignment alignment = TableAlignment::centre;
  bool ruled = true;
  bool limits = false;
  bool wide = false;
  bool below = false;
  int size = 0;      // of a bracket: 1 for \big to 4 for \Bigg; of a fraction: 1 for \dfrac, -1 for \tfrac
  double width = 0;  // of a space, in em
  std::vector<Box> parts = {};
  std::vector<std::size_t> row_ends = {};  // of a table: the number of cells up to the end of each row
  std::vector<std::string> tags = {};      // of a table: the tag of each row, perhaps empty
};

/// A display and the tag that belongs to the whole of it, as printed: `(6)`; empty if there is none.
struct ShownDisplay {
  Box box;
  std::string tag;
};

/// Tokens after `expand`. Never fails: a control that is not known is its own name as words, what is not
/// closed ends with the tokens, and what lies deeper than 60 brackets is shown as it was typed. Cost: the
/// number of tokens times the depth of their brackets.
[[nodiscard]] Box layout_of(TokenView tokens);

/// `environment`: of the display; empty for `$$` and `\[`. `\label` vanishes.
[[nodiscard]] ShownDisplay layout_of_display(TokenView tokens, std::string_view environment);

}  // namespace rigor
