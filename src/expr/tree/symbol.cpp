// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/symbol.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/check.h"
#include "expr/tree/path.h"

namespace rigor {
namespace {

/// `\dot{x}`, `\partial\partial \mathbf{A}`: as a reader would write it, but for the indices.
std::string name_of_derivative(const SymbolTable& symbols, const Derivation& derivation) {
  std::string name = symbols[derivation.base].name;
  if (const auto dots = derivation.by.count(By::time); dots > 0) {
    const auto tail = std::min(name.find('_'), name.find('\''));  // `\dot{T}_{\text{rot}}`
    const std::string rest = tail == std::string::npos ? "" : name.substr(tail);
    name = "\\" + std::string(dots, 'd') + "ot{" + name.substr(0, tail) + "}" + rest;
  }
  for (const Variable& each : derivation.by) {
    if (is_along_path(symbols, each)) {
      name.insert(0, "d");
    } else if (each.by == By::letter) {
      name.insert(0, "\\partial_{" + symbols[each.letter].name + "} ");
      if (each.held) name = "(" + name + ")_{" + symbols[*each.held].name + "}";
    }
    if (each.by == By::space) name.insert(0, "\\partial ");
    if (each.by == By::small) name.insert(0, "\\delta ");
  }
  return name;
}

}  // namespace

SymbolId SymbolTable::add(Symbol symbol) {
  RIGOR_CHECK(symbol.rank >= 0, symbol.name, symbol.rank);
  RIGOR_CHECK(!symbol.symmetric || symbol.rank == 2 || symbol.derivation, symbol.name, symbol.rank);
  RIGOR_CHECK(!symbol.unit || symbol.rank == 1, symbol.name, symbol.rank);
  RIGOR_CHECK(!symbol.rotation || symbol.rank == 2, symbol.name, symbol.rank);
  // Their generic points are written in three dimensions.
  RIGOR_CHECK(!(symbol.unit || symbol.rotation) || symbol.axes.are_common(), symbol.name);
  symbols_.push_back(std::move(symbol));
  derivatives_.push_back({});
  return static_cast<SymbolId>(symbols_.size() - 1);
}

SymbolId SymbolTable::derivative(SymbolId of, const Variable& by) {
  Derivation derivation = (*this)[of].derivation.value_or(Derivation{.base = of});
  derivation.by.insert(by);
  return derivative(derivation);
}

SymbolId SymbolTable::derivative(const Derivation& derivation) {
  if (derivation.by.empty()) return derivation.base;
  if (const auto known = find(derivation)) return *known;
  const Symbol& base = (*this)[derivation.base];
  RIGOR_CHECK(derivation.by.size() <= largest_derivation, base.name, derivation.by.size());
  Symbol symbol;
  symbol.name = name_of_derivative(*this, derivation);
  symbol.derivation = derivation;
  symbol.rank = base.rank + symbol.order(By::space);
  symbol.axes = base.axes;
  symbol.per_particle = base.per_particle;
  symbol.symmetric = base.symmetric;
  symbol.complex = base.complex || std::ranges::any_of(derivation.by, [this](const Variable& each) {
                     return each.by == By::letter && (*this)[each.letter].complex;
                   });
  symbol.noncommuting = base.noncommuting;
  symbol.unsized = base.unsized;
  symbol.ket = base.ket;
  symbol.declared = base.declared;
  symbol.first_seen = base.first_seen;
  const SymbolId id = add(std::move(symbol));
  derivatives_.write(static_cast<std::size_t>(derivation.base)).push_back(id);
  return id;
}

std::optional<SymbolId> SymbolTable::find(const Derivation& derivation) const {
  const std::vector<SymbolId>& known = derivatives_[static_cast<std::size_t>(derivation.base)];
  const auto found =
      std::ranges::find_if(known, [&](SymbolId each) { return (*this)[each].derivation == derivation; });
  return found == known.end() ? std::nullopt : std::optional(*found);
}

bool SymbolTable::has_derivatives(SymbolId base) const {
  return !derivatives_[static_cast<std::size_t>(base)].empty();
}

std::size_t canonical_component(const Symbol& symbol, std::size_t component) {
  if (!symbol.symmetric && symbol.order() < 2) return component;
  const auto exchangeable = static_cast<std::size_t>(symbol.order(By::space));
  if (exchangeable < 2 && !symbol.symmetric) return component;
  std::vector<std::size_t> axes(static_cast<std::size_t>(symbol.rank));
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
    const std::size_t dimension = symbol.axes[static_cast<int>(axes.rend() - axis) - 1].dimension;
    *axis = component % dimension;
    component /= dimension;
  }
  if (symbol.symmetric) std::sort(axes.begin(), axes.begin() + 2);
  std::sort(axes.end() - static_cast<std::ptrdiff_t>(exchangeable), axes.end());
  for (std::size_t k = 0; k < axes.size(); ++k)
    component = symbol.axes[static_cast<int>(k)].dimension * component + axes[k];
  return component;
}

}  // namespace rigor
