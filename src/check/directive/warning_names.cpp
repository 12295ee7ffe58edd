// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/directive/warning_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.h"
#include "source/suggest.h"

namespace rigor {
namespace {

bool in_name(char c) { return is_letter(c) || c == '-' || c == '_'; }

Diagnostic no_warning(const std::string& name, Span place) {
  Diagnostic diagnostic{DiagnosticKind::bad_directive, place, fmt::format("`{}` is not a warning", name)};
  const auto table = diagnostic_table();
  const auto known = std::ranges::find(table, name, &DiagnosticInfo::name);
  if (known != table.end()) {
    diagnostic.message = fmt::format("`{}` is not a warning and cannot be silenced or asked for", name);
    return diagnostic;
  }
  std::vector<std::string> names;
  for (const DiagnosticInfo& entry : table) {
    if (entry.severity == Severity::warning) names.emplace_back(entry.name);
  }
  const auto near = suggest(name, names);
  diagnostic.help = {near ? fmt::format("did you mean `{}`?", *near)
                          : fmt::format("the warnings are {}", fmt::join(names, ", "))};
  return diagnostic;
}

}  // namespace

bool read_warning_names(const SourceMap& sources, Span rest, Directive& directive, Diagnostics& diagnostics) {
  const std::string_view text = sources.text(rest);
  std::size_t at = 0;
  bool good = true;
  while (at < text.size() && text[at] != ':') {
    if (is_blank(text[at]) || text[at] == ',') {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && in_name(text[end])) ++end;
    end = std::max(end, at + 1);
    const std::string name(text.substr(at, end - at));
    const Span place{rest.file, rest.begin + static_cast<std::uint32_t>(at),
                     rest.begin + static_cast<std::uint32_t>(end)};
    at = end;
    if (name == "here" && directive.warnings.empty() && !directive.here) {
      directive.here = true;
      continue;
    }
    const auto table = diagnostic_table();
    const auto known = std::ranges::find_if(table, [&](const DiagnosticInfo& entry) {
      return entry.name == name && entry.severity == Severity::warning;
    });
    good = good && known != table.end();
    if (known != table.end()) {
      directive.warnings.push_back(known->kind);
    } else {
      diagnostics.push_back(no_warning(name, place));
    }
  }
  if (!good || !directive.warnings.empty()) return good;
  diagnostics.push_back({DiagnosticKind::bad_directive,
                         directive.span,
                         "the directive names no warning",
                         {},
                         {"e.g. `allow bold-index: as in the book`"}});
  return false;
}

}  // namespace rigor
