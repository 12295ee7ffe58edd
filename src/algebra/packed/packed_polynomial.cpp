// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/packed/packed_polynomial.h"

#include <algorithm>
#include <compare>
#include <numeric>

namespace rigor {
namespace {

[[nodiscard]] std::strong_ordering compared(const std::uint64_t* a, const std::uint64_t* b,
                                            std::size_t words) {
  for (std::size_t w = 0; w < words; ++w) {
    if (a[w] != b[w]) return a[w] <=> b[w];
  }
  return std::strong_ordering::equal;
}

/// a/b; false if b does not divide a.
[[nodiscard]] bool divided(const std::uint64_t* a, const std::uint64_t* b, std::span<std::uint64_t> result) {
  constexpr std::uint64_t byte = 0xff;
  for (std::size_t w = 0; w < result.size(); ++w) {
    for (std::uint64_t mask = byte; mask != 0; mask <<= 8U) {
      if ((a[w] & mask) < (b[w] & mask)) return false;
    }
    result[w] = a[w] - b[w];
  }
  return true;
}

}  // namespace

PackedPolynomial::PackedPolynomial(const PackedNumber& number) {
  if (!number.is_zero()) coefficients_.push_back(number);
}

PackedPolynomial::PackedPolynomial(const PackedNumber& number,
                                   std::span<const std::pair<std::size_t, int>> powers_of_variables) {
  if (number.is_zero()) return;
  coefficients_.push_back(number);
  for (const auto& [variable, exponent] : powers_of_variables) {
    const std::size_t word = variable / exponents_in_word;
    if (word >= words_) words_ = word + 1;
    exponents_.resize(words_);
    exponents_[word] += static_cast<std::uint64_t>(exponent)
                        << (variable % exponents_in_word * exponent_bits);
    degree_ += exponent;
  }
}

PackedPolynomial::PackedPolynomial(Terms terms) : coefficients_(std::move(terms.numbers)) {
  for (const auto& [variable, exponent] : terms.powers)
    words_ = std::max(words_, variable / exponents_in_word + 1);
  exponents_.resize(size() * words_, 0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    int degree = 0;
    for (; next < terms.ends[i]; ++next) {
      const auto [variable, exponent] = terms.powers[next];
      exponents_[i * words_ + variable / exponents_in_word] +=
          static_cast<std::uint64_t>(exponent) << (variable % exponents_in_word * exponent_bits);
      degree += exponent;
    }
    degree_ = std::max(degree_, degree);
  }
  combine();
}

bool PackedPolynomial::is_constant(std::size_t term) const {
  return std::all_of(monomial(term), monomial(term) + words_, [](std::uint64_t word) { return word == 0; });
}

void PackedPolynomial::widen(std::size_t words) {
  if (words <= words_) return;
  std::vector<std::uint64_t> wider(size() * words, 0);
  for (std::size_t i = 0; i < size(); ++i) std::copy_n(monomial(i), words_, wider.data() + i * words);
  words_ = words;
  exponents_ = std::move(wider);
}

void PackedPolynomial::reverse() {
  std::ranges::reverse(coefficients_);
  for (std::size_t i = 0; i + i + 1 < size(); ++i) {
    std::swap_ranges(exponents_.data() + i * words_, exponents_.data() + (i + 1) * words_,
                     exponents_.data() + (size() - 1 - i) * words_);
  }
}

void PackedPolynomial::append(const PackedPolynomial& from, std::size_t term) {
  exponents_.insert(exponents_.end(), from.monomial(term), from.monomial(term) + words_);
  coefficients_.push_back(from.coefficients_[term]);
}

int PackedPolynomial::degree_in(std::size_t variable) const {
  int highest = 0;
  for (std::size_t i = 0; i < size(); ++i) highest = std::max(highest, exponent(i, variable));
  return highest;
}

std::vector<int> PackedPolynomial::degrees(std::size_t variables) const {
  std::vector<int> highest(variables, 0);
  for (std::size_t i = 0; i < size(); ++i) {
    for_each_power(i, [&](std::size_t x, int exponent) { highest[x] = std::max(highest[x], exponent); });
  }
  return highest;
}

PackedPolynomial PackedPolynomial::coefficient_of(std::size_t variable, int wanted) const {
  PackedPolynomial result;
  result.words_ = words_;
  result.degree_ = degree_ - wanted;
  for (std::size_t i = 0; i < size(); ++i) {
    if (exponent(i, variable) != wanted) continue;
    result.append(*this, i);
    if (wanted == 0) continue;
    const std::size_t word = variable / exponents_in_word;
    const std::size_t shift = variable % exponents_in_word * exponent_bits;
    result.exponents_[result.exponents_.size() - words_ + word] -= static_cast<std::uint64_t>(wanted)
                                                                   << shift;
  }
  return result;
}

void PackedPolynomial::append(const PackedPolynomial& more) {
  degree_ = std::max(degree_, more.degree_);
  coefficients_.insert(coefficients_.end(), more.coefficients_.begin(), more.coefficients_.end());
  if (more.words_ == words_) {
    exponents_.insert(exponents_.end(), more.exponents_.begin(), more.exponents_.end());
    return;
  }
  for (std::size_t i = 0; i < more.size(); ++i) {
    const auto first = more.exponents_.begin() + static_cast<std::ptrdiff_t>(i * more.words_);
    exponents_.insert(exponents_.end(), first, first + static_cast<std::ptrdiff_t>(more.words_));
    exponents_.resize(exponents_.size() + words_ - more.words_, 0);
  }
}

/// Sorts the terms, and makes one of those with the same monomial.
void PackedPolynomial::combine() {
  std::vector<std::uint32_t> order(size());
  std::iota(order.begin(), order.end(), 0U);
  const std::uint64_t* const from = exponents_.data();
  if (words_ == 1) {
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(from[i], i); });
  } else {
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
      const auto result = compared(from + a * words_, from + b * words_, words_);
      return result == 0 ? a < b : result < 0;
    });
  }
  std::vector<std::uint64_t> exponents;
  std::vector<PackedNumber> coefficients;
  exponents.reserve(exponents_.size());
  coefficients.reserve(size());
  for (std::size_t i = 0; i < order.size();) {
    const std::uint64_t* const monomial = from + order[i] * words_;
    PackedNumber sum = std::move(coefficients_[order[i++]]);
    for (; i < order.size() && compared(from + order[i] * words_, monomial, words_) == 0; ++i)
      sum += coefficients_[order[i]];
    if (sum.is_zero()) continue;
    exponents.insert(exponents.end(), monomial, monomial + words_);
    coefficients.push_back(std::move(sum));
  }
  exponents_ = std::move(exponents);
  coefficients_ = std::move(coefficients);
}

PackedPolynomial PackedPolynomial::sum(std::span<const PackedPolynomial* const> summands) {
  PackedPolynomial total;
  std::size_t terms = 0;
  for (const PackedPolynomial* each : summands) {
    total.words_ = std::max(total.words_, each->words_);
    terms += each->size();
  }
  total.exponents_.reserve(terms * total.words_);
  total.coefficients_.reserve(terms);
  for (const PackedPolynomial* each : summands) total.append(*each);
  total.combine();
  return total;
}

/// Both are in order: one pass.
PackedPolynomial operator+(const PackedPolynomial& a, const PackedPolynomial& b) {
  if (a.words_ < b.words_) return b + a;
  if (b.words_ < a.words_) {
    PackedPolynomial wider = b;
    wider.widen(a.words_);
    return a + wider;
  }
  PackedPolynomial total;
  total.words_ = a.words_;
  total.degree_ = std::max(a.degree_, b.degree_);
  total.exponents_.reserve((a.size() + b.size()) * a.words_);
  total.coefficients_.reserve(a.size() + b.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    auto order = std::strong_ordering::greater;
    for (; k < b.size(); total.append(b, k++)) {
      order = compared(b.monomial(k), a.monomial(i), a.words_);
      if (order >= 0) break;
    }
    total.append(a, i);
    if (k == b.size() || order != 0) continue;
    total.coefficients_.back() += b.coefficients_[k++];
    if (!total.coefficients_.back().is_zero()) continue;
    total.coefficients_.pop_back();
    total.exponents_.resize(total.exponents_.size() - a.words_);
  }
  for (; k < b.size(); ++k) total.append(b, k);
  return total;
}

PackedPolynomial operator*(const PackedPolynomial& a, const PackedPolynomial& b) {
  PackedPolynomial product;
  if (a.is_zero() || b.is_zero()) return product;
  product.words_ = std::max(a.words_, b.words_);
  product.degree_ = a.degree_ + b.degree_;
  product.exponents_.resize(a.size() * b.size() * product.words_, 0);
  product.coefficients_.reserve(a.size() * b.size());
  std::uint64_t* monomial = product.exponents_.data();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::uint64_t* const of_a = a.exponents_.data() + i * a.words_;
    for (std::size_t k = 0; k < b.size(); ++k, monomial += product.words_) {
      const std::uint64_t* const of_b = b.exponents_.data() + k * b.words_;
      std::copy_n(of_a, a.words_, monomial);
      for (std::size_t w = 0; w < b.words_; ++w) monomial[w] += of_b[w];
      product.coefficients_.push_back(a.coefficients_[i] * b.coefficients_[k]);
    }
  }
  if (a.size() > 1 && b.size() > 1) product.combine();
  return product;
}

PackedPolynomial operator-(PackedPolynomial a) {
  for (PackedNumber& each : a.coefficients_) each = -each;
  return a;
}

void PackedPolynomial::push(std::span<const std::uint64_t> monomial, PackedNumber coefficient) {
  exponents_.insert(exponents_.end(), monomial.begin(), monomial.end());
  coefficients_.push_back(std::move(coefficient));
  int degree = 0;
  for_each_power(size() - 1, [&](std::size_t, int exponent) { degree += exponent; });
  degree_ = std::max(degree_, degree);
}

/// The first `count` terms less term · divisor without its last term, which has cancelled.
PackedPolynomial PackedPolynomial::less(std::size_t count, std::span<const std::uint64_t> monomial,
                                        const PackedNumber& coefficient,
                                        const PackedPolynomial& divisor) const {
  PackedPolynomial rest;
  rest.words_ = words_;
  rest.degree_ = degree_;
  rest.exponents_.reserve((count + divisor.size()) * words_);
  rest.coefficients_.reserve(count + divisor.size());
  const auto keep = [&](const std::uint64_t* which, PackedNumber number) {
    rest.exponents_.insert(rest.exponents_.end(), which, which + words_);
    rest.coefficients_.push_back(std::move(number));
  };
  const PackedNumber factor = -coefficient;
  std::vector<std::uint64_t> product(words_);
  std::size_t next = 0;
  for (std::size_t k = 0; k + 1 < divisor.size(); ++k) {
    for (std::size_t w = 0; w < words_; ++w) product[w] = divisor.monomial(k)[w] + monomial[w];
    auto order = std::strong_ordering::greater;
    for (; next < count; ++next) {
      order = compared(this->monomial(next), product.data(), words_);
      if (order >= 0) break;
      keep(this->monomial(next), coefficients_[next]);
    }
    PackedNumber number = factor * divisor.coefficients_[k];
    if (next < count && order == 0) number += coefficients_[next++];
    if (!number.is_zero()) keep(product.data(), std::move(number));
  }
  for (; next < count; ++next) keep(this->monomial(next), coefficients_[next]);
  return rest;
}

/// By last terms: the last of a product is the product of the factors' last.
std::optional<PackedPolynomial> exact_quotient(PackedPolynomial value, PackedPolynomial divisor) {
  const std::size_t words = std::max(value.words_, divisor.words_);
  value.widen(words);
  divisor.widen(words);
  const std::size_t last = divisor.size() - 1;
  PackedPolynomial whole;  // from the last term on
  whole.words_ = words;
  std::vector<std::uint64_t> monomial(words);
  for (std::size_t terms = value.size(); terms > 0; terms = value.size()) {
    // One term after the other, if the divisor is one; else what is left changes.
    for (std::size_t i = terms; i-- > 0;) {
      if (!divided(value.monomial(i), divisor.monomial(last), monomial)) return std::nullopt;
      const PackedNumber number = value.coefficients_[i] / divisor.coefficients_[last];
      whole.push(monomial, number);
      if (last == 0) continue;
      value = value.less(i, monomial, number, divisor);
      break;
    }
    if (last == 0) break;
  }
  whole.reverse();
  return whole;
}

bool operator==(const PackedPolynomial& a, const PackedPolynomial& b) {
  if (a.coefficients_ != b.coefficients_) return false;
  if (a.words_ == b.words_) return a.exponents_ == b.exponents_;
  return (a + -b).is_zero();
}

PackedPolynomial power(const PackedPolynomial& base, int exponent) {
  PackedPolynomial result = base;
  for (int i = 1; i < exponent; ++i) result = result * base;
  return result;
}

}  // namespace rigor
