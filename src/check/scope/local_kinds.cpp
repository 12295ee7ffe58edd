// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/local_kinds.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "check/event/written_statements.h"
#include "elaborate/name/letters.h"

namespace rigor {
namespace {

bool has_base(const std::set<NameKey>& keys, const std::string& base) {
  return std::ranges::any_of(keys, [&](const NameKey& key) { return key.base == base; });
}

bool is_bold(const Sightings& sightings, const std::string& base) {
  return sightings.bold.contains({base, false}) || sightings.bold.contains({base, true}) ||
         sightings.bold_indexed.contains(base);
}

}  // namespace

Directives sight_events(const Notes& notes, Names& names,
                        const std::function<bool(std::size_t)>& is_asked_for) {
  std::vector<std::vector<SyntaxId>> statements;
  std::vector<std::string> latin_particles;
  for (std::size_t k = 0; k < notes.events.size(); ++k) {
    if (!is_asked_for(k)) continue;
    const auto take = [&](const std::vector<ParsedChain>& chains) {
      for (const ParsedChain& chain : chains) statements.push_back(chain.sides);
    };
    if (const auto* display = std::get_if<ParsedDisplay>(&notes.events[k])) take(display->chains);
    const auto* placed = std::get_if<PlacedDirective>(&notes.events[k]);
    if (placed == nullptr || placed->directive.kind == DirectiveKind::use) continue;
    take(placed->directive.chains);
    for (const SyntaxId symbol : placed->directive.symbols) {
      if (placed->directive.kind == DirectiveKind::particles) {
        latin_particles.push_back(notes.syntax.symbol(symbol).letter);
      } else {
        statements.push_back({symbol});
      }
    }
  }
  auto& summed = names.symbols.sightings.write().summed_greek;
  for (const auto& sides : statements) {
    for (const SyntaxId side : sides) sight_sums(notes.syntax, side, names.symbols.sightings.write());
  }
  // "With $\sum_\alpha\mathbf p_\alpha = 0$": a letter that is summed over in a line is so everywhere.
  for (const SaidInLine& said : notes.prose.said) {
    for (const ParsedChain& chain : said.chains) {
      for (const SyntaxId side : chain.sides) sight_sums(notes.syntax, side, names.symbols.sightings.write());
    }
  }
  for (const auto& sides : statements)
    see_summed_members(notes.syntax, sides, names.symbols.sightings.write().members);
  const std::set<std::string> greek_only = summed;
  summed.insert(latin_particles.begin(), latin_particles.end());
  for (const auto& sides : statements) {
    for (const SyntaxId side : sides) sight_faces(notes.syntax, side, names);
  }
  for (const auto& sides : statements) sight_indices(notes.syntax, sides, names);
  for (const auto& sides : statements) {
    for (const SyntaxId side : sides) sight_changes(notes.syntax, side, names);
    sight_diagonals(notes.syntax, sides, names.symbols.sightings.write());
  }
  summed = greek_only;
  Directives used;
  for (const auto& sides : statements) {
    for (const SyntaxId id : nodes_below(notes.syntax, sides)) {
      if (notes.syntax[id].kind == SyntaxKind::symbol)
        used.merge(take_apart(notes.syntax.symbol(id), Letters{}, names).used);
    }
  }
  return used;
}

LocalKinds::LocalKinds(const Notes& notes, Names& names, std::size_t event)
    : names_(names), everywhere_(std::exchange(names.symbols.sightings, {})) {
  const std::vector<ProseBeside>& beside = notes.prose.beside;
  used_ = sight_events(notes, names, [&](std::size_t k) {
    return notes.prose.sections.reaches(beside[k].place, beside[event].place);
  });
  // What changes, and which letters label particles, is no kind.
  Sightings& here = names.symbols.sightings.write();
  here.rates = everywhere_->rates;
  here.fields = everywhere_->fields;
  here.partial_rates = everywhere_->partial_rates;
  here.places = everywhere_->places;
  here.summed_greek = everywhere_->summed_greek;
  here.members = everywhere_->members;
}

LocalKinds::~LocalKinds() { names_.symbols.sightings = std::move(everywhere_); }

std::optional<std::string> LocalKinds::borrowed_letter(const SyntaxTree& syntax,
                                                       const ParsedChain& parsed) const {
  const Sightings& here = *names_.symbols.sightings;
  std::vector<SyntaxId> pending = parsed.sides;
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const std::string base = take_apart(syntax.symbol(id), Letters{}, names_).base;
    const bool borrowed = is_bold(*everywhere_, base) != is_bold(here, base) ||
                          has_base(everywhere_->indexed, base) != has_base(here.indexed, base) ||
                          everywhere_->diagonal.contains(base) != here.diagonal.contains(base);
    if (borrowed) return base;
  }
  return std::nullopt;
}

}  // namespace rigor
