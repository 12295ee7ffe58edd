// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/packed/packed_letters.h"

#include <ginac/ginac.h>

#include <typeinfo>
#include <utility>

namespace rigor {
namespace {

using GiNaC::ex;

enum class NodeKind : std::uint8_t { symbol, number, power, product, sum, other };

/// By the address of the type's description: to compare descriptions, as GiNaC does, is to compare their
/// names. A second description of a type would be taken for `other`.
[[nodiscard]] NodeKind kind_of(const ex& value) {
  const std::type_info* const type = &typeid(GiNaC::ex_to<GiNaC::basic>(value));
  if (type == &typeid(GiNaC::symbol)) return NodeKind::symbol;
  if (type == &typeid(GiNaC::numeric)) return NodeKind::number;
  if (type == &typeid(GiNaC::power)) return NodeKind::power;
  if (type == &typeid(GiNaC::mul)) return NodeKind::product;
  if (type == &typeid(GiNaC::add)) return NodeKind::sum;
  return NodeKind::other;
}

/// What sums and products hold, without the expression that `op` makes of each part: c·t as (t, c), x^n as
/// (x, n), and a number.
struct SequenceAccess : GiNaC::expairseq {
  [[nodiscard]] static const GiNaC::epvector& pairs(const ex& value) {
    return GiNaC::ex_to<GiNaC::expairseq>(value).*(&SequenceAccess::seq);
  }
  [[nodiscard]] static const ex& number(const ex& value) {
    return GiNaC::ex_to<GiNaC::expairseq>(value).*(&SequenceAccess::overall_coeff);
  }
};

class PolynomialReader {
 public:
  explicit PolynomialReader(const PackedLetters& letters) : letters_(letters) {}

  /// Recursion: as deep as the expression, whose depth is bounded.
  [[nodiscard]] std::optional<PackedPolynomial> read(const ex& value) {
    if (kind_of(value) != NodeKind::sum) return read_term(value);
    PackedPolynomial::Terms terms;
    std::vector<PackedPolynomial> sums;  // what is not expanded
    const auto add = [&](const ex& term, const ex& number) {
      OpenTerm open{terms.powers.size(), 0, 1, {}};
      if (!multiply(open, terms, term, 1) || !multiply(open, terms, number, 1)) return false;
      if (open.sums.empty()) {
        close(open, terms);
        return true;
      }
      auto product = multiplied_out(open, terms);
      if (product) sums.push_back(std::move(*product));
      return product.has_value();
    };
    for (const GiNaC::expair& pair : SequenceAccess::pairs(value)) {
      if (!add(pair.rest, pair.coeff)) return std::nullopt;
    }
    if (!add(ex(1), SequenceAccess::number(value))) return std::nullopt;
    PackedPolynomial expanded(std::move(terms));
    if (sums.empty()) return expanded;
    std::vector<const PackedPolynomial*> summands{&expanded};
    for (const PackedPolynomial& each : sums) summands.push_back(&each);
    return PackedPolynomial::sum(summands);
  }
  [[nodiscard]] bool is_expanded() const { return is_expanded_; }

 private:
  [[nodiscard]] static std::optional<PackedNumber> read_number(const ex& value) {
    if (kind_of(value) != NodeKind::number) return std::nullopt;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(value);
    if (!number.is_rational()) return std::nullopt;
    return PackedNumber(cln::the<Rational>(number.to_cl_N()));
  }
  [[nodiscard]] static std::optional<int> read_exponent(const ex& value) {
    constexpr std::uintptr_t most_bits = 8;
    if (kind_of(value) != NodeKind::number) return std::nullopt;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(value);
    if (!number.is_integer()) return std::nullopt;
    const auto whole = cln::the<cln::cl_I>(number.to_cl_N());
    if (!cln::plusp(whole) || cln::integer_length(whole) > most_bits) return std::nullopt;
    return cln::cl_I_to_int(whole);
  }

  /// One term while its factors are read.
  struct OpenTerm {
    std::size_t begin = 0;  // of its powers
    int degree = 0;
    PackedNumber number = 1;
    std::vector<PackedPolynomial> sums = {};  // among the factors
  };

  static void close(const OpenTerm& term, PackedPolynomial::Terms& terms) {
    if (term.number.is_zero()) {
      terms.powers.resize(term.begin);
      return;
    }
    terms.numbers.push_back(term.number);
    terms.ends.push_back(terms.powers.size());
  }

  /// A term with sums among its factors; its powers are taken from the others'.
  [[nodiscard]] static std::optional<PackedPolynomial> multiplied_out(const OpenTerm& term,
                                                                      PackedPolynomial::Terms& terms) {
    PackedPolynomial product(term.number, std::span(terms.powers).subspan(term.begin));
    terms.powers.resize(term.begin);
    for (const PackedPolynomial& sum : term.sums) {
      if (product.degree_bound() + sum.degree_bound() > PackedPolynomial::largest_degree) return std::nullopt;
      product = product * sum;
    }
    return product;
  }

  [[nodiscard]] std::optional<PackedPolynomial> read_term(const ex& value) {
    PackedPolynomial::Terms terms;
    OpenTerm open;
    if (!multiply(open, terms, value, 1)) return std::nullopt;
    return multiplied_out(open, terms);
  }

  /// Takes base^exponent into a term; false where that is no part of a polynomial.
  [[nodiscard]] bool multiply(OpenTerm& term, PackedPolynomial::Terms& terms, const ex& base, int exponent) {
    switch (kind_of(base)) {
      case NodeKind::symbol: {
        const std::size_t position = letters_.position(base);
        term.degree += exponent;
        if (position == letters_.count() || term.degree > PackedPolynomial::largest_degree) return false;
        terms.powers.emplace_back(position, exponent);
        return true;
      }
      case NodeKind::number: {
        const auto number = read_number(base);
        if (!number) return false;
        for (int i = 0; i < exponent; ++i) term.number = term.number * *number;
        return true;
      }
      case NodeKind::power: {
        const auto inner = read_exponent(base.op(1));
        if (!inner || *inner * exponent > PackedPolynomial::largest_degree) return false;
        return multiply(term, terms, base.op(0), *inner * exponent);
      }
      case NodeKind::product: {
        for (const GiNaC::expair& pair : SequenceAccess::pairs(base)) {
          const auto inner = read_exponent(pair.coeff);
          if (!inner || *inner * exponent > PackedPolynomial::largest_degree) return false;
          if (!multiply(term, terms, pair.rest, *inner * exponent)) return false;
        }
        return multiply(term, terms, SequenceAccess::number(base), exponent);
      }
      case NodeKind::sum: {
        is_expanded_ = false;
        const auto sum = read(base);
        if (!sum || sum->degree_bound() * exponent > PackedPolynomial::largest_degree) return false;
        term.sums.push_back(power(*sum, exponent));
        return true;
      }
      case NodeKind::other:
        break;
    }
    return false;
  }

  const PackedLetters& letters_;
  bool is_expanded_ = true;
};

[[nodiscard]] ex monomial_of(const PackedPolynomial& value, std::size_t term, const PackedLetters& letters) {
  GiNaC::epvector factors;
  value.for_each_power(term, [&](std::size_t variable, int exponent) {
    factors.emplace_back(letters.at(variable), exponent);
  });
  if (factors.empty()) return 1;
  if (factors.size() == 1 && factors[0].coeff.is_equal(1)) return factors[0].rest;
  return GiNaC::dynallocate<GiNaC::mul>(std::move(factors), ex(1));
}

}  // namespace

void PackedLetters::add(const ex& symbol) {
  by_hash_.emplace(symbol.gethash(), symbols_.size());
  symbols_.push_back(symbol);
}

std::size_t PackedLetters::position(const ex& symbol) const {
  for (auto [at, end] = by_hash_.equal_range(symbol.gethash()); at != end; ++at) {
    const ex& known = symbols_[at->second];
    const bool same = &GiNaC::ex_to<GiNaC::basic>(known) == &GiNaC::ex_to<GiNaC::basic>(symbol);
    if (same || known.is_equal(symbol)) return at->second;
  }
  return symbols_.size();
}

void add_letters(PackedLetters& letters, const ex& value) {
  switch (kind_of(value)) {
    case NodeKind::symbol:
      if (letters.position(value) == letters.count()) letters.add(value);
      break;
    case NodeKind::power:
      add_letters(letters, value.op(0));
      break;
    case NodeKind::product:
    case NodeKind::sum:
      for (const GiNaC::expair& pair : SequenceAccess::pairs(value)) add_letters(letters, pair.rest);
      break;
    default:
      break;
  }
}

std::optional<ReadPolynomial> read_polynomial(const ex& value, const PackedLetters& letters) {
  PolynomialReader reader(letters);
  auto polynomial = reader.read(value);
  if (!polynomial) return std::nullopt;
  return ReadPolynomial{std::move(*polynomial), reader.is_expanded()};
}

ex to_ex(const PackedPolynomial& value, const PackedLetters& letters) {
  if (value.is_number()) return value.is_zero() ? ex(0) : ex(GiNaC::numeric(value.coefficient(0).exact()));
  if (value.size() == 1 && value.coefficient(0).is_one()) return monomial_of(value, 0, letters);
  Rational constant = 0;
  GiNaC::epvector summands;
  summands.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    const ex product = monomial_of(value, i, letters);
    if (product.is_equal(1)) {
      constant = value.coefficient(i).exact();
    } else {
      summands.emplace_back(product, GiNaC::numeric(value.coefficient(i).exact()));
    }
  }
  return GiNaC::dynallocate<GiNaC::add>(std::move(summands), GiNaC::numeric(constant));
}

}  // namespace rigor
