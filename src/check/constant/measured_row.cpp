// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/measured_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "check/meaning/measured.h"
#include "elaborate/name/measure_unit.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr std::size_t most_assignments = 200;

MeasuredValue value_of(const PhysicalConstant& constant, double shift = 0) {
  const auto unit = read_unit(constant.unit.empty() ? "1" : constant.unit, UnitNames::units);
  const double number = std::strtod(std::string(constant.digits).c_str(), nullptr) * (1 + shift);
  return {number * std::pow(10.0, constant.ten + unit->ten) * static_cast<double>(unit->factor.over()) /
              static_cast<double>(unit->factor.under()),
          Dimension(unit->exponents)};
}

/// `9.1093837139e-31 kg`
std::string shown_value(const PhysicalConstant& constant) {
  std::string text(constant.digits);
  if (constant.ten != 0) text += fmt::format("e{}", constant.ten);
  return constant.unit.empty() ? text : fmt::format("{} {}", text, constant.unit);
}

std::optional<ExprId> expression_of(ExprTree& tree, Names& names, const PhysicalConstant& constant,
                                    Span span) {
  auto unit = read_unit(constant.unit.empty() ? "1" : constant.unit, UnitNames::units);
  if (!unit) return std::nullopt;
  unit->ten += constant.ten;
  const auto measured = unit_expression(tree, names, *unit, span);
  if (!measured) return std::nullopt;
  const bool negative = constant.digits.starts_with('-');
  const std::array factors{tree.add_number(span, std::string(constant.digits.substr(negative ? 1 : 0))),
                           *measured};
  const ExprId whole = tree.add({.op = Op::multiply, .span = span}, factors);
  return negative ? tree.add({.op = Op::negate, .span = span}, std::span(&whole, 1)) : whole;
}

bool may_be_constant(const ExprTree& tree, SymbolId letter) {
  const Symbol& symbol = tree.symbols[letter];
  return symbol.rank == 0 && !symbol.per_particle && !symbol.derivation && !symbol.integral &&
         !symbol.complex && !symbol.noncommuting;
}

/// All assignments of constants to the letters; none where one letter has no constant, or there are too many.
std::vector<Assignment> assignments(const ExprTree& tree, const std::vector<SymbolId>& letters,
                                    const std::string& spoken) {
  std::vector<Assignment> all{{}};
  for (const SymbolId letter : letters) {
    if (!may_be_constant(tree, letter)) return {};
    const auto constants = constants_of(tree.symbols[letter].name, spoken);
    std::vector<Assignment> next;
    for (const Assignment& before : all) {
      for (const PhysicalConstant* constant : constants) {
        next.push_back(before);
        next.back().push_back(constant);
      }
    }
    if (next.empty() || next.size() > most_assignments) return {};
    all = std::move(next);
  }
  return all;
}

std::vector<std::string_view> names_of(const Assignment& assignment) {
  std::vector<std::string_view> names;
  for (const PhysicalConstant* each : assignment) names.push_back(each->name);
  return names;
}

/// Letters by what they are defined as, as often as there are any, and units by 1.
ExprId in_base_units(ExprTree& tree, const Names& names, ExprId expr) {
  constexpr int most_rounds_of_units = 12;
  const auto meaning = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = tree[id];
    if (node.op != Op::symbol || node.rank != 0 || node.slot_count != 0) return std::nullopt;
    if (tree.symbols[node.symbol].unit_of_measure) return tree.add_number(node.span, "1");
    return body_of_definition(names.scope, node.symbol);
  };
  for (int round = 0; round < most_rounds_of_units; ++round) {
    const ExprId next = replaced(tree, expr, meaning);
    if (next == expr) break;
    expr = next;
  }
  return expr;
}

}  // namespace

Claim claim_of_numbers(ExprTree& tree, const MeasuredRow& row, const Names& names) {
  Claim claim = row.claim;
  const ExprId side = row.shown.side;
  const bool negative = tree[side].op == Op::negate;
  const ExprId inside = negative ? tree.children(side)[0] : side;
  std::vector<ExprId> number{inside};
  std::vector<ExprId> units;
  if (tree[inside].op == Op::multiply) {
    const std::span<const ExprId> factors = tree.children(inside);
    const auto is_of_units = [&](ExprId each) { return !symbols_in(tree, each).empty(); };
    number.clear();
    std::ranges::copy_if(factors, std::back_inserter(number), std::not_fn(is_of_units));
    std::ranges::copy_if(factors, std::back_inserter(units), is_of_units);
  }
  const auto product = [&](const std::vector<ExprId>& factors) {
    return factors.size() == 1 ? factors[0]
                               : tree.add({.op = Op::multiply, .span = tree[side].span}, factors);
  };
  ExprId plain = product(number);
  if (negative) plain = tree.add({.op = Op::negate, .span = tree[side].span}, std::span(&plain, 1));
  ExprId value = in_base_units(tree, names, row.value);
  if (!units.empty()) {
    const std::array quotient{value, in_base_units(tree, names, product(units))};
    value = tree.add({.op = Op::divide, .span = tree[row.value].span}, quotient);
  }
  const bool left = side == claim.equation.left;
  claim.equation.left = left ? plain : value;
  claim.equation.right = left ? value : plain;
  return claim;
}

std::optional<Claim> claim_in_base_units(ExprTree& tree, const Names& names, const Claim& claim) {
  const auto shown = number_shown(tree, names, claim);
  if (!shown) return std::nullopt;
  const ExprId value = shown->side == claim.equation.left ? claim.equation.right : claim.equation.left;
  const auto has_unit = [&](SymbolId each) { return tree.symbols[each].unit_of_measure.has_value(); };
  if (std::ranges::none_of(symbols_in(tree, shown->side), has_unit)) return std::nullopt;
  const auto written = measured_value(tree, names, shown->side, {});
  const auto computed = measured_value(tree, names, value, {});
  if (!written || !computed || !(written->dimension == computed->dimension)) return std::nullopt;
  return claim_of_numbers(tree, {claim, *shown, value, names}, names);
}

std::vector<SymbolId> letters_without_value(const ExprTree& tree, const Names& names, ExprId value) {
  std::vector<SymbolId> letters;
  for (const SymbolId each : symbols_reached(tree, names.scope, {value})) {
    if (!tree.symbols[each].is_fixed() && !body_of_definition(names.scope, each)) letters.push_back(each);
  }
  return letters;
}

bool forget_rounded_constants(const ExprTree& tree, NameScope& scope, const std::string& spoken) {
  constexpr double rounded = 0.005;
  std::vector<SymbolId> letters;
  for (const NamedDefinition& named : scope.definitions) {
    const SymbolId letter = named.definition.symbol;
    if (!is_measured(tree, named.definition.body)) continue;
    const auto given = measured_value(tree, {}, named.definition.body, {});
    const auto constants = constants_of(tree.symbols[letter].name, spoken);
    const bool is_constant =
        given && std::ranges::any_of(constants, [&](const PhysicalConstant* each) {
          const MeasuredValue value = value_of(*each);
          return value.dimension == given->dimension && std::abs(given->number / value.number - 1) < rounded;
        });
    if (is_constant) letters.push_back(letter);
  }
  forget_definitions(scope, letters);
  return !letters.empty();
}

MeasuredLetters values_of(const std::vector<SymbolId>& letters, const Assignment& constants) {
  MeasuredLetters values;
  for (std::size_t k = 0; k < letters.size(); ++k) values[letters[k]] = value_of(*constants[k]);
  return values;
}

std::optional<Names> with_constants(ExprTree& tree, const MeasuredRow& row, const Assignment& constants) {
  Names names = row.names;
  for (std::size_t k = 0; k < row.letters.size(); ++k) {
    const PhysicalConstant& constant = *constants[k];
    const auto body = expression_of(tree, names, constant, row.claim.relation);
    if (!body) return std::nullopt;
    const std::string says = fmt::format("convention: `{}` is {}, {}", tree.symbols[row.letters[k]].name,
                                         constant.name, shown_value(constant));
    define(names.scope, {{row.letters[k], {}, no_particle, *body}, Origin{says, {}, std::nullopt}, 0});
  }
  return names;
}

double error_of(const ExprTree& tree, const MeasuredRow& row, const Assignment& constants, double value) {
  MeasuredLetters values = values_of(row.letters, constants);
  double error = 0;
  for (std::size_t k = 0; k < row.letters.size(); ++k) {
    if (constants[k]->uncertainty == 0) continue;
    values[row.letters[k]] = value_of(*constants[k], constants[k]->uncertainty);
    const auto shifted = measured_value(tree, row.names, row.value, values);
    values[row.letters[k]] = value_of(*constants[k]);
    error += shifted ? std::abs(shifted->number - value) : std::abs(value);
  }
  return error;
}

double half_a_digit(const ExprTree& tree, const MeasuredRow& row, double written) {
  std::string digits(tree.digits(row.shown.number));
  const bool whole = digits.find('.') == std::string::npos;
  std::erase(digits, '.');
  while (whole && digits.size() > 1 && digits.ends_with('0')) digits.pop_back();
  return 0.5 * std::abs(written) / std::strtod(digits.c_str(), nullptr);
}

Compared compare_with_constants(ExprTree& tree, const MeasuredRow& row, const std::string& spoken,
                                DecisionCache* cache) {
  Compared found;
  const auto written = measured_value(tree, row.names, row.shown.side, {});
  if (!written || written->number == 0) return found;
  std::set<std::vector<std::string_view>> names_fitting;
  std::set<std::vector<std::string_view>> names_possible;
  for (const Assignment& each : assignments(tree, row.letters, spoken)) {
    const auto computed = measured_value(tree, row.names, row.value, values_of(row.letters, each));
    if (!computed || !(computed->dimension == written->dimension)) continue;
    if (names_possible.insert(names_of(each)).second) found.possible.push_back(each);
    constexpr double near = 0.5;
    if (std::abs(computed->number / written->number - 1) > near || names_fitting.contains(names_of(each)) ||
        std::abs(computed->number - written->number) + error_of(tree, row, each, computed->number) >
            half_a_digit(tree, row, written->number))
      continue;
    const auto names = with_constants(tree, row, each);
    if (!names) continue;
    const Claim numbers = claim_of_numbers(tree, row, *names);
    const auto compared = agreement_of_digits(tree, *names, numbers, cache);
    if (!compared || compared->agreement != Agreement::rounds) continue;
    names_fitting.insert(names_of(each));
    found.fitting.push_back(each);
  }
  return found;
}

}  // namespace rigor
