// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says by the way: which quantities it differentiates, which axes it primes, whose diagonal it
// names.
#include <algorithm>
#include <functional>

#include "elaborate/letters.h"

namespace rigor {
namespace {

void for_each_symbol(const SyntaxTree& syntax, SyntaxId root,
                     const std::function<void(const WrittenSymbol&)>& visit) {
  std::vector<SyntaxId> pending{root};
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    if (syntax[id].kind == SyntaxKind::symbol) visit(syntax.symbol(id));
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
  }
}

void sight_rate(const WrittenSymbol& symbol, Names& names) {
  const WrittenName name = take_apart(symbol, Letters{}, names);
  names.sightings.rates.insert({name.base, name.per_particle()});
  names.sightings.rates.insert({with_labels(name.base, name.axes), name.per_particle()});
}

void sight_fields(const SyntaxTree& syntax, SyntaxId root, Names& names) {
  for_each_symbol(syntax, root, [&](const WrittenSymbol& symbol) {
    names.sightings.fields.insert(take_apart(symbol, Letters{}, names).base);
  });
}

/// The operand of d/dt, through the bracket around it.
SyntaxId operand_of(const SyntaxTree& syntax, SyntaxId derivative) {
  SyntaxId id = syntax.child(derivative, 0);
  while (syntax[id].kind == SyntaxKind::group || syntax[id].kind == SyntaxKind::derivative)
    id = syntax.child(id, 0);
  return id;
}

bool is_by_time(const WrittenDerivative& derivative) {
  return std::all_of(derivative.by.begin(), derivative.by.end(),
                     [](const WrittenVariable& variable) { return variable.symbol.letter == "t"; });
}

bool has_letters(const WrittenSymbol& symbol, std::size_t count) {
  return symbol.lower.size() == count &&
         std::all_of(symbol.lower.begin(), symbol.lower.end(),
                     [](const WrittenIndex& index) { return index.form == IndexForm::letter; });
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

bool is_nabla(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).letter == "\\nabla";
}

void sight_changes(const SyntaxTree& syntax, SyntaxId root, Names& names) {
  std::vector<SyntaxId> pending{root};
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    const auto children = syntax.children(id);
    for (const SyntaxChild& child : children) pending.push_back(child.id);
    switch (syntax[id].kind) {
      case SyntaxKind::symbol: {
        const WrittenSymbol& symbol = syntax.symbol(id);
        if (symbol.dots > 0) sight_rate(symbol, names);
        const auto primed = [](const WrittenIndex& index) { return index.primes > 0; };
        const bool mixed = symbol.lower.size() == 2 && primed(symbol.lower[0]) != primed(symbol.lower[1]);
        if (mixed && !is_kronecker(symbol)) names.sightings.mixed_axes.insert(symbol.letter);
        break;
      }
      case SyntaxKind::derivative: {
        const SyntaxId operand = operand_of(syntax, id);
        const bool time = is_by_time(syntax.derivative(id));
        if (time && syntax[operand].kind == SyntaxKind::symbol) sight_rate(syntax.symbol(operand), names);
        if (!time) sight_fields(syntax, operand, names);
        break;
      }
      case SyntaxKind::function:
        for (const char* name : {"grad", "div", "curl", "laplacian"}) {
          if (syntax.text(id) == name) sight_fields(syntax, syntax.child(id, 0), names);
        }
        break;
      case SyntaxKind::term:
        for (std::size_t k = 0; k + 1 < children.size(); ++k) {
          const SyntaxId factor = children[k].id;
          const bool power =
              syntax[factor].kind == SyntaxKind::power && is_nabla(syntax, syntax.child(factor, 0));
          const bool bracket = syntax[factor].kind == SyntaxKind::group &&
                               syntax[syntax.child(factor, 0)].kind == SyntaxKind::term &&
                               is_nabla(syntax, syntax.children(syntax.child(factor, 0)).back().id);
          if (power || bracket || is_nabla(syntax, factor)) sight_fields(syntax, children[k + 1].id, names);
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
