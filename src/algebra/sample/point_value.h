// SPDX-License-Identifier: GPL-3.0-or-later
// Values on a sample: a rational number plus rational multiples of quantities that are known only through
// functions of them: angles, whose half has a rational tangent, and logarithms of rational numbers. What is
// none of these, a root of 2 say, lies between two rational numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/engine/enclosure.h"

namespace rigor {

/// What the number t of a sample stands for.
struct Meaning {
  enum class Kind : std::uint8_t { itself, angle, logarithm };  // t; 2k arctan t; k log t
  Kind kind = Kind::itself;
  int multiple = 1;  // k
  friend bool operator==(const Meaning&, const Meaning&) = default;
};

struct PointValue {
  struct Part {
    Rational factor;
    Rational number;  // t
    Meaning meaning;
    std::size_t place = 0;  // in the sample: which t
  };

  Rational rational = 0;
  std::vector<Part> parts = {};            // by place, factors not 0
  std::optional<Enclosure> enclosed = {};  // then the others are not meant

  PointValue() = default;
  PointValue(Rational value) : rational(std::move(value)) {}  // NOLINT: meant to convert
  PointValue(int value) : rational(value) {}                  // NOLINT: meant to convert
  explicit PointValue(Enclosure bounds) : enclosed(std::move(bounds)) {}
};

[[nodiscard]] inline bool is_rational(const PointValue& value) {
  return value.parts.empty() && !value.enclosed;
}
/// The rational number; throws PointRejected if it is none.
[[nodiscard]] const Rational& rational_of(const PointValue& value);
[[nodiscard]] Enclosure enclosure_of(const PointValue& value);
/// Throws ValuesTooNear where two enclosures overlap.
[[nodiscard]] bool is_related(const PointValue& left, Relation relation, const PointValue& right);
void add(PointValue& total, const PointValue& summand);
[[nodiscard]] PointValue scaled(PointValue value, const Rational& factor);

/// cos and sin of a sum of multiples of angles; nothing where they are not known to be rational.
struct CosineAndSine {
  Rational cosine = 1;
  Rational sine = 0;
};
[[nodiscard]] std::optional<CosineAndSine> cosine_and_sine(const PointValue& angle);
[[nodiscard]] std::optional<Rational> exponential(const PointValue& value);

/// `3/2`; where it is not rational, a decimal, `0.693147`.
[[nodiscard]] std::string to_text(const PointValue& value);

/// `2*arctan(1/2)`, `log(3)`, and back; plain numbers as they are.
[[nodiscard]] std::string to_text(const Rational& number, const Meaning& meaning);
struct ReadNumber {
  Rational number;
  Meaning meaning;
};
[[nodiscard]] std::optional<ReadNumber> read_number(std::string_view text);

}  // namespace rigor
