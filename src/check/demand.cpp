// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/demand.h"

#include <algorithm>
#include <optional>

#include "check/lint_walk.h"
#include "elaborate/letters.h"

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

std::set<std::string> bases_below(const SyntaxTree& syntax, SyntaxId root, Names& names) {
  std::set<std::string> bases;
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind != SyntaxKind::symbol || !names_something(syntax.symbol(id))) continue;
    bases.insert(take_apart(syntax.symbol(id), Letters{}, names).base);
  }
  return bases;
}

std::set<std::string> bases_in(const Notes& notes, Names& names) {
  std::set<std::string> bases;
  const auto take = [&](SyntaxId root) { bases.merge(bases_below(notes.syntax, root, names)); };
  for (const Event& event : notes.events) {
    if (const auto* placed = std::get_if<PlacedDirective>(&event))
      std::for_each(placed->directive.symbols.begin(), placed->directive.symbols.end(), take);
    if (const auto* chains = chains_of(event)) {
      for (const ParsedChain& chain : *chains) std::for_each(chain.sides.begin(), chain.sides.end(), take);
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

std::set<const ParsedChain*> chains_needed(const Notes& notes, Names& names,
                                           const std::vector<SyntaxId>& asked,
                                           const std::vector<NamedPlace>& wanted) {
  struct Candidate {
    const ParsedChain* chain;
    std::set<std::string> defined;  // the one letter of its first side, if there is one
    std::set<std::string> all;
  };
  std::vector<Candidate> candidates;
  std::set<const ParsedChain*> needed;
  std::set<std::string> bases;
  for (const SyntaxId id : asked) bases.merge(bases_below(notes.syntax, id, names));
  for (std::size_t k = 0; k < notes.events.size(); ++k) {
    const auto* chains = chains_of(notes.events[k]);
    if (chains == nullptr) continue;
    for (const ParsedChain& chain : *chains) {
      Candidate candidate{&chain, {}, {}};
      for (const SyntaxId side : chain.sides) candidate.all.merge(bases_below(notes.syntax, side, names));
      if (!chain.sides.empty()) candidate.defined = bases_below(notes.syntax, chain.sides[0], names);
      const bool is_wanted = std::any_of(wanted.begin(), wanted.end(), [&](const NamedPlace& place) {
        return k >= place.first && k < place.behind && (place.tag.empty() || place.tag == chain.written.tag);
      });
      if (is_wanted) {
        needed.insert(&chain);
        bases.insert(candidate.all.begin(), candidate.all.end());
      }
      candidates.push_back(std::move(candidate));
    }
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const Candidate& candidate : candidates) {
      if (candidate.defined.size() != 1 || !bases.contains(*candidate.defined.begin())) continue;
      if (!needed.insert(candidate.chain).second) continue;
      bases.insert(candidate.all.begin(), candidate.all.end());
      grew = true;
    }
  }
  return needed;
}

}  // namespace rigor
