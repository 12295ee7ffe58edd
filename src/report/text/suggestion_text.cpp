// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/suggestion_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/paint.h"
#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::size_t shown_settled = 4;  // of each suggestion
constexpr std::size_t indent = 11;
constexpr std::size_t widest_row = 60;

std::string verdict_words(const std::string& outcome) {
  std::string words = outcome;
  std::ranges::replace(words, '-', ' ');
  return words;
}

std::string line_of_change(const RowChange& change, Paint style, bool color) {
  const std::string verdicts = change.before.empty() ? verdict_words(change.after)
                                                     : fmt::format("{} -> {}", verdict_words(change.before),
                                                                   verdict_words(change.after));
  return std::string(indent, ' ') + printable(change.place) + "  " + paint(verdicts, style, color) + "  " +
         shorten(change.source, widest_row) + "\n";
}

std::string text_of_suggestion(const Suggestion& suggestion, bool color) {
  std::string text;
  for (const PlacedLine& line : suggestion.lines) {
    const bool first = text.empty();
    text += fmt::format("{:>9}  {}: rigor: {}\n", first ? fmt::format("{}", suggestion.settled.size()) : "",
                        printable(line.anchor), printable(line.directive));
  }
  for (const std::string& why : suggestion.why)
    text += std::string(indent, ' ') + paint("since " + printable(why), Paint::faint, color) + "\n";
  for (const RowChange& change : suggestion.worse) text += line_of_change(change, Paint::bad, color);
  for (const RowChange& change : suggestion.lost) text += line_of_change(change, Paint::open, color);
  const std::size_t shown = std::min(shown_settled, suggestion.settled.size());
  for (std::size_t k = 0; k < shown; ++k) text += line_of_change(suggestion.settled[k], Paint::good, color);
  if (shown < suggestion.settled.size())
    text += fmt::format("{:{}}and {} more\n", "", indent, suggestion.settled.size() - shown);
  return text;
}

/// `2 proved, 1 law`
std::string counted_outcomes(const Suggestions& suggestions) {
  static constexpr std::array outcomes{"proved", "law", "definition", "given"};
  std::string text;
  for (const char* outcome : outcomes) {
    std::size_t count = 0;
    for (const Suggestion& each : suggestions.all) {
      if (each.accepted)
        count += static_cast<std::size_t>(std::ranges::count(each.settled, outcome, &RowChange::after));
    }
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, outcome);
  }
  return text;
}

std::string summary_of(const Suggestions& suggestions) {
  std::size_t lines = 0;
  std::size_t settled = 0;
  std::size_t worse = 0;
  for (const Suggestion& each : suggestions.all) {
    if (!each.accepted) continue;
    worse += each.worse.size();
    lines += each.lines.size();
    settled += each.settled.size();
  }
  const std::size_t rows = suggestions.report.steps.size();
  const std::string open =
      fmt::format("{} of {} row{} open", suggestions.open, rows, rows == 1 ? " is" : "s are");
  if (lines == 0) return fmt::format("{}; no line is known that settles any\n", open);
  std::string text = fmt::format("{}; {} line{} {} {}", open, lines, lines == 1 ? " settles" : "s settle",
                                 settled, settled == 1 ? "row" : "rows");
  if (const std::string counted = counted_outcomes(suggestions); !counted.empty()) text += ": " + counted;
  if (worse > 0)
    text += fmt::format("; and {} made worse", worse == 1 ? "1 is" : fmt::format("{} are", worse));
  return text + "\n";
}

}  // namespace

std::string suggestion_text(const Suggestions& suggestions, const TerminalOptions& options) {
  std::string text;
  for (const bool accepted : {true, false}) {
    bool first = true;
    for (const Suggestion& each : suggestions.all) {
      if (each.accepted != accepted) continue;
      if (first)
        text += paint(accepted ? "  settles  a line of yours\n" : "  settles  and is held back\n",
                      Paint::faint, options.color);
      first = false;
      text += text_of_suggestion(each, options.color);
    }
    if (!first) text += "\n";
  }
  if (suggestions.some_left) text += fmt::format("only {} lines were tried\n", suggestions.tried);
  return text + summary_of(suggestions);
}

}  // namespace rigor
