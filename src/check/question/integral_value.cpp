// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/integral_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "base/among.h"
#include "check/question/decision_cache.h"
#include "check/question/running_letters.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/differentiate.h"
#include "expr/print/print_latex.h"
#include "expr/tree/rough_value.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// Each new primitive is compared with all others, and the neighbours of a row have hundreds.
constexpr std::size_t most_unknown = 64;
constexpr Limits brief{.expanded_terms = 4'000,
                       .steps = 200'000,
                       .sample_attempts = 60,
                       .fewest_assumptions = false,
                       .simplest_sample = false};

/// `V''` of V'' where primes differentiate, as the notes write its values; else as it is printed.
std::string name_of_function(const ExprTree& tree, ExprId id) {
  const auto& derivation = tree.symbols[tree[id].symbol].derivation;
  const bool primed = derivation && std::ranges::all_of(derivation->by, [](const Variable& by) {
                        return by.by == By::letter && !by.partial;
                      });
  if (!primed) return print_latex(tree, id);
  return tree.symbols[derivation->base].name + std::string(derivation->by.size(), '\'');
}

}  // namespace

Decision IntegralValues::ask(Equation claim) {
  Question question{.tree = &tree_, .claim = std::move(claim)};
  std::vector<const NamedAssumption*> named;
  for (const NamedAssumption& each : names_.scope.assumptions) {
    if (each.equation.relation == Relation::equal || each.without_sample) continue;
    question.assumptions.push_back(each.equation);
    named.push_back(&each);
  }
  Decision decision = decide(nullptr, question, brief);
  if (decision.outcome != Outcome::proved) return decision;
  for (const std::size_t which : decision.assumptions) {
    if (!is_one_of(named[which], relied_on_)) relied_on_.push_back(named[which]);
  }
  return decision;
}

namespace {

/// At one point with numbers near 1 for all letters, π as it is; false where one has no value there.
bool differ_at_a_point(const ExprTree& tree, ExprId a, ExprId b) {
  constexpr double tolerance = 1e-6;  // of rounding errors, and far below what unlike expressions differ by
  const auto value = [&](SymbolId symbol) {
    if (tree.symbols[symbol].circle_number) return std::numbers::pi;
    return 0.5 + std::fmod(static_cast<double>(static_cast<std::uint32_t>(symbol)) * std::numbers::phi, 1.0);
  };
  const double at_a = rough_value(tree, a, value);
  const double at_b = rough_value(tree, b, value);
  return std::abs(at_a - at_b) > tolerance * (1 + std::abs(at_a) + std::abs(at_b));
}

}  // namespace

/// What holds of moduli and roots of real numbers need not hold where letters are complex.
bool IntegralValues::are_equal(ExprId a, ExprId b) const {
  if (same_expression(tree_, a, tree_, b)) return true;
  const auto letters = [&](ExprId id) {
    const std::vector<SymbolId> inside = symbols_in(tree_, id);
    return std::set<SymbolId>(inside.begin(), inside.end());
  };
  if (letters(a) != letters(b)) return false;
  for (const ExprId id : nodes_below(tree_, {a, b})) {
    if (tree_[id].op == Op::absolute || tree_[id].op == Op::root) return false;
  }
  if (differ_at_a_point(tree_, a, b)) return false;
  Equation claim;
  claim.left = a;
  claim.right = b;
  return decide(nullptr, {.tree = &tree_, .claim = claim}, brief).outcome == Outcome::proved;
}

ExprId IntegralValues::negative(ExprId id, Span span) {
  return tree_.add({.op = Op::negate, .span = span}, std::span(&id, 1));
}

ExprId IntegralValues::difference(ExprId upper, ExprId lower, Span span) {
  if (tree_.is_zero_literal(lower)) return upper;
  const std::array terms{upper, negative(lower, span)};
  return tree_.add({.op = Op::add, .span = span}, terms);
}

/// Does a symbol have another value where the variable has? Where nothing excludes it, it does.
/// `shown`: the variable stands beside it.
bool IntegralValues::changes_with(SymbolId variable, SymbolId symbol, bool shown) const {
  const auto holds_variable = [&](ExprId id) {
    return std::ranges::any_of(symbols_in(tree_, id), [&](SymbolId each) {
      return each == variable || (each != symbol && changes_with(variable, each, shown));
    });
  };
  if (symbol == variable) return true;
  if (bound_ == symbol) return false;
  if (sources_.contains(symbol)) return bound_ == variable;
  const Symbol& known = tree_.symbols[symbol];
  if (bound_ == variable && !known.integral) return false;  // what changes with it was put there
  if (known.is_fixed() || is_declared_constant(names_.scope, symbol)) return false;
  if (known.integral) {
    const auto& upper = known.integral->upper;
    const bool reaches = !upper || (upper->at && holds_variable(*upper->at));
    return reaches || known.integral->lower || holds_variable(known.integral->integrand);
  }
  if (known.derivation || known.rank > 0 || known.per_particle) return true;
  if (const auto value = names_.symbols.function_values.find(symbol); value != nullptr)
    return std::ranges::any_of(value->second.at, holds_variable);
  if (std::ranges::any_of(values_, [&](const auto& entry) { return entry.second == symbol; })) return false;
  if (!shown) return may_run_(symbol) || is_tied_to(names_, symbol, variable);
  return shows_change(names_, symbol, variable);
}

/// f(x), where x is the variable of f and of the integral, is f.
ExprId IntegralValues::bare(const Integral& integral) const {
  return replaced(tree_, integral.integrand, [&](ExprId id) -> std::optional<ExprId> {
    const auto known = names_.symbols.function_values.find(tree_[id].symbol);
    const NameKey* key = key_of(names_.symbols, integral.variable);
    if (known == nullptr || key == nullptr) return std::nullopt;
    const FunctionValue& value = known->second;
    const bool own = value.variables == std::vector{key->base} && value.at.size() == 1 &&
                     tree_[value.at[0]].op == Op::symbol && tree_[value.at[0]].symbol == integral.variable;
    if (!own || tree_[id].rank != 0) return std::nullopt;
    const int rank = tree_.symbols[value.of].rank;  // of a derivative by place
    if (rank > 0 && integral.axis == 0) return std::nullopt;
    const std::vector<Slot> slots(static_cast<std::size_t>(rank), Slot{integral.axis, {}});
    return tree_.add({.op = Op::symbol, .span = tree_[id].span, .symbol = value.of}, {}, slots);
  });
}

/// f of f', df/dx or ∂f/∂x along the variable's axis.
std::optional<ExprId> IntegralValues::function_of_rate(const Integral& integral, ExprId rate) const {
  const ExprNode node = tree_[rate];
  const auto& derivation = tree_.symbols[node.symbol].derivation;
  if (!derivation || integral.by.partial) return std::nullopt;
  if (derivation->by.count(integral.by) == 0) return std::nullopt;
  std::vector<Slot> slots(tree_.slots(rate).begin(), tree_.slots(rate).end());
  if (integral.by == By::space) {
    const auto along = std::ranges::find(slots, integral.axis, &Slot::axis);
    if (along == slots.end() || slots.size() != derivation->by.count(integral.by)) return std::nullopt;
    slots.erase(along);
  }
  Derivation less = *derivation;
  less.by.erase(integral.by);
  const SymbolId function = tree_.symbols.derivative(less);
  return tree_.add({.op = Op::symbol, .span = node.span, .symbol = function}, {}, slots);
}

/// R of `\int_0^R`: an end stays where it is while the variable runs up to it.
bool IntegralValues::is_end_of(const Integral& integral, SymbolId symbol) const {
  return std::ranges::any_of(std::array{integral.lower, integral.upper}, [&](const auto& limit) {
    return symbol != integral.variable && limit && limit->at &&
           is_one_of(symbol, symbols_in(tree_, *limit->at));
  });
}

Running IntegralValues::running_over(const Integral& integral) const {
  const bool shown = is_one_of(integral.variable, symbols_in(tree_, integral.integrand));
  const auto changes = [this, integral, shown](SymbolId each) {
    return !is_end_of(integral, each) && !is_independent(names_, tree_, each, integral) &&
           changes_with(integral.variable, each, shown);
  };
  return {.variable = integral.variable, .changes = changes, .antiderivative = [this, integral](ExprId rate) {
            return function_of_rate(integral, rate);
          }};
}

/// A value that the notes write, or a new one.
SymbolId IntegralValues::value_named(const std::string& name, ExprId node, const Running& running,
                                     ExprId argument, ExprId value) {
  const auto& written = names_.symbols.function_values;
  const auto known = find_symbol(names_.symbols, {name, 0, false});
  const auto as_written = known ? written.find(*known) : nullptr;
  if (as_written != nullptr && as_written->second.at.size() == 1 &&
      same_expression(tree_, as_written->second.at[0], tree_, argument))
    return *known;
  const auto [entry, fresh] = values_.try_emplace(name);
  if (fresh) entry->second = tree_.symbols.add({.name = name, .first_seen = tree_[node].span});
  if (tree_[value].op == Op::symbol && bound_ == tree_[value].symbol) {
    sources_.try_emplace(entry->second, Source{node, running.variable});
  } else {
    knows_values_ = false;
  }
  return entry->second;
}

bool IntegralValues::is_bound(SymbolId symbol) const {
  if (bound_ == symbol) return true;
  const auto source = sources_.find(symbol);
  if (source == sources_.end()) return false;
  const auto& [node, variable] = source->second;
  const auto value = names_.symbols.function_values.find(tree_[node].symbol);
  if (value != nullptr) return value->second.at.size() == 1;
  return is_function_of_only(names_, tree_, tree_[node].symbol, variable);
}

/// A symbol that changes with the variable, where that has a value; nothing where this cannot be written.
std::optional<ExprId> IntegralValues::symbol_at(ExprId id, const Running& running, ExprId value) {
  const ExprNode node = tree_[id];
  if (node.rank != 0 || node.particle != no_particle || tree_.symbols[node.symbol].integral)
    return std::nullopt;
  if (const auto source = sources_.find(node.symbol); source != sources_.end()) {
    const auto [function, variable] = source->second;
    const Running over{
        .variable = variable,
        .changes = [this, variable](SymbolId each) { return changes_with(variable, each, true); },
        .antiderivative = [](ExprId) { return std::nullopt; }};
    return symbol_at(function, over, value);
  }
  std::string name;
  const auto& values = names_.symbols.function_values;
  if (const auto known = values.find(node.symbol); known != nullptr) {
    std::string arguments;
    ExprId only{};
    for (const ExprId each : known->second.at) {
      const auto argument = at(each, running, value);
      if (!argument) return std::nullopt;
      arguments += (arguments.empty() ? "" : ", ") + print_latex(tree_, *argument);
      only = *argument;
    }
    const std::string& written = tree_.symbols[node.symbol].name;
    name = fmt::format("{}({})", written.substr(0, written.find('(')), arguments);
    if (known->second.indexed) {
      std::erase(arguments, ' ');
      name = fmt::format("{}_{{{}}}", tree_.symbols[known->second.of].name, arguments);
      const auto page = find_symbol(names_.symbols, {name, 0, false});  // `x_1` beside `\sum_{i=1}^nx_i`
      return tree_.add({.op = Op::symbol,
                        .span = node.span,
                        .symbol = page ? *page : value_named(name, id, running, only, value)});
    }
    const bool bare = known->second.at.size() == 1 && tree_[known->second.at[0]].op == Op::symbol;
    if (!bare) name += fmt::format(" at {}", print_latex(tree_, value));
    return tree_.add(
        {.op = Op::symbol, .span = node.span, .symbol = value_named(name, id, running, only, value)});
  }
  const std::string& variable = tree_.symbols[running.variable].name;
  name = is_function_of_only(names_, tree_, node.symbol, running.variable)
             ? fmt::format("{}({})", name_of_function(tree_, id), print_latex(tree_, value))
             : fmt::format("{} at {} = {}", name_of_function(tree_, id), variable, print_latex(tree_, value));
  return tree_.add(
      {.op = Op::symbol, .span = node.span, .symbol = value_named(name, id, running, value, value)});
}

std::optional<ExprId> IntegralValues::at(ExprId id, const Running& running, ExprId value) {
  bool known = true;
  const ExprId result = replaced(tree_, id, [&](ExprId symbol) -> std::optional<ExprId> {
    if (tree_[symbol].symbol == running.variable) return value;
    if (!running.changes(tree_[symbol].symbol)) return std::nullopt;
    const auto there = symbol_at(symbol, running, value);
    known = known && there.has_value();
    return there;
  });
  return known ? std::optional(result) : std::nullopt;
}

/// The factors of a rate, for a message.
std::pair<std::vector<ExprId>, bool> IntegralValues::without_minus(ExprId rate) const {
  std::vector<ExprId> factors{rate};
  if (tree_[rate].op == Op::multiply)
    factors.assign(tree_.children(rate).begin(), tree_.children(rate).end());
  const auto ones = std::erase_if(factors, [&](ExprId each) {
    return tree_[each].op == Op::negate && tree_[tree_.children(each)[0]].op == Op::number &&
           tree_.digits(tree_.children(each)[0]) == "1";
  });
  return {std::move(factors), ones % 2 != 0};
}

/// F at an end; at infinity only where it vanishes there.
std::optional<ExprId> IntegralValues::at_limit(const Primitive& primitive, const Running& running,
                                               const Limit& limit, Span span) {
  if (limit.at) return at(primitive.value, running, *limit.at);
  const ExprId zero = tree_.add_number(span, "0");
  if (primitive.falls) return zero;
  if (!primitive.rate) return std::nullopt;
  Equation falls;
  falls.left = limit.infinity > 0 ? *primitive.rate : zero;
  falls.right = limit.infinity > 0 ? zero : *primitive.rate;
  falls.relation = Relation::less;
  if (holds(falls)) return zero;
  const auto [factors, minus] = without_minus(*primitive.rate);
  sign_ = fmt::format("nothing says that `{}` is {}", print_latex(tree_, product_of(tree_, factors, span)),
                      (limit.infinity > 0) == minus ? "positive" : "negative");
  return std::nullopt;
}

/// Does a term have values from one limit to the other? What it divides by is linear, so it keeps its sign if
/// it has one sign at both. That is a condition, unless it is known or cannot be.
bool IntegralValues::goes_on(const IntegrandTerm& term, const Running& running, const Integral& integral,
                             Span span, IntegralValue& result) {
  const auto divisors = linear_divisors(tree_, term, running, span);
  return std::ranges::all_of(
      divisors, [&](ExprId divisor) { return keeps_its_sign(divisor, running, integral, span, result); });
}

bool IntegralValues::keeps_its_sign(ExprId linear, const Running& running, const Integral& integral,
                                    Span span, IntegralValue& result) {
  const ExprId zero = tree_.add_number(span, "0");
  const auto origin = at(linear, running, zero);
  const auto next = at(linear, running, tree_.add_number(span, "1"));
  if (!origin || !next) return false;
  std::vector<ExprId> ends;
  for (const Limit& limit : {*integral.lower, *integral.upper}) {
    const ExprId slope = difference(*next, *origin, span);
    const auto end = limit.at ? at(linear, running, *limit.at)
                              : std::optional(limit.infinity > 0 ? slope : negative(slope, span));
    if (!end) return false;
    ends.push_back(*end);
  }
  Equation one_sign;
  one_sign.left = zero;
  one_sign.right = product_of(tree_, ends, span);
  one_sign.relation = Relation::less;
  Equation crosses;
  crosses.left = one_sign.right;
  crosses.right = zero;
  crosses.relation = Relation::less_or_equal;
  if (holds(one_sign)) return true;
  if (ask(crosses).outcome != Outcome::refuted) return false;
  // `\int_a^b`, `\int_1^b`: that the ends have one sign goes without saying, but not those of `\int_{-m}^M`.
  const auto is_plain = [&](ExprId end) {
    return std::ranges::none_of(nodes_below(tree_, {end}),
                                [&](ExprId each) { return tree_[each].op == Op::negate; });
  };
  if (!std::ranges::all_of(ends, is_plain)) return false;
  result.conditions.push_back(one_sign);
  return true;
}

/// K_f at a limit; known ones are found again.
std::optional<ExprId> IntegralValues::unknown_at(ExprId integrand, const Running& running, const Limit& limit,
                                                 Span span) {
  if (!bound_) bound_ = tree_.symbols.add({.name = "\\xi", .first_seen = span});
  const ExprId bound = tree_.add({.op = Op::symbol, .span = span, .symbol = *bound_});
  const auto inside = at(integrand, running, bound);
  if (!inside) return std::nullopt;
  const auto is_it = [&](SymbolId each) {
    const Integral& known = *tree_.symbols[each].integral;
    if (known.sum) return false;
    if (known.upper->infinity != limit.infinity || known.upper->at.has_value() != limit.at.has_value())
      return false;
    return are_equal(known.integrand, *inside) && (!limit.at || are_equal(*known.upper->at, *limit.at));
  };
  auto found = std::ranges::find_if(unknown_, is_it);
  if (found == unknown_.end()) {
    if (unknown_.size() == most_unknown) return std::nullopt;
    const std::string end = limit.at             ? print_latex(tree_, *limit.at)
                            : limit.infinity < 0 ? "-\\infty"
                                                 : "\\infty";
    const Integral primitive{
        .integrand = *inside, .variable = *bound_, .by = {By::letter, *bound_}, .upper = limit};
    unknown_.push_back(
        tree_.symbols.add({.name = fmt::format("\\int^{{{}}} {}\\,d\\xi", end, print_latex(tree_, *inside)),
                           .first_seen = span,
                           .integral = primitive}));
    found = unknown_.end() - 1;
  }
  return tree_.add({.op = Op::symbol, .span = span, .symbol = *found});
}

std::optional<ExprId> IntegralValues::unknown(ExprId integrand, const Running& running,
                                              const Integral& integral, Span span) {
  const bool knew = knows_values_;  // values of functions inside do no harm
  const auto lower = unknown_at(integrand, running, *integral.lower, span);
  const auto upper = unknown_at(integrand, running, *integral.upper, span);
  knows_values_ = knew;
  if (!lower || !upper) return std::nullopt;
  if (*lower == *upper || tree_[*lower].symbol == tree_[*upper].symbol) return tree_.add_number(span, "0");
  return difference(*upper, *lower, span);
}

Differentiator IntegralValues::differentiator(const Integral& integral, const Running& running,
                                              DerivativeBudget& budget) {
  const auto dependence_of = [&running, axis = integral.axis](SymbolId symbol) -> Dependence {
    if (symbol == running.variable) return {Dependence::Kind::variable, axis};
    return {running.changes(symbol) ? Dependence::Kind::varies : Dependence::Kind::constant};
  };
  return {tree_, integral.by, dependence_of, budget, {integral.axis, {}}};
}

/// Is F' + what has no antiderivative the integrand?
bool IntegralValues::is_primitive(const Integral& integral, const Running& running, ExprId primitive,
                                  ExprId rest) {
  DerivativeBudget budget;
  Differentiator differentiate = differentiator(integral, running, budget);
  const std::array parts{differentiate.derivative_or_zero(primitive), rest};
  if (budget.exceeded) return false;
  Equation claim;
  claim.left = tree_.add({.op = Op::add, .span = tree_[primitive].span}, parts);
  claim.right = integral.integrand;
  return decide(nullptr, {.tree = &tree_, .claim = claim}, brief).outcome == Outcome::proved;
}

/// An antiderivative of a term, and its difference between the limits.
std::optional<std::pair<ExprId, ExprId>> IntegralValues::known_term(const IntegrandTerm& term,
                                                                    const Running& running,
                                                                    const Integral& integral, Span span) {
  const auto found = primitive(tree_, term, running, span);
  if (!found) return std::nullopt;
  const auto lower = at_limit(*found, running, *integral.lower, span);
  const auto upper = at_limit(*found, running, *integral.upper, span);
  if (!lower || !upper) return std::nullopt;
  return std::pair(found->value, difference(*upper, *lower, span));
}

/// h g' = (hg)' − h'g, until no derivative stands beside known functions, and of two unknown functions the
/// first one that the page has is differentiated, of one both factors alike: so both ways to write it meet.
std::optional<IntegralValues::Parts> IntegralValues::by_parts(const IntegrandTerm& term,
                                                              const Running& running,
                                                              const Integral& integral, Span span) {
  std::vector<ExprId> unknown;
  std::vector<ExprId> known;
  for (const ExprId factor : term.running) {
    const std::vector<SymbolId> inside = symbols_in(tree_, factor);
    const bool open = std::ranges::any_of(
        inside, [&](SymbolId each) { return each != running.variable && running.changes(each); });
    (open ? unknown : known).push_back(factor);
  }
  const bool symbols =
      std::ranges::all_of(unknown, [&](ExprId each) { return tree_[each].op == Op::symbol; });
  if (!symbols || unknown.empty() || unknown.size() > 2 || (unknown.size() == 2 && !known.empty()))
    return std::nullopt;
  const auto base = [&](ExprId id) { return base_of(tree_.symbols, tree_[id].symbol); };
  const auto order = [&](ExprId id) { return tree_.symbols[tree_[id].symbol].order(integral.by); };
  std::size_t which = 0;
  if (unknown.size() == 2) {
    const bool same = base(unknown[0]) == base(unknown[1]);
    which = same ? (order(unknown[1]) > order(unknown[0]) ? 1 : 0)
                 : (base(unknown[1]) > base(unknown[0]) ? 1 : 0);
    if (same && order(unknown[which]) < order(unknown[1 - which]) + 2) return std::nullopt;
  }
  const auto function = function_of_rate(integral, unknown[which]);
  if (!function) return std::nullopt;
  const ExprId other = unknown.size() == 2 ? unknown[1 - which] : product_of(tree_, known, span);
  DerivativeBudget budget;
  Differentiator differentiate = differentiator(integral, running, budget);
  const auto changed = differentiate.derivative(other);
  if (budget.exceeded) return std::nullopt;
  Parts parts{.primitive = product_of(tree_, {other, *function}, span)};
  if (changed) {
    auto rest =
        integrand_terms(tree_, product_of(tree_, {negative(*changed, span), *function}, span), running);
    if (!rest) return std::nullopt;
    parts.rest = *std::move(rest);
  }
  const auto lower = at(parts.primitive, running, *integral.lower->at);
  const auto upper = at(parts.primitive, running, *integral.upper->at);
  if (!lower || !upper) return std::nullopt;
  parts.difference = difference(*upper, *lower, span);
  return parts;
}

std::optional<IntegralValue> IntegralValues::value(const Integral& asked, Span span) {
  if (tree_.symbols[asked.variable].rank > 0) return std::nullopt;  // r is the length of a vector
  IntegralValue result;
  Integral integral = asked;
  integral.integrand = bare(asked);
  const Running running = running_over(integral);
  const std::vector<SymbolId> inside = symbols_in(tree_, integral.integrand);
  if (!is_one_of(integral.variable, inside)) {
    for (const SymbolId each : inside) {
      const bool said = tree_.symbols[each].unit_of_measure || is_declared_constant(names_.scope, each) ||
                        is_function_value(names_, tree_, each) || tree_.symbols[each].integral;
      if (!said && !running.changes(each)) result.taken_constant.push_back(each);
    }
  }
  knows_values_ = true;
  sign_.reset();
  auto terms = integrand_terms(tree_, integral.integrand, running);
  const bool endless = !integral.lower->at || !integral.upper->at;
  if (integral.primitive) {
    if (endless) return std::nullopt;
    const auto lower = at(integral.integrand, running, *integral.lower->at);
    const auto upper = at(integral.integrand, running, *integral.upper->at);
    if (!lower || !upper) return std::nullopt;
    result.value = difference(*upper, *lower, span);
    if (!knows_values_) result.open = "a value of a function is not known";
    return result;
  }
  std::vector<ExprId> primitives;  // with their constants, to be checked
  std::vector<ExprId> unknown_parts;
  std::vector<ExprId> values;
  bool closed = terms.has_value();
  constexpr std::size_t most_terms_by_parts = 60;
  constexpr std::size_t most_unknown = 8;
  for (std::size_t k = 0; closed && k < terms->size(); ++k) {
    const IntegrandTerm term = (*terms)[k];
    const ExprId constant = product_of(tree_, term.constant, span);
    const ExprId product = product_of(tree_, term.running, span);
    if (!goes_on(term, running, integral, span, result)) return std::nullopt;
    if (const auto known = known_term(term, running, integral, span)) {
      primitives.push_back(product_of(tree_, {constant, known->first}, span));
      values.push_back(product_of(tree_, {constant, known->second}, span));
      continue;
    }
    if (const auto known = endless ? gaussian(term, running, integral, span, result) : std::nullopt) {
      unknown_parts.push_back(product_of(tree_, {constant, product}, span));
      values.push_back(product_of(tree_, {constant, *known}, span));
      continue;
    }
    const auto parts = endless || terms->size() > most_terms_by_parts
                           ? std::nullopt
                           : by_parts(term, running, integral, span);
    if (parts) {
      primitives.push_back(product_of(tree_, {constant, parts->primitive}, span));
      values.push_back(product_of(tree_, {constant, parts->difference}, span));
      for (IntegrandTerm more : parts->rest) {
        more.constant.insert(more.constant.end(), term.constant.begin(), term.constant.end());
        terms->push_back(std::move(more));
      }
      continue;
    }
    const auto value =
        unknown_parts.size() < most_unknown ? unknown(product, running, integral, span) : std::nullopt;
    unknown_parts.push_back(product_of(tree_, {constant, product}, span));
    result.open = sign_.value_or("nothing is known that has this derivative");
    closed = value.has_value() && !(endless && terms->size() > 1);  // each alone need not exist
    if (closed) values.push_back(product_of(tree_, {constant, *value}, span));
  }
  const auto sum = [&](const std::vector<ExprId>& parts) {
    if (parts.empty()) return tree_.add_number(span, "0");
    return parts.size() == 1 ? parts[0] : tree_.add({.op = Op::add, .span = span}, parts);
  };
  if (closed && is_primitive(integral, running, sum(primitives), sum(unknown_parts))) {
    result.value = sum(values);
    if (!knows_values_) result.open = "a value of a function is not known";
    return result;
  }
  const auto whole = unknown(integral.integrand, running, integral, span);
  if (!whole) return std::nullopt;
  result.conditions.clear();
  result.value = *whole;
  result.open = sign_.value_or("nothing is known that has this derivative");
  return result;
}

std::optional<ExprId> IntegralValues::derivative(SymbolId primitive, const Derivative& by) {
  const Integral integral = *tree_.symbols[primitive].integral;
  const Span span = tree_.symbols[primitive].first_seen;
  const Running running = running_over(integral);
  // Of an unknown function an integral without end may exist, and `\int_r^\infty s\,ds` does not.
  const bool endless = (integral.lower && !integral.lower->at) || !integral.upper->at;
  const auto is_unknown = [&](SymbolId each) { return each != integral.variable && running.changes(each); };
  if (endless && std::ranges::none_of(symbols_in(tree_, integral.integrand), is_unknown)) return std::nullopt;
  std::vector<ExprId> parts;
  if (integral.upper->at) {
    const auto there = at(integral.integrand, running, *integral.upper->at);
    if (!there) return std::nullopt;
    if (const auto moves = by(*integral.upper->at))
      parts.push_back(product_of(tree_, {*there, *moves}, span));
  }
  if (const auto changed = by(integral.integrand)) {
    const auto terms = integrand_terms(tree_, *changed, running);
    if (!terms) return std::nullopt;
    for (const IntegrandTerm& term : *terms) {
      const auto value = unknown_at(product_of(tree_, term.running, span), running, *integral.upper, span);
      if (!value) return std::nullopt;
      std::vector<ExprId> factors = term.constant;
      factors.push_back(*value);
      parts.push_back(product_of(tree_, std::move(factors), span));
    }
  }
  if (parts.empty()) return tree_.add_number(span, "0");
  return parts.size() == 1 ? parts[0] : tree_.add({.op = Op::add, .span = span}, parts);
}

}  // namespace rigor
