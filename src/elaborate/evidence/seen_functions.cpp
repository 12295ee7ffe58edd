// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "expr/print/usual_letters.h"

namespace rigor {
namespace {

/// `\omega`, `E_n`: without primes and powers, which a function can have as well.
std::string name_of(const WrittenSymbol& symbol) {
  WrittenSymbol bare = symbol;
  bare.primes = 0;
  std::string name = letter_with_marks(bare);
  for (const WrittenIndex& index : symbol.lower) name += "_" + index.text;
  return name;
}

/// The same with its face: `E(k)` and `\mathbf E(\mathbf r)` are two functions.
std::string applied_name_of(const WrittenSymbol& symbol) {
  WrittenSymbol bare = symbol;
  bare.dots = 0;
  return (symbol.face == Face::plain ? "" : "\\mathbf ") + name_of(bare);
}

/// `(x, t)`, but no column: nobody writes arguments so.
bool may_hold_arguments(const SyntaxTree& syntax, SyntaxId bracket) {
  const SyntaxKind kind = syntax[bracket].kind;
  return kind == SyntaxKind::group || (kind == SyntaxKind::tuple && !written_shape(syntax, bracket).any());
}

/// The letters of `(\mathbf r, t)` as they stand; none if anything else is in the brackets.
std::vector<std::string> letters_in_bracket(const SyntaxTree& syntax, SyntaxId bracket) {
  std::vector<std::string> letters;
  if (!may_hold_arguments(syntax, bracket)) return letters;
  for (const SyntaxChild& child : syntax.children(bracket)) {
    if (syntax[child.id].kind != SyntaxKind::symbol || syntax.symbol(child.id).dots > 0) return {};
    const WrittenSymbol& symbol = syntax.symbol(child.id);
    letters.push_back(applied_name_of(symbol) + std::string(symbol.primes, '\''));
  }
  return letters;
}

/// `x_0`, `t'`: a value of what the function depends on.
bool is_marked(std::string_view letter) { return letter.find_first_of("_'^") != std::string_view::npos; }

/// The same however its label is set: `eff` of `\text{eff}` and of `{eff}`.
std::string plainly_set(std::string_view label) {
  std::string plain;
  while (!label.empty()) {
    if (label.starts_with("\\text") || label.starts_with("\\math") || label.starts_with("\\rm")) {
      label.remove_prefix(std::min(label.size(), label.find_first_of("{ ", 1)));
    } else {
      if (label.front() != '{' && label.front() != '}' && label.front() != ' ') plain += label.front();
      label.remove_prefix(1);
    }
  }
  return plain;
}

/// Can it name components, particles or members of a family, which change together? `p` and `eff` name a
/// quantity alone, and so does `0`: an initial value.
bool counts_components(std::string_view label) {
  if (label == "0") return false;
  static constexpr std::string_view indices[] = {
      "i",     "j",       "k",     "l",        "m",        "n",       "a",       "b",       "x",    "y",
      "z",     "r",       "s",     "t",        "\\alpha",  "\\beta",  "\\gamma", "\\delta", "\\mu", "\\nu",
      "\\rho", "\\theta", "\\phi", "\\varphi", "\\lambda", "\\kappa", "\\sigma", "+",       "-",    "\\pm"};
  while (!label.empty()) {
    const std::size_t length =
        label.front() == '\\' ? std::min(label.find_first_of("\\0123456789", 1), label.size()) : 1;
    const std::string_view index = label.substr(0, length);
    if (!is_digit(index.front()) && !is_one_of(index, indices)) return false;
    label.remove_prefix(length);
  }
  return true;
}

std::string with_own_label(const std::string& letter, const std::string& label) {
  if (label.empty()) return letter;
  return letter + (counts_components(label) ? "_#" : "_" + label);
}

/// `p` of `\omega_{p}`; upper labels count, as `^{(0)}`.
std::string label_in(std::string_view name) {
  const std::size_t at = name.find('_');
  if (at == std::string_view::npos || name.find('^') < at) return {};
  return plainly_set(name.substr(at + 1, name.find('^') - at - 1));
}

/// With its components, if it is a vector.
void note_changing(const WrittenSymbol& symbol, Evidence& evidence) {
  const std::string name = changing_name(symbol);
  evidence.changing.insert(name);
  if (symbol.face != Face::plain && symbol.lower.empty()) evidence.changing.insert(name + "_#");
}

SyntaxId bare(const SyntaxTree& syntax, SyntaxId id) {
  while (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
  return id;
}

/// The letters of `k` or `x, t`, if the brackets hold nothing else.
std::set<std::string> arguments_in(const SyntaxTree& syntax, SyntaxId bracket) {
  std::set<std::string> found;
  if (!may_hold_arguments(syntax, bracket)) return found;
  for (const SyntaxChild& child : syntax.children(bracket)) {
    if (syntax[child.id].kind != SyntaxKind::symbol) return {};
    found.insert(syntax.symbol(child.id).letter);
  }
  return found;
}

/// `\omega`, `k`: the letter that begins at `at`, which moves after it.
std::string take_letter(std::string_view text, std::size_t& at) {
  while (at < text.size() && text[at] == ' ') ++at;
  const std::size_t begin = at;
  if (at < text.size() && text[at] == '\\') {
    ++at;
    while (at < text.size() && is_letter(text[at])) ++at;
    return at - begin > 1 ? std::string(text.substr(begin, at - begin)) : std::string{};
  }
  return at < text.size() && is_letter(text[at]) ? std::string(1, text[at++]) : std::string{};
}

/// What has components among them can stand without an index, too.
bool is_among(const std::set<std::string>& letters, std::string_view name) {
  const std::string label = label_in(name);
  for (std::size_t at = 0; at < name.size();) {
    if (name[at] == '_' || name[at] == '^') return false;  // labels
    const std::string letter = take_letter(name, at);
    if (letters.contains(with_own_label(letter, label)) ||
        (label.empty() && !letter.empty() && letters.contains(letter + "_#")))
      return true;
    if (letter.empty()) ++at;
  }
  return false;
}

void see_functions_in(std::string_view formula, Evidence& evidence) {
  if (const auto arrow = formula.find("\\to "); arrow != std::string_view::npos)
    formula.remove_prefix(arrow + 4);  // `A \to A(x)`
  std::size_t at = 0;
  std::string name = take_letter(formula, at);
  if (name.empty() || name == "\\left" || name == "\\mathbf" || name == "\\vec") return;
  if (at + 1 < formula.size() && formula[at] == '_') {
    if (!is_letter(formula[at + 1])) return;
    name += "_" + std::string(1, formula[at + 1]);
    at += 2;
  }
  if (at >= formula.size() || formula[at] != '(') return;
  std::set<std::string> arguments;
  do {
    ++at;
    const std::string argument = take_letter(formula, at);
    if (argument.empty()) return;
    arguments.insert(argument);
    while (at < formula.size() && formula[at] == ' ') ++at;
  } while (at < formula.size() && formula[at] == ',');
  if (at >= formula.size() || formula[at] != ')') return;
  const std::size_t next = formula.find_first_not_of(" ~", at + 1);
  const bool ends = next == std::string_view::npos || formula[next] == '=' || formula[next] == ',' ||
                    formula[next] == ':' || formula.substr(next).starts_with("\\approx");
  if (!ends) return;
  const bool is_value = next != std::string_view::npos && formula[next] == '=';
  if (!is_value) evidence.running[name].insert(arguments.begin(), arguments.end());
  evidence.functions[name].merge(arguments);
}

}  // namespace

void see_functions(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  if (sides.size() < 2 || syntax[sides[0]].kind != SyntaxKind::term) return;
  const std::span<const SyntaxChild> factors = syntax.children(sides[0]);
  if (factors.size() != 2 || factors[1].joint != Joint::juxtaposed) return;
  if (syntax[factors[0].id].kind != SyntaxKind::symbol) return;
  std::set<std::string> arguments = arguments_in(syntax, factors[1].id);
  if (arguments.empty()) return;
  const std::string name = name_of(syntax.symbol(factors[0].id));
  // Beside `f(x) = x^2`, `f'(c) = 2c` is a value.
  auto& running = syntax.symbol(factors[0].id).primes > 0 ? evidence.running_primed : evidence.running;
  // `V(R) = 0` is a value; `V(R) = cR` says how V runs with R.
  for (const SyntaxId id : nodes_below(syntax, {sides.begin() + 1, sides.end()})) {
    if (syntax[id].kind == SyntaxKind::symbol && arguments.contains(syntax.symbol(id).letter))
      running[name].insert(syntax.symbol(id).letter);
  }
  evidence.functions[name].merge(arguments);
}

void see_inline_functions(std::string_view text, Evidence& evidence) {
  for (std::size_t open = text.find('$'); open != std::string_view::npos;) {
    const std::size_t close = text.find('$', open + 1);
    if (close == std::string_view::npos) break;
    see_functions_in(text.substr(open + 1, close - open - 1), evidence);
    open = text.find('$', close + 1);
  }
  for (std::size_t open = text.find("\\("); open != std::string_view::npos;) {
    const std::size_t close = text.find("\\)", open + 2);
    if (close == std::string_view::npos) break;
    see_functions_in(text.substr(open + 2, close - open - 2), evidence);
    open = text.find("\\(", close + 2);
  }
}

SyntaxId without_derivatives(const SyntaxTree& syntax, SyntaxId id) {
  for (;;) {
    const SyntaxKind kind = syntax[id].kind;
    const bool applied = kind == SyntaxKind::term && syntax[id].count == 2 &&
                         !letters_in_bracket(syntax, syntax.child(id, 1)).empty();
    const bool starred = kind == SyntaxKind::function && syntax.text(id) == "conjugate";  // `\psi^*(x)`
    if (kind != SyntaxKind::group && kind != SyntaxKind::derivative && !applied && !starred) return id;
    id = syntax.child(id, 0);
  }
}

namespace {

/// `rx`, and each of the terms of `i(kr - \omega t)`: two letters side by side.
void see_exponent_of_growth(const SyntaxTree& syntax, SyntaxId exponent, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, {exponent})) {
    if (syntax[id].kind != SyntaxKind::term) continue;
    std::vector<std::string> letters;
    for (const SyntaxChild& factor : syntax.children(id)) {
      if (syntax[factor.id].kind == SyntaxKind::symbol)
        letters.push_back(changing_name(syntax.symbol(factor.id)));
    }
    if (letters.size() != 2) continue;
    evidence.in_exponents[letters[0]].insert(letters[1]);
    evidence.in_exponents[letters[1]].insert(letters[0]);
  }
}

}  // namespace

void see_changing(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    const SyntaxKind kind = syntax[id].kind;
    if (kind == SyntaxKind::symbol && syntax.symbol(id).dots > 0) note_changing(syntax.symbol(id), evidence);
    if (kind == SyntaxKind::symbol && syntax.symbol(id).primes > 1)
      evidence.primed.insert(name_of(syntax.symbol(id)));
    if (kind == SyntaxKind::symbol && syntax.symbol(id).primes > 0)
      evidence.with_primes.insert(changing_name(syntax.symbol(id)));
    if (kind == SyntaxKind::power) see_exponent_of_growth(syntax, syntax.child(id, 1), evidence);
    if (kind == SyntaxKind::component && syntax.indices(id).size() == 1 &&
        syntax[bare(syntax, syntax.child(id, 0))].kind == SyntaxKind::derivative)
      evidence.by[syntax.indices(id)[0].text];  // V of `(\partial S/\partial T)_V` could change
    if (kind == SyntaxKind::derivative) {
      const SyntaxId of = without_derivatives(syntax, id);
      if (syntax[of].kind == SyntaxKind::symbol) note_changing(syntax.symbol(of), evidence);
      for (const WrittenVariable& by : syntax.derivative(id).by) {
        std::set<std::string>& functions = evidence.by[dotted(by.symbol.letter, by.symbol.dots)];
        if (syntax[of].kind == SyntaxKind::symbol) functions.insert(changing_name(syntax.symbol(of)));
      }
    }
    if (kind != SyntaxKind::term) continue;
    const std::span<const SyntaxChild> factors = syntax.children(id);
    for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
      const bool differential = syntax[factors[k].id].kind == SyntaxKind::symbol &&
                                syntax.symbol(factors[k].id).letter == "d" &&
                                syntax[factors[k + 1].id].kind == SyntaxKind::symbol;
      if (differential) note_changing(syntax.symbol(factors[k + 1].id), evidence);
      const SyntaxId of = without_derivatives(syntax, factors[k].id);
      if (factors[k + 1].joint != Joint::juxtaposed || syntax[of].kind != SyntaxKind::symbol) continue;
      SyntaxId bracket = factors[k + 1].id;
      if (syntax[bracket].kind == SyntaxKind::power) bracket = syntax.child(bracket, 0);  // `v(t)^2`
      std::vector<std::string> letters = letters_in_bracket(syntax, bracket);
      if (letters.empty() || is_never_applied(syntax.symbol(of))) continue;
      note_changing(syntax.symbol(of), evidence);
      if (syntax.symbol(of).primes > 0) evidence.primed.insert(name_of(syntax.symbol(of)));
      evidence.applied[applied_name_of(syntax.symbol(of))].insert(std::move(letters));
    }
  }
}

bool is_never_applied(const WrittenSymbol& symbol) {
  static constexpr std::string_view letters[] = {"\\pi", "i",       "\\mathrm{i}", "d",      "O",
                                                 "o",    "\\delta", "\\Delta",     "\\nabla"};
  return is_one_of(symbol.letter, letters) || !symbol.change.empty();
}

std::string changing_name(const WrittenSymbol& symbol) {
  std::string label;
  for (const WrittenIndex& index : symbol.lower) {
    if (!index.text.starts_with('^')) label += plainly_set(index.text);
  }
  return with_own_label(symbol.letter, label);
}

std::string changing_name(std::string_view name) {
  const std::string label = label_in(name);
  return with_own_label(std::string(name.substr(0, name.find_first_of("_^"))), label);
}

std::string dotted(std::string_view letter, int dots) {
  std::string name;
  for (int k = 0; k < dots; ++k) name += "\\dot ";
  return name.append(letter);
}

bool is_applied(const Evidence& evidence, std::string_view name) {
  std::size_t at = 0;
  const std::string letter = take_letter(name, at);
  return std::ranges::any_of(evidence.applied, [&](const auto& entry) {
    std::size_t begin = entry.first.starts_with("\\mathbf ") ? 8 : 0;
    return take_letter(entry.first, begin) == letter;
  });
}

bool is_function_of(const Evidence& evidence, std::string_view name, std::string_view variable) {
  std::size_t at = 0;
  const std::string letter = take_letter(name, at);
  const std::string own = with_own_label(letter, label_in(name));
  const auto by = evidence.by.find(std::string(variable));
  if (by != evidence.by.end() && by->second.contains(own)) return true;
  return std::ranges::any_of(evidence.applied, [&](const auto& entry) {
    std::size_t begin = entry.first.starts_with("\\mathbf ") ? 8 : 0;
    return with_own_label(take_letter(entry.first, begin), label_in(entry.first)) == own &&
           std::ranges::any_of(entry.second, [&](const std::vector<std::string>& letters) {
             return std::ranges::find(letters, variable) != letters.end();
           });
  });
}

namespace {

constexpr std::array<std::string_view, 3> coordinates{"x", "y", "z"};

}  // namespace

bool is_function_of_a_coordinate(const Evidence& evidence, std::string_view name) {
  return std::ranges::any_of(coordinates, [&](std::string_view other) {
    return other != name && is_function_of(evidence, name, other);
  });
}

bool is_own_variable(const Evidence& evidence, std::string_view letter) {
  if (!is_one_of(letter, coordinates) || evidence.complex_numbers.contains(std::string(letter))) return true;
  return std::ranges::any_of(coordinates, [&](std::string_view other) {
    return other != letter && is_function_of(evidence, other, letter);
  });
}

std::optional<std::string> variable_of_primes(const WrittenSymbol& symbol, const Evidence& evidence) {
  if (symbol.primes == 0 || !evidence.primed.contains(name_of(symbol))) return std::nullopt;
  const auto variables = variables_of(symbol, evidence);
  std::set<std::string> found;
  if (variables) found.insert(variables->begin(), variables->end());
  for (const auto& [variable, functions] : evidence.by) {
    if (!variables && functions.contains(changing_name(symbol))) found.insert(variable);
  }
  const bool one = found.size() == 1 && *found.begin() != "t" && !is_marked(*found.begin()) &&
                   found.begin()->find(' ') == std::string::npos;
  return one ? std::optional(*found.begin()) : std::nullopt;
}

bool is_changing(const Evidence& evidence, std::string_view name) {
  return is_among(evidence.changing, name);
}

bool may_be_changing(const Evidence& evidence, std::string_view name) {
  return evidence.speaks_of_change || is_among(evidence.may_change, name);
}

bool may_be_changing_in_time(const Evidence& evidence, std::string_view name) {
  return evidence.speaks_of_change || is_among(evidence.may_change_in_time, name);
}

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
        evidence.running.contains(name_of(syntax.symbol(factors[k].id))))
      return true;
  }
  return false;
}

/// `Cd = \epsilon A` says of none of its letters alone what it is, so that any of them may follow the others.
/// An identity, with the same letters on both sides, a law of rates, a sum and an integral do not. Initial
/// values follow nothing.
void see_mutual_ties(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  static constexpr std::string_view of_states[] = {"N", "n", "R", "k", "k_B"};  // of `pV = NkT`: constants
  std::vector<std::set<std::string>> letters;
  for (const SyntaxId side : sides) {
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
      if (!name.ends_with("_0") && !is_one_of(name, of_states)) own.insert(name);
    }
  }
  if (letters.size() != 2 || letters[0] == letters[1]) return;
  letters[0].merge(letters[1]);
  evidence.tied_together.push_back(std::move(letters[0]));
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
  const auto running = evidence.running.find(name_of(syntax.symbol(function.id)));
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
  bool says_what_a_letter_is = false;
  for (const SyntaxId side : sides) {
    const SyntaxId letter = letter_of_side(syntax, side);
    if (syntax[letter].kind != SyntaxKind::symbol || is_power_that_counts(syntax, side, sides)) continue;
    says_what_a_letter_is = true;
    const std::string name = changing_name(syntax.symbol(letter));
    if (name.ends_with("_0") && side != sides.front()) continue;  // `L\dot I + RI = V_0`
    std::set<std::string>& tied = evidence.tied[name];
    for (const SyntaxId other : sides) {
      if (other == side || is_value_at_a_number(syntax, other) || is_value_elsewhere(syntax, other, evidence))
        continue;
      tied.merge(free_letters(syntax, other));
    }
  }
  if (!says_what_a_letter_is) see_mutual_ties(syntax, sides, evidence);
}

namespace {

/// With all that is tied to one of them.
std::set<std::string> with_what_is_tied(std::set<std::string> changing, const Evidence& evidence) {
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [letter, others] : evidence.tied) {
      const bool changes =
          std::ranges::any_of(others, [&](const std::string& other) { return changing.contains(other); });
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

void settle_changes(Evidence& evidence) {
  for (const auto& [function, variables] : evidence.running_primed) {
    if (!evidence.running.contains(function)) evidence.running[function] = variables;
  }
  for (const std::set<std::string>& letters : evidence.tied_together) {
    if (says_how_one_runs(letters, evidence)) continue;
    for (const std::string& letter : letters) evidence.tied[letter].insert(letters.begin(), letters.end());
  }
  see_what_primes_mean(evidence);
  std::set<std::string> places{"x", "y", "z"};
  if (!is_rate_of_growth(evidence, "r")) places.insert("r");
  std::set<std::string> changing = evidence.changing;
  changing.insert(evidence.said_to_change.begin(), evidence.said_to_change.end());
  changing.insert("t");
  for (const auto& [variable, functions] : evidence.by) changing.insert(variable);
  for (const auto& [name, arguments] : evidence.functions) {
    std::size_t at = 0;
    changing.insert(take_letter(name, at));
  }
  evidence.may_change_in_time = with_what_is_tied(changing, evidence);
  changing.merge(places);
  evidence.may_change = with_what_is_tied(std::move(changing), evidence);
}

std::optional<std::vector<std::string>> variables_of(const WrittenSymbol& symbol, const Evidence& evidence) {
  const auto applied = evidence.applied.find(applied_name_of(symbol));
  if (applied == evidence.applied.end()) return std::nullopt;
  std::vector<std::vector<std::string>> plain;
  std::ranges::copy_if(applied->second, std::back_inserter(plain), [](const std::vector<std::string>& each) {
    return std::ranges::none_of(each, is_marked);
  });
  const auto running = evidence.running.find(name_of(symbol));
  const auto runs = [&](const std::string& each) {
    return running != evidence.running.end() && running->second.contains(each);
  };
  const auto all_run = [&](const std::vector<std::string>& each) { return std::ranges::all_of(each, runs); };
  const auto are_coordinates = [](const std::vector<std::string>& each) {
    return std::ranges::all_of(each, [](const std::string& letter) { return is_usual_coordinate(letter); });
  };
  // `f(\varepsilon) = …`, `f(\mu)`: the letter that it is written with; `u(y)`, `u(h)`: that is a coordinate.
  if (plain.size() > 1 && std::ranges::any_of(plain, all_run))
    std::erase_if(plain, [&](const auto& each) { return !all_run(each); });
  if (plain.size() > 1) std::erase_if(plain, [&](const auto& each) { return !are_coordinates(each); });
  if (plain.size() != 1) return std::nullopt;
  const std::vector<std::string>& variables = plain.front();
  const auto is_running = [&](const std::string& each) {
    const bool vector = each.starts_with("\\mathbf ") && !is_marked(each);
    return runs(each) || is_usual_coordinate(each) || vector;
  };
  const bool sure = variables.size() > 1 ? std::ranges::all_of(variables, is_running)
                                         : all_run(variables) || (are_coordinates(variables) &&
                                                                  !is_usual_coefficient(symbol.letter));
  return sure ? std::optional(variables) : std::nullopt;
}

bool is_argument(const SyntaxTree& syntax, SyntaxId applied, SyntaxId bracket, const Evidence& evidence) {
  const SyntaxId id = without_derivatives(syntax, applied);
  if (syntax[id].kind != SyntaxKind::symbol) return false;
  if (holds_matrix_letter(syntax, bracket, evidence)) return false;
  const std::vector<std::string> letters = letters_in_bracket(syntax, bracket);
  return !letters.empty() && variables_of(syntax.symbol(id), evidence) == letters;
}

namespace {

/// `f(f(x))`, and not `n(n + 1)`: the letter stands before a bracket in the bracket, too.
bool is_applied_inside(const SyntaxTree& syntax, SyntaxId bracket, const std::string& letter) {
  return std::ranges::any_of(nodes_below(syntax, {bracket}), [&](SyntaxId id) {
    const auto factors = syntax.children(id);
    for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
      const SyntaxId next = factors[k + 1].id;
      if (syntax[factors[k].id].kind == SyntaxKind::symbol && syntax[next].kind == SyntaxKind::group &&
          factors[k + 1].joint == Joint::juxtaposed && syntax.symbol(factors[k].id).letter == letter)
        return true;
    }
    return false;
  });
}

}  // namespace

const std::set<std::string>* arguments_of(const SyntaxTree& syntax, SyntaxId symbol, SyntaxId bracket,
                                          const Evidence& evidence) {
  const WrittenSymbol& written = syntax.symbol(symbol);
  const auto found = evidence.functions.find(name_of(written));
  if (found == evidence.functions.end()) return nullptr;
  bool itself = false;
  bool argument = false;
  for (const SyntaxId id : nodes_below(syntax, {bracket})) {
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    itself = itself || syntax.symbol(id).letter == written.letter;
    argument = argument || found->second.contains(syntax.symbol(id).letter);
  }
  const bool applies =
      written.face == Face::vector ? argument : !itself || is_applied_inside(syntax, bracket, written.letter);
  return applies ? &found->second : nullptr;
}

}  // namespace rigor
