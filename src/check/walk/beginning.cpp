// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "check/scope/local_kinds.h"
#include "check/scope/section_evidence.h"
#include "check/walk/walk.h"

namespace rigor {
namespace {

/// Without a directive, one symbol with mixed indices (`\lambda_{i'j}`) gives the primed axes.
void imply_primed_axes(const Notes& notes, ExprTree& tree, Names& names) {
  if (names.symbols.sightings->mixed_axes.size() != 1) return;
  const std::string& letter = *names.symbols.sightings->mixed_axes.begin();
  const bool told = std::ranges::any_of(notes.events, [&](const Event& event) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    if (placed == nullptr || placed->directive.kind == DirectiveKind::basis) return placed != nullptr;
    return placed->directive.kind == DirectiveKind::rotation &&
           std::ranges::any_of(placed->directive.symbols,
                               [&](SyntaxId id) { return notes.syntax.symbol(id).letter == letter; });
  });
  if (told) return;
  const SymbolId symbol = resolve(names.symbols, tree, {letter, 2, false}, letter, {});
  tree.symbols.write(symbol).rotation = true;
  tree.symbols.write(symbol).declared = true;
  names.symbols.primed_axes = symbol;
}

}  // namespace

/// How symbols are written anywhere in the file decides what their letters mean everywhere.
Names names_at_beginning(const SourceMap& sources, const Notes& notes, ExprTree& tree) {
  Names names;
  static_cast<void>(sight_events(notes, names, [](std::size_t) { return true; }));  // none is in force yet
  imply_primed_axes(notes, tree, names);
  names.symbols.evidence = Shared(evidence_of_section(sources, notes, std::nullopt));
  return names;
}

}  // namespace rigor
