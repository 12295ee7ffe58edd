// SPDX-License-Identifier: GPL-3.0-or-later
// The slips of the pen that make a false twin of a true statement, each an edit of the text as it was typed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor::twins {

enum class Slip : std::uint8_t {
  sign,             // + for -, a minus in front
  indices_swapped,  // two letters or two digits of one subscript
  index_replaced,   // by another one that occurs in the statement
  order,            // of the operands of one cross product
  factor,           // 2 or 1/2 on one term
  term_dropped,
  power,  // a square to the first or third power
  cross_to_dot,
  bars_dropped,  // brackets instead
  // of `further_slips_of`
  indices_exchanged,  // of neighbouring factors
  terms_exchanged,    // neighbouring ones, their signs stay
  letters_exchanged,  // neighbouring ones with one face
  letter_replaced,    // by another one of the statement
  prime,              // one more, or one less
  dot,                // the same
  function,           // \cos for \sin
  square_added,
  fraction_inverted,
  denominator,     // a number more or less in it
  factor_dropped,  // a letter
};
inline constexpr std::size_t slip_count = 20;

[[nodiscard]] std::string_view name_of(Slip slip);

/// `span` of the notes is replaced by `text`.
struct Edit {
  Slip slip;
  Span span;
  std::string text;
};

/// All edits of one side, given the statement's sides (for the indices that occur in it). No two are alike,
/// none changes nothing.
[[nodiscard]] std::vector<Edit> slips_of(const SourceMap& sources, TokenView side,
                                         const std::vector<TokenView>& statement);

/// The edited text; `text` begins where the file's byte `offset` stands.
[[nodiscard]] std::string with_edit(std::string_view text, std::uint32_t offset, const Edit& edit);

}  // namespace rigor::twins
