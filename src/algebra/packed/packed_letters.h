// SPDX-License-Identifier: GPL-3.0-or-later
// The symbols of GiNaC that the variables of packed polynomials stand for, and polynomials from and to
// expressions.
#pragma once

#include <ginac/ex.h>

#include <optional>
#include <unordered_map>
#include <vector>

#include "algebra/packed/packed_polynomial.h"

namespace rigor {

class PackedLetters {
 public:
  /// Adds a symbol that is not among them.
  void add(const GiNaC::ex& symbol);
  [[nodiscard]] const GiNaC::ex& at(std::size_t position) const { return symbols_[position]; }
  [[nodiscard]] std::size_t count() const { return symbols_.size(); }
  /// `count()` if it is not among them.
  [[nodiscard]] std::size_t position(const GiNaC::ex& symbol) const;

 private:
  std::vector<GiNaC::ex> symbols_;
  std::unordered_multimap<unsigned, std::size_t> by_hash_;
};

/// Adds the symbols of a polynomial in the order of their occurrence.
void add_letters(PackedLetters& letters, const GiNaC::ex& value);

struct ReadPolynomial {
  PackedPolynomial value;
  bool is_expanded = true;  // as it was written
};

/// An expression of these symbols and rational numbers with +, × and whole powers, multiplied out. Nothing
/// where it is anything else, or has too high a degree.
[[nodiscard]] std::optional<ReadPolynomial> read_polynomial(const GiNaC::ex& value,
                                                            const PackedLetters& letters);

/// As GiNaC would have it after `expand`.
[[nodiscard]] GiNaC::ex to_ex(const PackedPolynomial& value, const PackedLetters& letters);

}  // namespace rigor
