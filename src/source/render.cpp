// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/paint.h"
#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::size_t tab_stop = 4;
constexpr std::uint32_t least_width = 20;

/// One code point of a source line as it is printed.
struct Glyph {
  std::uint32_t offset = 0;  // of its byte, from the start of the file
  std::size_t width = 0;     // in cells
  std::string text;
};

/// A stretch of one source line.
struct Excerpt {
  std::vector<Glyph> glyphs;
  bool cut_left = false;
  bool cut_right = false;
};

Paint paint_of(Severity severity) {
  switch (severity) {
    case Severity::error:
    case Severity::refuted:
      return Paint::bad;
    case Severity::undecided:
    case Severity::not_understood:
    case Severity::warning:
    case Severity::suspect:
      return Paint::open;
  }
  return Paint::plain;
}

/// The glyphs of the bytes [begin, end) of a line that starts at `line_start`. Tabs become blanks, so that
/// the marks below are under what they mark on every terminal.
std::vector<Glyph> read_glyphs(std::string_view line, std::size_t begin, std::size_t end,
                               std::uint32_t line_start) {
  std::vector<Glyph> glyphs;
  std::size_t column = 0;
  for (std::size_t at = begin; at < end;) {
    const std::size_t first = at;
    const char32_t c = next_code_point(line.substr(0, end), at);
    Glyph glyph{line_start + static_cast<std::uint32_t>(first), cells(c), {}};
    if (c == U'\t') {
      glyph.width = tab_stop - column % tab_stop;
      glyph.text.assign(glyph.width, ' ');
    } else {
      glyph.text = printable(line.substr(first, at - first));
    }
    column += glyph.width;
    glyphs.push_back(std::move(glyph));
  }
  return glyphs;
}

/// At most `width` cells of a line around the byte `center`, each `…` included. Cost: O(width).
Excerpt excerpt_around(std::string_view line, std::uint32_t line_start, std::size_t center,
                       std::size_t width) {
  const std::size_t reach = 4 * width;  // bytes that hold `width` code points
  std::size_t begin = center > reach ? center - reach : 0;
  std::size_t end = std::min(line.size(), center + reach);
  while (begin < center && is_continuation(line[begin])) ++begin;
  while (end > center && end < line.size() && is_continuation(line[end])) --end;

  Excerpt result{read_glyphs(line, begin, end, line_start), begin > 0, end < line.size()};
  std::vector<Glyph>& glyphs = result.glyphs;
  std::size_t total = 0;
  for (const Glyph& glyph : glyphs) total += glyph.width;
  if (total <= width && !result.cut_left && !result.cut_right) return result;

  const auto after =
      std::ranges::find_if(glyphs, [&](const Glyph& glyph) { return glyph.offset >= line_start + center; });
  auto first = static_cast<std::size_t>(after - glyphs.begin());
  std::size_t last = first;
  std::size_t room = width - 2;  // a cell for each `…`
  for (bool grown = true; grown;) {
    grown = false;
    if (last < glyphs.size() && glyphs[last].width <= room) {
      room -= glyphs[last++].width;
      grown = true;
    }
    if (first > 0 && glyphs[first - 1].width <= room) {
      room -= glyphs[--first].width;
      grown = true;
    }
  }
  result.cut_left = result.cut_left || first > 0;
  result.cut_right = result.cut_right || last < glyphs.size();
  glyphs.erase(glyphs.begin() + static_cast<std::ptrdiff_t>(last), glyphs.end());
  glyphs.erase(glyphs.begin(), glyphs.begin() + static_cast<std::ptrdiff_t>(first));
  return result;
}

class Renderer {
 public:
  Renderer(const SourceMap& sources, const RenderOptions& options) : sources_(sources), options_(options) {}

  void add_head(Span span, std::string_view word, Paint style, std::string_view message) {
    const LineColumn place = sources_.line_column(span.file, span.begin);
    const std::string where =
        fmt::format("{}:{}:{}:", printable(sources_.path(span.file)), place.line, place.column);
    out_ += fmt::format("{} {} {}\n", paint(where, Paint::strong, options_.color),
                        paint(fmt::format("{}:", word), style, options_.color), message);
  }

  /// The source line of `span`, and below it `^` at its start, `~` under the rest of it and under each label.
  void add_snippet(Span span, const std::vector<Label>& labels) {
    if (sources_.text(span.file).empty()) return;
    const std::uint32_t line = sources_.line_column(span.file, span.begin).line;
    const std::uint32_t line_start = sources_.line_start(span.file, line);
    const std::string_view text = sources_.line_text(span.file, line);
    span.begin = std::min(span.begin, line_start + static_cast<std::uint32_t>(text.size()));
    const Excerpt excerpt =
        excerpt_around(text, line_start, span.begin - line_start, std::max(options_.width, least_width));
    std::string source = excerpt.cut_left ? "…" : "";
    for (const Glyph& glyph : excerpt.glyphs) source += glyph.text;
    if (excerpt.cut_right) source += "…";
    add_line(fmt::format("{:>5}", line), source, Paint::plain);
    add_line(std::string(std::max<std::size_t>(5, fmt::formatted_size("{}", line)), ' '),
             marks_below(excerpt, span, labels), Paint::mark);
  }

  void add_help(std::string_view text) {
    out_ += fmt::format("{} {}\n", paint("help:", Paint::strong, options_.color), printable(text));
  }

  [[nodiscard]] bool on_line_of(Span span, Span label) const {
    return label.file == span.file && sources_.line_column(span.file, span.begin).line ==
                                          sources_.line_column(label.file, label.begin).line;
  }

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  /// One mark a glyph, and one for the place after the last.
  static std::string marks_of(const std::vector<Glyph>& glyphs, Span span, const std::vector<Label>& labels) {
    std::string marks(glyphs.size() + 1, ' ');
    const auto underline = [&](Span part) {
      part.end = std::max(part.end, part.begin + 1);
      for (std::size_t i = 0; i < glyphs.size(); ++i)
        if (part.begin <= glyphs[i].offset && glyphs[i].offset < part.end) marks[i] = '~';
    };
    for (const Label& label : labels)
      if (label.span.file == span.file) underline(label.span);
    underline(span);
    std::size_t caret = 0;  // the last glyph that starts at or before the span, on a cell of its own
    while (caret < glyphs.size() && glyphs[caret].offset < span.begin) ++caret;
    while (caret > 0 && caret < glyphs.size() && glyphs[caret].width == 0) --caret;
    marks[caret] = '^';
    return marks;
  }

  static std::string marks_below(const Excerpt& excerpt, Span span, const std::vector<Label>& labels) {
    const std::string marks = marks_of(excerpt.glyphs, span, labels);
    std::string line = excerpt.cut_left ? " " : "";
    for (std::size_t i = 0; i < excerpt.glyphs.size(); ++i) {
      const std::size_t width = excerpt.glyphs[i].width;
      if (width == 0) continue;
      line += marks[i];
      line.append(width - 1, marks[i] == '^' ? ' ' : marks[i]);
    }
    line += marks.back();
    return line;
  }

  void add_line(std::string_view margin, std::string text, Paint style) {
    text.erase(text.find_last_not_of(' ') + 1);
    out_ += fmt::format("{} |{}{}\n", margin, text.empty() ? "" : " ", paint(text, style, options_.color));
  }

  const SourceMap& sources_;
  const RenderOptions& options_;
  std::string out_;
};

}  // namespace

std::string render(const Diagnostic& diagnostic, const SourceMap& sources, const RenderOptions& options) {
  Renderer renderer(sources, options);
  const DiagnosticInfo& kind = info(diagnostic.kind);
  renderer.add_head(diagnostic.span, name_of(kind.severity), paint_of(kind.severity),
                    fmt::format("{} [{}]", printable(diagnostic.message), kind.name));
  std::vector<Label> here;
  for (const Label& label : diagnostic.labels)
    if (renderer.on_line_of(diagnostic.span, label.span)) here.push_back(label);
  renderer.add_snippet(diagnostic.span, here);
  for (const Label& label : diagnostic.labels) {
    const bool is_here = renderer.on_line_of(diagnostic.span, label.span);
    if (is_here && label.text.empty()) continue;
    renderer.add_head(label.span, "note", Paint::strong, label.text.empty() ? "here" : printable(label.text));
    if (!is_here) renderer.add_snippet(label.span, {});
  }
  for (const std::string& text : diagnostic.help) renderer.add_help(text);
  return renderer.take();
}

}  // namespace rigor
