// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/line_image.h"

#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/engine/terms.h"

namespace rigor {
namespace {

using GiNaC::ex;

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
[[nodiscard]] std::optional<std::uint64_t> residue(const ex& number) {
  const GiNaC::numeric& value = GiNaC::ex_to<GiNaC::numeric>(number);
  if (!value.is_rational()) return std::nullopt;
  const cln::cl_RA exact = cln::the<cln::cl_RA>(value.to_cl_N());
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

/// Of a product of a number and powers of indeterminates; false where there is anything else.
[[nodiscard]] bool add_term(AlongLine& sum, const ex& term) {
  Image product = {1};
  for (const ex& factor : factors_of(term)) {
    if (is_number(factor)) {
      const auto number = residue(factor);
      if (!number) return false;
      for (std::uint64_t& each : product) each = each * *number % prime;
      continue;
    }
    const bool is_power = GiNaC::is_a<GiNaC::power>(factor);
    const ex base = is_power ? factor.op(0) : factor;
    if (!GiNaC::is_a<GiNaC::symbol>(base)) return false;
    if (is_power && !factor.op(1).info(GiNaC::info_flags::posint)) return false;
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(base).get_name();
    const int exponent = is_power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    for (int i = 0; i < exponent; ++i) multiply_by_line(product, scattered(name, 0), scattered(name, 1));
  }
  sum.degree = std::max(sum.degree, product.size() - 1);
  if (sum.image.size() < product.size()) sum.image.resize(product.size(), 0);
  for (std::size_t i = 0; i < product.size(); ++i) sum.image[i] = (sum.image[i] + product[i]) % prime;
  return true;
}

[[nodiscard]] std::optional<AlongLine> along_line(const ex& expanded) {
  AlongLine sum;
  for (const ex& term : terms_of(expanded)) {
    if (!add_term(sum, term)) return std::nullopt;
  }
  trim(sum.image);
  return sum;
}

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

bool may_divide(const ex& divisor, const ex& value) {
  const auto of_divisor = along_line(divisor);
  if (!of_divisor || of_divisor->image.empty()) return true;
  const auto of_value = along_line(value);
  if (!of_value) return true;
  if (of_divisor->degree > of_value->degree && !value.is_zero()) return false;
  return remainder(of_value->image, of_divisor->image).empty();
}

bool may_repeat_a_factor(const ex& value) {
  const auto of_value = along_line(value);
  // Where the highest terms stay, so do those of each factor: none becomes a number along the line.
  if (!of_value || of_value->image.size() != of_value->degree + 1) return true;
  return have_common_factor(of_value->image, derivative(of_value->image));
}

}  // namespace rigor
