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

std::string function_name(const WrittenSymbol& symbol) {
  WrittenSymbol bare = symbol;
  bare.primes = 0;
  std::string name = letter_with_marks(bare);
  for (const WrittenIndex& index : symbol.lower) name += "_" + index.text;
  return name;
}

bool may_hold_arguments(const SyntaxTree& syntax, SyntaxId bracket) {
  const SyntaxKind kind = syntax[bracket].kind;
  return kind == SyntaxKind::group || (kind == SyntaxKind::tuple && !written_shape(syntax, bracket).any());
}

bool is_marked(std::string_view letter) { return letter.find_first_of("_'^") != std::string_view::npos; }

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

namespace {

/// The same with its face: `E(k)` and `\mathbf E(\mathbf r)` are two functions.
std::string applied_name_of(const WrittenSymbol& symbol) {
  WrittenSymbol bare = symbol;
  bare.dots = 0;
  return (symbol.face == Face::plain ? "" : "\\mathbf ") + function_name(bare);
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
  const bool below_zero = formula.ends_with("< 0") || formula.ends_with("<0");
  evidence.speaks_of_signs = evidence.speaks_of_signs || below_zero;
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
  const std::string name = function_name(syntax.symbol(factors[0].id));
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
    const std::string_view formula = text.substr(open + 1, close - open - 1);
    see_functions_in(formula, evidence);
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
      evidence.primed.insert(function_name(syntax.symbol(id)));
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
        const std::string variable = dotted(by.symbol.letter, by.symbol.dots);
        evidence.first_by.try_emplace(variable, syntax[id].span);
        std::set<std::string>& functions = evidence.by[variable];
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
      if (syntax.symbol(of).primes > 0) evidence.primed.insert(function_name(syntax.symbol(of)));
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
  if (symbol.primes == 0 || !evidence.primed.contains(function_name(symbol))) return std::nullopt;
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

std::optional<std::vector<std::string>> variables_of(const WrittenSymbol& symbol, const Evidence& evidence) {
  const auto applied = evidence.applied.find(applied_name_of(symbol));
  if (applied == evidence.applied.end()) return std::nullopt;
  std::vector<std::vector<std::string>> plain;
  std::ranges::copy_if(applied->second, std::back_inserter(plain), [](const std::vector<std::string>& each) {
    return std::ranges::none_of(each, is_marked);
  });
  const auto running = evidence.running.find(function_name(symbol));
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
  const auto found = evidence.functions.find(function_name(written));
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
