// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/declared_first.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace rigor {
namespace {

enum class Rank : std::uint8_t { kind, property, other };

Rank rank_of(const Event& event) {
  const auto* placed = std::get_if<PlacedDirective>(&event);
  if (placed == nullptr) return Rank::other;
  switch (placed->directive.kind) {
    case DirectiveKind::vector:
    case DirectiveKind::scalar:
    case DirectiveKind::complex:
    case DirectiveKind::tensor:
    case DirectiveKind::rotation:
    case DirectiveKind::particles:
      return Rank::kind;
    case DirectiveKind::constant:
    case DirectiveKind::variable:
    case DirectiveKind::for_all:
    case DirectiveKind::small:
      return Rank::property;
    default:
      return Rank::other;
  }
}

/// The axes of what follows change, and with them what is constant.
bool ends_stretch(const Event& event) {
  if (std::holds_alternative<Heading>(event)) return true;
  const auto* placed = std::get_if<PlacedDirective>(&event);
  return placed != nullptr &&
         (placed->directive.kind == DirectiveKind::frame || placed->directive.kind == DirectiveKind::basis ||
          placed->directive.kind == DirectiveKind::space);
}

/// The letter with its face and marks, and its labels.
std::string name_of(const WrittenSymbol& symbol) {
  std::string name = fmt::format("{} {} {} {} {}", symbol.letter, static_cast<int>(symbol.face),
                                 static_cast<int>(symbol.accent), symbol.primes, symbol.change);
  for (const WrittenIndex& index : symbol.lower) name += " " + index.text;
  return name;
}

/// Does it say again what a letter is? Notes its letters.
bool declares_again(const Event& event, const SyntaxTree& syntax, std::set<std::string>& declared) {
  bool again = false;
  for (const SyntaxId symbol : std::get<PlacedDirective>(event).directive.symbols)
    again = !declared.insert(name_of(syntax.symbol(symbol))).second || again;
  return again;
}

}  // namespace

std::vector<Event> with_declarations_first(std::vector<Event> events, const SyntaxTree& syntax) {
  std::vector<Event> sorted;
  sorted.reserve(events.size());
  for (auto begin = events.begin(); begin != events.end();) {
    const auto end = std::find_if(begin, events.end(), ends_stretch);
    std::vector<Event> properties;
    std::vector<Event> others;
    std::set<std::string> declared;
    bool may_move = true;
    for (auto event = begin; event != end; ++event) {
      const Rank rank = rank_of(*event);
      if (rank == Rank::kind && declares_again(*event, syntax, declared)) may_move = false;
      std::vector<Event>& into = !may_move || rank == Rank::other ? others
                                 : rank == Rank::kind             ? sorted
                                                                  : properties;
      into.push_back(std::move(*event));
    }
    std::move(properties.begin(), properties.end(), std::back_inserter(sorted));
    std::move(others.begin(), others.end(), std::back_inserter(sorted));
    begin = end;
    if (begin != events.end()) sorted.push_back(std::move(*begin++));
  }
  return sorted;
}

}  // namespace rigor
