// SPDX-License-Identifier: GPL-3.0-or-later
// How a row was read, on the page.
#include "report/page/page_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/xml.h"
#include "latex/layout/plain_text.h"
#include "report/read/reading_lines.h"

namespace rigor {
namespace {

/// The notes were read a second time, so that only its path names the file of a step. Cases and signs can be
/// written at one place for several rows.
const ReadRow* row_of(const PageContext& page, const Step& step) {
  if (page.reading == nullptr || cyclic_image_of(step) > 0) return nullptr;
  const std::vector<Step>& steps = page.reading->report.steps;
  const auto found = std::ranges::find_if(page.reading->rows, [&](const ReadRow& row) {
    const Span span = steps[row.step].span;
    return span.begin == step.span.begin && span.end == step.span.end &&
           steps[row.step].source == step.source &&
           page.sources.path(span.file) == page.sources.path(step.span.file);
  });
  return found == page.reading->rows.end() ? nullptr : &*found;
}

std::string printed_html(const PageContext& page, const std::string& latex) {
  return to_mathml(page.math.box_of_printed(latex), MathStyle::inline_);
}

std::string reading_line_html(const PageContext& page, const ReadingLine& line) {
  switch (line.part) {
    case ReadingPart::read_as:
      return printed_html(page, line.latex);
    case ReadingPart::letters:
      return fmt::format("{} {}{}", printed_html(page, line.latex), line.words,
                         line.source.empty() ? "" : " <i>" + message_html(line.source) + "</i>");
    case ReadingPart::rests_on:  // up to eight of a kind: as MathML they would be most of a long page
      return use_html(page, line.words) + ": " +
             xml_escaped(to_plain_text(page.math.box_of_printed(line.latex)));
    default:
      return message_html(line.words);
  }
}

}  // namespace

std::string reading_html(const PageContext& page, const Step& step) {
  const ReadRow* row = row_of(page, step);
  if (row == nullptr) return {};
  std::string terms;
  std::vector<ReadingLine> lines = reading_lines(*row, page.reading->report, page.sources);
  std::erase_if(lines, [](const ReadingLine& line) {
    return line.part == ReadingPart::written || line.part == ReadingPart::not_read ||
           line.part == ReadingPart::help;
  });
  for (auto line = lines.begin(); line != lines.end();) {
    const ReadingPart part = line->part;
    std::string what;
    for (; line != lines.end() && line->part == part; ++line)
      what += "<p>" + reading_line_html(page, *line) + "</p>";
    terms += term_html(heading_of(part), what);
  }
  return fmt::format("<details class=\"reading\"><summary>How it was read</summary><dl>\n{}</dl></details>",
                     terms);
}

}  // namespace rigor
