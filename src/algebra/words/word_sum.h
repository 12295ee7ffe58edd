// SPDX-License-Identifier: GPL-3.0-or-later
// Operators as a free associative algebra: sums of words, each with a coefficient that commutes with all.
// Two sums are equal for all operators exactly if each word has the same coefficient in both.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "algebra/words/coefficient.h"

namespace rigor {

/// An operator, its adjoint, its transpose or its inverse. `component` counts from 1; 0: it is no component.
struct Letter {
  SymbolId symbol{};
  std::uint8_t component = 0;
  bool inverse = false;
  bool adjoint = false;
  bool transpose = false;
  friend auto operator<=>(const Letter&, const Letter&) = default;
};

using Word = std::vector<Letter>;

/// Longer words are greater; of one length the order is that of the letters. Rules lead to smaller words, of
/// which there are finitely many.
struct IsSmallerWord {
  [[nodiscard]] bool operator()(const Word& a, const Word& b) const {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  }
};

/// No coefficient is empty.
using WordSum = std::map<Word, Coefficient, IsSmallerWord>;

[[nodiscard]] WordSum scalar(Coefficient value);
void add_to(WordSum& into, const WordSum& more);
[[nodiscard]] WordSum times(const WordSum& a, const WordSum& b);
[[nodiscard]] WordSum opposite(const WordSum& a);
/// (AB)† = B†A†, and numbers are conjugated.
[[nodiscard]] WordSum adjoint(const WordSum& a, CommutingParts& parts);
/// (AB)ᵀ = BᵀAᵀ
[[nodiscard]] WordSum transpose(const WordSum& a);
[[nodiscard]] Word transpose(const Word& word);
/// u·a·v
[[nodiscard]] WordSum between(const Word& u, const WordSum& a, const Word& v);

}  // namespace rigor
