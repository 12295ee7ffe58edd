// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/replay_text.h"

#include <fmt/format.h>

#include "base/paint.h"
#include "base/utf8.h"
#include "source/render.h"

namespace rigor {
namespace {

constexpr std::uint32_t margin = 8;  // cells of a line number and its bar

/// The byte at a line and column of a file, or its end.
std::uint32_t offset_of(const SourceMap& sources, FileId file, LineColumn place) {
  const std::string_view line = sources.line_text(file, place.line);
  std::size_t offset = 0;
  for (std::uint32_t column = 1; column < place.column && offset < line.size(); ++column)
    static_cast<void>(next_code_point(line, offset));
  return sources.line_start(file, place.line) + static_cast<std::uint32_t>(offset);
}

std::string why_not(const RecordedStep& recorded, const FileReport& notes) {
  if (!recorded.step)
    return fmt::format("the notes have no such step at {}:{}", recorded.line, recorded.column);
  if (!recorded.fault.empty()) return recorded.fault;
  const Verdict verdict = notes.steps[*recorded.step].verdict;
  if (verdict != Verdict::refuted) return fmt::format("the step is `{}` now", name_of(verdict));
  return "the sample of the report is about something else";
}

}  // namespace

bool is_confirmed(const RecordedStep& recorded, const FileReport& notes) {
  return recorded.step && *recorded.step < notes.steps.size() && recorded.replayed &&
         recorded.fault.empty() && notes.steps[*recorded.step].verdict == Verdict::refuted;
}

std::string print_replay(const RecordedStep& recorded, const FileReport& notes, const SourceMap& sources,
                         const TerminalOptions& options) {
  if (is_confirmed(recorded, notes)) {
    const Span span = notes.steps[*recorded.step].span;
    const LineColumn place = sources.line_column(span.file, span.begin);
    return fmt::format("{}:{}:{}: {}: left {}, right {}\n", printable(sources.path(span.file)), place.line,
                       place.column, paint("confirmed", Paint::good, options.color), recorded.example.left,
                       recorded.example.right);
  }
  Span span;
  if (recorded.step && *recorded.step < notes.steps.size()) {
    span = notes.steps[*recorded.step].relation_span;
  } else {
    span.file = notes.file;
    span.begin = span.end = offset_of(sources, notes.file, {recorded.line, recorded.column});
  }
  Diagnostic diagnostic{DiagnosticKind::not_confirmed, span, "not confirmed: " + why_not(recorded, notes)};
  if (!recorded.step) diagnostic.help = {fmt::format("the report says `{}`", recorded.source)};
  return render(diagnostic, sources, {options.color, options.width > margin ? options.width - margin : 0});
}

std::string print_tally(const ReplayTally& tally) {
  const std::size_t all = tally.confirmed + tally.not_confirmed;
  std::string text = fmt::format("{} refutation{}: {} confirmed", all, all == 1 ? "" : "s", tally.confirmed);
  if (tally.not_confirmed > 0) text += fmt::format(", {} not confirmed", tally.not_confirmed);
  return text;
}

}  // namespace rigor
