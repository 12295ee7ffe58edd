// SPDX-License-Identifier: GPL-3.0-or-later
// A polynomial as it is written: the sums, products and powers that it was made of. It is multiplied out as a
// packed polynomial, and becomes an expression of GiNaC only where one asks for it: most are only added,
// multiplied and asked whether they are zero, which takes GiNaC a hundred times as long. Each form is found
// once, and kept.
#pragma once

#include <ginac/ex.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "algebra/packed/packed_letters.h"

namespace rigor {

class Numerator {
 public:
  Numerator();  // 0
  Numerator(GiNaC::ex value);
  Numerator(const PackedNumber& value);
  Numerator(int value) : Numerator(PackedNumber(value)) {}
  /// The letters must outlive it.
  Numerator(PackedPolynomial expanded, const PackedLetters& letters);

  /// What GiNaC makes of it, not multiplied out.
  [[nodiscard]] const GiNaC::ex& written() const;
  operator const GiNaC::ex&() const { return written(); }
  /// As it is written: what GiNaC cancels by itself is gone, and nothing else.
  [[nodiscard]] bool is_zero() const;
  /// The same as it is written?
  [[nodiscard]] bool is_equal(const Numerator& other, const PackedLetters& letters) const;
  /// Multiplied out, if it is known to be written so; else none.
  [[nodiscard]] const PackedPolynomial* known_expanded() const;
  /// Multiplied out; none where it is no polynomial, or its degree is too high.
  [[nodiscard]] const PackedPolynomial* packed(const PackedLetters& letters) const;
  /// Multiplied out, and written so.
  [[nodiscard]] Numerator expanded(const PackedLetters& letters) const;

  void add(const Numerator& summand, const PackedLetters& letters);
  [[nodiscard]] Numerator times(const Numerator& factor, const PackedLetters& letters) const;
  [[nodiscard]] Numerator to_power(int exponent, const PackedLetters& letters) const;  // positive
  [[nodiscard]] Numerator negated(const PackedLetters& letters) const;

 private:
  struct Node;
  using Shared = std::shared_ptr<Node>;
  explicit Numerator(Shared node) : node_(std::move(node)) {}

  /// The polynomial, if that is how it is written: a sum of different monomials.
  [[nodiscard]] static const PackedPolynomial* flat(const Node& node, const PackedLetters& letters);
  static void pack(const Node& node, const PackedLetters& letters);
  [[nodiscard]] static std::optional<PackedPolynomial> multiplied_out(const Node& node,
                                                                      const PackedLetters& letters);
  [[nodiscard]] static const GiNaC::ex& written(const Node& node);
  [[nodiscard]] static std::uint64_t image(const Node& node, const PackedLetters& letters);

  Shared node_;
};

}  // namespace rigor
