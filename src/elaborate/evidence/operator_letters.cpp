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
#include "expr/tree/state.h"

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

/// What side by side kets, bras and letters make, as far as the signs show.
enum class WrittenShape : std::uint8_t { other, ket, bra, operators };

bool is_state(const SyntaxTree& syntax, SyntaxId id, const char* kind) {
  return syntax[id].kind == SyntaxKind::function && syntax.text(id) == kind;
}

/// Recursion: as deep as the tree.
WrittenShape shape_of_states(const SyntaxTree& syntax, SyntaxId id) {
  using enum WrittenShape;
  const SyntaxNode& node = syntax[id];
  if (is_state(syntax, id, "ket")) return ket;
  if (is_state(syntax, id, "bra")) return bra;
  if (node.kind == SyntaxKind::group || node.kind == SyntaxKind::big_sum || node.kind == SyntaxKind::sum ||
      node.kind == SyntaxKind::fraction)
    return shape_of_states(syntax, syntax.child(id, 0));
  if (node.kind != SyntaxKind::term) return other;
  WrittenShape shape = other;
  for (const SyntaxChild& child : syntax.children(id)) {
    const WrittenShape next = shape_of_states(syntax, child.id);
    if (next == other) continue;
    if (shape == ket && next == bra) {
      shape = operators;
    } else if (shape == bra && next == ket) {
      shape = other;
    } else if (next == ket || next == bra) {
      shape = next;
    } else if (shape == other) {
      shape = next;
    }
  }
  return shape;
}

/// Numbers before a ket: energies, and what is usually none but real.
bool is_usual_real_before_states(const WrittenSymbol& symbol) {
  static constexpr auto reals = std::to_array<std::string_view>(
      {"E",       "m",       "M",       "n",        "N",          "k",     "l",       "j",       "t", "T",
       "\\hbar",  "\\omega", "\\Omega", "\\theta",  "\\epsilon",  "\\pi",  "\\mu",    "\\nu",    "g", "B",
       "\\Delta", "\\delta", "\\tau",   "\\varphi", "\\phi",      "i",     "e",       "x",       "r", "p",
       "J",       "s",       "L",       "\\lambda", "\\vartheta", "\\Phi", "\\kappa", "\\Lambda"});
  return is_one_of(symbol.letter, reals);
}

/// H of `H|n\rangle`: what is written so is an operator wherever it stands. Other capitals can be amplitudes.
bool acts_everywhere(const WrittenSymbol& symbol) {
  static constexpr auto acting = std::to_array<std::string_view>(
      {"H", "U", "V", "P", "L", "J", "S", "X", "Y", "Z", "Q", "K", "W", "O", "\\sigma", "\\rho"});
  return symbol.accent == Accent::hat || is_one_of(symbol.letter, acting);
}

bool is_never_operator(const WrittenSymbol& symbol) {
  static constexpr auto numbers = std::to_array<std::string_view>(
      {"E",     "\\lambda", "\\alpha", "\\beta", "\\gamma", "\\epsilon", "\\omega", "n",
       "m",     "k",        "l",       "j",      "t",       "\\theta",   "\\phi",   "\\varphi",
       "\\psi", "c",        "e",       "\\mu",   "\\nu",    "\\Delta",   "\\delta"});
  return symbol.accent != Accent::hat && (is_one_of(symbol.letter, numbers) || is_constant_of_nature(symbol));
}

/// The letter of `a`, `a^\dagger`, `\hat p^2`; nothing of all else.
const WrittenSymbol* letter_of_factor(const SyntaxTree& syntax, SyntaxId id) {
  while (syntax[id].kind == SyntaxKind::power || is_adjoint(syntax, id) ||
         (syntax[id].kind == SyntaxKind::group && syntax[id].count == 1))
    id = syntax.child(id, 0);
  return syntax[id].kind == SyntaxKind::symbol ? &syntax.symbol(id) : nullptr;
}

/// L of `L^2|l, m\rangle` is the square of L_z and its like, where these are about.
void add_letter_beside_states(const WrittenSymbol& symbol, Evidence& evidence) {
  if (symbol.face != Face::plain) return add_letter(symbol, evidence);
  const std::string letter = letter_with_marks(symbol);
  evidence.state_operators.insert(with_labels(letter, symbol.lower));
  static constexpr auto axes = std::to_array<std::string_view>({"x", "y", "z"});
  if (symbol.lower.size() == 1 && is_one_of(symbol.lower[0].text, axes))
    evidence.operator_families.insert(letter);
}

/// The letters between a bra and a ket, where brackets may be around a sum.
void add_letters_between(const SyntaxTree& syntax, SyntaxId id, bool alone, Evidence& evidence) {
  const SyntaxNode& node = syntax[id];
  if (const WrittenSymbol* letter = letter_of_factor(syntax, id)) {
    const bool many =
        may_be_of_many(*letter) || acts_everywhere(*letter) ||
        is_one_of(letter->letter, std::array<std::string_view, 6>{"a", "b", "x", "p", "q", "r"});
    if (!is_never_operator(*letter) && (alone || many)) add_letter_beside_states(*letter, evidence);
    return;
  }
  if (node.kind != SyntaxKind::group && node.kind != SyntaxKind::sum && node.kind != SyntaxKind::term &&
      node.kind != SyntaxKind::fraction)
    return;
  const bool only = node.kind != SyntaxKind::term && node.kind != SyntaxKind::fraction;
  for (const SyntaxChild& child : syntax.children(id)) {
    if (node.kind == SyntaxKind::fraction && child.id != syntax.child(id, 0)) continue;
    add_letters_between(syntax, child.id, alone && only, evidence);
  }
}

/// c_n of `c_n|n\rangle`: a complex number.
void add_amplitude(const SyntaxTree& syntax, SyntaxId id, Evidence& evidence) {
  if (syntax[id].kind == SyntaxKind::fraction || syntax[id].kind == SyntaxKind::group ||
      syntax[id].kind == SyntaxKind::sum || syntax[id].kind == SyntaxKind::term) {
    for (const SyntaxChild& child : syntax.children(id)) add_amplitude(syntax, child.id, evidence);
    return;
  }
  if (syntax[id].kind == SyntaxKind::function && syntax.text(id) == "conjugate") id = syntax.child(id, 0);
  if (syntax[id].kind != SyntaxKind::symbol) return;
  const WrittenSymbol& symbol = syntax.symbol(id);
  if (symbol.face != Face::plain || symbol.accent == Accent::hat || is_usual_real_before_states(symbol))
    return;
  evidence.complex_numbers.insert(complex_name(symbol));
}

/// Operators and amplitudes of one product. `leads`: it is a whole side, the first of its row.
void see_product_of_states(const SyntaxTree& syntax, SyntaxId term, bool leads, Evidence& evidence) {
  const auto factors = syntax.children(term);
  std::vector<WrittenShape> shapes;
  for (const SyntaxChild& child : factors) shapes.push_back(shape_of_states(syntax, child.id));
  const auto is_kind = [&](std::size_t k, WrittenShape shape) {
    return k < shapes.size() && shapes[k] == shape;
  };
  for (std::size_t k = 0; k < factors.size(); ++k) {
    if (!is_kind(k, WrittenShape::bra)) continue;
    std::size_t end = k + 1;
    while (end < factors.size() && shapes[end] == WrittenShape::other) ++end;
    if (!is_kind(end, WrittenShape::ket)) continue;
    for (std::size_t each = k + 1; each < end; ++each)
      add_letters_between(syntax, factors[each].id, end == k + 2, evidence);
  }
  const bool whole_ket = shape_of_states(syntax, term) == WrittenShape::ket;
  const bool whole_bra = shape_of_states(syntax, term) == WrittenShape::bra;
  if (!whole_ket && !whole_bra) return;
  bool any_operator = false;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    if (shapes[k] != WrittenShape::other) continue;
    const WrittenSymbol* letter = letter_of_factor(syntax, factors[k].id);
    if (letter == nullptr) {
      if (!any_operator) add_amplitude(syntax, factors[k].id, evidence);
      continue;
    }
    const bool beside = whole_ket ? true : k > 0;
    const bool first = leads && k == 0 && whole_ket && !is_never_operator(*letter);
    const bool adjoint = is_adjoint(syntax, factors[k].id);
    if (beside && (first || adjoint || any_operator || acts_everywhere(*letter)) &&
        !is_never_operator(*letter)) {
      add_letter_beside_states(*letter, evidence);
      any_operator = true;
    } else {
      add_amplitude(syntax, factors[k].id, evidence);
    }
  }
}

/// What kets and bras show: letters that act on them, amplitudes, and letters that number them. Are there
/// some that make no operator?
bool see_states(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  bool any = false;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (!is_state(syntax, id, "ket") && !is_state(syntax, id, "bra")) continue;
    any = true;
    for (const LabelPart& part : label_of(syntax.text(syntax.child(id, 0)))) {
      if (numbers_states(part)) evidence.state_labels.insert(part.letter);
    }
  }
  if (!any) return false;
  evidence.states = true;
  evidence.operators = true;
  evidence.speaks_of_operators = true;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::term) see_product_of_states(syntax, id, id == sides[0], evidence);
  }
  const bool makes_operator = std::ranges::any_of(
      sides, [&](SyntaxId side) { return shape_of_states(syntax, side) == WrittenShape::operators; });
  if (!makes_operator) return true;
  for (const SyntaxId side : sides) {
    const WrittenSymbol* letter = letter_of_factor(syntax, side);
    if (letter != nullptr && !is_constant_of_nature(*letter)) add_letter_beside_states(*letter, evidence);
  }
  return false;
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
  const bool of_numbers = see_states(syntax, sides, evidence);
  for (const SyntaxId side : sides) {
    if (of_numbers || syntax[side].kind != SyntaxKind::symbol || is_constant_of_nature(syntax.symbol(side)))
      continue;
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
  for (const std::string& name : evidence.state_operators) {
    if (!is_written_out(name) && !evidence.declared_real.contains(name) &&
        !evidence.noncommuting_triples.contains(name))
      evidence.noncommuting.insert(name);
  }
  add_what_is_made_of_operators(evidence);
  // Beside operators nobody writes a current or an index on the line.
  const bool any = !evidence.noncommuting.empty() || !evidence.noncommuting_triples.empty();
  const bool triples = evidence.speaks_of_pauli || !evidence.triples.empty();
  if ((any || triples || evidence.states) && !evidence.no_units.contains("i"))
    evidence.imaginary_units.insert("i");
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
