// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <algorithm>

#include "base/ascii.h"

namespace rigor {
namespace {

/// What a sine is taken of is a real number.
void see_angle(const SyntaxTree& syntax, SyntaxId argument, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, {argument})) {
    if (syntax[id].kind != SyntaxKind::symbol || syntax.symbol(id).face != Face::plain) continue;
    evidence.real.insert(letter_with_marks(syntax.symbol(id)));
    evidence.numbers.insert(letter_with_marks(syntax.symbol(id)));
  }
}

bool is_small_latin(const WrittenSymbol& symbol) {
  return symbol.letter.size() == 1 && symbol.letter[0] >= 'a' && symbol.letter[0] <= 'z' &&
         symbol.face == Face::plain && symbol.accent == Accent::none;
}

/// `z`, `\hat z`, `a_3`, `a_z`, `\mathbf k`.
bool shows_third_axis(const WrittenSymbol& symbol) {
  const bool letter = symbol.letter == "z" || (symbol.letter == "k" && symbol.face == Face::vector) ||
                      (symbol.letter == "k" && symbol.accent == Accent::hat);
  return letter || std::ranges::any_of(symbol.lower, [](const WrittenIndex& index) {
           return index.text == "3" || index.text == "z";
         });
}

const WrittenSymbol* symbol_at(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind == SyntaxKind::power) id = syntax.child(id, 0);
  return syntax[id].kind == SyntaxKind::symbol ? &syntax.symbol(id) : nullptr;
}

void see_divisor(const SyntaxTree& syntax, SyntaxId divisor, Evidence& evidence) {
  const bool product = syntax[divisor].kind == SyntaxKind::term;
  if (const WrittenSymbol* symbol = symbol_at(syntax, divisor)) {
    if (symbol->face == Face::plain) evidence.numbers.insert(letter_with_marks(*symbol));
  }
  if (!product) return;
  for (const SyntaxChild& child : syntax.children(divisor)) {
    const WrittenSymbol* symbol = symbol_at(syntax, child.id);
    if (symbol != nullptr && symbol->face == Face::plain) evidence.numbers.insert(letter_with_marks(*symbol));
  }
}

/// `m\mathbf v`: a small Latin letter next to a vector is a number; a capital may be a matrix.
void see_product(const SyntaxTree& syntax, SyntaxId term, Evidence& evidence) {
  const std::span<const SyntaxChild> factors = syntax.children(term);
  bool vector = false;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const WrittenSymbol* symbol = symbol_at(syntax, factors[k].id);
    if (k > 0 && factors[k].joint == Joint::cross) {
      for (const SyntaxId id : {factors[k - 1].id, factors[k].id}) {
        const WrittenSymbol* crossed = symbol_at(syntax, id);
        if (crossed != nullptr) evidence.crossed.insert(letter_with_marks(*crossed));
      }
    }
    if (factors[k].joint == Joint::slash) see_divisor(syntax, factors[k].id, evidence);
    vector = vector || (symbol != nullptr && symbol->face == Face::vector);
  }
  if (!vector) return;
  for (const SyntaxChild& factor : factors) {
    const WrittenSymbol* symbol = symbol_at(syntax, factor.id);
    const bool beside = factor.joint == Joint::none || factor.joint == Joint::juxtaposed;
    if (symbol != nullptr && beside && is_small_latin(*symbol))
      evidence.numbers.insert(letter_with_marks(*symbol));
  }
}

}  // namespace

bool Evidence::is_ordered(const std::string& letter) const {
  const bool capital = is_capital_letter(letter);
  return ordered.contains(letter) || (capital && speaks_of_order && !vectors.contains(letter));
}

void see_kinds(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind == SyntaxKind::fraction) see_divisor(syntax, syntax.child(id, 1), evidence);
    if (syntax[id].kind == SyntaxKind::term) see_product(syntax, id, evidence);
    if (syntax[id].kind == SyntaxKind::tuple && syntax[id].count == 3) evidence.third_axis = true;
    const bool angle = syntax[id].kind == SyntaxKind::function &&
                       (syntax.text(id) == "sin" || syntax.text(id) == "cos" || syntax.text(id) == "tan");
    if (angle) see_angle(syntax, syntax.child(id, 0), evidence);
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(id);
    evidence.letters.insert(symbol.letter);
    evidence.third_axis = evidence.third_axis || shows_third_axis(symbol);
    const bool axis = symbol.letter == "x" || symbol.letter == "y" || symbol.letter == "z";
    evidence.hatted_axes = evidence.hatted_axes || (axis && symbol.accent == Accent::hat);
    if (symbol.accent == Accent::bar) evidence.complex.insert(symbol.letter);
    if (symbol.face == Face::vector) evidence.vectors.insert(letter_with_marks(symbol));
  }
}

namespace {

/// `r\hat r` and `\hat r\,r` of a side: the plain letters that stand beside a unit vector.
std::set<std::string> letters_beside_unit_vectors(const SyntaxTree& syntax, SyntaxId side) {
  std::set<std::string> plain;
  if (syntax[side].kind != SyntaxKind::term) return plain;
  bool hatted = false;
  for (const SyntaxChild& factor : syntax.children(side)) {
    const WrittenSymbol* symbol = symbol_at(syntax, factor.id);
    if (symbol == nullptr || symbol->dots > 0) continue;
    hatted = hatted || symbol->accent == Accent::hat;
    if (symbol->face == Face::plain && symbol->accent == Accent::none)
      plain.insert(letter_with_marks(*symbol));
  }
  return hatted ? plain : std::set<std::string>{};
}

/// `\mathbf r = r\hat r`: r is its component along a unit vector.
void see_coefficients(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  for (const SyntaxId whole : sides) {
    const WrittenSymbol* vector = symbol_at(syntax, whole);
    if (vector == nullptr || vector->face != Face::vector || vector->accent == Accent::hat) continue;
    for (const SyntaxId side : sides) {
      const std::set<std::string> plain = letters_beside_unit_vectors(syntax, side);
      if (plain.contains(letter_with_marks(*vector)))
        evidence.coefficients.insert(letter_with_marks(*vector));
    }
  }
}

}  // namespace

void see_components(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  see_coefficients(syntax, sides, evidence);
  for (const SyntaxId tuple : sides) {
    if (syntax[tuple].kind != SyntaxKind::tuple) continue;
    std::set<std::string> entries;
    for (const SyntaxChild& child : syntax.children(tuple)) {
      const WrittenSymbol* entry = symbol_at(syntax, child.id);
      if (entry != nullptr && is_small_latin(*entry)) entries.insert(letter_with_marks(*entry));
    }
    // `(r, \theta, \phi)` are coordinates, and r is the length of the position.
    if (entries.size() != syntax.children(tuple).size()) continue;
    for (const SyntaxId side : sides) {
      const WrittenSymbol* whole = symbol_at(syntax, side);
      if (whole != nullptr && whole->face == Face::vector && entries.contains(letter_with_marks(*whole)))
        evidence.components.insert(entries.begin(), entries.end());
    }
  }
}

std::string letter_with_marks(const WrittenSymbol& symbol) {
  std::string base = symbol.letter;
  if (symbol.accent == Accent::hat) base = "\\hat{" + base + "}";
  if (symbol.accent == Accent::bar) base = "\\bar{" + base + "}";
  if (symbol.accent == Accent::tilde) base = "\\tilde{" + base + "}";
  if (!symbol.change.empty()) base = symbol.change + (base[0] == '\\' ? "" : " ") + base;
  return base + std::string(symbol.primes, '\'');
}

std::string with_labels(const std::string& base, const std::vector<WrittenIndex>& labels) {
  if (labels.empty()) return base;
  if (labels.front().text.starts_with('^'))
    return with_labels(base + labels.front().text, {labels.begin() + 1, labels.end()});
  std::string text = base + "_{";
  for (const WrittenIndex& label : labels) {
    text += label.form == IndexForm::word && label.text.find_first_of("\\_(") == std::string::npos
                ? "\\text{" + label.text + "}"
                : label.text;
    text += std::string(label.primes, '\'');
  }
  return text + "}";
}

}  // namespace rigor
