// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/first_order.h"

#include <algorithm>

#include "derive/notation/letter_choice.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

/// The order of a small quantity where it cannot be seen.
struct OrderHidden {};

class FirstOrder {
 public:
  FirstOrder(ExprTree& tree, std::span<const ExprId> small) : tree_(tree), small_(small) {}

  /// The terms of second order, taken out of the polynomial.
  std::vector<ExprId> split(IndexPolynomial& polynomial) {
    std::vector<ExprId> left_out;
    IndexPolynomial kept;
    IndexPolynomial dropped;
    for (IndexMonomial& term : polynomial.terms) {
      if (order_of(term) >= 2) {
        dropped.terms.push_back(std::move(term));
        continue;
      }
      while (const auto correction = simplify_denominator(term)) left_out.push_back(*correction);
      kept.terms.push_back(std::move(term));
    }
    if (!dropped.terms.empty()) left_out.push_back(expression_of(tree_, dropped));
    polynomial = std::move(kept);
    return left_out;
  }

 private:
  bool is_small(const IndexFactor& factor) const {
    if (factor.kind != Kind::component) return false;
    return std::ranges::any_of(small_, [&](ExprId id) {
      if (tree_[id].op != Op::symbol || tree_[id].symbol != base_of(tree_.symbols, factor.symbol))
        return false;
      const auto slots = tree_.slots(id);
      for (std::size_t k = 0; k < slots.size(); ++k) {
        if (factor.slots[k].axis == 0 && slots[k].axis != 0) throw OrderHidden{};
        if (slots[k].axis != 0 && slots[k].axis != factor.slots[k].axis) return false;
      }
      return true;
    });
  }

  int order_of(const IndexMonomial& term) const {
    int order = 0;
    for (const IndexFactor& factor : term.factors) {
      if (is_small(factor)) {
        if (factor.exponent < 0) throw OrderHidden{};
        order += factor.exponent;
      }
      if (factor.argument == nullptr) continue;
      const int least = least_order(*factor.argument);
      const bool hidden = factor.kind == Kind::sum ? least > 0 : speaks_of_small(*factor.argument);
      if (hidden) throw OrderHidden{};
    }
    return order;
  }

  int least_order(const IndexPolynomial& polynomial) const {
    int least = 2;
    for (const IndexMonomial& term : polynomial.terms) least = std::min(least, order_of(term));
    return least;
  }

  bool speaks_of_small(const IndexPolynomial& polynomial) const {
    return std::ranges::any_of(polynomial.terms,
                               [&](const IndexMonomial& term) { return order_of(term) > 0; });
  }

  /// rest/(P + Q) = rest/P − rest·Q/((P + Q)P), with Q of second order: the denominator becomes P.
  std::optional<ExprId> simplify_denominator(IndexMonomial& term) {
    for (std::size_t k = 0; k < term.factors.size(); ++k) {
      if (term.factors[k].kind != Kind::sum || term.factors[k].exponent >= 0) continue;
      IndexPolynomial kept;
      IndexPolynomial small;
      for (const IndexMonomial& part : term.factors[k].argument->terms) {
        const int order = order_of(part);
        if (order == 1) throw OrderHidden{};
        (order == 0 ? kept : small).terms.push_back(part);
      }
      if (small.terms.empty()) continue;
      IndexMonomial rest = term;
      IndexFactor without = term.factors[k];
      without.argument = std::make_shared<const IndexPolynomial>(kept);
      without.exponent = -1;
      rest.factors.push_back(without);
      const ExprId correction =
          product_node(tree_, {expression_of(tree_, {{rest}}), expression_of(tree_, small)});
      if (++term.factors[k].exponent == 0) {
        term.factors[k] = without;
      } else {
        term.factors.push_back(without);
      }
      return negated_node(tree_, correction);
    }
    return std::nullopt;
  }

  ExprTree& tree_;
  std::span<const ExprId> small_;
};

}  // namespace

std::optional<ExprId> without_second_order(ExprTree& tree, std::span<const ExprId> small,
                                           IndexPolynomial& polynomial) {
  try {
    std::vector<ExprId> left_out = FirstOrder(tree, small).split(polynomial);
    for (ExprId& each : left_out) each = with_letters(tree, each, {});
    return sum_node(tree, left_out);
  } catch (const OrderHidden&) {
    return std::nullopt;
  }
}

}  // namespace rigor
