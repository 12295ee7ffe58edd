// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/average/average_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <span>
#include <utility>

#include "base/among.h"
#include "elaborate/name/function_value.h"
#include "elaborate/symbol/average.h"
#include "expr/calculus/integrate.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

constexpr std::size_t most_terms_averaged = 200;
constexpr int highest_power_averaged = 8;  // of a sum that is multiplied out, or of operators side by side

enum class Outcomes : std::uint8_t { same, same_by_convention, any };

bool names_it(const std::set<std::string>& letters, const NameKey& key) {
  return letters.contains(complex_name(key.base, key.rank)) || letters.contains(key.base) ||
         letters.contains(without_labels(key.base));
}

Outcomes outcomes_of(const ExprTree& tree, const Names& names, SymbolId symbol) {
  const SymbolId base = base_of(tree.symbols, symbol);
  const Symbol& known = tree.symbols[base];
  if (known.integral) {
    if (known.integral->average) return Outcomes::same;
    const bool any = std::ranges::any_of(letters_in(tree, known.integral->integrand), [&](SymbolId each) {
      return each != base && each != known.integral->variable && may_fluctuate(tree, names, each);
    });
    return any ? Outcomes::any : Outcomes::same;
  }
  if (known.is_fixed() || is_declared_constant(names.scope, base)) return Outcomes::same;
  const NameKey* key = key_of(names.symbols, base);
  if (key == nullptr || known.noncommuting) return Outcomes::any;
  const std::string name = complex_name(key->base, key->rank);
  if (is_same_for_all_outcomes(name)) return Outcomes::same;
  const Evidence& evidence = *names.symbols.evidence;
  if (names_it(evidence.averaged, *key) || !evidence.beside_averages.contains(name)) return Outcomes::any;
  return Outcomes::same_by_convention;
}

/// A product: factors that are the same for all outcomes, and the others in their order.
struct AveragedTerm {
  std::vector<ExprId> same = {};
  std::vector<ExprId> any = {};
};
using AveragedTerms = std::optional<std::vector<AveragedTerm>>;

/// b^n with b from the front.
struct PowerOfFactor {
  ExprId base{};
  int exponent = 1;
};

class Averaging {
 public:
  Averaging(ExprTree& tree, const Names& names, Span span) : tree_(tree), names_(names), span_(span) {}

  std::optional<AverageValue> value(ExprId inside) {
    ordered_ = keeps_its_order(inside);
    const AveragedTerms parts = terms(inside);
    if (!parts) return std::nullopt;
    std::vector<ExprId> values;
    bool any = false;
    for (const AveragedTerm& part : *parts) {
      std::vector<ExprId> factors = part.same;
      any = any || !part.any.empty();
      if (const auto average = average_of(part.any)) factors.push_back(*average);
      values.push_back(product_of(tree_, std::move(factors), span_));
    }
    if (!any && !outside_.empty()) return std::nullopt;
    AverageValue result{.value = values.size() == 1 ? values[0]
                                                    : tree_.add({.op = Op::add, .span = span_}, values)};
    for (const SymbolId each : outside_)
      result.conventions.push_back(fmt::format(
          "`{}` does not fluctuate, since it stands outside of the averages", tree_.symbols[each].name));
    for (const SymbolId each : observables_)
      result.conventions.push_back(
          fmt::format("averages of `{}` are real, as those of an observable", tree_.symbols[each].name));
    return result;
  }

 private:
  // --- what changes

  /// Operators, and letters that may be some.
  bool keeps_its_order(ExprId id) const {
    return std::ranges::any_of(symbols_in(tree_, id), [&](SymbolId symbol) {
      const SymbolId base = base_of(tree_.symbols, symbol);
      const NameKey* key = key_of(names_.symbols, base);
      return tree_.symbols[base].noncommuting ||
             (key != nullptr && names_.symbols.evidence->is_ordered(without_labels(key->base)));
    });
  }

  bool is_same(ExprId id) {
    std::vector<SymbolId> taken;
    for (const SymbolId symbol : symbols_in(tree_, id)) {
      const Outcomes outcomes = outcomes_of(tree_, names_, symbol);
      if (outcomes == Outcomes::any) return false;
      if (outcomes == Outcomes::same_by_convention) taken.push_back(base_of(tree_.symbols, symbol));
    }
    for (const SymbolId symbol : taken) {
      if (!is_one_of(symbol, outside_)) outside_.push_back(symbol);
    }
    return true;
  }

  // --- trees

  ExprId number(int value) { return tree_.add_number(span_, std::to_string(value)); }
  ExprId minus_one() {
    const ExprId one = number(1);
    return tree_.add({.op = Op::negate, .span = span_}, std::span(&one, 1));
  }
  ExprId power(ExprId base, int exponent) {
    if (exponent == 1) return base;
    return tree_.add({.op = Op::power, .span = span_, .exponent = exponent}, std::span(&base, 1));
  }
  ExprId conjugate(ExprId id) {
    if (tree_[id].op == Op::conjugate) return tree_.children(id)[0];
    if (const auto observables = observables_with_real_average(names_, tree_, id)) {
      for (const SymbolId each : *observables) {
        if (!is_one_of(each, observables_)) observables_.push_back(each);
      }
      return id;
    }
    return tree_.add({.op = Op::conjugate, .rank = tree_[id].rank, .span = span_}, std::span(&id, 1));
  }

  // --- terms

  AveragedTerms terms(ExprId id) {
    if (tree_[id].rank != 0) return std::nullopt;
    if (is_same(id)) return std::vector{AveragedTerm{.same = {id}}};
    const ExprNode node = tree_[id];
    const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
    switch (node.op) {
      case Op::add: {
        std::vector<AveragedTerm> all;
        for (const ExprId child : children) {
          const AveragedTerms more = terms(child);
          if (!more || all.size() + more->size() > most_terms_averaged) return std::nullopt;
          all.insert(all.end(), more->begin(), more->end());
        }
        return all;
      }
      case Op::negate:
        return times(std::vector{AveragedTerm{.same = {minus_one()}}}, terms(children[0]));
      case Op::multiply: {
        AveragedTerms product = std::vector{AveragedTerm{}};
        for (const ExprId child : children) product = times(product, terms(child));
        return product;
      }
      case Op::divide:
        return times(terms(children[0]), powers(children[1], -1));
      case Op::power:
        return powers(children[0], node.exponent);
      case Op::conjugate:
        return conjugated(terms(children[0]));
      default:
        return std::vector{AveragedTerm{.any = {id}}};
    }
  }

  static AveragedTerms times(const AveragedTerms& a, const AveragedTerms& b) {
    if (!a || !b || a->size() * b->size() > most_terms_averaged) return std::nullopt;
    std::vector<AveragedTerm> all;
    for (const AveragedTerm& left : *a) {
      for (const AveragedTerm& right : *b) {
        AveragedTerm both = left;
        both.same.insert(both.same.end(), right.same.begin(), right.same.end());
        both.any.insert(both.any.end(), right.any.begin(), right.any.end());
        all.push_back(std::move(both));
      }
    }
    return all;
  }

  AveragedTerms powers(ExprId base, int exponent) {
    if (is_same(base)) return std::vector{AveragedTerm{.same = {power(base, exponent)}}};
    const ExprNode node = tree_[base];
    const std::vector<ExprId> parts(tree_.children(base).begin(), tree_.children(base).end());
    AveragedTerms result = std::vector{AveragedTerm{}};
    const bool multiplies_out = exponent > 0 && exponent <= highest_power_averaged;
    if (multiplies_out && (ordered_ || node.op == Op::add)) {
      const AveragedTerms once = terms(base);
      for (int k = 0; k < exponent; ++k) result = times(result, once);
      return result;
    }
    if (ordered_) return std::vector{AveragedTerm{.any = {power(base, exponent)}}};
    switch (node.op) {
      case Op::multiply:
        for (const ExprId part : parts) result = times(result, powers(part, exponent));
        return result;
      case Op::divide:
        return times(powers(parts[0], exponent), powers(parts[1], -exponent));
      case Op::negate:
        if (exponent % 2 != 0) result->front().same.push_back(minus_one());
        return times(result, powers(parts[0], exponent));
      case Op::function: {
        if (node.function != Function::sin || !multiplies_out || exponent < 2) break;
        const ExprId cosine =
            tree_.add({.op = Op::function, .span = span_, .function = Function::cos}, parts);
        const AveragedTerms square =
            std::vector{AveragedTerm{}, AveragedTerm{.same = {minus_one()}, .any = {cosine, cosine}}};
        for (int k = 0; k < exponent / 2; ++k) result = times(result, square);
        return exponent % 2 == 0 ? result
                                 : times(result, std::vector{AveragedTerm{.same = {}, .any = {base}}});
      }
      case Op::power:
        if (std::abs(exponent * node.exponent) > highest_power_averaged) break;
        return powers(parts[0], exponent * node.exponent);
      default:
        break;
    }
    return std::vector{AveragedTerm{.any = {power(base, exponent)}}};
  }

  AveragedTerms conjugated(AveragedTerms parts) {
    if (!parts) return parts;
    for (AveragedTerm& part : *parts) {
      for (ExprId& each : part.same) each = conjugate(each);
      part.any = adjoint(std::move(part.any));
    }
    return parts;
  }

  std::vector<ExprId> adjoint(std::vector<ExprId> factors) {
    std::ranges::reverse(factors);
    for (ExprId& each : factors) each = conjugate(each);
    return factors;
  }

  // --- averages of products

  /// In one order, powers together; operators where they stand.
  std::vector<ExprId> in_order(const std::vector<ExprId>& factors) {
    std::vector<PowerOfFactor> powers;
    for (const ExprId factor : factors) {
      PowerOfFactor next{factor};
      if (tree_[factor].op == Op::power) next = {tree_.children(factor)[0], tree_[factor].exponent};
      const auto is_it = [&](const PowerOfFactor& each) {
        return same_expression(tree_, each.base, tree_, next.base);
      };
      if (ordered_) {
        if (!powers.empty() && is_it(powers.back()))
          powers.back().exponent += next.exponent;
        else
          powers.push_back(next);
        continue;
      }
      const auto known = std::ranges::find_if(powers, is_it);
      if (known == powers.end())
        powers.push_back(next);
      else
        known->exponent += next.exponent;
    }
    std::erase_if(powers, [](const PowerOfFactor& each) { return each.exponent == 0; });
    if (!ordered_)
      std::ranges::stable_sort(powers, {}, [&](const PowerOfFactor& each) { return dump(tree_, each.base); });
    std::vector<ExprId> result;
    for (const PowerOfFactor& each : powers) result.push_back(power(each.base, each.exponent));
    return result;
  }

  [[nodiscard]] std::optional<SymbolId> known_average(ExprId inside) const {
    for (std::uint32_t k = 0; k < tree_.symbols.size(); ++k) {
      const auto& known = tree_.symbols[SymbolId{k}].integral;
      if (known && known->average && same_expression(tree_, known->integrand, tree_, inside))
        return SymbolId{k};
    }
    return std::nullopt;
  }

  /// Nothing where no factor is left. That of an adjoint is the conjugate.
  std::optional<ExprId> average_of(const std::vector<ExprId>& factors) {
    const std::vector<ExprId> own = in_order(factors);
    if (own.empty()) return std::nullopt;
    const ExprId inside = product_of(tree_, own, span_);
    const ExprId other = product_of(tree_, in_order(adjoint(factors)), span_);
    if (!same_expression(tree_, inside, tree_, other)) {
      const auto own_average = known_average(inside);
      const auto known = known_average(other);
      if (known && (!own_average || *known < *own_average)) return conjugate(as_node(*known));
    }
    const bool complex = !observables_with_real_average(names_, tree_, inside);
    return as_node(symbol_of_average(tree_, inside, complex, span_));
  }

  ExprId as_node(SymbolId symbol) { return tree_.add({.op = Op::symbol, .span = span_, .symbol = symbol}); }

  ExprTree& tree_;
  const Names& names_;
  Span span_;
  bool ordered_ = false;
  std::vector<SymbolId> outside_;
  std::vector<SymbolId> observables_;
};

/// What holds at an instant only says nothing of an average.
bool holds_at_all_times(const ExprTree& tree, const NameScope& scope, ExprId body) {
  return std::ranges::none_of(symbols_reached(tree, scope, {body}), [&](SymbolId each) {
    const NamedDefinition* named = definition_of(scope, each);
    return named != nullptr && named->at_instant;
  });
}

/// Of a letter that changes only where its definition is one for outcomes.
std::optional<AverageValue> average_value(ExprTree& tree, const Names& names, ExprId inside,
                                          const Opener& opened) {
  const auto body = holds_at_all_times(tree, names.scope, inside) ? opened(inside) : std::nullopt;
  if (!body) return std::nullopt;
  const auto fluctuates = [&](SymbolId each) { return may_fluctuate(tree, names, each); };
  const bool before = std::ranges::any_of(symbols_in(tree, inside), fluctuates);
  if (before && std::ranges::none_of(symbols_in(tree, *body), fluctuates)) return std::nullopt;
  return Averaging(tree, names, tree[inside].span).value(*body);
}

}  // namespace

std::optional<AverageValue> value_of_average(ExprTree& tree, const Names& names, SymbolId average,
                                             const Opener& opened) {
  auto found = average_value(tree, names, tree.symbols[average].integral->integrand, opened);
  if (!found || is_one_of(average, symbols_in(tree, found->value))) return std::nullopt;
  // \langle xp + px\rangle is real, though its terms are not.
  const bool real = !tree.symbols[average].complex && has_complex_numbers(tree, found->value);
  if (real)
    found->value =
        tree.add({.op = Op::real_part, .span = tree[found->value].span}, std::span(&found->value, 1));
  return found;
}

std::optional<Equation> averaged_law(ExprTree& tree, const Names& names, const Equation& law,
                                     const Opener& opened) {
  const bool plain = law.relation == Relation::equal && law.indices.empty() && law.particles.empty() &&
                     tree[law.left].rank == 0;
  const auto left = plain ? average_value(tree, names, law.left, opened) : std::nullopt;
  const auto right = left ? average_value(tree, names, law.right, opened) : std::nullopt;
  if (!right) return std::nullopt;
  return Equation{.left = left->value, .right = right->value};
}

bool may_fluctuate(const ExprTree& tree, const Names& names, SymbolId symbol) {
  return outcomes_of(tree, names, symbol) == Outcomes::any;
}

bool fluctuates_surely(const ExprTree& tree, const Names& names, SymbolId symbol) {
  const NameKey* key = key_of(names.symbols, base_of(tree.symbols, symbol));
  return key != nullptr && names_it(names.symbols.evidence->averaged, *key);
}

}  // namespace rigor
