// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/antiderivatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/among.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

bool is_antiderivative(const ExprTree& tree, SymbolId symbol) {
  const std::optional<Integral>& integral = tree.symbols[symbol].integral;
  return integral && !integral->lower && !integral->upper && !integral->average;
}

/// One side as Σ c·∫f + rest.
struct Split {
  struct Part {
    std::vector<ExprId> factors;  // constant
    SymbolId integral{};
    bool negative = false;
  };
  std::vector<Part> parts;
  std::vector<ExprId> rest;
};

class Differentiating {
 public:
  Differentiating(Reading& reading, const Integral& integral) : reading_(reading), integral_(integral) {}

  /// With the definitions of the place put in, so that what runs with the variable shows.
  ExprId opened(ExprId id) {
    constexpr int deepest = 8;
    for (int k = 0; k < deepest; ++k) {
      const ExprId next = replaced(tree(), id, [&](ExprId symbol) -> std::optional<ExprId> {
        if (tree()[symbol].symbol == integral_.variable) return std::nullopt;
        const NamedDefinition* named = definition_of(reading_.names.scope, tree()[symbol].symbol);
        const bool whole = named != nullptr && named->definition.indices.empty() &&
                           named->definition.particle == no_particle && !named->definition.by_square &&
                           tree()[symbol].slot_count == 0;
        return whole ? std::optional(named->definition.body) : std::nullopt;
      });
      if (next == id) break;
      id = next;
    }
    return id;
  }

  /// Does the variable itself stand there?
  bool shows_variable(ExprId id) {
    return std::ranges::any_of(symbols_in(tree(), id), [&](SymbolId symbol) {
      if (symbol == integral_.variable) return true;
      if (tree().symbols[symbol].integral) return false;
      const auto& values = reading_.names.symbols.function_values;
      const auto value = values.find(symbol);
      if (value != nullptr)
        return std::ranges::any_of(value->second.at, [&](ExprId at) { return shows_variable(at); });
      const NameKey* own = key_of(reading_.names.symbols, symbol);
      const NameKey* of = key_of(reading_.names.symbols, integral_.variable);
      return own != nullptr && of != nullptr &&
             is_function_of(*reading_.names.symbols.evidence, own->base, of->base);
    });
  }

  void take_constants(ExprId integrand) {
    if (!is_one_of(integral_.variable, symbols_in(tree(), integrand))) return;
    for (const SymbolId each : symbols_in(tree(), integrand)) beside_variable_.insert(each);
  }

  bool split(ExprId id, bool negative, std::vector<ExprId> factors, Split& into) {
    const ExprNode node = tree()[id];
    const std::vector<ExprId> children(tree().children(id).begin(), tree().children(id).end());
    if (!has_antiderivative(tree(), id)) {
      factors.push_back(id);
      const ExprId whole = product(std::move(factors));
      into.rest.push_back(negative ? make(Op::negate, {whole}) : whole);
      return true;
    }
    switch (node.op) {
      case Op::symbol:
        into.parts.push_back({std::move(factors), node.symbol, negative});
        return true;
      case Op::add:
        return std::ranges::all_of(children,
                                   [&](ExprId child) { return split(child, negative, factors, into); });
      case Op::negate:
        return split(children[0], !negative, std::move(factors), into);
      case Op::divide:
        if (has_antiderivative(tree(), children[1]) || runs(children[1])) return false;
        factors.push_back(make(Op::divide, {tree().add_number(node.span, "1"), children[1]}));
        return split(children[0], negative, std::move(factors), into);
      case Op::multiply: {
        const auto holds = [&](ExprId child) { return has_antiderivative(tree(), child); };
        const auto integral = std::ranges::find_if(children, holds);
        if (std::ranges::count_if(children, holds) != 1) return false;
        for (const ExprId& child : children) {
          if (&child == &*integral) continue;
          if (runs(child)) return false;
          factors.push_back(child);
        }
        return split(*integral, negative, std::move(factors), into);
      }
      default:
        return false;
    }
  }

  /// Σ c·f + the derivative of the rest.
  std::optional<ExprId> derivative(const Split& split, Span span) {
    const auto dependence_of = [this](SymbolId symbol) { return dependence(symbol); };
    DerivativeBudget budget;
    Differentiator differentiate(tree(), integral_.by, dependence_of, budget, {integral_.axis, {}});
    std::vector<ExprId> terms;
    for (const Split::Part& part : split.parts) {
      std::vector<ExprId> factors = part.factors;
      factors.push_back(opened(tree().symbols[part.integral].integral->integrand));
      const ExprId whole = product(std::move(factors));
      terms.push_back(part.negative ? make(Op::negate, {whole}) : whole);
    }
    for (const ExprId each : split.rest) {
      if (const auto changed = differentiate.derivative(each)) terms.push_back(*changed);
    }
    if (budget.exceeded) return std::nullopt;
    if (terms.empty()) return tree().add_number(span, "0");
    return terms.size() == 1 ? terms[0] : make(Op::add, std::move(terms));
  }

 private:
  ExprTree& tree() { return reading_.tree; }

  ExprId make(Op op, std::vector<ExprId> children) {
    return tree().add({.op = op, .span = tree()[children[0]].span}, children);
  }
  ExprId product(std::vector<ExprId> factors) {
    return factors.size() == 1 ? factors[0] : make(Op::multiply, std::move(factors));
  }

  bool runs(ExprId id) {
    return std::ranges::any_of(symbols_in(tree(), id), [&](SymbolId symbol) {
      return dependence(symbol).kind != Dependence::Kind::constant;
    });
  }

  /// The constant of integration, which nobody declares.
  static bool is_usual_constant(const std::string& name) {
    return is_one_of(without_labels(name), {"C", "c", "K", "D"});
  }

  /// Beside the variable itself, other letters are constants, unless the section shows that they change.
  /// Where it is not written, they may be functions of it: then only a proof counts.
  Dependence dependence(SymbolId symbol) {
    using Kind = Dependence::Kind;
    const Names& names = reading_.names;
    const Symbol& known = tree().symbols[symbol];
    if (symbol == integral_.variable) return {Kind::variable, integral_.axis};
    if (known.is_fixed() || is_declared_constant(names.scope, symbol)) return {Kind::constant};
    if (known.derivation || known.rank > 0 || known.per_particle || known.integral) return {Kind::varies};
    if (names.scope.variables.contains(symbol)) return {Kind::varies};
    const auto value = names.symbols.function_values.find(symbol);
    if (value != nullptr) {
      const bool at_variable =
          std::ranges::any_of(value->second.at, [&](ExprId at) { return shows_variable(at); });
      return {at_variable ? Kind::varies : Kind::constant};
    }
    const NameKey* key = key_of(names.symbols, symbol);
    const Evidence& evidence = *names.symbols.evidence;
    if (key == nullptr || is_changing(evidence, key->base)) return {Kind::varies};
    if (is_usual_constant(key->base)) return {Kind::constant};
    const bool beside = beside_variable_.contains(symbol);
    const bool may_change = beside ? changes_in_section(names, symbol) : may_be_changing(evidence, key->base);
    const bool said = beside && !may_change;
    std::vector<SymbolId>& unknown = reading_.found.unknown_changes;
    if (!said && !is_one_of(symbol, unknown)) unknown.push_back(symbol);
    return {may_change ? Kind::varies : Kind::constant};
  }

  Reading& reading_;
  const Integral& integral_;
  std::set<SymbolId> beside_variable_;
};

}  // namespace

bool has_antiderivative(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(symbols_in(tree, root),
                             [&](SymbolId symbol) { return is_antiderivative(tree, symbol); });
}

std::optional<Differentiated> differentiated(Reading& reading, const Equation& equation,
                                             const std::vector<ExprId>& sides, Span place,
                                             Diagnostics& diagnostics) {
  const auto fails = [&](DiagnosticKind kind, std::string message, std::vector<std::string> help = {}) {
    report(diagnostics, kind, place, std::move(message), std::move(help));
    return std::nullopt;
  };
  ExprTree& tree = reading.tree;
  std::vector<SymbolId> integrals;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      if (is_antiderivative(tree, symbol)) integrals.push_back(symbol);
    }
  }
  const Integral integral = *tree.symbols[integrals.front()].integral;
  const std::string& by = tree.symbols[integral.variable].name;
  if (equation.relation != Relation::equal)
    return fails(DiagnosticKind::unsupported, "an order between integrals without limits is not read");
  if (std::ranges::any_of(integrals, [&](SymbolId each) {
        return tree.symbols[each].integral->variable != integral.variable;
      }))
    return fails(DiagnosticKind::unsupported,
                 "integrals without limits over different letters are not compared");
  Differentiating differentiating(reading, integral);
  Equation derivatives = equation;
  std::array<Split, 2> split;
  std::array<ExprId, 2> open{differentiating.opened(equation.left), differentiating.opened(equation.right)};
  for (const SymbolId each : integrals)
    differentiating.take_constants(differentiating.opened(tree.symbols[each].integral->integrand));
  for (std::size_t k = 0; k < 2; ++k) {
    if (!differentiating.split(open[k], false, {}, split[k]))
      return fails(DiagnosticKind::unsupported,
                   "an integral without limits is read as a term of its own, with constant factors");
  }
  // `\int|\psi|^2\,dx = 1` is over all values.
  const bool sure = std::ranges::any_of(
      sides, [&](ExprId side) { return differentiating.shows_variable(differentiating.opened(side)); });
  if (!sure && (split[0].parts.empty() || split[1].parts.empty()))
    return fails(
        DiagnosticKind::ambiguous_reading,
        fmt::format("without limits this can be a function of `{}`, or an integral over all its values", by),
        {"limits say which is meant"});
  if (!sure)
    reading.found.guess =
        Obstacle{DiagnosticKind::ambiguous_reading,
                 fmt::format("the integrals can be functions of `{}`, or over all its values", by),
                 {"limits say which is meant"}};
  const auto left = differentiating.derivative(split[0], tree[equation.left].span);
  const auto right = differentiating.derivative(split[1], tree[equation.right].span);
  if (!left || !right)
    return fails(DiagnosticKind::unsupported, "the derivatives of these integrals are too large");
  derivatives.left = *left;
  derivatives.right = *right;
  return Differentiated{derivatives, by};
}

}  // namespace rigor
