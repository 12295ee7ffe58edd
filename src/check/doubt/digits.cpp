// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/digits.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "base/among.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr std::size_t most_digits = 15;
constexpr std::int64_t most_halves = 1000;
constexpr int fewest_digits_cut = 6;  // who shows less rounds them

/// M · 10^-places, whose last `unsure` digits are zeros that may count or not.
struct Shown {
  ExprId number{};
  std::int64_t mantissa = 0;
  int places = 0;
  int unsure = 0;
  int digits = 0;
  bool negative = false;
};

bool is_power_of_ten(const ExprTree& tree, ExprId id) {
  return tree[id].op == Op::power && tree[tree.children(id)[0]].op == Op::number &&
         tree.digits(tree.children(id)[0]) == "10";
}

/// `\mathrm{h}`, which is 3600 s.
bool is_of_units(const ExprTree& tree, ExprId id) {
  const std::vector<SymbolId> symbols = symbols_in(tree, id);
  return !symbols.empty() && std::ranges::all_of(symbols, [&](SymbolId symbol) {
    return tree.symbols[symbol].unit_of_measure.has_value();
  });
}

bool has_units(const ExprTree& tree, ExprId side) {
  return std::ranges::any_of(symbols_in(tree, side), [&](SymbolId symbol) {
    return tree.symbols[symbol].unit_of_measure.has_value();
  });
}

bool has_degrees(const ExprTree& tree, const Names& names, std::vector<ExprId> roots) {
  return std::ranges::any_of(nodes_below(tree, std::move(roots)),
                             [&](ExprId id) { return is_degree(tree, names, id); });
}

/// `1.69`, `-1.69`, `1.11 \times 10^{-16}`, `1.407\,\mathrm{h}`, `36.9^\circ`.
std::optional<Shown> shown_in(const ExprTree& tree, const Names& names, ExprId side, bool nearly) {
  Shown shown;
  while (tree[side].op == Op::negate) {
    shown.negative = !shown.negative;
    side = tree.children(side)[0];
  }
  ExprId number = side;
  if (tree[side].op == Op::multiply) {
    const std::span<const ExprId> factors = tree.children(side);
    const bool scaled = std::all_of(factors.begin() + 1, factors.end(), [&](ExprId factor) {
      return is_power_of_ten(tree, factor) || is_of_units(tree, factor) || is_degree(tree, names, factor);
    });
    if (scaled) number = factors.front();
  }
  if (tree[number].op != Op::number) return std::nullopt;
  std::string digits(tree.digits(number));
  const auto point = digits.find('.');
  if (point == std::string::npos && !nearly) return std::nullopt;
  if (point != std::string::npos) {
    shown.places = static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));  // `\SI{2.4e-23}{s}`
  while (point == std::string::npos && digits.size() > most_digits && digits.back() == '0') {
    digits.pop_back();  // `\SI{5.97e24}{kg}`
    --shown.places;
  }
  if (digits.empty() || digits.size() > most_digits) return std::nullopt;
  if (point == std::string::npos && shown.places <= 0) {
    for (std::size_t k = digits.size(); k > 1 && digits[k - 1] == '0'; --k) ++shown.unsure;
  }
  shown.number = number;
  shown.digits = static_cast<int>(digits.size());
  shown.mantissa = std::stoll(digits);
  return shown;
}

/// `0.693\,\tau`, `1.26\frac{\sigma}{\sqrt n}`: a decimal, and no other number in front of letters.
bool is_number_times_letters(const ExprTree& tree, ExprId side) {
  if (tree[side].op != Op::multiply || tree[side].rank != 0) return false;
  const ExprId first = tree.children(side)[0];
  const std::vector<SymbolId> letters = symbols_in(tree, side);
  return tree[first].op == Op::number && tree.digits(first).find('.') != std::string::npos &&
         std::ranges::any_of(letters, [&](SymbolId each) { return !tree.symbols[each].is_fixed(); });
}

/// The decimal number value · 10^-places.
std::string decimal(std::int64_t value, int places) {
  std::string digits = std::to_string(value);
  if (places <= 0) return digits.append(static_cast<std::size_t>(-places), '0');
  const auto width = static_cast<std::size_t>(places);
  if (digits.size() <= width) digits.insert(0, width + 1 - digits.size(), '0');
  digits.insert(digits.size() - width, 1, '.');
  return digits;
}

/// `\mathrm{eV}`, `\mathrm h`: a unit with a number of its own.
bool holds_conversion(const ExprTree& tree, ExprId side, ExprId shown) {
  return std::ranges::any_of(nodes_below(tree, {side}), [&](ExprId id) {
    return id != shown && tree[id].op == Op::number && tree.digits(id) != "10";
  });
}

std::string signed_decimal(std::int64_t value, int places) {
  return value < 0 ? "-" + decimal(-value, places) : decimal(value, places);
}

/// `4.73\cdot 10^{-19}\,\mathrm J = 2.96\,\mathrm{eV}`: the value is a rounded number, too. How many halves
/// of the last digit shown on the other side that makes.
int halves_of_own_rounding(const ExprTree& tree, const Names& names, ExprId value, ExprId side,
                           const Shown& other) {
  const auto own = shown_in(tree, names, value, false);
  const bool converts =
      own && (holds_conversion(tree, value, own->number) || holds_conversion(tree, side, other.number));
  const bool measured = has_units(tree, value) || has_degrees(tree, names, {value, side});
  if (!own || own->mantissa == 0 || !measured || !converts) return 0;
  return static_cast<int>(std::min<std::int64_t>((other.mantissa - 1) / own->mantissa + 1, most_halves));
}

class Comparison {
 public:
  Comparison(ExprTree& tree, const Names& names, ExprId value, ExprId side, const Shown& shown,
             DecisionCache* cache)
      : tree_(tree), names_(names), value_(value), side_(side), shown_(shown), cache_(cache) {}

  /// Does the value lie within that many halves of the digit with `unsure` zeros after it?
  std::optional<bool> lies_within(int halves, int unsure) {
    std::int64_t reach = 5 * halves;
    for (int k = 0; k < unsure; ++k) reach *= 10;
    const std::int64_t middle = 10 * shown_.mantissa;
    const auto above_lower = is_ordered(middle - reach, false);
    const auto below_upper = is_ordered(middle + reach, true);
    if (above_lower == false) bound_ = "less than " + signed_decimal(middle - reach, shown_.places + 1);
    if (below_upper == false) bound_ = "more than " + decimal(middle + reach, shown_.places + 1);
    if (above_lower == false || below_upper == false) return false;
    if (!above_lower || !below_upper) return std::nullopt;
    return true;
  }

  /// `1.054571817` of 1.0545718176…: the digits are right, and those behind them are left out.
  bool is_cut() {
    return is_ordered(10 * shown_.mantissa, false) == true &&
           is_ordered(10 * shown_.mantissa + 10, true) == true;
  }

  /// Where the value lies, once it does not lie within; empty where the number has a sign, a factor or a
  /// unit.
  [[nodiscard]] std::string bound() const {
    return side_ == shown_.number && tree_[side_].op == Op::number ? bound_ : std::string();
  }

 private:
  /// Is the value at most (or at least) the side with this number in place of its own?
  std::optional<bool> is_ordered(std::int64_t bound, bool at_most) {
    const Span span = tree_[shown_.number].span;
    const std::array number{tree_.add_number(span, decimal(std::abs(bound), shown_.places + 1))};
    const ExprId signed_number = bound < 0 ? tree_.add({.op = Op::negate, .span = span}, number) : number[0];
    const ExprId other = with(side_, signed_number);
    Equation order;
    const bool value_left = at_most != shown_.negative;
    order.left = value_left ? value_ : other;
    order.right = value_left ? other : value_;
    order.relation = Relation::less_or_equal;
    const auto decided = [&](const Equation& claim) {
      Prepared prepared = prepare(tree_, names_, claim);
      return prepared.too_large ? Decision() : decide(cache_, prepared.question, {.simplest_sample = false});
    };
    const Decision decision = decided(order);
    if (decision.outcome == Outcome::proved) return true;
    if (decision.outcome == Outcome::refuted) return false;
    const Equation reverse{.left = order.right, .right = order.left, .relation = Relation::less};
    return decided(reverse).outcome == Outcome::proved ? std::optional(false) : std::nullopt;
  }

  ExprId with(ExprId id, ExprId number) {
    if (id == shown_.number) return number;
    const ExprNode node = tree_[id];
    if (node.op != Op::negate && node.op != Op::multiply) return id;
    const std::span<const ExprId> children = tree_.children(id);
    std::vector<ExprId> copies(children.begin(), children.end());
    for (ExprId& child : copies) child = with(child, number);
    return tree_.add(node, copies);
  }

  ExprTree& tree_;
  const Names& names_;
  ExprId value_;
  ExprId side_;
  const Shown& shown_;
  DecisionCache* cache_;
  std::string bound_;
};

/// No letter but units is left when definitions are unfolded.
bool is_a_number(const ExprTree& tree, const Names& names, ExprId root) {
  const auto is_known = [&](SymbolId symbol) {
    return tree.symbols[symbol].unit_of_measure || is_circle_number(tree, names, symbol);
  };
  const auto body_of = [&](SymbolId symbol) {
    return is_known(symbol) ? std::nullopt : body_of_definition(names.scope, symbol);
  };
  return std::ranges::all_of(symbols_reached(tree, {root}, body_of),
                             [&](SymbolId symbol) { return is_known(symbol) || body_of(symbol); });
}

/// A root, a function or π in it: as a rule no fraction of whole numbers.
bool has_no_end(const ExprTree& tree, const Names& names, ExprId root) {
  return std::ranges::any_of(nodes_below(tree, {root}), [&](ExprId id) {
    const ExprNode& node = tree[id];
    return node.op == Op::root || node.op == Op::function || node.op == Op::real_power ||
           (node.op == Op::symbol && is_circle_number(tree, names, node.symbol));
  });
}

/// Plain names by what they are defined as, as often as there are any.
ExprId unfolded(ExprTree& tree, const Names& names, ExprId expr) {
  constexpr int most_rounds = 8;
  const auto body = [&](ExprId id) -> std::optional<ExprId> {
    const NamedDefinition* named = definition_of(names.scope, tree[id].symbol);
    const bool plain = named != nullptr && tree[id].rank == 0 && tree[id].slot_count == 0 &&
                       named->definition.indices.empty() && named->definition.particle == no_particle &&
                       !named->definition.by_square;
    return plain ? std::optional(named->definition.body) : std::nullopt;
  };
  for (int round = 0; round < most_rounds; ++round) {
    const ExprId next = replaced(tree, expr, body);
    if (next == expr) break;
    expr = next;
  }
  return expr;
}

/// `\tau\ln 2 = 0.693\,\tau`: the numbers before the same letters.
std::optional<Equation> of_numbers(ExprTree& tree, const Names& names, const Equation& equation,
                                   DecisionCache* cache) {
  for (const bool swap : {false, true}) {
    const ExprId side = swap ? equation.left : equation.right;
    const ExprId value = swap ? equation.right : equation.left;
    if (!is_number_times_letters(tree, side)) continue;
    const std::vector<SymbolId> letters = symbols_in(tree, side);
    const auto one = [&](ExprId id) -> std::optional<ExprId> {
      const ExprNode node = tree[id];
      if (tree.symbols[node.symbol].is_fixed() || !is_one_of(node.symbol, letters)) return std::nullopt;
      if (node.rank > 0) return std::nullopt;  // `\mathbf v` beside v_x
      return tree.add_number(node.span, "1");
    };
    const ExprId number = replaced(tree, side, one);
    const ExprId own = replaced(tree, unfolded(tree, names, value), one);
    const ExprId shown = tree.children(side)[0];
    if (!is_a_number(tree, names, own)) continue;
    const auto product = [&](ExprId a, ExprId b) {
      const std::array factors{a, b};
      return tree.add({.op = Op::multiply, .span = tree[a].span}, factors);
    };
    const Equation same{.left = product(value, number), .right = product(own, side)};
    const Prepared prepared = prepare(tree, names, same);
    if (prepared.too_large) continue;
    const Decision decision = decide(cache, prepared.question, {.simplest_sample = false});
    if (decision.outcome != Outcome::proved || decision.vanishes) continue;
    const std::array ratio{product(own, shown), number};  // the value where the side is what is shown
    const ExprId computed = tree.add({.op = Op::divide, .span = tree[value].span}, ratio);
    return Equation{.left = swap ? shown : computed, .right = swap ? computed : shown};
  }
  return std::nullopt;
}

/// A calculation, and no number as it stands.
bool is_computed(const ExprTree& tree, ExprId value) {
  return tree[value].op != Op::number && tree[value].op != Op::negate;
}

}  // namespace

bool has_decimal(const ExprTree& tree, const Names& names, ExprId root) {
  const auto body_of = [&](SymbolId symbol) { return body_of_definition(names.scope, symbol); };
  std::vector<ExprId> roots{root};
  for (const SymbolId symbol : symbols_reached(tree, {root}, body_of)) {
    if (const auto body = body_of(symbol)) roots.push_back(*body);
  }
  return std::ranges::any_of(nodes_below(tree, roots), [&](ExprId id) {
    return tree[id].op == Op::number && tree.digits(id).find('.') != std::string::npos;
  });
}

std::optional<NumberShown> number_shown(const ExprTree& tree, const Names& names, const Claim& claim) {
  std::optional<NumberShown> found;
  for (const ExprId side : {claim.equation.left, claim.equation.right}) {
    const auto shown = shown_in(tree, names, side, true);
    if (!shown) continue;
    if (found) return std::nullopt;
    found = NumberShown{side, shown->number, shown->digits};
  }
  return found;
}

bool compares_decimals(const ExprTree& tree, const Names& names, const Equation& equation) {
  const auto is_number = [&](ExprId side) { return is_a_number(tree, names, side); };
  return is_number(equation.left) && is_number(equation.right) &&
         (has_decimal(tree, names, equation.left) || has_decimal(tree, names, equation.right));
}

bool is_circle_number(const ExprTree& tree, const Names& names, SymbolId symbol) {
  return tree.symbols[symbol].circle_number && definition_of(names.scope, symbol) == nullptr;
}

bool is_degree(const ExprTree& tree, const Names& names, ExprId id) {
  if (tree[id].op != Op::divide) return false;
  const ExprNode& above = tree[tree.children(id)[0]];
  const ExprId below = tree.children(id)[1];
  return above.op == Op::symbol && is_circle_number(tree, names, above.symbol) &&
         tree[below].op == Op::number && tree.digits(below) == "180";
}

bool has_rounded_degrees(const ExprTree& tree, const Names& names, const Equation& equation) {
  constexpr int surely_meant = 15;  // multiples of it
  const auto body_of = [&](SymbolId symbol) { return body_of_definition(names.scope, symbol); };
  std::vector<ExprId> roots{equation.left, equation.right};
  for (const SymbolId symbol : symbols_reached(tree, roots, body_of)) {
    if (const auto body = body_of(symbol)) roots.push_back(*body);
  }
  return std::ranges::any_of(nodes_below(tree, roots), [&](ExprId id) {
    const std::span<const ExprId> factors = tree.children(id);
    if (tree[id].op != Op::multiply || factors.size() < 2 || tree[factors[0]].op != Op::number) return false;
    const std::string digits(tree.digits(factors[0]));
    const bool short_number = digits.size() <= 4 && digits.find('.') == std::string::npos;
    return is_degree(tree, names, factors[1]) && !(short_number && std::stoi(digits) % surely_meant == 0);
  });
}

bool shows_circle_number(const ExprTree& tree, const Names& names, const Typed& left, const Typed& right) {
  return tree[left.id].op == Op::symbol && is_circle_number(tree, names, tree[left.id].symbol) &&
         symbols_in(tree, right.id).empty() && shown_in(tree, names, right.id, false);
}

bool has_degrees_alone(const ExprTree& tree, const Names& names, const Equation& equation) {
  bool degrees = false;
  std::vector<ExprId> pending{equation.left, equation.right};
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    const ExprNode& node = tree[id];
    const bool inverse =
        node.op == Op::function && (node.function == Function::arcsin || node.function == Function::arccos ||
                                    node.function == Function::arctan);
    if (is_degree(tree, names, id)) {
      degrees = true;
    } else if (inverse || (node.op == Op::symbol && is_circle_number(tree, names, node.symbol))) {
      return false;
    } else if (node.op != Op::function) {
      pending.insert(pending.end(), tree.children(id).begin(), tree.children(id).end());
    }
  }
  return degrees;
}

std::optional<DigitComparison> agreement_of_digits(ExprTree& tree, const Names& names, const Claim& claim,
                                                   DecisionCache* cache, bool measured) {
  if (claim.equation.relation != Relation::equal || tree[claim.equation.left].rank != 0) return std::nullopt;
  const auto before_letters = of_numbers(tree, names, claim.equation, cache);
  const Equation equation = before_letters.value_or(claim.equation);
  std::optional<DigitComparison> differs;  // ≈ has two sides, and the coarser one counts
  for (const bool swap : {false, true}) {
    const ExprId side = swap ? equation.left : equation.right;
    const ExprId value = swap ? equation.right : equation.left;
    const bool order = claim.nearly && is_power_of_ten(tree, side);  // `1024 \approx 10^3`
    if (order && is_a_number(tree, names, value)) return DigitComparison{};
    // `100\,\mathrm{m}/(3\,\mathrm{s}) = 33\,\mathrm{m/s}`,
    // `0.5 \cdot 9.8 \cdot 3^2 = 44`; `2\pi(60\,\mathrm{Hz}) = 377\,\mathrm{s^{-1}}`, whose digits may be
    // rounded
    const bool of_decimals = has_decimal(tree, names, value);
    const bool may_be_rounded =
        has_units(tree, side) ||
        (has_no_end(tree, names, value) && (measured || has_degrees(tree, names, {value, side})));
    const auto shown = shown_in(tree, names, side,
                                claim.nearly || of_decimals || may_be_rounded || is_computed(tree, value));
    const bool whole = shown && !claim.nearly && !of_decimals && !shown_in(tree, names, side, false);
    // `2\pi\cdot 50 = 314`: the unit may stand in the sentence. Of one digit nobody expects that.
    if (whole && !may_be_rounded && shown->digits - shown->unsure < 2) continue;
    if (!shown || !is_a_number(tree, names, value)) continue;
    Comparison comparison(tree, names, value, side, *shown, cache);
    if (whole && comparison.lies_within(0, 0) == true) continue;  // nothing is rounded
    // In 1000 after ≈, two digits must be right, though one may be all that is meant.
    const bool two_are_sure = shown->digits - shown->unsure >= 2;
    const auto rounds =
        comparison.lies_within(1, two_are_sure ? shown->unsure : std::max(shown->unsure - 1, 0));
    if (!rounds) return std::nullopt;
    // `12.28 = 12` may round, and calculates nothing.
    const bool calculates = tree[value].op != Op::number && tree[value].op != Op::negate;
    const bool written = claim.nearly || shown_in(tree, names, side, false).has_value();
    if (*rounds && ((!calculates && !written) || whole)) return DigitComparison{};
    if (*rounds) return DigitComparison{.agreement = Agreement::rounds};
    const int halves = (claim.nearly ? 2 : 1) + halves_of_own_rounding(tree, names, value, side, *shown);
    const auto may_round = comparison.lies_within(halves, shown->unsure);
    if (!may_round) return std::nullopt;
    if (*may_round) return DigitComparison{};
    if ((claim.digits_go_on || shown->digits - shown->unsure >= fewest_digits_cut) && comparison.is_cut())
      return DigitComparison{.agreement = claim.digits_go_on ? Agreement::rounds : Agreement::cut};
    if (!differs)
      differs = DigitComparison{.agreement = Agreement::differs,
                                .bound = comparison.bound(),
                                .of_decimals = has_decimal(tree, names, value),
                                .before_letters = before_letters};
    if (!claim.nearly) return differs;
  }
  return differs;
}

}  // namespace rigor
