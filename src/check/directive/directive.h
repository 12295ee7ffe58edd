// SPDX-License-Identifier: GPL-3.0-or-later
// A directive line taken apart: what it does, and the mathematics it does it to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/directive/remainder.h"
#include "check/step/report.h"
#include "expr/tree/dimension.h"
#include "latex/macro/macros.h"
#include "latex/reading/readings.h"
#include "latex/split/split.h"
#include "source/diagnostic.h"

namespace rigor {

enum class DirectiveKind : std::uint8_t {
  vector,
  scalar,
  complex,  // a number or a vector of complex numbers
  tensor,
  for_all,  // what is stated is meant for all values of these
  particles,
  constant,
  variable,
  rotation,
  basis,
  frame,
  space,  // what vectors and indices run over from here to the end of the section
  small,
  units,
  let,
  given,
  where,        // an assumption for the next statement only
  first_order,  // the `=` of the next statement means "to first order in what is small"
  claim,
  expect,
  skip,
  use,    // a definition that is said elsewhere holds here, too
  allow,  // silences warnings
  warn    // asks for them
};

/// One side of a chain after parsing, and a chain of them.
struct ParsedChain {
  WrittenChain written;
  std::vector<SyntaxId> sides;
  std::vector<Choice> choices;                // places that can be read in two ways…
  std::vector<std::vector<SyntaxId>> others;  // … and the sides in the other readings (see `Readings`)
  std::vector<std::optional<Remainder>> remainders = {};  // of each side: `+ O(x^n)`
  std::vector<ParsedChain> assumed = {};  // what is said next to it, in its tag and at its braces
  std::string signs = {};                 // of `\pm` and `\mp`: "upper signs", "lower signs"
  int image = 0;  // of "and cyclic permutations": how often 1 → 2 → 3 → 1 was applied
};

struct Directive {
  DirectiveKind kind = DirectiveKind::skip;
  Span span;
  std::size_t number = 0;  // in the file, for "was it used?"
  bool symmetric = false;
  bool unit = false;
  std::optional<bool> polar = {};  // `polar vector`, `axial vector`
  std::vector<SyntaxId>
      symbols;  // vector, scalar, tensor, particles, constant, small…; frame: the angular velocity
  std::vector<Dimension> dimensions = {};     // units: one for each symbol
  std::vector<ParsedChain> chains;            // let, given, where, claim
  std::vector<DiagnosticKind> warnings = {};  // allow, warn
  std::vector<std::string> places = {};       // use: tags, `line 12`
  Verdict expected = Verdict::refuted;        // expect: or a law, or suspect
  bool here = false;                          // allow, warn: of the next statement only
  std::string space;                          // space: its name
  int dimension = 0;                          // and dimension
  std::string rotating;                       // frame: the labels
  std::string fixed;
  std::string text;  // as written, without comment
};

/// Nothing where the line cannot be read (with a diagnostic), or holds only a comment.
[[nodiscard]] std::optional<Directive> read_directive(const SourceMap& sources, Span line, MacroTable& macros,
                                                      SyntaxTree& syntax, Diagnostics& diagnostics);

/// Splits and parses; used for displays as well.
[[nodiscard]] std::vector<ParsedChain> parse_chains(TokenView tokens, std::string_view environment,
                                                    SyntaxTree& syntax, Diagnostics& diagnostics);

/// "and cyclic permutations": the two images of the last chain, after it; where it has none, one that is on
/// a condition which says so.
void add_images(std::vector<ParsedChain>& chains, SyntaxTree& syntax);

/// The line without `# …` at its end and without blanks around it.
[[nodiscard]] Span without_comment(const SourceMap& sources, Span line);

}  // namespace rigor
