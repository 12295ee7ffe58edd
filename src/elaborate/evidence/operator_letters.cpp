// SPDX-License-Identifier: GPL-3.0-or-later
// A pair in square brackets can be an interval, a hat a unit vector, a pair in braces a set. So what stands
// in brackets is an operator only where a dagger or the words of the section say of what it speaks, and a
// letter with a hat only where operators are about and it is no usual unit vector.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

bool is_adjoint(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::function && syntax.text(id) == "adjoint";
}

/// `L_i`, `S_z`, `J_+`: one of several that belong together.
bool is_of_family(const WrittenSymbol& symbol) {
  static constexpr auto labels = std::to_array<std::string_view>(
      {"i", "j", "k", "l", "m", "n", "a", "b", "c", "x", "y", "z", "1", "2", "3"});
  return symbol.lower.size() == 1 && is_one_of(symbol.lower[0].text, labels);
}

/// No operators, wherever they stand.
bool is_constant_of_nature(const WrittenSymbol& symbol) {
  static constexpr auto constants =
      std::to_array<std::string_view>({"i", "e", "\\hbar", "\\pi", "\\epsilon", "\\delta", "\\mathrm{i}"});
  return symbol.accent != Accent::hat && is_one_of(symbol.letter, constants);
}

void add_letter(const WrittenSymbol& symbol, Evidence& evidence) {
  const std::string letter = letter_with_marks(symbol);
  if (symbol.face == Face::plain) evidence.operator_letters.insert(with_labels(letter, symbol.lower));
  if (is_of_family(symbol) || symbol.face == Face::vector) evidence.operator_families.insert(letter);
}

bool may_be_of_many(const WrittenSymbol& symbol) {
  return symbol.accent == Accent::hat || (symbol.letter.size() == 1 && is_capital_letter(symbol.letter));
}

/// The letters that a pair is about: what stands alone, under powers and daggers, and beside others what has
/// a hat or is a capital. Recursion: as deep as the tree.
void add_letters(const SyntaxTree& syntax, SyntaxId id, bool alone, Evidence& evidence) {
  const SyntaxNode& node = syntax[id];
  switch (node.kind) {
    case SyntaxKind::symbol: {
      const WrittenSymbol& symbol = syntax.symbol(id);
      if (alone ? !is_constant_of_nature(symbol) : may_be_of_many(symbol)) add_letter(symbol, evidence);
      return;
    }
    case SyntaxKind::power:
      return add_letters(syntax, syntax.child(id, 0), alone, evidence);
    case SyntaxKind::group:
      return add_letters(syntax, syntax.child(id, 0), alone, evidence);
    case SyntaxKind::function:
      if (is_adjoint(syntax, id)) add_letters(syntax, syntax.child(id, 0), true, evidence);
      return;
    case SyntaxKind::sum:
    case SyntaxKind::term:
      for (const SyntaxChild& child : syntax.children(id)) {
        if (child.joint != Joint::slash) add_letters(syntax, child.id, node.count == 1 && alone, evidence);
      }
      return;
    default:
      return;
  }
}

/// Unit vectors, and the axes, have the same hat.
bool is_usual_unit_vector(std::string_view letter) {
  static constexpr auto units = std::to_array<std::string_view>(
      {"\\hat{x}",       "\\hat{y}",       "\\hat{z}",         "\\hat{r}",        "\\hat{n}",
       "\\hat{k}",       "\\hat{e}",       "\\hat{i}",         "\\hat{j}",        "\\hat{u}",
       "\\hat{v}",       "\\hat{t}",       "\\hat{s}",         "\\hat{d}",        "\\hat{l}",
       "\\hat{m}",       "\\hat{\\theta}", "\\hat{\\phi}",     "\\hat{\\varphi}", "\\hat{\\rho}",
       "\\hat{\\imath}", "\\hat{\\jmath}", "\\hat{\\epsilon}", "\\hat{\\omega}",  "\\hat{\\tau}",
       "\\hat{f}",       "\\hat{g}",       "\\hat{\\psi}"});
  return is_one_of(letter, units);
}

std::string without_subscript(const std::string& name) { return name.substr(0, name.find('_')); }

bool speaks_of(const std::string& lower, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) {
    for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1)) {
      if (at == 0 || !is_letter(lower[at - 1])) return true;
    }
    return false;
  });
}

/// "the operators $A$ and $B$", "matrices $A$, $B$": the letters that directly follow the word.
void see_called(std::string_view text, std::string_view word, Evidence& evidence) {
  const std::string lower = lowered(text);
  for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1)) {
    if (at > 0 && is_letter(lower[at - 1])) continue;
    std::size_t next = at + word.size();
    while (true) {
      const std::size_t open = text.find('$', next);
      if (open == std::string_view::npos) break;
      std::string_view between = text.substr(next, open - next);
      while (!between.empty() &&
             (is_white(between.front()) || between.front() == '~' || between.front() == ','))
        between.remove_prefix(1);
      while (!between.empty() && (is_white(between.back()) || between.back() == '~'))
        between.remove_suffix(1);
      if (!between.empty() && between != "and") break;
      const std::size_t close = text.find('$', open + 1);
      if (close == std::string_view::npos) break;
      const std::string_view formula = text.substr(open + 1, close - open - 1);
      const bool capital = formula.size() == 1 && is_capital_letter(formula[0]);
      const bool small = formula.size() == 1 && !capital && is_letter(formula[0]);
      if (!capital && !small) break;
      evidence.operator_letters.insert(std::string(formula));
      next = close + 1;
    }
  }
}

}  // namespace

namespace {

/// H of `H = p^2/2m + V`, N of `N = a^\dagger a`.
void add_what_is_made_of_operators(Evidence& evidence) {
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [letter, names] : evidence.set_equal) {
      if (is_operator(evidence, letter, 0) || evidence.declared_real.contains(letter) ||
          evidence.written_out.contains(letter))
        continue;
      const bool made = std::ranges::any_of(names, [&](const std::string& name) {
        return is_operator(evidence, name, 0) && unsized_letter(evidence, name) == Unsized::none;
      });
      if (made) evidence.noncommuting.insert(letter);
      grew = grew || made;
    }
  }
}

}  // namespace

void see_operators(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (is_adjoint(syntax, id)) {
      add_letters(syntax, syntax.child(id, 0), true, evidence);
      evidence.speaks_of_operators = true;
    }
    if (!is_pair_in_brackets(syntax[id])) continue;
    for (const SyntaxChild& child : syntax.children(id)) add_letters(syntax, child.id, true, evidence);
  }
  for (const SyntaxId side : sides) {
    if (syntax[side].kind != SyntaxKind::symbol || is_constant_of_nature(syntax.symbol(side))) continue;
    const WrittenSymbol& symbol = syntax.symbol(side);
    if (symbol.face != Face::plain) continue;
    std::set<std::string>& names = evidence.set_equal[with_labels(letter_with_marks(symbol), symbol.lower)];
    for (const SyntaxId id : nodes_below(syntax, sides)) {
      if (syntax[id].kind != SyntaxKind::symbol || id == side) continue;
      const WrittenSymbol& other = syntax.symbol(id);
      names.insert(with_labels(letter_with_marks(other), other.lower));
    }
  }
  const bool matrix = std::ranges::any_of(nodes_below(syntax, sides),
                                          [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::matrix; });
  for (const SyntaxId side : sides) {
    if (matrix && syntax[side].kind == SyntaxKind::symbol)
      evidence.written_out.insert(letter_with_marks(syntax.symbol(side)));
  }
}

void see_said_operators(std::string_view text, Evidence& evidence) {
  const std::string lower = lowered(text);
  if (speaks_of(lower, {"poisson"})) evidence.speaks_of_poisson = true;
  if (speaks_of(lower,
                {"operator", "commutator", "commute", "commutation", "noncommut", "non-commut", "anticommut",
                 "anti-commut", "observable", "hermitian", "heisenberg", "pauli matri", "matrices"}))
    evidence.speaks_of_operators = true;
  if (speaks_of(lower, {"pauli"})) evidence.operator_families.insert("\\sigma");
  if (speaks_of(lower, {"pauli matri", "pauli spin matri", "pauli's matri"})) evidence.speaks_of_pauli = true;
  for (const std::string_view word : {"operators", "operator", "observables", "matrices"})
    see_called(text, word, evidence);
}

void settle_operators(Evidence& evidence) {
  if (!evidence.speaks_of_operators) return;
  const auto is_written_out = [&](const std::string& name) {
    return evidence.written_out.contains(without_subscript(name)) || evidence.written_out.contains(name);
  };
  for (const std::string& name : evidence.operator_letters) {
    if (!is_written_out(name) && !evidence.declared_real.contains(name)) evidence.noncommuting.insert(name);
  }
  for (const std::string& letter : evidence.operator_families) {
    const auto triple = triple_of(evidence, letter);
    const bool matrices = is_written_out(letter) || (triple && !triple->usual);
    if (!matrices) evidence.noncommuting_triples.insert(letter);
  }
  add_what_is_made_of_operators(evidence);
  // Beside operators nobody writes a current or an index on the line.
  const bool any = !evidence.noncommuting.empty() || !evidence.noncommuting_triples.empty();
  const bool triples = evidence.speaks_of_pauli || !evidence.triples.empty();
  if ((any || triples) && !evidence.no_units.contains("i")) evidence.imaginary_units.insert("i");
  if (!evidence.operators) return;
  for (const std::string& letter : evidence.hatted) {
    if (!is_usual_unit_vector(letter) && !is_written_out(letter)) evidence.noncommuting.insert(letter);
  }
}

bool is_operator(const Evidence& evidence, const std::string& base, int rank) {
  if (rank > 1) return false;
  const bool of_family = evidence.noncommuting_triples.contains(without_subscript(base));
  if (rank == 1) return evidence.noncommuting_triples.contains(base);
  if (evidence.noncommuting.contains(base)) return true;
  // L_z and L_+ beside `[L_x, L_y]`, not L_0 and L_{rot}.
  const std::size_t label = base.find("_{");
  static constexpr auto labels = std::to_array<std::string_view>({"x", "y", "z", "+", "-", "1", "2", "3"});
  return of_family && label != std::string::npos && base.size() == label + 4 &&
         is_one_of(std::string_view(base).substr(label + 2, 1), labels);
}

bool is_operator(const Evidence& evidence, const WrittenSymbol& symbol) {
  const std::string letter = letter_with_marks(symbol);
  if (symbol.face != Face::plain) return is_operator(evidence, letter, 1);
  return is_operator(evidence, with_labels(letter, symbol.lower), 0) ||
         (symbol.lower.size() == 1 && is_operator(evidence, letter, 1));
}

}  // namespace rigor
