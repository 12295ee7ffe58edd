// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/unread.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {
namespace {

/// Is it a letter of a Greek name, and no face, accent, function or sign?
bool names_a_quantity(std::string_view control) {
  static constexpr std::array known{
      "alpha", "beta",   "gamma",  "delta", "epsilon", "varepsilon", "zeta",   "eta",   "theta",
      "kappa", "lambda", "mu",     "nu",    "xi",      "rho",        "sigma",  "tau",   "upsilon",
      "phi",   "varphi", "chi",    "psi",   "omega",   "Gamma",      "Delta",  "Theta", "Lambda",
      "Xi",    "Pi",     "Sigma",  "Phi",   "Psi",     "Omega",      "iota",   "pi",    "vartheta",
      "ell",   "hbar",   "varrho", "imath", "jmath",   "varsigma",   "Upsilon"};
  return is_one_of(control, known);
}

/// After what `_` holds.
std::size_t behind_subscript(std::string_view latex, std::size_t at) {
  while (at < latex.size() && latex[at] == ' ') ++at;
  if (at >= latex.size() || latex[at] != '{') {
    if (at < latex.size() && latex[at] == '\\') {
      ++at;
      while (at < latex.size() && is_letter(latex[at])) ++at;
      return at;
    }
    return at + 1;
  }
  int depth = 0;
  for (; at < latex.size(); ++at) {
    if (latex[at] == '{') ++depth;
    if (latex[at] == '}' && --depth == 0) return at + 1;
  }
  return at;
}

std::vector<SymbolId> symbols_in_equation(const ExprTree& tree, const Equation& equation) {
  std::vector<SymbolId> symbols = symbols_in(tree, equation.left);
  const std::vector<SymbolId> right = symbols_in(tree, equation.right);
  symbols.insert(symbols.end(), right.begin(), right.end());
  return symbols;
}

}  // namespace

std::set<std::string> letters_of(std::string_view latex) {
  std::set<std::string> letters;
  for (std::size_t at = 0; at < latex.size();) {
    if (latex[at] == '_') {
      at = behind_subscript(latex, at + 1);
      continue;
    }
    const bool control = latex[at] == '\\';
    std::size_t end = at + (control ? 1 : 0);
    while (end < latex.size() && is_letter(latex[end])) ++end;
    const std::string_view word = latex.substr(at, std::max(end, at + 1) - at);
    if (control && names_a_quantity(word.substr(1))) letters.insert(std::string(word));
    if (!control && word.size() < 3) {
      for (const char c : word) {
        if (is_letter(c)) letters.insert(std::string(1, c));
      }
    }
    at = std::max(end, at + 1);
  }
  return letters;
}

std::vector<SymbolId> symbols_of(const Question& question) {
  const ExprTree& tree = *question.tree;
  std::vector<SymbolId> symbols = symbols_in_equation(tree, question.claim);
  const auto add = [&](const std::vector<SymbolId>& more) {
    symbols.insert(symbols.end(), more.begin(), more.end());
  };
  for (const Definition& definition : question.definitions) add(symbols_in(tree, definition.body));
  for (const Equation& assumption : question.assumptions) add(symbols_in_equation(tree, assumption));
  return symbols;
}

const UnreadAssumption* unread_assumption(const ExprTree& tree, const Names& names,
                                          const Question& question) {
  if (names.scope.unread.empty()) return nullptr;
  std::set<std::string> letters;
  for (const SymbolId symbol : symbols_of(question))
    letters.merge(letters_of(tree.symbols[base_of(tree.symbols, symbol)].name));
  const auto shares = [&](const UnreadAssumption& unread) {
    return std::ranges::any_of(unread.letters,
                               [&](const std::string& letter) { return letters.contains(letter); });
  };
  const SharedList<UnreadAssumption>& unread = names.scope.unread;
  for (std::size_t k = unread.size(); k-- > 0;)
    if (shares(unread[k])) return &unread[k];
  return nullptr;
}

}  // namespace rigor
