// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <string>

#include "base/ascii.h"

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

/// The letters of `k` or `x, t`, if the brackets hold nothing else.
std::set<std::string> arguments_in(const SyntaxTree& syntax, SyntaxId bracket) {
  std::set<std::string> found;
  if (syntax[bracket].kind != SyntaxKind::group && syntax[bracket].kind != SyntaxKind::tuple) return found;
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

void see_functions_in(std::string_view formula, Evidence& evidence) {
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
  if (ends) evidence.functions[name].merge(arguments);
}

}  // namespace

void see_functions(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  if (sides.size() < 2 || syntax[sides[0]].kind != SyntaxKind::term) return;
  const std::span<const SyntaxChild> factors = syntax.children(sides[0]);
  if (factors.size() != 2 || factors[1].joint != Joint::juxtaposed) return;
  if (syntax[factors[0].id].kind != SyntaxKind::symbol) return;
  std::set<std::string> arguments = arguments_in(syntax, factors[1].id);
  if (!arguments.empty()) evidence.functions[name_of(syntax.symbol(factors[0].id))].merge(arguments);
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
  const bool applies = written.face == Face::vector ? argument : !itself;
  return applies ? &found->second : nullptr;
}

}  // namespace rigor
