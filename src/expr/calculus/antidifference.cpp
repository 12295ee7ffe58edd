// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/antidifference.h"

#include <algorithm>
#include <string>
#include <utility>

namespace rigor {
namespace {

constexpr std::size_t most_summand_terms = 100;
constexpr int highest_summand_power = 8;

class Antidifferences {
 public:
  Antidifferences(ExprTree& tree, const Running& running, Span span)
      : tree_(tree), running_(running), span_(span) {}

  using Terms = std::optional<std::vector<SummandTerm>>;

  Terms terms(ExprId id) {
    if (tree_[id].rank != 0) return std::nullopt;
    if (!runs(id)) return std::vector{SummandTerm{.constant = {id}}};
    const ExprNode node = tree_[id];
    const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
    switch (node.op) {
      case Op::symbol:
        if (node.symbol == running_.variable) return std::vector{SummandTerm{.power = 1}};
        return other(id);
      case Op::add:
        return of_sum(children);
      case Op::negate:
        return times(std::vector{SummandTerm{.constant = {negative(number(1))}}}, terms(children[0]));
      case Op::multiply: {
        Terms product = std::vector{SummandTerm{}};
        for (const ExprId child : children) product = times(product, terms(child));
        return product;
      }
      case Op::divide:
        return times(terms(children[0]), of_reciprocal(children[1]));
      case Op::power: {
        if (node.exponent < 1 || node.exponent > highest_summand_power) return other(id);
        const Terms once = terms(children[0]);
        Terms product = std::vector{SummandTerm{}};
        for (int k = 0; k < node.exponent; ++k) product = times(product, once);
        return product;
      }
      case Op::real_power:
        if (!runs(children[0]))
          if (const auto slope = slope_of(children[1])) return of_ratio(id, raised(children[0], *slope));
        return other(id);
      case Op::function:
        if (node.function == Function::exp)
          if (const auto slope = slope_of(children[0])) return of_ratio(id, exponential(*slope));
        return other(id);
      default:
        return other(id);
    }
  }

  /// From Δ(k^m g) = k^m g (r − 1) + r Σ_{j<m} (m over j) k^j g; without g, k^m is (Δk^{m+1} − Σ_{j<m} …)/(m
  /// + 1).
  std::optional<ExprId> antidifference(const SummandTerm& term) {
    if (!term.others.empty() || term.power > highest_summand_power) return std::nullopt;
    std::vector<ExprId> found;
    const bool plain = term.geometric.empty();
    const ExprId g = product_of(tree_, term.geometric, span_);
    const ExprId r = product_of(tree_, term.ratios, span_);
    for (int m = 0; m <= term.power; ++m) {
      const int top = plain ? m + 1 : m;
      std::vector<ExprId> parts{product_of(tree_, {power(top), g}, span_)};
      for (int j = 0; j < m; ++j) {
        std::vector<ExprId> factors{number(binomial(top, j)), found[static_cast<std::size_t>(j)]};
        if (!plain) factors.push_back(r);
        parts.push_back(negative(product_of(tree_, std::move(factors), span_)));
      }
      const ExprId above = sum(std::move(parts));
      const ExprId below = plain ? number(m + 1) : sum({r, negative(number(1))});
      const ExprId quotient[] = {above, below};
      found.push_back(tree_.add({.op = Op::divide, .span = span_}, quotient));
    }
    return found.back();
  }

 private:
  ExprId number(int value) { return tree_.add_number(span_, std::to_string(value)); }
  ExprId negative(ExprId id) { return tree_.add({.op = Op::negate, .span = span_}, std::span(&id, 1)); }
  ExprId sum(std::vector<ExprId> parts) {
    return parts.size() == 1 ? parts[0] : tree_.add({.op = Op::add, .span = span_}, parts);
  }
  ExprId power(int exponent) {
    const ExprId variable = tree_.add({.op = Op::symbol, .span = span_, .symbol = running_.variable});
    if (exponent == 0) return number(1);
    if (exponent == 1) return variable;
    return tree_.add({.op = Op::power, .span = span_, .exponent = exponent}, std::span(&variable, 1));
  }
  ExprId exponential(ExprId argument) {
    return tree_.add({.op = Op::function, .span = span_, .function = Function::exp}, std::span(&argument, 1));
  }
  static int binomial(int n, int k) {
    int result = 1;
    for (int j = 0; j < k; ++j) result = result * (n - j) / (j + 1);
    return result;
  }

  /// r^α of a whole number α is a power like any other.
  ExprId raised(ExprId base, ExprId slope) {
    const bool minus = tree_[slope].op == Op::negate;
    const ExprId size = minus ? tree_.children(slope)[0] : slope;
    if (tree_[size].op == Op::number && tree_.digits(size).size() == 1) {
      const int exponent = (minus ? -1 : 1) * (tree_.digits(size)[0] - '0');
      if (exponent == 1) return base;
      return tree_.add({.op = Op::power, .span = span_, .exponent = exponent}, std::span(&base, 1));
    }
    const ExprId parts[] = {base, slope};
    return tree_.add({.op = Op::real_power, .span = span_}, parts);
  }

  bool runs(ExprId id) const {
    return std::ranges::any_of(symbols_in(tree_, id), [&](SymbolId symbol) {
      return symbol == running_.variable || running_.changes(symbol);
    });
  }

  /// α of αk + β.
  std::optional<ExprId> slope_of(ExprId id) {
    const Terms parts = terms(id);
    if (!parts) return std::nullopt;
    std::vector<ExprId> slopes;
    for (const SummandTerm& part : *parts) {
      if (!part.others.empty() || !part.geometric.empty() || part.power > 1) return std::nullopt;
      if (part.power == 1) slopes.push_back(product_of(tree_, part.constant, span_));
    }
    if (slopes.empty()) return std::nullopt;
    return sum(std::move(slopes));
  }

  Terms other(ExprId id) const { return std::vector{SummandTerm{.others = {id}}}; }
  static Terms of_ratio(ExprId id, ExprId ratio) {
    return std::vector{SummandTerm{.geometric = {id}, .ratios = {ratio}}};
  }

  Terms of_sum(const std::vector<ExprId>& children) {
    std::vector<SummandTerm> all;
    for (const ExprId child : children) {
      const Terms more = terms(child);
      if (!more || all.size() + more->size() > most_summand_terms) return std::nullopt;
      all.insert(all.end(), more->begin(), more->end());
    }
    return all;
  }

  static Terms times(const Terms& a, const Terms& b) {
    if (!a || !b || a->size() * b->size() > most_summand_terms) return std::nullopt;
    std::vector<SummandTerm> all;
    for (const SummandTerm& left : *a) {
      for (const SummandTerm& right : *b) {
        SummandTerm both = left;
        both.power += right.power;
        const auto append = [](std::vector<ExprId>& to, const std::vector<ExprId>& more) {
          to.insert(to.end(), more.begin(), more.end());
        };
        append(both.constant, right.constant);
        append(both.geometric, right.geometric);
        append(both.ratios, right.ratios);
        append(both.others, right.others);
        all.push_back(std::move(both));
      }
    }
    return all;
  }

  ExprId reciprocal(ExprId id) {
    return tree_.add({.op = Op::power, .span = span_, .exponent = -1}, std::span(&id, 1));
  }

  Terms of_reciprocal(ExprId divisor) {
    if (!runs(divisor)) return std::vector{SummandTerm{.constant = {reciprocal(divisor)}}};
    const Terms below = terms(divisor);
    if (!below || below->size() != 1 || !below->front().others.empty() || below->front().power > 0)
      return other(reciprocal(divisor));
    SummandTerm over = below->front();
    for (std::vector<ExprId>* factors : {&over.constant, &over.geometric, &over.ratios}) {
      for (ExprId& each : *factors) each = reciprocal(each);
    }
    return std::vector{std::move(over)};
  }

  ExprTree& tree_;
  const Running& running_;
  Span span_;
};

}  // namespace

std::optional<std::vector<SummandTerm>> summand_terms(ExprTree& tree, ExprId summand, const Running& running,
                                                      Span span) {
  return Antidifferences(tree, running, span).terms(summand);
}

std::optional<ExprId> antidifference(ExprTree& tree, const SummandTerm& term, const Running& running,
                                     Span span) {
  return Antidifferences(tree, running, span).antidifference(term);
}

}  // namespace rigor
