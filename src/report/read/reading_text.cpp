// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read/reading_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/paint.h"
#include "base/utf8.h"
#include "report/read/read_words.h"
#include "report/wording/finding.h"

namespace rigor {
namespace {

constexpr std::size_t widest_head = 14;
constexpr std::size_t widest_letter = 24;  // cells; what is longer moves the columns behind it

std::string filled(const std::string& text, std::size_t width) {
  const std::size_t used = cells(text);
  return used < width ? text + std::string(width - used, ' ') : text;
}

/// Lines below one heading.
class ReadingLines {
 public:
  explicit ReadingLines(bool color) : color_(color) {}

  void add(const char* heading, const std::string& line, Paint style = Paint::plain) {
    const bool again = last_ == heading;
    last_ = heading;
    text_ += "  " + paint(filled(again ? "" : heading, widest_head), Paint::faint, color_) +
             paint(printable(line), style, color_) + "\n";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  bool color_;
  std::string last_;
  std::string text_;
};

void add_letters(ReadingLines& lines, const ReadRow& row, FileId file, const SourceMap& sources) {
  std::size_t names = 0;
  std::size_t kinds = 0;
  for (const ReadLetter& letter : row.letters) {
    names = std::max(names, std::min(widest_letter, cells(printable(letter.name))));
    kinds = std::max(kinds, kind_words(letter).size());
  }
  for (const ReadLetter& letter : row.letters) {
    const std::string source = source_words(letter, file, sources);
    std::string line = filled(printable(letter.name), names) + "  ";
    line += source.empty() ? kind_words(letter) : filled(kind_words(letter), kinds) + "  " + source;
    lines.add("letters", line);
  }
}

void add_obstacles(ReadingLines& lines, const Step& step) {
  for (const Diagnostic& each : step.diagnostics) {
    const Severity severity = each.severity();
    if (severity != Severity::error && severity != Severity::not_understood) continue;
    lines.add("not read", each.message, Paint::open);
    for (const std::string& help : each.help) lines.add("help", help);
  }
}

std::string text_of_row(const ReadRow& row, const FileReport& report, const SourceMap& sources,
                        const TerminalOptions& options) {
  const Step& step = report.steps[row.step];
  std::string head = printable(place_text(step.span, sources));
  if (!step.tag.empty()) head += " " + printable(step.tag);
  ReadingLines lines(options.color);
  lines.add("written", step.source);
  if (!row.statement.empty()) lines.add("read as", row.statement);
  lines.add("role", role_words(row), row.role == RowRole::unread ? Paint::open : Paint::plain);
  if (row.cyclic) lines.add("role", "said for its cyclic images, too");
  add_obstacles(lines, step);
  add_letters(lines, row, report.file, sources);
  for (const std::string& convention : row.conventions) lines.add("by convention", convention);
  if (row.open) lines.add("also read as", row.open->message);
  for (const std::string& words : row.restricted) lines.add("restricted", words);
  for (const Ground& ground : row.grounds) {
    const std::string name = ground.kind == Ground::Kind::said ? "said: " + ground.name : ground.name;
    lines.add("rests on", fmt::format("{}: {}", name, ground.statement));
  }
  return paint(head, Paint::strong, options.color) + "\n" + lines.text();
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
