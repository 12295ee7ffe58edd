// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says by the way: which quantities it differentiates, which axes it primes, whose diagonal it
// names.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "elaborate/name/letters.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// `\dot{A}` of a letter that is bold elsewhere is the rate of a length, and so of the vector.
void sight_rate(const WrittenSymbol& symbol, Names& names) {
  const WrittenName name = take_apart(symbol, Letters{}, names);
  const bool particle = name.per_particle();
  std::set<NameKey>& rates = names.symbols.sightings.write().rates;
  const bool plain = symbol.face == Face::plain;
  if (plain) rates.insert({name.base, static_cast<int>(name.axes.size()), particle});
  if (!name.axes.empty()) rates.insert({with_labels(name.base, name.axes), 0, particle});
  const bool vector =
      !plain || (name.axes.empty() && names.symbols.sightings->bold.contains({name.base, particle}));
  if (vector) rates.insert({name.base, 1, particle});
  if (!plain) rates.insert({name.base, 2, particle});
}

/// Its base, and whether it is a vector.
std::optional<std::pair<std::string, bool>> face_of(const SyntaxTree& syntax, SyntaxId operand,
                                                    const Names& names) {
  const SyntaxId id = without_derivatives(syntax, operand);
  if (syntax[id].kind != SyntaxKind::symbol) return std::nullopt;
  const WrittenSymbol& symbol = syntax.symbol(id);
  const WrittenName name = take_apart(symbol, Letters{}, names);
  const bool vector = symbol.face != Face::plain || symbol.accent == Accent::hat || !name.axes.empty();
  return std::pair(name.base, vector);
}

/// A factor of a product need not be a field.
void sight_field(const SyntaxTree& syntax, SyntaxId operand, Names& names) {
  names.symbols.sightings.write().places = true;
  if (auto face = face_of(syntax, operand, names))
    names.symbols.sightings.write().fields.insert(*std::move(face));
}

void sight_partial_rate(const SyntaxTree& syntax, SyntaxId operand, Names& names) {
  if (auto face = face_of(syntax, operand, names))
    names.symbols.sightings.write().partial_rates.insert(*std::move(face));
}

/// `D(fg)/Dt`: unless it is declared constant, each letter is carried along by the motion.
void sight_carried(const SyntaxTree& syntax, SyntaxId operand, Names& names) {
  for (const SyntaxId id : nodes_below(syntax, {operand})) {
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    sight_field(syntax, id, names);
    sight_partial_rate(syntax, id, names);
  }
}

bool is_by_time(const WrittenDerivative& derivative) {
  return std::ranges::all_of(derivative.by,
                             [](const WrittenVariable& variable) { return is_time(variable.symbol); });
}

/// What is behind it changes from place to place.
bool is_by_place(const WrittenDerivative& derivative) {
  return std::ranges::any_of(derivative.by,
                             [](const WrittenVariable& variable) { return names_a_place(variable.symbol); });
}

bool has_letters(const WrittenSymbol& symbol, std::size_t count) {
  return symbol.lower.size() == count && std::ranges::all_of(symbol.lower, [](const WrittenIndex& index) {
           return index.form == IndexForm::letter;
         });
}

/// `X_i`, alone or before `\delta_{ij}`.
const WrittenSymbol* with_one_letter(const SyntaxTree& syntax, SyntaxId side) {
  if (syntax[side].kind == SyntaxKind::symbol) return &syntax.symbol(side);
  if (syntax[side].kind != SyntaxKind::term || syntax[side].count != 2) return nullptr;
  const SyntaxId first = syntax.child(side, 0);
  const SyntaxId second = syntax.child(side, 1);
  const bool fits = syntax[first].kind == SyntaxKind::symbol && syntax[second].kind == SyntaxKind::symbol &&
                    is_kronecker(syntax.symbol(second));
  return fits ? &syntax.symbol(first) : nullptr;
}

}  // namespace

bool is_undecorated(const WrittenSymbol& symbol) {
  return symbol.face == Face::plain && symbol.accent == Accent::none && symbol.primes == 0 &&
         symbol.dots == 0 && symbol.change.empty();
}

bool is_time(const WrittenSymbol& symbol) {
  return symbol.letter == "t" && symbol.lower.empty() && is_undecorated(symbol);
}

bool is_nabla(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).letter == "\\nabla";
}

bool acts_as_operator(const SyntaxTree& syntax, SyntaxId id) {
  if (is_nabla(syntax, id)) return true;
  if (syntax[id].kind == SyntaxKind::power) return is_nabla(syntax, syntax.child(id, 0));
  if (syntax[id].kind != SyntaxKind::group) return false;
  const SyntaxId inside = syntax.child(id, 0);
  return syntax[inside].kind == SyntaxKind::term && is_nabla(syntax, syntax.children(inside).back().id);
}

void sight_changes(const SyntaxTree& syntax, SyntaxId root, Names& names) {
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    const auto children = syntax.children(id);
    switch (syntax[id].kind) {
      case SyntaxKind::symbol: {
        const WrittenSymbol& symbol = syntax.symbol(id);
        if (symbol.dots > 0) sight_rate(symbol, names);
        const auto primed = [](const WrittenIndex& index) { return index.primes > 0; };
        const bool mixed = symbol.lower.size() == 2 && primed(symbol.lower[0]) != primed(symbol.lower[1]);
        if (mixed && !is_kronecker(symbol)) names.symbols.sightings.write().mixed_axes.insert(symbol.letter);
        break;
      }
      case SyntaxKind::derivative: {
        const SyntaxId operand = without_derivatives(syntax, id);
        const bool time = is_by_time(syntax.derivative(id));
        if (time && syntax[operand].kind == SyntaxKind::symbol) sight_rate(syntax.symbol(operand), names);
        if (is_by_place(syntax.derivative(id))) sight_field(syntax, operand, names);
        if (time && syntax.derivative(id).partial) sight_partial_rate(syntax, operand, names);
        break;
      }
      case SyntaxKind::function:
        if (syntax.text(id) == "D/Dt") sight_carried(syntax, syntax.child(id, 0), names);
        if (field_operator(syntax.text(id))) sight_field(syntax, syntax.child(id, 0), names);
        break;
      case SyntaxKind::term:
        for (std::size_t k = 0; k + 1 < children.size(); ++k) {
          if (acts_as_operator(syntax, children[k].id)) sight_field(syntax, children[k + 1].id, names);
        }
        break;
      default:
        break;
    }
  }
}

void sight_diagonals(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Sightings& sightings) {
  for (const SyntaxId one : sides) {
    const WrittenSymbol* diagonal = with_one_letter(syntax, one);
    if (diagonal == nullptr || diagonal->face != Face::plain || !has_letters(*diagonal, 1)) continue;
    for (const SyntaxId other : sides) {
      if (syntax[other].kind != SyntaxKind::symbol) continue;
      const WrittenSymbol& tensor = syntax.symbol(other);
      if (tensor.letter == diagonal->letter && tensor.primes == diagonal->primes && has_letters(tensor, 2))
        sightings.diagonal.insert(diagonal->letter);
    }
  }
}

}  // namespace rigor
