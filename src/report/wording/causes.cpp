// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/causes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::size_t least_open_steps = 3;
constexpr std::size_t shown_causes = 6;  // of each part
constexpr std::size_t shown_places = 3;

bool leaves_open(const Diagnostic& diagnostic) {
  const Severity severity = diagnostic.severity();
  return severity == Severity::undecided || severity == Severity::not_understood ||
         severity == Severity::error;
}

/// What is quoted becomes `…`, and a list of quotes one of them.
std::string without_quotes(std::string_view message) {
  constexpr std::string_view gap = "`…`";
  std::string text;
  for (std::size_t at = 0; at < message.size(); ++at) {
    const std::size_t end = message[at] == '`' ? message.find('`', at + 1) : std::string_view::npos;
    if (end == std::string_view::npos) {
      text += message[at];
      continue;
    }
    text += gap;
    at = end;
  }
  for (const std::string_view between : {", ", " and "}) {
    const std::string pair = fmt::format("{}{}{}", gap, between, gap);
    for (std::size_t at = text.find(pair); at != std::string::npos; at = text.find(pair))
      text.replace(at, pair.size(), gap);
  }
  return text;
}

std::vector<std::string> directives_of(const Diagnostic& diagnostic) {
  std::vector<std::string> all;
  for (const std::string& help : diagnostic.help)
    for (const std::string& directive : directives_in(help)) all.push_back(directive);
  return all;
}

class CauseTable {
 public:
  void add(const Step& step, const KnownFindings& known) {
    std::set<std::size_t> found;
    for (const Diagnostic& diagnostic : step.diagnostics) {
      if (leaves_open(diagnostic) && !is_expected(diagnostic, &step) && !known.has(diagnostic))
        found.insert(entry_of(diagnostic));
    }
    for (const std::size_t each : found) {
      Cause& cause = causes_[each];
      ++cause.steps;
      cause.alone += found.size() == 1 ? 1 : 0;
      cause.places.push_back(step.span);
    }
  }

  std::vector<Cause> take() {
    std::ranges::stable_sort(causes_, [](const Cause& a, const Cause& b) {
      return std::tuple(a.directives.empty(), b.alone, b.steps) <
             std::tuple(b.directives.empty(), a.alone, a.steps);
    });
    return std::move(causes_);
  }

 private:
  std::size_t entry_of(const Diagnostic& diagnostic) {
    std::vector<std::string> directives = directives_of(diagnostic);
    std::string pattern = without_quotes(diagnostic.message);
    const std::string key = directives.empty() ? pattern : "rigor: " + directives.front();
    const auto [entry, is_new] = entries_.emplace(key, causes_.size());
    if (is_new) causes_.push_back({.words = diagnostic.message, .directives = std::move(directives)});
    Cause& cause = causes_[entry->second];
    if (cause.directives.empty() && cause.words != diagnostic.message) cause.words = std::move(pattern);
    return entry->second;
  }

  std::map<std::string, std::size_t> entries_;  // by what makes causes the same
  std::vector<Cause> causes_;
};

/// `lines 3, 9, 20, …`; with several files `a.md:3, b.md:9, …`.
std::string print_places(const Cause& cause, const Report& report, const SourceMap& sources) {
  const bool one_file = report.files.size() == 1 && std::ranges::all_of(cause.places, [&](Span place) {
                          return place.file == report.files.front().file;
                        });
  std::vector<std::string> places;
  for (const Span place : cause.places) {
    const std::uint32_t line = sources.line_column(place.file, place.begin).line;
    std::string text =
        one_file ? fmt::format("{}", line) : fmt::format("{}:{}", printable(sources.path(place.file)), line);
    if (places.empty() || places.back() != text) places.push_back(std::move(text));
  }
  const bool several = places.size() > 1;
  const bool more = places.size() > shown_places;
  places.resize(std::min(places.size(), shown_places));
  return fmt::format("{}{}{}", one_file ? several ? "lines " : "line " : "", fmt::join(places, ", "),
                     more ? ", …" : "");
}

/// One part of the table; `left` counts the causes that do not fit.
std::string print_part(const std::vector<Cause>& causes, bool with_directive, std::size_t most,
                       const Report& report, const SourceMap& sources, std::size_t& left) {
  std::string text;
  std::size_t shown = 0;
  for (const Cause& cause : causes) {
    if (cause.directives.empty() == with_directive) continue;
    if (shown++ >= most) {
      ++left;
      continue;
    }
    std::string words = printable(cause.words) + ": " + print_places(cause, report, sources);
    if (with_directive)
      words = fmt::format("`rigor: {}`\n{:>16}{}", fmt::join(cause.directives, "` or `rigor: "), "", words);
    text += fmt::format("{:>7}{:>7}  {}\n", cause.steps, cause.alone, words);
  }
  return text;
}

}  // namespace

std::vector<std::string> directives_in(const std::string& help) {
  constexpr std::string_view opening = "`rigor: ";
  std::vector<std::string> all;
  for (std::size_t at = help.find(opening); at != std::string::npos; at = help.find(opening, at)) {
    at += opening.size();
    const std::size_t end = help.find('`', at);
    if (end == std::string::npos) break;
    const std::string directive = help.substr(at, end - at);
    if (directive.find("…") == std::string::npos) all.push_back(directive);
    at = end + 1;
  }
  return all;
}

std::vector<Cause> causes_of(const Report& report, const KnownFindings& known) {
  CauseTable table;
  for (const FileReport& file : report.files)
    for (const Step& step : file.steps) table.add(step, known);
  return table.take();
}

std::string print_causes(const Report& report, const SourceMap& sources, const KnownFindings& known,
                         bool all) {
  const std::vector<Cause> causes = causes_of(report, known);
  std::size_t open = 0;
  for (const FileReport& file : report.files)
    for (const Step& step : file.steps)
      open += std::ranges::any_of(
          step.diagnostics, [&](const Diagnostic& each) { return leaves_open(each) && !known.has(each); });
  if (open < least_open_steps) return "";
  const std::size_t most = all ? causes.size() : shown_causes;
  std::size_t left = 0;
  std::string text = fmt::format("why {} steps are open (with this cause, and with no other):\n", open);
  if (const std::string part = print_part(causes, true, most, report, sources, left); !part.empty())
    text += "  a line of yours may settle\n" + part;
  if (const std::string part = print_part(causes, false, most, report, sources, left); !part.empty())
    text += "  no line is known that settles\n" + part;
  if (left > 0) text += fmt::format("  and {} other cause{} (--all-causes)\n", left, left == 1 ? "" : "s");
  return text;
}

}  // namespace rigor
