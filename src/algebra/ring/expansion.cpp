// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/expansion.h"

#include <cln/rational.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rigor {
namespace {

using cln::cl_RA;
using GiNaC::ex;

constexpr int exponent_bits = 8;
constexpr int largest_packed_exponent = (1 << exponent_bits) - 1;
constexpr std::size_t exponents_in_word = 64 / exponent_bits;

/// The symbols of an expression in the order of their first occurrence, found again by their hash.
class Variables {
 public:
  /// False if the expression is no polynomial, or has too high an exponent.
  [[nodiscard]] bool collect(const ex& value) { return degree(value) <= largest_packed_exponent; }
  [[nodiscard]] std::size_t count() const { return symbols_.size(); }
  [[nodiscard]] const ex& symbol(std::size_t position) const { return symbols_[position]; }
  [[nodiscard]] std::size_t position(const ex& symbol) const {
    for (auto [at, end] = by_hash_.equal_range(symbol.gethash()); at != end; ++at) {
      if (symbols_[at->second].is_equal(symbol)) return at->second;
    }
    return symbols_.size();
  }

 private:
  static constexpr int no_polynomial = largest_packed_exponent + 1;

  /// A bound of the total degree. Recursion: as deep as the expression, whose depth is bounded.
  [[nodiscard]] int degree(const ex& value) {
    if (GiNaC::is_exactly_a<GiNaC::symbol>(value)) {
      if (position(value) == symbols_.size()) {
        by_hash_.emplace(value.gethash(), symbols_.size());
        symbols_.push_back(value);
      }
      return 1;
    }
    if (GiNaC::is_exactly_a<GiNaC::numeric>(value)) {
      return GiNaC::ex_to<GiNaC::numeric>(value).is_rational() ? 0 : no_polynomial;
    }
    if (GiNaC::is_exactly_a<GiNaC::power>(value)) {
      const ex exponent = value.op(1);
      if (!GiNaC::is_exactly_a<GiNaC::numeric>(exponent)) return no_polynomial;
      const auto& count = GiNaC::ex_to<GiNaC::numeric>(exponent);
      if (!count.is_pos_integer() || count > largest_packed_exponent) return no_polynomial;
      return limited(degree(value.op(0)) * count.to_int());
    }
    const bool is_sum = GiNaC::is_exactly_a<GiNaC::add>(value);
    if (!is_sum && !GiNaC::is_exactly_a<GiNaC::mul>(value)) return no_polynomial;
    int total = 0;
    for (std::size_t i = 0; i < value.nops() && total < no_polynomial; ++i) {
      const int more = degree(value.op(i));
      total = limited(is_sum ? std::max(total, more) : total + more);
    }
    return total;
  }
  [[nodiscard]] static int limited(int degree) { return std::min(degree, no_polynomial); }

  std::vector<ex> symbols_;
  std::unordered_multimap<unsigned, std::size_t> by_hash_;
};

/// The exponents of up to `words` × 8 symbols. The order is kept by multiplication.
template <std::size_t words>
struct Monomial {
  std::array<std::uint64_t, words> packed{};

  friend auto operator<=>(const Monomial&, const Monomial&) = default;
  friend Monomial operator*(Monomial a, const Monomial& b) {
    for (std::size_t i = 0; i < words; ++i) a.packed[i] += b.packed[i];
    return a;
  }
  void set(std::size_t variable, int exponent) {
    packed[variable / exponents_in_word] = static_cast<std::uint64_t>(exponent) << shift(variable);
  }
  [[nodiscard]] int exponent(std::size_t variable) const {
    return static_cast<int>(packed[variable / exponents_in_word] >> shift(variable)) &
           largest_packed_exponent;
  }

 private:
  [[nodiscard]] static int shift(std::size_t variable) {
    return static_cast<int>(variable % exponents_in_word) * exponent_bits;
  }
};

/// A sum of terms with different monomials, in their order, and coefficients that are not 0.
template <std::size_t words>
class Polynomial {
 public:
  Polynomial() = default;
  Polynomial(const Monomial<words>& monomial, const cl_RA& coefficient) {
    if (!cln::zerop(coefficient)) terms_.push_back({monomial, coefficient});
  }

  void append(Polynomial&& more) {
    terms_.insert(terms_.end(), std::make_move_iterator(more.terms_.begin()),
                  std::make_move_iterator(more.terms_.end()));
  }
  /// To be called after what was appended.
  void combine() {
    std::ranges::sort(terms_, {}, &Term::monomial);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < terms_.size();) {
      Term sum = std::move(terms_[i++]);
      for (; i < terms_.size() && terms_[i].monomial == sum.monomial; ++i)
        sum.coefficient = sum.coefficient + terms_[i].coefficient;
      if (!cln::zerop(sum.coefficient)) terms_[kept++] = std::move(sum);
    }
    terms_.resize(kept);
  }

  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product;
    product.terms_.reserve(a.terms_.size() * b.terms_.size());
    for (const Term& x : a.terms_) {
      for (const Term& y : b.terms_)
        product.terms_.push_back({x.monomial * y.monomial, x.coefficient * y.coefficient});
    }
    if (a.terms_.size() > 1 && b.terms_.size() > 1) product.combine();
    return product;
  }

  [[nodiscard]] ex to_ex(const Variables& variables) const {
    cl_RA constant = 0;
    GiNaC::epvector summands;
    summands.reserve(terms_.size());
    for (const Term& term : terms_) {
      const ex product = to_ex(term.monomial, variables);
      if (product.is_equal(1)) {
        constant = term.coefficient;
      } else {
        summands.emplace_back(product, GiNaC::numeric(term.coefficient));
      }
    }
    return GiNaC::dynallocate<GiNaC::add>(std::move(summands), GiNaC::numeric(constant));
  }

 private:
  struct Term {
    Monomial<words> monomial;
    cl_RA coefficient;
  };

  [[nodiscard]] static ex to_ex(const Monomial<words>& monomial, const Variables& variables) {
    GiNaC::epvector factors;
    for (std::size_t i = 0; i < variables.count(); ++i) {
      if (const int exponent = monomial.exponent(i); exponent > 0)
        factors.emplace_back(variables.symbol(i), exponent);
    }
    return GiNaC::dynallocate<GiNaC::mul>(std::move(factors), ex(1));
  }

  std::vector<Term> terms_;
};

/// Recursion: as deep as the expression.
template <std::size_t words>
[[nodiscard]] Polynomial<words> to_polynomial(const ex& value, const Variables& variables) {
  if (GiNaC::is_exactly_a<GiNaC::symbol>(value)) {
    Monomial<words> monomial;
    monomial.set(variables.position(value), 1);
    return {monomial, 1};
  }
  if (GiNaC::is_exactly_a<GiNaC::numeric>(value)) {
    return {{}, cln::the<cl_RA>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N())};
  }
  if (GiNaC::is_exactly_a<GiNaC::power>(value)) {
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(value.op(1)).to_int();
    if (const ex base = value.op(0); GiNaC::is_exactly_a<GiNaC::symbol>(base)) {
      Monomial<words> monomial;
      monomial.set(variables.position(base), exponent);
      return {monomial, 1};
    }
    const Polynomial<words> base = to_polynomial<words>(value.op(0), variables);
    Polynomial<words> result = base;
    for (int i = 1; i < exponent; ++i) result = result * base;
    return result;
  }
  if (GiNaC::is_exactly_a<GiNaC::add>(value)) {
    Polynomial<words> sum;
    for (std::size_t i = 0; i < value.nops(); ++i) sum.append(to_polynomial<words>(value.op(i), variables));
    sum.combine();
    return sum;
  }
  Polynomial<words> product({}, 1);
  for (std::size_t i = 0; i < value.nops(); ++i) {
    product = product * to_polynomial<words>(value.op(i), variables);
  }
  return product;
}

}  // namespace

ex expanded_polynomial(const ex& value) {
  if (GiNaC::is_exactly_a<GiNaC::symbol>(value) || GiNaC::is_exactly_a<GiNaC::numeric>(value)) return value;
  Variables variables;
  if (!variables.collect(value)) return value.expand();
  const auto expand = [&]<std::size_t words>(std::integral_constant<std::size_t, words>) {
    return to_polynomial<words>(value, variables).to_ex(variables);
  };
  const std::size_t words = (variables.count() + exponents_in_word - 1) / exponents_in_word;
  if (words <= 1) return expand(std::integral_constant<std::size_t, 1>());
  if (words <= 2) return expand(std::integral_constant<std::size_t, 2>());
  if (words <= 4) return expand(std::integral_constant<std::size_t, 4>());
  if (words <= 16) return expand(std::integral_constant<std::size_t, 16>());
  return value.expand();
}

}  // namespace rigor
