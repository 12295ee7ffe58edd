// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read/reading_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/paint.h"
#include "base/utf8.h"
#include "report/read/reading_lines.h"
#include "report/wording/finding.h"

namespace rigor {
namespace {

constexpr std::size_t widest_head = 14;
constexpr std::size_t widest_letter = 24;  // cells; what is longer moves the columns behind it

std::string filled(const std::string& text, std::size_t width) {
  const std::size_t used = cells(text);
  return used < width ? text + std::string(width - used, ' ') : text;
}

/// Where the kind of a letter ends, and what says so begins.
struct LetterColumns {
  std::size_t names = 0;
  std::size_t kinds = 0;
};

LetterColumns letter_columns(const std::vector<ReadingLine>& lines) {
  LetterColumns columns;
  for (const ReadingLine& line : lines) {
    if (line.part != ReadingPart::letters) continue;
    columns.names = std::max(columns.names, std::min(widest_letter, cells(printable(line.latex))));
    columns.kinds = std::max(columns.kinds, line.words.size());
  }
  return columns;
}

std::string text_of_line(const ReadingLine& line, const LetterColumns& columns) {
  if (line.part == ReadingPart::rests_on) return fmt::format("{}: {}", line.words, line.latex);
  if (line.part != ReadingPart::letters) return line.latex + line.words;
  const std::string name = filled(printable(line.latex), columns.names) + "  ";
  return name + (line.source.empty() ? line.words : filled(line.words, columns.kinds) + "  " + line.source);
}

Paint paint_of(const ReadingLine& line, const ReadRow& row) {
  const bool unread =
      line.part == ReadingPart::not_read || (line.part == ReadingPart::role && row.role == RowRole::unread);
  return unread ? Paint::open : Paint::plain;
}

std::string text_of_row(const ReadRow& row, const FileReport& report, const SourceMap& sources,
                        const TerminalOptions& options) {
  const Step& step = report.steps[row.step];
  std::string head = printable(place_text(step.span, sources));
  if (!step.tag.empty()) head += " " + printable(step.tag);
  const std::vector<ReadingLine> lines = reading_lines(row, report, sources);
  const LetterColumns columns = letter_columns(lines);
  std::string text;
  std::string_view above;
  for (const ReadingLine& line : lines) {
    const std::string_view heading = heading_of(line.part);
    const std::string shown = filled(std::string(heading == above ? "" : heading), widest_head);
    above = heading;
    text += "  " + paint(shown, Paint::faint, options.color) +
            paint(printable(text_of_line(line, columns)), paint_of(line, row), options.color) + "\n";
  }
  return paint(head, Paint::strong, options.color) + "\n" + text;
}

}  // namespace

std::string reading_text(const NotesReading& reading, const SourceMap& sources,
                         const TerminalOptions& options) {
  std::string text;
  for (const ReadRow& row : reading.rows) text += text_of_row(row, reading.report, sources, options) + "\n";
  const auto unread =
      static_cast<std::size_t>(std::ranges::count(reading.rows, RowRole::unread, &ReadRow::role));
  const std::size_t all = reading.rows.size();
  return text + fmt::format("{} row{}: {} read, {} not\n", all, all == 1 ? "" : "s", all - unread, unread);
}

}  // namespace rigor
