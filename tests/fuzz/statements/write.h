// SPDX-License-Identifier: GPL-3.0-or-later
// Statements as somebody would write them: LaTeX with one of many faces, in Markdown or LaTeX notes.
#pragma once

#include <string>

#include "random.h"
#include "statement.h"

namespace fuzz {

/// How one author writes; each note keeps to one.
struct Style {
  explicit Style(Random random);

  std::string face;         // `\mathbf`, `\vec`, `\boldsymbol`, `\bm`
  std::string unit_face;    // `\hat`, `\hat{\mathbf`
  std::string tensor_face;  // `\mathsf`, `\overleftrightarrow{\mathbf`
  std::string epsilon;      // `\varepsilon`, `\epsilon`
  std::string fraction;     // `\frac`, `\dfrac`
  std::string between;      // of two factors: ` `, `\,`
  bool dots_as_fractions;   // `\frac{d\mathbf A}{dt}`
  bool lengths_by_letter;   // `A` for |A|
  bool latex_notes;
  bool physics;  // `\dv`, `\abs`, `\curl`
  bool spaced;
  std::uint64_t seed;  // of what varies inside a statement: kinds of brackets, `/`
};

[[nodiscard]] std::string latex(const Term& term, const std::vector<Letter>& letters, const Style& style);

/// One display and the directives that it needs, below a heading.
[[nodiscard]] std::string section(const Statement& statement, const Style& style, const std::string& title);

/// Whole notes with one statement.
[[nodiscard]] std::string notes(const Statement& statement, const Style& style);
[[nodiscard]] std::string file_name(const Style& style);

}  // namespace fuzz
