// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/collected.h"

#include <algorithm>
#include <map>
#include <utility>

#include "derive/polynomial/canonical.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

bool is_closed(const IndexMonomial& term, const IndexFactor& factor) {
  return std::ranges::none_of(term.indices, [&](IndexId index) { return speaks_of(factor, index); });
}

/// Powers of equal factors that no sum over components reaches are one factor.
void join_equal_factors(const SymbolTable& symbols, IndexMonomial& term) {
  std::map<std::string, std::size_t> known;
  std::vector<IndexFactor> factors;
  for (const IndexFactor& factor : term.factors) {
    if (!is_closed(term, factor) || factor.kind == Kind::delta || factor.kind == Kind::epsilon) {
      factors.push_back(factor);
      continue;
    }
    IndexMonomial alone{.factors = {factor}};
    alone.factors[0].exponent = 1;
    const auto [entry, fresh] = known.try_emplace(canonical_monomial(symbols, alone).text, factors.size());
    if (fresh) {
      factors.push_back(factor);
    } else {
      factors[entry->second].exponent += factor.exponent;
    }
  }
  std::erase_if(factors, [](const IndexFactor& factor) { return factor.exponent == 0; });
  term.factors = std::move(factors);
}

/// √x^n with x = a_i a_i next to a_i a_i: √x^(n+2).
bool join_square_with_root(const SymbolTable& symbols, IndexMonomial& term) {
  for (IndexFactor& root : term.factors) {
    if (root.kind != Kind::root || root.exponent >= 0 || root.argument->terms.size() != 1) continue;
    const IndexMonomial& square = root.argument->terms[0];
    if (square.indices.size() != 1 || square.factors.size() != 2 || square.coefficient != SmallRational(1))
      continue;
    const std::string wanted = canonical_monomial(symbols, square).text;
    for (const IndexId index : term.indices) {
      IndexMonomial pair{.indices = {index}};
      for (const IndexFactor& factor : term.factors) {
        if (speaks_of(factor, index)) pair.factors.push_back(factor);
      }
      if (pair.factors.size() != 2 || canonical_monomial(symbols, pair).text != wanted) continue;
      root.exponent += 2;
      const IndexId joined = index;
      std::erase_if(term.factors, [&](const IndexFactor& factor) { return speaks_of(factor, joined); });
      std::erase(term.indices, joined);
      std::erase_if(term.factors, [](const IndexFactor& factor) { return factor.exponent == 0; });
      return true;
    }
  }
  return false;
}

/// √x² = x, where x can be multiplied in.
bool open_root(ExprTree& tree, IndexMonomial& term, IndexPolynomial& opened) {
  for (std::size_t k = 0; k < term.factors.size(); ++k) {
    IndexFactor& root = term.factors[k];
    if (root.kind != Kind::root || root.exponent < 2) continue;
    IndexPolynomial argument = *root.argument;
    for (IndexMonomial& inner : argument.terms) inner = with_new_sums(tree, inner);
    root.exponent -= 2;
    if (root.exponent == 0) term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(k));
    const auto product = product_of({{term}}, argument);
    if (!product) return false;
    opened = *product;
    return true;
  }
  return false;
}

/// 1/2 of a denominator that is the number 2, and 1 of √1.
bool take_out_numbers(IndexMonomial& term) {
  for (std::size_t k = 0; k < term.factors.size(); ++k) {
    const IndexFactor factor = term.factors[k];
    if (factor.kind != Kind::root && factor.kind != Kind::sum) continue;
    const auto& terms = factor.argument->terms;
    if (terms.size() != 1 || !terms[0].factors.empty() || !terms[0].indices.empty() ||
        !terms[0].particles.empty())
      continue;
    const SmallRational value = terms[0].coefficient;
    if (factor.kind == Kind::root && value != SmallRational(1)) continue;
    term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(k));
    for (int n = factor.exponent; n < 0; ++n) term.coefficient = term.coefficient / value;
    for (int n = factor.exponent; n > 0; --n) term.coefficient = term.coefficient * value;
    return true;
  }
  return false;
}

/// A sum over what does not speak of its index.
void count_idle_sums(IndexMonomial& term) {
  for (std::size_t k = term.indices.size(); k-- > 0;) {
    if (occurrences(term, term.indices[k]) > 0) continue;
    term.coefficient = term.coefficient * SmallRational(3);
    term.indices.erase(term.indices.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

}  // namespace

std::string text_of_terms(const SymbolTable& symbols, const IndexPolynomial& polynomial) {
  std::vector<std::string> texts;
  for (const IndexMonomial& term : polynomial.terms) {
    IndexMonomial joined = term;
    join_equal_factors(symbols, joined);
    const CanonicalMonomial text = canonical_monomial(symbols, joined);
    texts.push_back((term.coefficient * SmallRational(text.sign == 0 ? 1 : text.sign)).text() + '*' +
                    text.text);
  }
  std::ranges::sort(texts);
  std::string all;
  for (const std::string& text : texts) all += text + '+';
  return all;
}

bool drop_antisymmetric(const SymbolTable& symbols, IndexPolynomial& polynomial) {
  return std::erase_if(polynomial.terms, [&](const IndexMonomial& term) {
           return canonical_monomial(symbols, term).sign == 0;
         }) > 0;
}

bool join_powers(ExprTree& tree, IndexPolynomial& polynomial) {
  const SymbolTable& symbols = tree.symbols;
  bool changed = false;
  IndexPolynomial result;
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  while (!open.empty()) {
    IndexMonomial term = std::move(open.back());
    open.pop_back();
    const std::size_t before = term.factors.size();
    join_equal_factors(symbols, term);
    while (join_square_with_root(symbols, term)) {
    }
    while (take_out_numbers(term)) {
    }
    changed = changed || term.factors.size() != before;
    IndexPolynomial opened;
    if (!open_root(tree, term, opened)) {
      result.terms.push_back(std::move(term));
      continue;
    }
    changed = true;
    open.insert(open.end(), opened.terms.rbegin(), opened.terms.rend());
    if (open.size() + result.terms.size() > most_monomials) return false;
  }
  if (changed) polynomial = std::move(result);
  return changed;
}

IndexPolynomial collected(ExprTree& tree, const IndexPolynomial& polynomial) {
  const SymbolTable& symbols = tree.symbols;
  std::map<std::string, std::size_t> known;
  std::vector<std::pair<IndexMonomial, int>> kept;  // with the sign of its text
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  for (std::size_t budget = 4 * most_monomials; !open.empty() && budget > 0; --budget) {
    IndexMonomial term = std::move(open.back());
    open.pop_back();
    count_idle_sums(term);
    join_equal_factors(symbols, term);
    while (join_square_with_root(symbols, term) || take_out_numbers(term)) {
    }
    IndexPolynomial opened;
    if (open_root(tree, term, opened)) {
      open.insert(open.end(), opened.terms.rbegin(), opened.terms.rend());
      continue;
    }
    const CanonicalMonomial text = canonical_monomial(symbols, term);
    if (text.sign == 0 || term.coefficient.is_zero()) continue;
    const auto [entry, fresh] = known.try_emplace(text.text, kept.size());
    if (fresh) {
      kept.emplace_back(std::move(term), text.sign);
    } else {
      auto& [first, sign] = kept[entry->second];
      first.coefficient = first.coefficient + term.coefficient * SmallRational(text.sign * sign);
    }
  }
  if (!open.empty()) return polynomial;
  IndexPolynomial result;
  for (auto& [term, sign] : kept) {
    if (!term.coefficient.is_valid()) return polynomial;
    if (!term.coefficient.is_zero()) result.terms.push_back(std::move(term));
  }
  return result;
}

}  // namespace rigor
