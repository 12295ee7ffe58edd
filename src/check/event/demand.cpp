// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/demand.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "check/event/written_statements.h"
#include "elaborate/name/letters.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

const std::vector<ParsedChain>* chains_of(const Event& event) {
  if (const auto* display = std::get_if<ParsedDisplay>(&event)) return &display->chains;
  if (const auto* placed = std::get_if<PlacedDirective>(&event)) return &placed->directive.chains;
  return nullptr;
}

/// Without the brackets around it.
std::string bare_tag(std::string tag) {
  if (tag.size() >= 2 && tag.front() == '(' && tag.back() == ')') return tag.substr(1, tag.size() - 2);
  return tag;
}

bool names_something(const WrittenSymbol& symbol) {
  return !is_kronecker(symbol) && !is_levi_civita(symbol) && !is_basis_family(symbol);
}

}  // namespace

std::set<std::string> bases_below(const SyntaxTree& syntax, SyntaxId root, const Names& names) {
  std::set<std::string> bases;
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind != SyntaxKind::symbol || !names_something(syntax.symbol(id))) continue;
    bases.insert(take_apart(syntax.symbol(id), Letters{}, names).base);
  }
  return bases;
}

std::set<std::string> bases_in(const Notes& notes, const Names& names) {
  std::set<std::string> bases;
  const auto take = [&](SyntaxId root) { bases.merge(bases_below(notes.syntax, root, names)); };
  for (const Event& event : notes.events) {
    if (const auto* placed = std::get_if<PlacedDirective>(&event))
      std::ranges::for_each(placed->directive.symbols, take);
    if (const auto* chains = chains_of(event)) {
      for (const ParsedChain& chain : *chains) std::ranges::for_each(chain.sides, take);
    }
  }
  return bases;
}

std::optional<NamedPlace> place_named(const Notes& notes, const std::string& name) {
  for (std::size_t k = 0; k < notes.events.size(); ++k) {
    if (const auto* heading = std::get_if<Heading>(&notes.events[k]); heading && heading->title == name) {
      std::size_t behind = k + 1;
      for (; behind < notes.events.size(); ++behind) {
        const auto* next = std::get_if<Heading>(&notes.events[behind]);
        if (next != nullptr && next->level <= heading->level) break;
      }
      return NamedPlace{k + 1, behind, ""};
    }
    const auto* display = std::get_if<ParsedDisplay>(&notes.events[k]);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      const std::string& tag = chain.written.tag;
      if (!tag.empty() && bare_tag(tag) == bare_tag(name)) return NamedPlace{k, k + 1, tag};
    }
  }
  return std::nullopt;
}

std::vector<std::string> place_names(const Notes& notes) {
  std::vector<std::string> known;
  for (const Event& event : notes.events) {
    if (const auto* heading = std::get_if<Heading>(&event)) known.push_back(heading->title);
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      if (!chain.written.tag.empty()) known.push_back(chain.written.tag);
    }
  }
  return known;
}

namespace {

/// The letters of some sides, and those of them whose derivatives are written.
struct Mentioned {
  std::set<std::string> bases;
  std::set<std::string> rates;

  void take(const Mentioned& other) {
    bases.insert(other.bases.begin(), other.bases.end());
    rates.insert(other.rates.begin(), other.rates.end());
  }
};

Mentioned mentioned_in(const SyntaxTree& syntax, SyntaxId root, const Names& names) {
  Mentioned mentioned{bases_below(syntax, root, names), {}};
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind == SyntaxKind::derivative) mentioned.rates.merge(bases_below(syntax, id, names));
    if (syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).dots > 0)
      mentioned.rates.merge(bases_below(syntax, id, names));
  }
  return mentioned;
}

/// What a chain may say: what a letter is, or how it changes.
struct DemandedMeaning {
  std::string base;
  bool rate = false;
};

/// `I_{ij} =`, `(\Omega_1)^2 =`, `\dot\omega_1 =`; a component of a vector or tensor defines nothing.
std::optional<DemandedMeaning> meaning_of(const SyntaxTree& syntax, SyntaxId side, const Names& names) {
  DemandedMeaning meaning;
  for (;; side = syntax.child(side, 0)) {
    const SyntaxKind kind = syntax[side].kind;
    if (kind == SyntaxKind::symbol) break;
    if (kind == SyntaxKind::derivative) meaning.rate = true;
    const bool peels = kind == SyntaxKind::derivative || kind == SyntaxKind::group ||
                       kind == SyntaxKind::power || kind == SyntaxKind::component;
    if (!peels || syntax.children(side).empty()) return std::nullopt;
  }
  const WrittenSymbol& symbol = syntax.symbol(side);
  if (!names_something(symbol)) return std::nullopt;
  const WrittenName name = take_apart(symbol, Letters{}, names);
  meaning.base = name.base;
  meaning.rate = meaning.rate || symbol.dots > 0;
  const bool component =
      std::ranges::any_of(name.axes,
                          [](const WrittenIndex& axis) { return axis.form == IndexForm::digit; }) &&
      (name.axes.size() > 1 || names.symbols.sightings->bold.contains({name.base, name.per_particle()}));
  if (component && !meaning.rate) return std::nullopt;
  return meaning;
}

/// Displays and `let` define; of `given`, only rules for derivatives do; of `where`, `X := …`.
bool may_define(const Event& event, const ParsedChain& chain, const DemandedMeaning& meaning) {
  if (chain.written.relations.empty()) return false;
  const RelationKind relation = chain.written.relations[0].kind;
  if (is_order(relation) || relation == RelationKind::nearly) return false;
  const auto* placed = std::get_if<PlacedDirective>(&event);
  if (placed == nullptr) return true;
  switch (placed->directive.kind) {
    case DirectiveKind::let:
      return true;
    case DirectiveKind::given:
      return meaning.rate;
    case DirectiveKind::where:
      return relation == RelationKind::defines;
    default:
      return false;
  }
}

}  // namespace

std::set<const ParsedChain*> chains_needed(const Notes& notes, const Names& names,
                                           const std::vector<SyntaxId>& asked,
                                           const std::vector<NamedPlace>& wanted) {
  struct Candidate {
    const ParsedChain* chain;
    DemandedMeaning meaning;
    Mentioned mentioned;
  };
  std::vector<Candidate> candidates;
  std::set<const ParsedChain*> needed;
  Mentioned reached;
  for (const SyntaxId id : asked) reached.take(mentioned_in(notes.syntax, id, names));
  for (std::size_t k = 0; k < notes.events.size(); ++k) {
    const auto* chains = chains_of(notes.events[k]);
    if (chains == nullptr) continue;
    for (const ParsedChain& chain : *chains) {
      Mentioned mentioned;
      for (const SyntaxId side : chain.sides) mentioned.take(mentioned_in(notes.syntax, side, names));
      const bool is_wanted = std::ranges::any_of(wanted, [&](const NamedPlace& place) {
        return k >= place.first && k < place.behind && (place.tag.empty() || place.tag == chain.written.tag);
      });
      if (is_wanted) {
        needed.insert(&chain);
        reached.take(mentioned);
      }
      auto meaning = chain.sides.empty() ? std::nullopt : meaning_of(notes.syntax, chain.sides[0], names);
      if (meaning && may_define(notes.events[k], chain, *meaning))
        candidates.push_back({&chain, std::move(*meaning), std::move(mentioned)});
    }
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const Candidate& candidate : candidates) {
      const auto& [base, rate] = candidate.meaning;
      if (!(rate ? reached.rates : reached.bases).contains(base)) continue;
      const std::size_t before = reached.bases.size() + reached.rates.size();
      reached.take(candidate.mentioned);
      // the derivative of what is defined is that of its definition
      if (reached.rates.contains(base))
        reached.rates.insert(candidate.mentioned.bases.begin(), candidate.mentioned.bases.end());
      const bool more = reached.bases.size() + reached.rates.size() > before;
      grew = needed.insert(candidate.chain).second || more || grew;
    }
  }
  return needed;
}

}  // namespace rigor
