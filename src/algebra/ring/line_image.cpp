// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/line_image.h"

#include <cln/integer.h>
#include <cln/rational.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/packed/packed_letters.h"

namespace rigor {
namespace {

constexpr std::uint64_t prime = 2'147'483'647;  // 2^31 - 1: a product of two residues fits into 64 bits

using Image = std::vector<std::uint64_t>;  // the coefficients from t^0 on; the last is not 0

[[nodiscard]] std::uint64_t power(std::uint64_t base, std::uint64_t exponent) {
  std::uint64_t result = 1;
  for (; exponent != 0; exponent /= 2) {
    if (exponent % 2 != 0) result = result * base % prime;
    base = base * base % prime;
  }
  return result;
}

[[nodiscard]] std::uint64_t inverse(std::uint64_t residue) { return power(residue, prime - 2); }

[[nodiscard]] std::uint64_t residue(const cln::cl_I& integer) {
  return cln::cl_I_to_ulong(cln::mod(integer, cln::cl_I(static_cast<unsigned long>(prime))));
}

/// None where the denominator is a multiple of the prime.
[[nodiscard]] std::optional<std::uint64_t> residue(const PackedNumber& number) {
  if (number.is_small()) {
    const auto whole = static_cast<std::int64_t>(prime);
    return static_cast<std::uint64_t>((number.small() % whole + whole) % whole);
  }
  const Rational exact = number.exact();
  const std::uint64_t denominator = residue(cln::denominator(exact));
  if (denominator == 0) return std::nullopt;
  return residue(cln::numerator(exact)) * inverse(denominator) % prime;
}

/// FNV-1a, and the end of SplitMix64: some residue other than 0 for each name. FNV-1a alone keeps differences
/// of names that differ in the last digit, and (a − b)(c − d) looks like a square.
[[nodiscard]] std::uint64_t scattered(std::string_view name, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037U ^ seed;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
  hash ^= hash >> 31U;
  return 1 + (hash >> 20U) % (prime - 1);
}

void multiply_by_line(Image& image, std::uint64_t start, std::uint64_t slope) {
  image.push_back(0);
  for (std::size_t i = image.size(); i-- > 0;) {
    image[i] = (image[i] * start + (i == 0 ? 0 : image[i - 1] * slope)) % prime;
  }
}

void trim(Image& image) {
  while (!image.empty() && image.back() == 0) image.pop_back();
}

/// One image and the degree that the polynomial has in all indeterminates together, which the image has as
/// well unless its highest terms cancel along the line.
struct AlongLine {
  Image image;
  std::size_t degree = 0;
};

/// Where the line begins and how steep it is, in one letter; 0 where that is not known yet.
struct LineInLetter {
  std::uint64_t start = 0;
  std::uint64_t slope = 0;
};

class Line {
 public:
  explicit Line(const PackedLetters& letters) : letters_(letters), in_letters_(letters.count()) {}

  /// Nothing where a denominator is a multiple of the prime.
  [[nodiscard]] std::optional<AlongLine> along(const PackedPolynomial& value) {
    AlongLine sum;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const auto number = residue(value.coefficient(i));
      if (!number) return std::nullopt;
      product_.assign(1, *number);
      value.for_each_power(i, [&](std::size_t letter, int exponent) {
        const LineInLetter& line = in_letter(letter);
        for (int k = 0; k < exponent; ++k) multiply_by_line(product_, line.start, line.slope);
      });
      sum.degree = std::max(sum.degree, product_.size() - 1);
      if (sum.image.size() < product_.size()) sum.image.resize(product_.size(), 0);
      for (std::size_t k = 0; k < product_.size(); ++k) sum.image[k] = (sum.image[k] + product_[k]) % prime;
    }
    trim(sum.image);
    return sum;
  }

 private:
  [[nodiscard]] const LineInLetter& in_letter(std::size_t letter) {
    LineInLetter& line = in_letters_[letter];
    if (line.start == 0) {
      const std::string name = GiNaC::ex_to<GiNaC::symbol>(letters_.at(letter)).get_name();
      line = {scattered(name, 0), scattered(name, 1)};
    }
    return line;
  }

  const PackedLetters& letters_;
  std::vector<LineInLetter> in_letters_;
  Image product_;  // of one term
};

/// What is left of a when it is divided by b, which is not 0.
[[nodiscard]] Image remainder(Image a, const Image& b) {
  const std::uint64_t scale = inverse(b.back());
  while (a.size() >= b.size()) {
    const std::uint64_t factor = prime - a.back() * scale % prime;
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] = (a[shift + i] + factor * b[i]) % prime;
    trim(a);
  }
  return a;
}

[[nodiscard]] Image derivative(const Image& image) {
  Image result;
  for (std::size_t i = 1; i < image.size(); ++i) result.push_back(i * image[i] % prime);
  trim(result);
  return result;
}

[[nodiscard]] bool have_common_factor(Image a, Image b) {
  while (!b.empty()) {
    a = remainder(std::move(a), b);
    std::swap(a, b);
  }
  return a.size() != 1;
}

}  // namespace

bool may_divide(const PackedPolynomial& divisor, const PackedPolynomial& value,
                const PackedLetters& letters) {
  Line line(letters);
  const auto of_divisor = line.along(divisor);
  if (!of_divisor || of_divisor->image.empty()) return true;
  const auto of_value = line.along(value);
  if (!of_value) return true;
  if (of_divisor->degree > of_value->degree && !value.is_zero()) return false;
  return remainder(of_value->image, of_divisor->image).empty();
}

bool may_repeat_a_factor(const GiNaC::ex& value) {
  PackedLetters letters;
  add_letters(letters, value);
  const auto read = read_polynomial(value, letters);
  if (!read) return true;
  const auto of_value = Line(letters).along(read->value);
  // Where the highest terms stay, so do those of each factor: none becomes a number along the line.
  if (!of_value || of_value->image.size() != of_value->degree + 1) return true;
  return have_common_factor(of_value->image, derivative(of_value->image));
}

}  // namespace rigor
