// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/sidecar_places.h"

#include <iterator>
#include <map>
#include <utility>

namespace rigor {
namespace {

struct Said {
  Span directive;
  Span place;
};

/// By where the directives begin.
using Places = std::map<std::pair<FileId, std::uint32_t>, Said>;

Places places_in(const Notes& notes) {
  Places places;
  for (const Event& event : notes.events) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    if (placed == nullptr || placed->directive.chains.empty() || placed->place.empty()) continue;
    const Span own = placed->directive.span;
    if (own.file != placed->place.file) places[{own.file, own.begin}] = {own, placed->place};
  }
  return places;
}

}  // namespace

void label_places(const Notes& notes, FileReport& report) {
  const Places places = places_in(notes);
  const auto label = [&](Diagnostics& diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
      const auto behind = places.upper_bound({diagnostic.span.file, diagnostic.span.begin});
      if (behind == places.begin()) continue;
      const Said& said = std::prev(behind)->second;
      const bool inside =
          said.directive.file == diagnostic.span.file && diagnostic.span.begin < said.directive.end;
      const Span begin{said.place.file, said.place.begin, said.place.begin + 1};
      if (inside) diagnostic.labels.push_back({begin, "said of this place"});
    }
  };
  if (places.empty()) return;
  for (Step& step : report.steps) label(step.diagnostics);
  label(report.diagnostics);
  label(report.silenced);
}

}  // namespace rigor
