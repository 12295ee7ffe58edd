// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/fold.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "derive/polynomial/factor_node.h"
#include "derive/polynomial/nodes.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

/// A part of a monomial: an expression without its slots, and the letters at them.
struct Piece {
  ExprId expr{};
  std::vector<Slot> slots = {};
  bool epsilon = false;  // `expr` is nothing
  bool delta = false;
  bool symmetric = false;
  int exponent = 1;
  std::vector<ParticleId> particles = {};  // that it speaks of, and that are summed over
};

class Folding {
 public:
  Folding(ExprTree& tree, std::span<const IndexId> open) : tree_(tree), open_(open) {}

  std::optional<ExprId> monomial(const IndexMonomial& term) {
    summed_ = term.indices;
    pieces_.clear();
    for (const IndexFactor& factor : term.factors) pieces_.push_back(piece(factor, term.particles));
    while (step()) {
    }
    for (const Piece& each : pieces_) {
      for (const Slot& slot : each.slots) {
        if (is_summed(slot)) return std::nullopt;
      }
    }
    if (!close()) return std::nullopt;
    return product(term);
  }

 private:
  Piece piece(const IndexFactor& factor, const std::vector<ParticleId>& summed) {
    Piece result{.slots = factor.slots, .exponent = factor.exponent};
    for (const ParticleId particle : summed) {
      if (speaks_of(factor, particle)) result.particles.push_back(particle);
    }
    result.epsilon = factor.kind == Kind::epsilon;
    result.delta = factor.kind == Kind::delta;
    if (result.epsilon || result.delta) return result;
    if (factor.kind == Kind::component) {
      result.expr = symbol_node(tree_, factor.symbol, factor.particle, {});
      result.symmetric = tree_.symbols[factor.symbol].symmetric;
      if (factor.slots.empty()) return result;
      if (factor.exponent == 1) return result;
    }
    result.expr = factor_node(tree_, factor);  // closed: its slots stay written
    result.slots.clear();
    return result;
  }

  [[nodiscard]] bool is_summed(const Slot& slot) const {
    return slot.axis == 0 && is_one_of(slot.variable, summed_);
  }
  static bool same(const Slot& a, const Slot& b) {
    return a.axis == 0 && b.axis == 0 && a.variable == b.variable;
  }

  void take(Piece& into, const Piece& from) {
    for (const ParticleId particle : from.particles) {
      if (!is_one_of(particle, into.particles)) into.particles.push_back(particle);
    }
  }

  void replace(std::size_t a, std::size_t b, Piece piece) {
    take(piece, pieces_[a]);
    take(piece, pieces_[b]);
    pieces_[std::min(a, b)] = std::move(piece);
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(std::max(a, b)));
  }

  bool step() { return tensor_on_vector() || cross() || dot() || tensors(); }

  [[nodiscard]] bool is_tensor(const Piece& piece, std::size_t rank) const {
    return !piece.epsilon && !piece.delta && piece.slots.size() == rank;
  }

  bool tensor_on_vector() {
    for (std::size_t t = 0; t < pieces_.size(); ++t) {
      if (!is_tensor(pieces_[t], 2)) continue;
      for (const std::size_t side : {1u, 0u}) {
        for (std::size_t v = 0; v < pieces_.size(); ++v) {
          if (!is_tensor(pieces_[v], 1) || !same(pieces_[t].slots[side], pieces_[v].slots[0])) continue;
          if (!is_summed(pieces_[v].slots[0])) continue;
          const bool from_right = side == 1 || pieces_[t].symmetric;
          Piece product{.slots = {pieces_[t].slots[1 - side]}};
          product.expr = from_right ? dot_node(tree_, pieces_[t].expr, pieces_[v].expr)
                                    : dot_node(tree_, pieces_[v].expr, pieces_[t].expr);
          replace(t, v, std::move(product));
          return true;
        }
      }
    }
    return false;
  }

  std::optional<std::size_t> vector_at(const Slot& slot) const {
    if (!is_summed(slot)) return std::nullopt;
    for (std::size_t v = 0; v < pieces_.size(); ++v) {
      if (is_tensor(pieces_[v], 1) && same(pieces_[v].slots[0], slot)) return v;
    }
    return std::nullopt;
  }

  /// ε with vectors at two slots or more; of three, the first written stays outside: A·(B×C).
  bool cross() {
    for (std::size_t e = 0; e < pieces_.size(); ++e) {
      if (!pieces_[e].epsilon) continue;
      std::optional<std::size_t> best;
      std::size_t first = 0;
      for (std::size_t stays = 0; stays < 3; ++stays) {
        const auto a = vector_at(pieces_[e].slots[(stays + 1) % 3]);
        const auto b = vector_at(pieces_[e].slots[(stays + 2) % 3]);
        if (!a || !b || *a == *b) continue;
        const auto outside = vector_at(pieces_[e].slots[stays]);
        const std::size_t place = outside ? *outside : 0;
        if (best && place >= first) continue;
        best = stays;
        first = place;
      }
      if (!best) continue;
      const std::size_t a = *vector_at(pieces_[e].slots[(*best + 1) % 3]);
      const std::size_t b = *vector_at(pieces_[e].slots[(*best + 2) % 3]);
      Piece product{.expr = cross_node(tree_, pieces_[a].expr, pieces_[b].expr),
                    .slots = {pieces_[e].slots[*best]}};
      take(product, pieces_[a]);
      take(product, pieces_[b]);
      pieces_[e] = std::move(product);
      for (const std::size_t gone : {std::max(a, b), std::min(a, b)})
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(gone));
      return true;
    }
    return false;
  }

  bool dot() {
    for (std::size_t a = 0; a < pieces_.size(); ++a) {
      if (!is_tensor(pieces_[a], 1)) continue;
      for (std::size_t b = a + 1; b < pieces_.size(); ++b) {
        if (!is_tensor(pieces_[b], 1) || !same(pieces_[a].slots[0], pieces_[b].slots[0])) continue;
        if (!is_summed(pieces_[a].slots[0])) continue;
        Piece product;
        const std::array child{pieces_[a].expr};
        const auto is_symbol = [&](std::size_t k) { return tree_[pieces_[k].expr].op == Op::symbol; };
        const bool swapped = is_symbol(b) && !is_symbol(a);  // a·(b×c), not (b×c)·a
        product.expr = dump(tree_, pieces_[a].expr) == dump(tree_, pieces_[b].expr)
                           ? power_node(tree_, tree_.add({.op = Op::length}, child), 2)
                           : dot_node(tree_, pieces_[swapped ? b : a].expr, pieces_[swapped ? a : b].expr);
        replace(a, b, std::move(product));
        return true;
      }
    }
    return false;
  }

  bool tensors() {
    for (std::size_t a = 0; a < pieces_.size(); ++a) {
      for (std::size_t b = 0; b < pieces_.size(); ++b) {
        if (a == b || !is_tensor(pieces_[a], 2) || !is_tensor(pieces_[b], 2)) continue;
        if (!is_summed(pieces_[a].slots[1]) || !same(pieces_[a].slots[1], pieces_[b].slots[0])) continue;
        Piece product{.expr = dot_node(tree_, pieces_[a].expr, pieces_[b].expr),
                      .slots = {pieces_[a].slots[0], pieces_[b].slots[1]}};
        replace(a, b, std::move(product));
        return true;
      }
    }
    return false;
  }

  /// Slots that are not open stay written as components; the open ones must be in their order.
  bool close() {
    std::vector<IndexId> seen;
    for (Piece& each : pieces_) {
      std::size_t open = 0;
      for (const Slot& slot : each.slots) {
        const bool is_open = slot.axis == 0 && is_one_of(slot.variable, open_);
        if (is_open) seen.push_back(slot.variable);
        open += is_open ? 1 : 0;
      }
      if (open != 0 && (open != each.slots.size() || each.epsilon || each.delta)) return false;
      if (open != 0 || each.slots.empty()) continue;
      if (each.epsilon || each.delta) {
        each.expr = tree_.add({.op = each.epsilon ? Op::epsilon : Op::delta}, {}, each.slots);
      } else {
        each.expr = component_of(tree_, each.expr, each.slots);
      }
      each.slots.clear();
    }
    return std::ranges::equal(seen, open_);
  }

  /// Scalars in front, equal ones as powers, what speaks of a particle under its sum.
  std::optional<ExprId> product(const IndexMonomial& term) {
    const auto place = [&](const Piece& piece) {
      if (!piece.slots.empty()) return 2;
      return tree_[piece.expr].op == Op::symbol ? 0 : 1;
    };
    std::ranges::stable_sort(pieces_, [&](const Piece& a, const Piece& b) { return place(a) < place(b); });
    join_powers();
    const bool negative = term.coefficient.over() < 0;
    const SmallRational size = negative ? term.coefficient * SmallRational(-1) : term.coefficient;
    const ExprId body = under_sums(pieces_, term.particles, size);
    return negative ? negated_node(tree_, body) : body;
  }

  void join_powers() {
    for (std::size_t a = 0; a < pieces_.size(); ++a) {
      if (!pieces_[a].slots.empty() || tree_[pieces_[a].expr].op == Op::power) continue;
      int count = 1;
      for (std::size_t b = pieces_.size() - 1; b > a; --b) {
        if (!pieces_[b].slots.empty() || pieces_[a].exponent != 1 || pieces_[b].exponent != 1 ||
            dump(tree_, pieces_[a].expr) != dump(tree_, pieces_[b].expr))
          continue;
        ++count;
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(b));
      }
      if (tree_[pieces_[a].expr].rank == 0) pieces_[a].expr = power_node(tree_, pieces_[a].expr, count);
    }
  }

  ExprId under_sums(const std::vector<Piece>& pieces, std::vector<ParticleId> particles, SmallRational size) {
    std::vector<ExprId> over;
    std::vector<ExprId> under;
    if (particles.empty()) {
      if (size != SmallRational(1)) over.push_back(rational_node(tree_, size));
      for (const Piece& each : pieces) {
        const bool plain_power = each.exponent > 0 && tree_[each.expr].op == Op::symbol && each.exponent != 1;
        const ExprId expr = each.exponent < 0 && tree_[each.expr].op == Op::symbol
                                ? power_node(tree_, each.expr, -each.exponent)
                            : plain_power ? power_node(tree_, each.expr, each.exponent)
                                          : each.expr;
        (each.exponent < 0 ? under : over).push_back(expr);
      }
      const ExprId dividend = product_node(tree_, over);
      return under.empty() ? dividend : quotient_node(tree_, dividend, product_node(tree_, under));
    }
    const ParticleId particle = particles.back();
    particles.pop_back();
    std::vector<Piece> inside;
    std::vector<Piece> outside;
    for (const Piece& each : pieces) {
      const bool speaks = is_one_of(particle, each.particles);
      (speaks ? inside : outside).push_back(each);
    }
    Piece sum{.expr = particle_sum_node(tree_, particle, under_sums(inside, {}, 1))};
    for (const Piece& each : inside) take(sum, each);
    std::erase(sum.particles, particle);
    outside.push_back(std::move(sum));
    return under_sums(outside, particles, size);
  }

  ExprTree& tree_;
  std::span<const IndexId> open_;
  std::vector<IndexId> summed_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::optional<ExprId> folded(ExprTree& tree, const IndexPolynomial& polynomial,
                             std::span<const IndexId> open) {
  std::vector<ExprId> terms;
  for (const IndexMonomial& term : polynomial.terms) {
    const auto folded_term = Folding(tree, open).monomial(term);
    if (!folded_term) return std::nullopt;
    terms.push_back(*folded_term);
  }
  return sum_node(tree, terms, static_cast<int>(open.size()));
}

}  // namespace rigor
