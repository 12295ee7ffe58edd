// SPDX-License-Identifier: GPL-3.0-or-later
// What the author of a wrong side may have meant: the side with one slip of the pen taken back. Nothing here
// knows what the signs mean; most rewritings are nonsense, and what is true among them is found out
// elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "latex/reading/pieces.h"
#include "latex/token/tokens.h"

namespace rigor {

/// Which slip is taken back.
enum class Slip : std::uint8_t {
  sign,
  factor,  // a coefficient
  index,   // another letter, digit or prime on a subscript
  indices_swapped,
  order,    // of the operands of a cross product, of factors, of the rows and columns of a matrix
  product,  // dot for cross, cross for dot
  power,
  bars,
  term_missing,
  term_extra,
  rate,               // a dot over a letter
  prime,              // on a letter
  letter,             // another one
  indices_exchanged,  // of two factors
  terms_exchanged,    // neighbouring ones; their signs stay
  letters_exchanged,
  function,        // `\cos` for `\sin`
  inverted,        // a fraction
  factor_missing,  // a letter
  factor_extra,
};

/// `begin` to `end` of the side's tokens become `text`. `shown_begin` to `shown_end` is what a reader
/// compares with what it became: the sign with its term, the letter with its index.
struct Rewriting {
  Slip slip = Slip::sign;
  std::size_t begin = 0;
  std::size_t end = 0;
  Tokens text = {};
  std::size_t shown_begin = 0;
  std::size_t shown_end = 0;
};

[[nodiscard]] Tokens rewritten(TokenView side, const Rewriting& rewriting);
/// What is shown of the side, after the rewriting.
[[nodiscard]] Tokens shown_after(TokenView side, const Rewriting& rewriting);

/// A rational number as it is before a term.
struct Coefficient {
  long numerator = 1;
  long denominator = 1;
};

/// All rewritings of one side, given the sides of its chain (for the letters that occur in it). Where the
/// right coefficient of a term can be calculated, `with_coefficient` and `with_term` are used for the side as
/// a whole; otherwise (`whole_side`) its terms are rewritten like those in brackets. Cost: quadratic in the
/// letters.
[[nodiscard]] std::vector<Rewriting> rewritings_of(TokenView side, const std::vector<TokenView>& chain,
                                                   bool whole_side);
/// A term more in each of the side's brackets: one that stands somewhere in the chain, or an image of one.
[[nodiscard]] std::vector<Rewriting> insertions_of(TokenView side, const std::vector<TokenView>& chain);

/// A term of the side as a whole.
struct SideTerm {
  TokenView tokens;
  TokenView with_sign;  // the sign that was typed before it included
};

/// A side that is 0 has none.
[[nodiscard]] std::vector<SideTerm> terms_of_side(TokenView side);

/// Term `which` of the side `times` as large as it is written: another sign, another number, or left out.
[[nodiscard]] Rewriting with_coefficient(TokenView side, std::size_t which, Coefficient times);

/// The side with a term more, at its end; a side that is 0 becomes the term.
[[nodiscard]] Rewriting with_term(TokenView side, TokenView term, Coefficient times);

/// A term with some of its letters, indices or digits exchanged, turned in a cycle, or replaced by other
/// letters of the chain: what may be next to it. Those that change nothing are left out.
[[nodiscard]] std::vector<Tokens> images_of_term(TokenView term, const std::vector<TokenView>& chain);

/// The symbols of a chain with their faces, without scripts, each once: `\mathbf{A}`, `m`.
[[nodiscard]] std::vector<TokenView> letters_of(const std::vector<TokenView>& chain);
/// X·Y, X×Y, XY and X² of these: the simplest terms that can be missing.
[[nodiscard]] std::vector<Tokens> products_of(const std::vector<TokenView>& letters);

/// What a side has when its brackets and the numerators of its fractions are multiplied out, term by term.
[[nodiscard]] std::vector<Tokens> expanded_terms_of(TokenView side);
/// Where a chain has a `\nabla`: f∇·A, A·∇f, (A·∇)B… of its letters.
[[nodiscard]] std::vector<Tokens> field_terms_of(const std::vector<TokenView>& chain);

/// Products of up to three vectors of a chain, after what comes before vectors in it:
/// m\mathbf{a}\times\mathbf{b}, (A·B)C, A×(B×C).
[[nodiscard]] std::vector<Tokens> vector_products_of(const std::vector<TokenView>& chain);

/// Where the letter of a symbol with its face ends: `\mathbf{A}`, `m`, `\omega`; 0 if no symbol is there.
[[nodiscard]] std::size_t end_of_letter(TokenView tokens);
/// \frac, \nabla, \cos…: a power of it alone means nothing.
[[nodiscard]] bool takes_what_follows(const Token& token);

/// `\mathbf`, `\dot`, `_`: what comes after it without braces is one token.
[[nodiscard]] bool takes_one_token(const Token& token);

/// Without blanks, alignment and line breaks: to be set in another place.
[[nodiscard]] Tokens without_layout(TokenView tokens);

}  // namespace rigor
