// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {
namespace {

/// Two of them above a letter are indices.
bool is_spacetime_index(std::string_view letter) {
  static constexpr std::array<std::string_view, 6> letters{"\\mu",    "\\nu",     "\\rho",
                                                           "\\sigma", "\\lambda", "\\kappa"};
  return is_one_of(letter, letters);
}

bool is_index(std::string_view letter) {
  static constexpr std::array<std::string_view, 13> letters{"i", "j", "k", "l", "m",       "n",     "a",
                                                            "b", "c", "d", "p", "\\alpha", "\\beta"};
  return is_one_of(letter, letters) || is_spacetime_index(letter);
}

bool is_euler(const WrittenSymbol& symbol) { return symbol.letter == "e" || symbol.letter == "\\mathrm{e}"; }

/// Everything in a chain, wherever it is.
struct Scripts {
  std::set<std::string> lower;   // letters of subscripts
  std::set<std::string> ridden;  // `i` or `j` above a letter of each side: `v^i = \dot x^i`
  std::set<std::string> summed;  // those that a `\sum` writes
};

Scripts scripts_in(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  Scripts scripts;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol) {
      for (const WrittenIndex& index : syntax.symbol(id).lower) scripts.lower.insert(index.text);
    }
    if (syntax[id].kind == SyntaxKind::big_sum) {
      for (const WrittenIndex& index : syntax.big_sum(id).indices) scripts.summed.insert(index.text);
    }
  }
  return scripts;
}

/// The letters of `ij`, `\mu`; nothing where more is there.
std::vector<std::string> letters_of_exponent(const SyntaxTree& syntax, SyntaxId exponent) {
  const auto plain = [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return false;
    const WrittenSymbol& symbol = syntax.symbol(id);
    return symbol.face == Face::plain && symbol.accent == Accent::none && symbol.lower.empty() &&
           symbol.primes == 0 && symbol.change.empty();
  };
  if (plain(exponent)) return {syntax.symbol(exponent).letter};
  if (syntax[exponent].kind != SyntaxKind::term) return {};
  std::vector<std::string> letters;
  for (const SyntaxChild& child : syntax.children(exponent)) {
    const bool beside = letters.empty() || child.joint == Joint::juxtaposed;
    if (!beside || !plain(child.id)) return {};
    letters.push_back(syntax.symbol(child.id).letter);
  }
  return letters;
}

/// What stands above something below `sides`, each node.
std::set<SyntaxId> nodes_above(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::vector<SyntaxId> exponents;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::power) exponents.push_back(syntax.child(id, 1));
  }
  const std::vector<SyntaxId> below = nodes_below(syntax, exponents);
  return {below.begin(), below.end()};
}

/// `i` and `j` that stand alone above a letter below `side`.
std::set<std::string> above_letters(const SyntaxTree& syntax, SyntaxId side) {
  std::set<std::string> found;
  for (const SyntaxId id : nodes_below(syntax, {side})) {
    if (syntax[id].kind != SyntaxKind::power) continue;
    const std::vector<std::string> letters = letters_of_exponent(syntax, syntax.child(id, 1));
    if (letters.size() == 1 && (letters[0] == "i" || letters[0] == "j")) found.insert(letters[0]);
  }
  return found;
}

/// \gamma of `V^{\gamma - 1}`; n of `x^{n+1}` may count the steps of an iteration.
void see_reckoned(const SyntaxTree& syntax, SyntaxId exponent, Evidence& evidence) {
  static constexpr std::array<std::string_view, 8> counters{"i", "j", "k", "l", "m", "n", "s", "t"};
  if (!is_reckoned(syntax, exponent)) return;
  for (const SyntaxId id : nodes_below(syntax, {exponent})) {
    if (syntax[id].kind != SyntaxKind::symbol || is_one_of(syntax.symbol(id).letter, counters)) continue;
    evidence.exponents.insert(syntax.symbol(id).letter);
  }
}

bool is_upper_index(const SyntaxTree& syntax, SyntaxId exponent, const Scripts& scripts) {
  if (syntax[exponent].kind == SyntaxKind::number)
    return syntax.text(exponent) == "0" || syntax.text(exponent) == "1";
  const std::vector<std::string> letters = letters_of_exponent(syntax, exponent);
  if (letters.empty() || !std::ranges::all_of(letters, is_index)) return false;
  const bool spacetime =
      std::ranges::all_of(letters, is_spacetime_index) && (letters.size() > 1 || letters[0] == "\\mu");
  const bool paired = std::ranges::any_of(letters, [&](const std::string& letter) {
    const bool beside = scripts.lower.contains(letter) || scripts.ridden.contains(letter);
    return beside && !scripts.summed.contains(letter);
  });
  return spacetime || paired;
}

// -- words --

/// `x` of `x^0 = ct`, `x^\mu`, `v^1`; with `any_letter` of `x^i` as well.
void see_raised_in(std::string_view formula, bool any_letter, Evidence& evidence) {
  for (std::size_t at = formula.find('^'); at != std::string_view::npos; at = formula.find('^', at + 1)) {
    std::size_t begin = at;
    while (begin > 0 && is_letter(formula[begin - 1])) --begin;
    const bool control = begin > 0 && formula[begin - 1] == '\\';
    if (begin == at) continue;
    const std::string_view base =
        control ? formula.substr(begin - 1, at - begin + 1) : formula.substr(at - 1, 1);
    std::string_view script = formula.substr(at + 1);
    if (script.starts_with("{")) script = script.substr(1, std::min(script.find('}'), script.size()) - 1);
    const std::string_view first = script.substr(0, script.find_first_of(" ,=+-()^_}", 1));
    const bool number = (script.starts_with("0") || script.starts_with("1")) &&
                        (script.size() == 1 || !is_digit(script[1])) && !script.substr(1).starts_with("/");
    const bool usual = first == "i" || first == "j" || is_spacetime_index(first);
    const bool index = first == "\\mu" || (any_letter && usual);
    if (base != "e" && (number || index)) evidence.raised.insert(std::string(base));
  }
}

bool mentions(std::string_view text, std::string_view words) {
  return text.find(words) != std::string_view::npos;
}

}  // namespace

bool is_reckoned(const SyntaxTree& syntax, SyntaxId exponent) {
  return std::ranges::any_of(nodes_below(syntax, {exponent}), [&](SyntaxId id) {
    if (syntax[id].kind == SyntaxKind::fraction || syntax[id].kind == SyntaxKind::number) return true;
    return std::ranges::any_of(syntax.children(id), [](const SyntaxChild& child) {
      return child.joint == Joint::minus || child.joint == Joint::slash;
    });
  });
}

void see_raised(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  Scripts scripts = scripts_in(syntax, sides);
  if (sides.size() > 1) scripts.ridden = above_letters(syntax, sides.front());
  for (const SyntaxId side : sides) {
    const std::set<std::string> above = above_letters(syntax, side);
    std::erase_if(scripts.ridden, [&](const std::string& letter) { return !above.contains(letter); });
  }
  const std::set<SyntaxId> raised = nodes_above(syntax, sides);
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol && !raised.contains(id) && syntax.symbol(id).lower.empty())
      evidence.exponents.insert(syntax.symbol(id).letter);
    if (syntax[id].kind != SyntaxKind::power) continue;
    see_reckoned(syntax, syntax.child(id, 1), evidence);
    const SyntaxId base = syntax.child(id, 0);
    if (syntax[base].kind != SyntaxKind::symbol || is_euler(syntax.symbol(base))) continue;
    if (is_upper_index(syntax, syntax.child(id, 1), scripts))
      evidence.raised.insert(syntax.symbol(base).letter);
  }
}

void see_said_raised(std::string_view text, Evidence& evidence) {
  const std::string lower = lowered_line(text);
  for (const char* words : {"upper ind", "superscript", "raised ind", "upper and lower ind",
                            "lower and upper ind", "raise and lower", "raising and lowering ind"}) {
    evidence.speaks_of_raised = evidence.speaks_of_raised || mentions(lower, words);
  }
  const bool indices = mentions(lower, "coordinate") || mentions(lower, "component") ||
                       mentions(lower, "contravariant") || mentions(lower, "index") ||
                       mentions(lower, "indices");
  for (std::size_t open = text.find('$'); open != std::string_view::npos;) {
    const std::size_t close = text.find('$', open + 1);
    if (close == std::string_view::npos) return;
    see_raised_in(text.substr(open + 1, close - open - 1), indices, evidence);
    open = text.find('$', close + 1);
  }
}

bool may_be_raised(const WrittenSymbol& symbol, const Evidence& evidence) {
  if (symbol.face != Face::plain || !symbol.lower.empty() || symbol.primes > 0) return false;
  return evidence.speaks_of_raised || evidence.raised.contains(symbol.letter);
}

}  // namespace rigor
