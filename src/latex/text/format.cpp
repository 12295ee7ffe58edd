// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/format.h"

#include <algorithm>
#include <array>

namespace rigor {
namespace {

/// A line of these is in LaTeX only. Those that Markdown reads as well (`\begin{align}`, `\newcommand`) say
/// nothing.
bool is_latex_line(std::string_view line) {
  static constexpr auto openings = std::to_array<std::string_view>(
      {"%", "\\documentclass", "\\usepackage", "\\begin{document}", "\\part{", "\\chapter{", "\\section{",
       "\\section*{", "\\subsection{", "\\subsection*{", "\\paragraph{", "\\input{", "\\maketitle"});
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return false;
  line.remove_prefix(first);
  return std::ranges::any_of(openings, [&](std::string_view opening) { return line.starts_with(opening); });
}

/// Looks at the first lines only, since each display asks.
Format format_of_text(std::string_view text) {
  text = text.substr(0, std::size_t{64} << 10);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (is_latex_line(text.substr(0, end))) return Format::latex;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return Format::markdown;
}

}  // namespace

Format format_of(std::string_view path) {
  static constexpr auto endings = std::to_array<std::string_view>({".tex", ".ltx", ".latex", ".sty", ".cls"});
  const bool latex =
      std::ranges::any_of(endings, [&](std::string_view ending) { return path.ends_with(ending); });
  return latex ? Format::latex : Format::markdown;
}

Format format_of(const SourceMap& sources, FileId file) {
  const std::string& path = sources.path(file);
  return path == standard_input ? format_of_text(sources.text(file)) : format_of(path);
}

}  // namespace rigor
