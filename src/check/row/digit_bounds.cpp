// SPDX-License-Identifier: GPL-3.0-or-later
// `\sqrt{19} = 4.3`, `\approx`: numbers are compared to the digits shown, by bounds where no sample is exact.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/constant/measured_row.h"
#include "check/doubt/approximate_value.h"
#include "check/doubt/digits.h"
#include "check/place/place.h"
#include "check/question/decision_cache.h"

namespace rigor {
namespace {

/// A slip in a digit, and no equation for the letters.
bool is_near(const ExprTree& tree, const Names& names, const Equation& numbers) {
  constexpr double nearness = 0.2;
  const auto left = approximate_value(tree, names, numbers.left);
  const auto right = approximate_value(tree, names, numbers.right);
  return left && right && std::abs(*left - *right) < nearness * std::abs(*right);
}

/// More than what is rounded in an angle of whole degrees; not known where letters are left, nor beside a 0.
bool is_beyond_rounding(const ExprTree& tree, const Names& names, const Equation& equation) {
  constexpr double rounding = 0.02;
  const auto left = approximate_value(tree, names, equation.left);
  const auto right = approximate_value(tree, names, equation.right);
  if (!left || !right || *left == 0.0 || *right == 0.0) return false;
  return std::abs(*left - *right) > rounding * std::max(std::abs(*left), std::abs(*right));
}

/// Where the number lies instead; nothing where the step is not refuted so.
std::optional<Counterexample> bound_of(ExprTree& tree, const Names& names, const Claim& claim,
                                       DecisionCache* cache) {
  if (claim.nearly || claim.doubt != nullptr || claim.equation.relation != Relation::equal)
    return std::nullopt;
  if (guess_of(*claim.reading) || has_degrees_alone(tree, names, claim.equation)) return std::nullopt;
  const auto is_own = [&](ExprId side) {
    return std::ranges::all_of(symbols_in(tree, side),
                               [&](SymbolId symbol) { return is_circle_number(tree, names, symbol); });
  };
  const bool own = is_own(claim.equation.left) && is_own(claim.equation.right);
  const auto compared = agreement_of_digits(tree, names, claim, cache);
  if (!compared || compared->agreement != Agreement::differs || compared->bound.empty() ||
      may_be_rounded_on_the_way(tree, names, claim, *compared))
    return std::nullopt;
  if (!own && !(compared->before_letters && is_near(tree, names, *compared->before_letters)))
    return std::nullopt;
  const Equation shown = compared->before_letters.value_or(claim.equation);
  const auto digits = [&](ExprId side) -> std::optional<std::string> {
    if (tree[side].op != Op::number) return std::nullopt;
    return tree.digits(side);
  };
  if (digits(shown.left) && digits(shown.right)) return std::nullopt;  // nothing is computed
  Counterexample example;
  example.left = digits(shown.left).value_or(compared->bound);
  example.right = digits(shown.right).value_or(compared->bound);
  return example;
}

/// `\frac{(6.7)^2(9.8)}{4\pi^2} \approx 11\,\mathrm m`
bool lacks_units(const ExprTree& tree, const Equation& equation) {
  const auto is_pure = [&](ExprId side) {
    return std::ranges::all_of(symbols_in(tree, side),
                               [&](SymbolId each) { return tree.symbols[each].circle_number; });
  };
  const auto has_unit = [&](ExprId side) {
    return std::ranges::any_of(symbols_in(tree, side),
                               [&](SymbolId each) { return tree.symbols[each].unit_of_measure.has_value(); });
  };
  return (has_unit(equation.left) && is_pure(equation.right)) ||
         (is_pure(equation.left) && has_unit(equation.right));
}

}  // namespace

void heed_digits(RowPlace& place, const Claim& claim, Judgement& judgement) {
  ExprTree& tree = place.tree;
  const Names& names = place.names;
  const auto doubt = [&](std::string message, std::string help) {
    withdraw(judgement, claim,
             {.message = std::move(message), .help = {std::move(help)}, .kind = DiagnosticKind::undecided});
  };
  auto compared = agreement_of_digits(tree, names, claim, place.options.cache);
  const bool differs = compared && compared->agreement == Agreement::differs;
  if (!compared || differs) {  // `2\pi\,(3.0\,\mathrm m) = 18.8\,\mathrm m`
    const auto numbers = claim_in_base_units(tree, names, claim);
    auto of_numbers =
        numbers ? agreement_of_digits(tree, names, *numbers, place.options.cache, true) : std::nullopt;
    // Of what differs, only numbers show whether it is cut off.
    const Agreement cut_off = claim.digits_go_on ? Agreement::rounds : Agreement::cut;
    if (!differs || (of_numbers && of_numbers->agreement == cut_off)) compared = std::move(of_numbers);
  }
  const auto digits = [&](Agreement each) { return compared && compared->agreement == each; };
  if (digits(Agreement::rounds)) {
    judgement.verdict = Verdict::proved;
    judgement.route = "to the digits shown";
    judgement.of_another_question = true;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics.clear();
  } else if (digits(Agreement::unclear) && judgement.verdict == Verdict::refuted) {
    doubt("whether it holds depends on how many of the digits are meant",
          "write only the digits that are meant");
  } else if (digits(Agreement::cut) && judgement.verdict == Verdict::refuted) {
    doubt("its digits are those of the value, cut off where they would be rounded up",
          "`\\dots` behind them says so, or `\\approx`");
  } else if (compared && judgement.verdict == Verdict::refuted &&
             may_be_rounded_on_the_way(tree, names, claim, *compared)) {
    doubt("it holds if the decimals that it is computed from are rounded themselves",
          "more digits of them show whether it holds");
  } else if (claim.nearly && judgement.verdict == Verdict::refuted && lacks_units(tree, claim.equation)) {
    doubt("one side has a unit, and the other is a number without one", "write the units on both sides");
  } else if (!digits(Agreement::differs) && judgement.verdict == Verdict::refuted &&
             has_rounded_degrees(tree, names, claim.equation) &&
             !is_beyond_rounding(tree, names, claim.equation)) {
    doubt("it holds if the angle in degrees is rounded", "`\\approx` says so, or a decimal for the result");
  } else if (!compared && judgement.verdict == Verdict::refuted &&
             compares_decimals(tree, names, claim.equation)) {
    doubt("decimals are rounded, and nothing shows to how many digits the other side is meant",
          "write it as a decimal, or `\\approx`");
  } else if (!compared && claim.nearly && names.scope.small.empty() &&
             judgement.verdict == Verdict::refuted) {
    doubt("nothing says what is small here", "`rigor: small …` says so");
  }
}

void refute_by_digits(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement) {
  const bool open = judgement.verdict == Verdict::undecided || judgement.verdict == Verdict::not_understood ||
                    judgement.verdict == Verdict::law;
  if (!open || is_conditional(place) || is_alternative(place, parsed)) return;
  auto example = bound_of(place.tree, place.names, claim, place.options.cache);
  if (!example) return;
  judgement.verdict = Verdict::refuted;
  judgement.route = "by bounds";
  judgement.diagnostics = {{DiagnosticKind::refuted,
                            claim.relation,
                            fmt::format("the sides differ in the digits shown: left is {}, right is {}",
                                        example->left, example->right),
                            {{claim.left, ""}, {claim.right, ""}}}};
  judgement.counterexample = std::move(example);
}

bool replay_by_digits(RowPlace& place, const Claim& claim, Step& step) {
  const Counterexample& recorded = claim.recorded->example;
  const auto is_bound = [](const std::string& text) {
    return text.starts_with("less than ") || text.starts_with("more than ");
  };
  if (!recorded.values.empty() || (!is_bound(recorded.left) && !is_bound(recorded.right))) return false;
  const auto example = bound_of(place.tree, place.names, claim, place.options.cache);
  claim.recorded->replayed = true;
  if (!example || example->left != recorded.left || example->right != recorded.right) {
    claim.recorded->fault = "the sides have other bounds now";
    return true;
  }
  step.verdict = Verdict::refuted;
  step.counterexample = example;
  return true;
}

}  // namespace rigor
