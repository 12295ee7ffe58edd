// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <map>

#include "derive/chain/descent.h"
#include "derive/chain/line.h"
#include "derive/polynomial/canonical.h"
#include "derive/polynomial/collected.h"
#include "derive/polynomial/contraction.h"
#include "derive/polynomial/factor_node.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

/// Factors of a denominator, with positive exponents, by what they are.
using Denominator = std::map<std::string, IndexFactor>;

std::string text_of(const ExprTree& tree, IndexFactor factor) {
  factor.exponent = 1;
  return canonical_text(tree.symbols, {{IndexMonomial{.factors = {std::move(factor)}}}});
}

bool is_open(const IndexMonomial& term, const IndexFactor& factor) {
  const auto speaks = [&](auto variable) { return speaks_of(factor, variable); };
  return std::ranges::none_of(term.indices, speaks) && std::ranges::none_of(term.particles, speaks);
}

void note_denominators(const ExprTree& tree, const IndexPolynomial& polynomial, Denominator& denominator) {
  for (const IndexMonomial& term : polynomial.terms) {
    for (const IndexFactor& factor : term.factors) {
      if (factor.exponent >= 0 || !is_open(term, factor)) continue;
      IndexFactor& known = denominator.try_emplace(text_of(tree, factor), factor).first->second;
      known.exponent = std::max(std::abs(known.exponent), -factor.exponent);
    }
  }
  for (auto& [text, factor] : denominator) factor.exponent = std::abs(factor.exponent);
}

/// The polynomial times a factor; a sum is multiplied in.
std::optional<IndexPolynomial> times(ExprTree& tree, const IndexMonomial& term, const IndexFactor& factor) {
  IndexPolynomial result{{term}};
  const std::string text = text_of(tree, factor);
  int missing = factor.exponent;
  for (IndexFactor& own : result.terms[0].factors) {
    if (own.exponent >= 0 || text_of(tree, own) != text) continue;
    const int cancelled = std::min(missing, -own.exponent);
    own.exponent += cancelled;
    missing -= cancelled;
  }
  std::erase_if(result.terms[0].factors, [](const IndexFactor& own) { return own.exponent == 0; });
  if (factor.kind != Kind::sum) {
    IndexFactor more = factor;
    more.exponent = missing;
    if (missing > 0) result.terms[0].factors.push_back(more);
    return result;
  }
  for (; missing > 0; --missing) {
    IndexPolynomial argument = *factor.argument;
    for (IndexMonomial& inner : argument.terms) inner = with_new_sums(tree, inner);
    const auto product = product_of(result, argument);
    if (!product) return std::nullopt;
    result = *product;
  }
  return result;
}

std::optional<IndexPolynomial> numerator(ExprTree& tree, const IndexPolynomial& polynomial,
                                         const Denominator& denominator) {
  IndexPolynomial result = polynomial;
  for (const auto& [text, factor] : denominator) {
    IndexPolynomial next;
    for (const IndexMonomial& term : result.terms) {
      const auto product = times(tree, term, factor);
      if (!product) return std::nullopt;
      next.terms.insert(next.terms.end(), product->terms.begin(), product->terms.end());
    }
    if (next.terms.size() > most_monomials) return std::nullopt;
    result = std::move(next);
  }
  for (int round = 0; round < 8; ++round) {
    const bool contracted = contract_deltas(result) || contract_unit_vectors(tree.symbols, result);
    if (!contracted) break;
  }
  return collected(tree, result);
}

void append(ExprTree& tree, const DescentRules& rules, const Denominator& denominator,
            const std::vector<IndexPolynomial>& numerators, Descent& descent) {
  std::vector<ExprId> under;
  for (const auto& [text, factor] : denominator) under.push_back(factor_node(tree, factor));
  Line line{.parts = {}, .down = {{RuleKind::rearranged}}, .up = {{RuleKind::rearranged}}, .flat = true};
  for (const IndexPolynomial& each : numerators) {
    const ExprId quotient = quotient_node(tree, expression_of(tree, each), product_node(tree, under));
    line.parts.push_back(
        with_letters(tree, each.terms.empty() ? number_node(tree, 0) : quotient, rules.letters));
  }
  describe(tree, line, rules.open);
  for (const IndexPolynomial& each : numerators) line.terms += '/' + canonical_text(tree.symbols, each);
  descent.lines.push_back(std::move(line));
}

}  // namespace

void append_common_denominator(ExprTree& tree, const DescentRules& rules, Descent& left, Descent& right) {
  if (left.polynomials.empty() || left.polynomials.size() != right.polynomials.size()) return;
  Denominator denominator;
  for (const Descent* side : {&left, &right}) {
    for (const IndexPolynomial& each : side->polynomials) note_denominators(tree, each, denominator);
  }
  if (denominator.empty()) return;
  std::vector<IndexPolynomial> numerators[2];
  for (std::size_t k = 0; k < left.polynomials.size(); ++k) {
    for (const std::size_t side : {0u, 1u}) {
      auto over = numerator(tree, (side == 0 ? left : right).polynomials[k], denominator);
      if (!over) return;
      numerators[side].push_back(*std::move(over));
    }
    if (canonical_text(tree.symbols, numerators[0][k]) != canonical_text(tree.symbols, numerators[1][k]))
      return;
  }
  append(tree, rules, denominator, numerators[0], left);
  append(tree, rules, denominator, numerators[0], right);
}

}  // namespace rigor
