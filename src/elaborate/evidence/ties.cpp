// SPDX-License-Identifier: GPL-3.0-or-later
// Which letters the rows of a section tie together, and what may change by that.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"
#include "expr/print/usual_letters.h"

namespace rigor {

namespace {

/// `U(1 - a^2/r^2)`, `b(1 - \cos\omega t)`: a factor to all who read it.
bool holds_a_factor(const SyntaxTree& syntax, SyntaxId bracket) {
  if (syntax[bracket].kind != SyntaxKind::group) return false;
  const SyntaxId sum = syntax.child(bracket, 0);
  if (syntax[sum].kind != SyntaxKind::sum || syntax.children(sum).size() < 2) return false;
  const bool number = std::ranges::any_of(syntax.children(sum), [&](const SyntaxChild& term) {
    return syntax[term.id].kind == SyntaxKind::number;
  });
  return number && std::ranges::any_of(nodes_below(syntax, {sum}), [&](SyntaxId id) {
           const SyntaxKind kind = syntax[id].kind;
           return kind == SyntaxKind::fraction || kind == SyntaxKind::power || kind == SyntaxKind::function;
         });
}

/// \omega of `\omega^2`, x of `x(t)`.
SyntaxId letter_of_side(const SyntaxTree& syntax, SyntaxId side) {
  if (syntax[side].kind == SyntaxKind::power) return syntax.child(side, 0);
  if (syntax[side].kind != SyntaxKind::term || syntax.children(side).size() != 2) return side;
  const SyntaxChild bracket = syntax.children(side)[1];
  const bool applied = bracket.joint == Joint::juxtaposed && may_hold_arguments(syntax, bracket.id) &&
                       !holds_a_factor(syntax, bracket.id);
  return applied ? syntax.children(side)[0].id : side;
}

/// An average does not change with what it is taken of.
bool is_of_outcomes(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::function && syntax.text(id) == "average";
}

/// `f(\mu + \delta)`, where `f(x) = …` stands above: a relation of such values says nothing of their letters.
bool is_value_of_function(const SyntaxTree& syntax, SyntaxId term, const Evidence& evidence) {
  if (syntax[term].kind != SyntaxKind::term) return false;
  const std::span<const SyntaxChild> factors = syntax.children(term);
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
    if (syntax[factors[k].id].kind == SyntaxKind::symbol && factors[k + 1].joint == Joint::juxtaposed &&
        may_hold_arguments(syntax, factors[k + 1].id) &&
        evidence.running.contains(function_name(syntax.symbol(factors[k].id))))
      return true;
  }
  return false;
}

Span row_of(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  return cover(syntax[sides.front()].span, syntax[sides.back()].span);
}

void tie(Evidence& evidence, const std::string& letter, const std::set<std::string>& others, Span row,
         bool of_the_letter = false) {
  std::map<std::string, TyingRows>& tied = evidence.tied[letter];
  for (const std::string& other : others) {
    const auto [known, is_new] = tied.try_emplace(other, TyingRows{row});
    if (!is_new && known->second.first != row) known->second.several = true;
    known->second.of_the_letter = known->second.of_the_letter || of_the_letter;
  }
}

/// `c^2`; not `e^{-kt}`
bool is_square(const SyntaxTree& syntax, SyntaxId side) {
  return syntax[side].kind == SyntaxKind::power && syntax[syntax.child(side, 0)].kind == SyntaxKind::symbol &&
         syntax[syntax.child(side, 1)].kind == SyntaxKind::number;
}

/// `Cd = \epsilon A` says of none of its letters alone what it is, so that any of them may follow the others.
/// An identity, with the same letters on both sides, a law of rates, a sum and an integral do not. Initial
/// values follow nothing.
void see_mutual_ties(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  static constexpr std::string_view constants_of_gases[] = {"N", "n", "R", "k",
                                                            "k_B"};  // of `pV = NkT`: constants
  std::vector<std::set<std::string>> letters;
  std::set<std::string> squared;  // c of `uv = c^2`
  for (const SyntaxId side : sides) {
    if (is_square(syntax, side)) squared.insert(changing_name(syntax.symbol(syntax.child(side, 0))));
    std::set<std::string>& own = letters.emplace_back();
    for (const SyntaxId id : nodes_below(syntax, {side})) {
      const SyntaxKind kind = syntax[id].kind;
      if (kind == SyntaxKind::derivative || kind == SyntaxKind::line_integral ||
          kind == SyntaxKind::between || kind == SyntaxKind::big_sum || is_of_outcomes(syntax, id) ||
          is_value_of_function(syntax, id, evidence))
        return;
      if (kind != SyntaxKind::symbol) continue;
      if (syntax.symbol(id).dots > 0 || syntax.symbol(id).primes > 0) return;
      const std::string name = changing_name(syntax.symbol(id));
      if (!name.ends_with("_0")) own.insert(name);
    }
  }
  if (letters.size() != 2 || letters[0] == letters[1]) return;
  letters[0].merge(letters[1]);
  const bool of_a_gas = letters[0].contains("T") &&
                        (letters[0].contains("p") || letters[0].contains("P") || letters[0].contains("V"));
  if (of_a_gas)
    std::erase_if(letters[0], [](const auto& each) { return is_one_of(each, constants_of_gases); });
  std::erase_if(letters[0], [&](const std::string& letter) { return squared.contains(letter); });
  evidence.tied_together.push_back({std::move(letters[0]), row_of(syntax, sides)});
}

/// The letters of a side, but for what an integral between limits, a sum or an average runs over.
std::set<std::string> free_letters(const SyntaxTree& syntax, SyntaxId side) {
  std::set<std::string> letters;
  if (is_of_outcomes(syntax, side)) return letters;
  if (syntax[side].kind == SyntaxKind::symbol) letters.insert(changing_name(syntax.symbol(side)));
  const auto children = syntax.children(side);
  const bool bound = syntax[side].kind == SyntaxKind::line_integral && children.size() > 2;
  for (std::size_t k = 0; k < children.size(); ++k) {
    if (bound && k == 1) {
      letters.erase(changing_name(syntax.symbol(children[k].id)));
    } else {
      letters.merge(free_letters(syntax, children[k].id));
    }
  }
  if (syntax[side].kind == SyntaxKind::big_sum && !syntax.big_sum(side).from.empty()) {
    for (const WrittenIndex& index : syntax.big_sum(side).indices) letters.erase(index.text);
  }
  return letters;
}

/// `x(0)`, `\dot x(0)`: it does not change with x.
bool is_value_at_a_number(const SyntaxTree& syntax, SyntaxId side) {
  if (syntax[side].kind != SyntaxKind::term || syntax.children(side).size() != 2) return false;
  const SyntaxChild bracket = syntax.children(side)[1];
  return bracket.joint == Joint::juxtaposed && syntax[bracket.id].kind == SyntaxKind::group &&
         std::ranges::none_of(nodes_below(syntax, {bracket.id}),
                              [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; });
}

/// `f(s)` below `f(x) = a + b(x - s)`: a value, which does not change with what f is a function of.
bool is_value_elsewhere(const SyntaxTree& syntax, SyntaxId side, const Evidence& evidence) {
  if (syntax[side].kind != SyntaxKind::term || syntax.children(side).size() != 2) return false;
  const auto [function, bracket] = std::pair(syntax.children(side)[0], syntax.children(side)[1]);
  if (bracket.joint != Joint::juxtaposed || syntax[function.id].kind != SyntaxKind::symbol ||
      syntax[bracket.id].kind != SyntaxKind::group)
    return false;
  const auto running = evidence.running.find(function_name(syntax.symbol(function.id)));
  return running != evidence.running.end() &&
         std::ranges::none_of(nodes_below(syntax, {bracket.id}), [&](SyntaxId id) {
           return syntax[id].kind == SyntaxKind::symbol &&
                  running->second.contains(changing_name(syntax.symbol(id)));
         });
}

/// `x_n = q^n`: the power says what x is for each n, and nothing of its base.
bool is_power_that_counts(const SyntaxTree& syntax, SyntaxId side, const std::vector<SyntaxId>& sides) {
  if (syntax[side].kind != SyntaxKind::power) return false;
  const std::set<std::string> counted = free_letters(syntax, syntax.child(side, 1));
  return std::ranges::any_of(sides, [&](SyntaxId other) {
    return other != side && syntax[other].kind == SyntaxKind::symbol &&
           std::ranges::any_of(syntax.symbol(other).lower,
                               [&](const WrittenIndex& index) { return counted.contains(index.text); });
  });
}

}  // namespace

void see_ties(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  if (sides.empty()) return;
  bool says_what_a_letter_is = false;
  for (const SyntaxId side : sides) {
    const SyntaxId letter = letter_of_side(syntax, side);
    if (side != sides.front() && is_square(syntax, side)) continue;  // `uv = c^2`
    if (syntax[letter].kind != SyntaxKind::symbol || is_power_that_counts(syntax, side, sides)) continue;
    says_what_a_letter_is = true;
    const std::string name = changing_name(syntax.symbol(letter));
    if (name.ends_with("_0") && side != sides.front()) continue;  // `L\dot I + RI = V_0`
    for (const SyntaxId other : sides) {
      if (other == side || is_value_at_a_number(syntax, other) || is_value_elsewhere(syntax, other, evidence))
        continue;
      const bool of_the_letter = syntax.symbol(letter).dots == 0 && syntax.symbol(letter).primes == 0;
      tie(evidence, name, free_letters(syntax, other), row_of(syntax, sides), of_the_letter);
    }
  }
  // `a + b = l` says what l is, and ties a to b as well.
  const SyntaxId front = letter_of_side(syntax, sides.front());
  if (!says_what_a_letter_is || syntax[front].kind != SyntaxKind::symbol)
    see_mutual_ties(syntax, sides, evidence);
}

namespace {

/// With all that is tied to one of them.
std::set<std::string> with_what_is_tied(std::set<std::string> changing, const Evidence& evidence) {
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [letter, others] : evidence.tied) {
      const bool changes =
          std::ranges::any_of(others, [&](const auto& other) { return changing.contains(other.first); });
      grew = (changes && changing.insert(letter).second) || grew;
    }
  }
  return changing;
}

/// All that the section differentiates by, or writes functions of.
std::set<std::string> all_variables(const Evidence& evidence) {
  std::set<std::string> all;
  for (const auto& [variable, functions] : evidence.by) all.insert(variable);
  for (const auto& [function, variables] : evidence.running) all.insert(variables.begin(), variables.end());
  return all;
}

/// x of `y'' + by' + cy = 0` and "we try $y = e^{rx}$": the usual letter for a variable, where y is none.
std::set<std::string> unnamed_variables(const Evidence& evidence) {
  std::set<std::string> found;
  for (const std::string_view usual : {"x", "t", "z", "\\theta", "\\xi", "\\tau"}) {
    const std::string letter(usual);
    const bool written = evidence.letters.contains(letter) || evidence.in_exponents.contains(letter);
    if (written && !evidence.primed.contains(letter)) found.insert(letter);
  }
  return found;
}

/// `y''` beside `E(x) = \tfrac12y'^2 + \dots`: there is only one variable that the primes can mean.
void see_what_primes_mean(Evidence& evidence) {
  std::set<std::string> variables = all_variables(evidence);
  if (variables.empty() && !evidence.primed.empty()) variables = unnamed_variables(evidence);
  if (variables.size() != 1 || is_marked(*variables.begin())) return;
  for (const std::string& name : evidence.primed) {
    const bool applied = evidence.applied.contains(name);
    if (!applied && name != *variables.begin()) evidence.by[*variables.begin()].insert(changing_name(name));
  }
}

/// `\ln N = rt + c` beside `\dot N`: it says how N runs with the time, and not that r does.
bool says_how_one_runs(const std::set<std::string>& letters, const Evidence& evidence) {
  return letters.contains("t") && std::ranges::count_if(letters, [&](const std::string& each) {
                                    return each != "t" && is_changing(evidence, each);
                                  }) == 1;
}

/// r of `e^{rx}`, where something is a function of x and nothing of r.
bool is_rate_of_growth(const Evidence& evidence, const std::string& letter) {
  const auto found = evidence.in_exponents.find(letter);
  if (found == evidence.in_exponents.end() || evidence.vectors.contains(letter)) return false;
  std::set<std::string> variables = all_variables(evidence);
  for (const auto& [function, arguments] : evidence.applied) {
    for (const std::vector<std::string>& each : arguments) variables.insert(each.begin(), each.end());
  }
  if (variables.contains(letter)) return false;
  if (!evidence.primed.empty()) variables.merge(unnamed_variables(evidence));
  return std::ranges::any_of(
      found->second, [&](const std::string& each) { return each == "t" || variables.contains(each); });
}

}  // namespace

bool is_mass_or_constant(std::string_view name) {
  return is_one_of(name, {"m", "M", "c", "\\hbar", "g", "G", "\\epsilon_0", "\\mu_0"});
}

bool is_made_of(const Evidence& evidence, const std::string& variable, const std::string& letter) {
  const auto tied = evidence.tied.find(variable);
  if (tied == evidence.tied.end() || is_mass_or_constant(letter)) return false;
  const auto rows = tied->second.find(letter);
  if (rows == tied->second.end() || !rows->second.of_the_letter) return false;
  const auto first = evidence.first_by.find(variable);
  const Span row = rows->second.first;
  return first == evidence.first_by.end() || first->second.file != row.file ||
         row.begin < first->second.begin;
}

void settle_changes(Evidence& evidence) {
  for (const auto& [function, variables] : evidence.running_primed) {
    if (!evidence.running.contains(function)) evidence.running[function] = variables;
  }
  for (const TiedTogether& each : evidence.tied_together) {
    if (says_how_one_runs(each.letters, evidence)) continue;
    for (const std::string& letter : each.letters) tie(evidence, letter, each.letters, each.row);
  }
  see_what_primes_mean(evidence);
  std::set<std::string> places{"x", "y", "z"};
  if (!is_rate_of_growth(evidence, "r")) places.insert("r");
  std::set<std::string> changing = evidence.changing;
  changing.insert(evidence.said_to_change.begin(), evidence.said_to_change.end());
  changing.insert("t");
  for (const auto& [variable, functions] : evidence.by) {
    changing.insert(variable);
    const auto tied = evidence.tied.find(variable);
    if (variable == "t" || tied == evidence.tied.end()) continue;
    for (const auto& [other, rows] : tied->second) {
      if (is_made_of(evidence, variable, other)) changing.insert(other);
    }
  }
  for (const auto& [name, arguments] : evidence.functions) {
    std::size_t at = 0;
    changing.insert(take_letter(name, at));
  }
  evidence.may_change_in_time = with_what_is_tied(changing, evidence);
  changing.merge(places);
  evidence.may_change = with_what_is_tied(std::move(changing), evidence);
}

}  // namespace rigor
