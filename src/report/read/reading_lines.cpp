// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read/reading_lines.h"

#include <array>

#include "report/read/read_words.h"

namespace rigor {

std::string_view heading_of(ReadingPart part) {
  static constexpr std::array<std::string_view, 10> headings{
      "written", "read as",       "role",         "not read",   "help",
      "letters", "by convention", "also read as", "restricted", "rests on"};
  return headings.at(static_cast<std::size_t>(part));
}

std::vector<ReadingLine> reading_lines(const ReadRow& row, const FileReport& report,
                                       const SourceMap& sources) {
  using enum ReadingPart;
  const Step& step = report.steps[row.step];
  std::vector<ReadingLine> lines{{.part = written, .latex = step.source}};
  if (!row.statement.empty()) lines.push_back({.part = read_as, .latex = row.statement});
  lines.push_back({.part = role, .words = role_words(row)});
  if (row.cyclic) lines.push_back({.part = role, .words = "said for its cyclic images, too"});
  for (const Diagnostic& each : step.diagnostics) {
    const Severity severity = each.severity();
    if (severity != Severity::error && severity != Severity::not_understood) continue;
    lines.push_back({.part = not_read, .words = each.message});
    for (const std::string& words : each.help) lines.push_back({.part = help, .words = words});
  }
  for (const ReadLetter& letter : row.letters)
    lines.push_back({letters, letter.name, kind_words(letter), source_words(letter, report.file, sources)});
  for (const std::string& words : row.conventions) lines.push_back({.part = convention, .words = words});
  if (row.open) lines.push_back({.part = also_read_as, .words = row.open->message});
  for (const std::string& words : row.restricted) lines.push_back({.part = restricted, .words = words});
  for (const Ground& ground : row.grounds) {
    const bool said = ground.kind == Ground::Kind::said;
    lines.push_back(
        {.part = rests_on, .latex = ground.statement, .words = (said ? "said: " : "") + ground.name});
  }
  return lines;
}

}  // namespace rigor
