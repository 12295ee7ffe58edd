// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/diagnostics_of.h"

#include <algorithm>
#include <tuple>

namespace rigor {

std::vector<PlacedDiagnostic> diagnostics_of(const FileReport& file) {
  std::vector<PlacedDiagnostic> all;
  for (const Step& step : file.steps)
    for (const Diagnostic& diagnostic : step.diagnostics) all.push_back({&diagnostic, &step});
  for (const Diagnostic& diagnostic : file.diagnostics) all.push_back({&diagnostic, nullptr});
  const auto place = [](const PlacedDiagnostic& placed) {
    const Span& span = placed.diagnostic->span;
    return std::tuple(span.file, span.begin);
  };
  std::ranges::stable_sort(
      all, [&](const PlacedDiagnostic& a, const PlacedDiagnostic& b) { return place(a) < place(b); });
  // An obstacle of several steps is reported once.
  const auto same = [](const PlacedDiagnostic& a, const PlacedDiagnostic& b) {
    return a.diagnostic->kind == b.diagnostic->kind && a.diagnostic->span == b.diagnostic->span &&
           a.diagnostic->message == b.diagnostic->message;
  };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace rigor
