// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/contraction.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

bool is_summed(const IndexMonomial& term, const Slot& slot) {
  return slot.axis == 0 && is_one_of(slot.variable, term.indices);
}

void erase_factor(IndexMonomial& term, std::size_t at) {
  term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(at));
}

void erase_index(IndexMonomial& term, IndexId index) { std::erase(term.indices, index); }

std::size_t slots_in_common(const IndexMonomial& term, const IndexFactor& a, const IndexFactor& b) {
  std::size_t count = 0;
  for (const Slot& slot : a.slots) {
    for (const Slot& other : b.slots) count += same_slot(slot, other) && is_summed(term, slot) ? 1 : 0;
  }
  return count;
}

/// The two ε with most summed letters in common.
std::optional<std::pair<std::size_t, std::size_t>> closest_epsilons(const IndexMonomial& term) {
  std::optional<std::pair<std::size_t, std::size_t>> best;
  std::size_t most = 0;
  for (std::size_t a = 0; a < term.factors.size(); ++a) {
    for (std::size_t b = a + 1; b < term.factors.size(); ++b) {
      if (term.factors[a].kind != Kind::epsilon || term.factors[b].kind != Kind::epsilon) continue;
      const std::size_t common = slots_in_common(term, term.factors[a], term.factors[b]);
      if (best && common <= most) continue;
      best = {a, b};
      most = common;
    }
  }
  return best;
}

/// The common letter is brought to the front of both, cyclically; the sign of neither changes.
void turn_to_common(const IndexMonomial& term, IndexFactor& a, IndexFactor& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!same_slot(a.slots[i], b.slots[j]) || !is_summed(term, a.slots[i])) continue;
      std::rotate(a.slots.begin(), a.slots.begin() + static_cast<std::ptrdiff_t>(i), a.slots.end());
      std::rotate(b.slots.begin(), b.slots.begin() + static_cast<std::ptrdiff_t>(j), b.slots.end());
      return;
    }
  }
}

IndexFactor delta(const Slot& a, const Slot& b) { return {.kind = Kind::delta, .slots = {a, b}}; }

/// Terms of the product of two ε: (sign, three δ), or two δ where a common letter stands first in both.
std::vector<IndexMonomial> product_of_epsilons(const IndexMonomial& term, std::size_t at, std::size_t other) {
  static constexpr std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
  IndexFactor a = term.factors[at];
  IndexFactor b = term.factors[other];
  turn_to_common(term, a, b);
  const bool common = same_slot(a.slots[0], b.slots[0]) && is_summed(term, a.slots[0]);
  std::vector<IndexMonomial> result;
  for (std::size_t k = 0; k < (common ? 2u : 6u); ++k) {
    IndexMonomial product = term;
    if (k % 2 == 1) product.coefficient = product.coefficient * SmallRational(-1);
    erase_factor(product, other);
    erase_factor(product, at);
    std::vector<IndexFactor> deltas;
    for (std::size_t i = common ? 1 : 0; i < 3; ++i)
      deltas.push_back(delta(a.slots[i], b.slots[orders[k][i]]));
    product.factors.insert(product.factors.begin() + static_cast<std::ptrdiff_t>(at), deltas.begin(),
                           deltas.end());
    if (common) erase_index(product, a.slots[0].variable);
    result.push_back(std::move(product));
  }
  return result;
}

int sign_of_axes(const std::vector<Slot>& slots) {
  const int i = slots[0].axis;
  const int j = slots[1].axis;
  const int k = slots[2].axis;
  return (i - j) * (j - k) * (k - i) / 2;
}

/// One δ or ε of a monomial is taken away; false where none can be.
bool contract_one(IndexMonomial& term) {
  for (std::size_t at = 0; at < term.factors.size(); ++at) {
    const IndexFactor factor = term.factors[at];
    const auto& slots = factor.slots;
    if (factor.kind == Kind::epsilon) {
      const bool equal =
          same_slot(slots[0], slots[1]) || same_slot(slots[1], slots[2]) || same_slot(slots[0], slots[2]);
      const bool numbers = slots[0].axis != 0 && slots[1].axis != 0 && slots[2].axis != 0;
      if (!equal && !numbers) continue;
      term.coefficient = term.coefficient * SmallRational(equal ? 0 : sign_of_axes(slots));
      erase_factor(term, at);
      return true;
    }
    if (factor.kind != Kind::delta) continue;
    if (same_slot(slots[0], slots[1])) {
      const bool counts = is_summed(term, slots[0]) && occurrences(term, slots[0].variable) == 2;
      erase_factor(term, at);
      if (counts) {
        term.coefficient = term.coefficient * SmallRational(3);
        erase_index(term, slots[0].variable);
      }
      return true;
    }
    if (slots[0].axis != 0 && slots[1].axis != 0) {
      term.coefficient = 0;
      erase_factor(term, at);
      return true;
    }
    for (std::size_t k : {1u, 0u}) {
      if (!is_summed(term, slots[k])) continue;
      erase_factor(term, at);
      replace_index(term, slots[k].variable, slots[1 - k]);
      erase_index(term, slots[k].variable);
      return true;
    }
  }
  return false;
}

void drop_zeros(IndexPolynomial& polynomial) {
  std::erase_if(polynomial.terms, [](const IndexMonomial& term) { return term.coefficient.is_zero(); });
}

/// Two factors of one symbol that meet in one summed letter, at the same slot: the positions, and the slots
/// that are left.
struct Pair {
  std::size_t a = 0;
  std::size_t b = 0;
  IndexId index{};
  std::vector<Slot> left = {};
};

std::optional<Pair> find_pair(const IndexMonomial& term, const auto& fits) {
  for (std::size_t a = 0; a < term.factors.size(); ++a) {
    for (std::size_t b = a + 1; b < term.factors.size(); ++b) {
      const IndexFactor& one = term.factors[a];
      const IndexFactor& other = term.factors[b];
      if (one.kind != Kind::component || other.kind != Kind::component || one.symbol != other.symbol ||
          one.particle != other.particle || one.exponent != 1 || other.exponent != 1 || !fits(one.symbol))
        continue;
      for (std::size_t k = 0; k < one.slots.size(); ++k) {
        if (!same_slot(one.slots[k], other.slots[k]) || !is_summed(term, one.slots[k]) ||
            occurrences(term, one.slots[k].variable) != 2)
          continue;
        Pair pair{a, b, one.slots[k].variable};
        for (std::size_t other_slot = 0; other_slot < one.slots.size(); ++other_slot) {
          if (other_slot == k) continue;
          pair.left = {one.slots[other_slot], other.slots[other_slot]};
        }
        return pair;
      }
    }
  }
  return std::nullopt;
}

bool contract_pairs(IndexPolynomial& polynomial, const auto& fits) {
  bool changed = false;
  for (IndexMonomial& term : polynomial.terms) {
    while (const auto pair = find_pair(term, fits)) {
      changed = true;
      erase_factor(term, pair->b);
      if (pair->left.empty()) {
        erase_factor(term, pair->a);
      } else {
        term.factors[pair->a] = delta(pair->left[0], pair->left[1]);
      }
      erase_index(term, pair->index);
    }
  }
  return changed;
}

}  // namespace

bool contract_epsilons(IndexPolynomial& polynomial) {
  bool changed = false;
  IndexPolynomial result;
  for (const IndexMonomial& term : polynomial.terms) {
    const auto pair = closest_epsilons(term);
    if (!pair) {
      result.terms.push_back(term);
      continue;
    }
    changed = true;
    for (IndexMonomial& product : product_of_epsilons(term, pair->first, pair->second))
      result.terms.push_back(std::move(product));
  }
  if (!changed || result.terms.size() > most_monomials) return false;
  polynomial = std::move(result);
  return true;
}

bool contract_deltas(IndexPolynomial& polynomial) {
  bool changed = false;
  for (IndexMonomial& term : polynomial.terms) {
    while (!term.coefficient.is_zero() && contract_one(term)) changed = true;
  }
  drop_zeros(polynomial);
  return changed;
}

bool write_out_sums(IndexPolynomial& polynomial) {
  IndexPolynomial result;
  bool changed = false;
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  while (!open.empty()) {
    IndexMonomial term = std::move(open.back());
    open.pop_back();
    if (!term.coefficient.is_zero() && contract_one(term)) {
      changed = true;
      open.push_back(std::move(term));
      continue;
    }
    if (term.coefficient.is_zero()) continue;
    if (term.indices.empty()) {
      result.terms.push_back(std::move(term));
      if (result.terms.size() > most_monomials) return false;
      continue;
    }
    changed = true;
    const IndexId index = term.indices.front();
    term.indices.erase(term.indices.begin());
    for (std::uint8_t axis = 3; axis >= 1; --axis) {
      open.push_back(term);
      replace_index(open.back(), index, {.axis = axis});
    }
  }
  polynomial = std::move(result);
  return changed;
}

bool contract_rotations(const SymbolTable& symbols, IndexPolynomial& polynomial) {
  return contract_pairs(polynomial, [&](SymbolId symbol) { return symbols[symbol].rotation; });
}

bool contract_unit_vectors(const SymbolTable& symbols, IndexPolynomial& polynomial) {
  return contract_pairs(polynomial, [&](SymbolId symbol) { return symbols[symbol].unit; });
}

bool replace_cosines(IndexPolynomial& polynomial) {
  bool changed = false;
  IndexPolynomial result;
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  while (!open.empty()) {
    IndexMonomial term = std::move(open.back());
    open.pop_back();
    const auto cosine = std::ranges::find_if(term.factors, [](const IndexFactor& factor) {
      return factor.kind == Kind::function && factor.function == Function::cos && factor.exponent >= 2;
    });
    if (cosine == term.factors.end()) {
      result.terms.push_back(std::move(term));
      continue;
    }
    changed = true;
    IndexFactor sine = *cosine;
    sine.function = Function::sin;
    sine.exponent = 2;
    cosine->exponent -= 2;
    if (cosine->exponent == 0) term.factors.erase(cosine);
    open.push_back(term);
    open.back().factors.push_back(sine);
    open.back().coefficient = open.back().coefficient * SmallRational(-1);
    open.push_back(std::move(term));
    if (open.size() + result.terms.size() > most_monomials) return false;
  }
  if (changed) polynomial = std::move(result);
  return changed;
}

}  // namespace rigor
