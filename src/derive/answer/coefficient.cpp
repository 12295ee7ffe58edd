// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/answer/coefficient.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "derive/notation/contracted.h"
#include "derive/polynomial/index_polynomial.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

bool is_hole(const IndexFactor& factor, SymbolId hole) {
  return factor.kind == Kind::component && factor.symbol == hole;
}

bool is_same(const Slot& a, const Slot& b) {
  return a.axis == b.axis && (a.axis != 0 || a.variable == b.variable);
}

/// What the hole is multiplied with.
struct Company {
  std::vector<Slot> letters = {};  // of the hole
  std::vector<std::pair<Slot, IndexFactor>> vectors =
      {};  // each with the letter that it shares with the hole
  SmallRational coefficient = 1;
  std::vector<IndexFactor> scalars = {};
};

std::optional<Company> company_of(const IndexMonomial& monomial, SymbolId hole) {
  if (!monomial.particles.empty()) return std::nullopt;
  Company company{.coefficient = monomial.coefficient};
  for (const IndexFactor& factor : monomial.factors) {
    if (is_hole(factor, hole)) company.letters = factor.slots;
  }
  for (const IndexFactor& factor : monomial.factors) {
    if (is_hole(factor, hole)) {
      if (factor.exponent != 1) return std::nullopt;
    } else if (factor.kind != Kind::component) {
      return std::nullopt;
    } else if (factor.slots.empty()) {
      company.scalars.push_back(factor);
    } else {
      const auto shared = std::ranges::find_if(
          company.letters, [&](const Slot& letter) { return is_same(letter, factor.slots[0]); });
      if (factor.slots.size() != 1 || factor.exponent != 1 || shared == company.letters.end())
        return std::nullopt;
      company.vectors.emplace_back(*shared, factor);
    }
  }
  return company;
}

/// Takes one factor of the vector out of a term and puts the letter in the place of its own.
bool take_out(IndexMonomial& term, const IndexFactor& vector, const Slot& letter) {
  const auto found = std::ranges::find_if(term.factors, [&](const IndexFactor& factor) {
    return factor.kind == Kind::component && factor.symbol == vector.symbol &&
           factor.particle == vector.particle && factor.exponent >= 1;
  });
  if (found == term.factors.end()) return false;
  const Slot own = found->slots[0];
  if (--found->exponent == 0) term.factors.erase(found);
  const auto summed = own.axis == 0 ? std::ranges::find(term.indices, own.variable) : term.indices.end();
  if (summed != term.indices.end()) {
    term.indices.erase(summed);
    replace_index(term, own.variable, letter);
  } else {
    IndexFactor delta{.kind = Kind::delta};
    delta.slots = {own, letter};
    term.factors.push_back(std::move(delta));
  }
  return true;
}

}  // namespace

std::optional<ExprId> coefficient_of_vectors(ExprTree& tree, const Equation& claim, SymbolId hole) {
  if (tree[claim.left].rank != 0) return std::nullopt;
  auto left = polynomial_of(tree, claim.left);
  auto right = polynomial_of(tree, claim.right);
  if (!left || !right) return std::nullopt;
  contract(tree, *left);
  std::optional<Company> company;
  for (IndexMonomial& term : right->terms) {
    const bool own =
        std::ranges::any_of(term.factors, [&](const IndexFactor& factor) { return is_hole(factor, hole); });
    if (own && company) return std::nullopt;
    if (own) {
      company = company_of(term, hole);
      if (!company) return std::nullopt;
      continue;
    }
    term.coefficient = SmallRational(0) - term.coefficient;
    left->terms.push_back(term);
  }
  if (!company || company->vectors.empty()) return std::nullopt;
  for (IndexMonomial& term : left->terms) {
    term = with_new_sums(tree, term);
    for (const auto& [letter, vector] : company->vectors) {
      if (!take_out(term, vector, letter)) return std::nullopt;
    }
    term.coefficient = term.coefficient / company->coefficient;
    for (IndexFactor scalar : company->scalars) {
      scalar.exponent = -scalar.exponent;
      term.factors.push_back(std::move(scalar));
    }
  }
  contract(tree, *left);
  return as_scalar(tree, *left);
}

}  // namespace rigor
