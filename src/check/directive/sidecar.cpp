// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/directive/sidecar.h"

#include <fmt/format.h>

#include <charconv>

#include "check/directive/directive.h"

namespace rigor {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<Anchor> read_anchor(std::string_view text, Span span) {
  Anchor anchor;
  anchor.span = span;
  const auto after = [&](std::string_view word) -> std::optional<std::string_view> {
    if (!text.starts_with(word)) return std::nullopt;
    return trimmed(text.substr(word.size()));
  };
  if (text == "start") return anchor;
  if (text.size() > 2 && text.front() == '(' && text.back() == ')') {
    anchor.kind = AnchorKind::tag;
    anchor.text = std::string(text);
    return anchor;
  }
  if (const auto label = after("label ")) {
    anchor.kind = AnchorKind::label;
    anchor.text = std::string(*label);
    return label->empty() ? std::nullopt : std::optional(anchor);
  }
  if (const auto title = after("section ")) {
    anchor.kind = AnchorKind::section;
    const bool quoted = title->size() > 1 && title->front() == '"' && title->back() == '"';
    anchor.text = std::string(quoted ? title->substr(1, title->size() - 2) : *title);
    return anchor.text.empty() ? std::nullopt : std::optional(anchor);
  }
  if (const auto number = after("line ")) {
    anchor.kind = AnchorKind::line;
    const auto [end, error] = std::from_chars(number->data(), number->data() + number->size(), anchor.line);
    const bool whole = error == std::errc{} && end == number->data() + number->size() && anchor.line > 0;
    return whole ? std::optional(anchor) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<SidecarLine> read_sidecar(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  std::vector<SidecarLine> lines;
  Anchor anchor;
  for (std::uint32_t line = 1; line <= sources.line_count(file); ++line) {
    const std::uint32_t begin = sources.line_start(file, line);
    const auto size = static_cast<std::uint32_t>(sources.line_text(file, line).size());
    const Span bare = without_comment(sources, {file, begin, begin + size});
    if (bare.empty()) continue;
    const std::string_view text = sources.text(bare);
    if (!text.starts_with("at ")) {
      lines.push_back({anchor, bare});
      continue;
    }
    if (const auto found = read_anchor(trimmed(text.substr(3)), bare)) {
      anchor = *found;
      continue;
    }
    diagnostics.push_back(
        {DiagnosticKind::unknown_anchor,
         bare,
         fmt::format("`{}` names no place", text),
         {},
         {"places are `at start`, `at (6)`, `at label eq:name`, `at section \"Title\"`, `at line 57`"}});
  }
  return lines;
}

}  // namespace rigor
