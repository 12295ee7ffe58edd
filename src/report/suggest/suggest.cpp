// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/suggest/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/among.h"
#include "check/entry/check.h"
#include "report/wording/finding.h"

namespace rigor {
namespace {

constexpr std::size_t most_followers = 2;

/// What became of a row: its verdict, or `error`.
std::string outcome_of_row(const Step& step) {
  const bool wrong = std::ranges::any_of(
      step.diagnostics, [](const Diagnostic& each) { return each.severity() == Severity::error; });
  return wrong ? "error" : std::string(name_of(step.verdict));
}

bool is_open_outcome(std::string_view outcome) {
  return is_one_of(outcome, {"undecided", "not-understood", "error"});
}
bool is_good_outcome(std::string_view outcome) {
  return is_one_of(outcome, {"proved", "law", "definition", "given"});
}
bool is_worse_outcome(std::string_view outcome) {
  return is_one_of(outcome, {"refuted", "suspect", "error"});
}

/// A row is known by its place and its text, and by how many such rows are before it: a sidecar can make
/// several at one place.
using RowKey = std::tuple<std::string, std::uint32_t, std::uint32_t, std::string, std::size_t>;

struct RowOutcome {
  RowKey key;
  std::string place;
  std::string source;
  std::string outcome;
  bool is_expected = false;
};

struct Outcomes {
  std::vector<RowOutcome> rows = {};
  std::map<std::string, std::size_t> errors = {};  // outside all rows, each with how often it is there
};

Outcomes outcomes_of(const FileReport& report, const SourceMap& sources) {
  Outcomes outcomes;
  std::map<RowKey, std::size_t> seen;
  for (const Step& step : report.steps) {
    const LineColumn at = sources.line_column(step.span.file, step.span.begin);
    RowKey key{sources.path(step.span.file), at.line, at.column, step.source, 0};
    std::get<4>(key) = seen[key]++;
    std::string place = place_text(step.span, sources);
    if (!step.tag.empty()) place += " " + step.tag;
    outcomes.rows.push_back(
        {std::move(key), std::move(place), step.source, outcome_of_row(step), step.expected_refuted});
  }
  for (const Diagnostic& each : report.diagnostics) {
    if (each.severity() == Severity::error)
      ++outcomes.errors[place_text(each.span, sources) + "\n" + each.message];
  }
  return outcomes;
}

/// What is another with the lines than without.
Suggestion compared(const Outcomes& before, const Outcomes& after, std::vector<PlacedLine> lines) {
  // Whether a row holds for all values is no longer asked where it becomes a law.
  const bool asks = std::ranges::any_of(
      lines, [](const PlacedLine& line) { return line.directive.starts_with("for all"); });
  Suggestion suggestion{.lines = std::move(lines)};
  std::map<RowKey, const RowOutcome*> known;
  for (const RowOutcome& row : before.rows) known[row.key] = &row;
  for (const RowOutcome& row : after.rows) {
    const auto earlier = known.find(row.key);
    const std::string was = earlier == known.end() ? "" : earlier->second->outcome;
    if (was == row.outcome) continue;
    const RowChange change{row.place, row.source, was, row.outcome};
    if (is_worse_outcome(row.outcome) && !row.is_expected) {
      suggestion.worse.push_back(change);
    } else if ((is_open_outcome(was) && is_good_outcome(row.outcome) && !(asks && row.outcome == "law")) ||
               (was == "law" && row.outcome == "proved")) {
      suggestion.settled.push_back(change);
    } else if (is_good_outcome(was) && (is_open_outcome(row.outcome) || was == "proved")) {
      suggestion.lost.push_back(change);
    }
  }
  for (const auto& [error, count] : after.errors) {
    const auto earlier = before.errors.find(error);
    if (earlier != before.errors.end() && earlier->second >= count) continue;
    const std::size_t end = error.find('\n');
    suggestion.worse.push_back({error.substr(0, end), error.substr(end + 1), "", "error"});
  }
  return suggestion;
}

class Search {
 public:
  Search(const std::string& path, const std::string& text, const SuggestRequest& request)
      : path_(path), text_(text), request_(request) {}

  void run(const FileReport& report, const SourceMap& sources, Suggestions& found) {
    before_ = outcomes_of(report, sources);
    const std::vector<Candidate> candidates = candidates_of(report);
    for (const Candidate& candidate : candidates) offer(candidate);
    for (const Candidate& candidate : candidates) try_one(candidate, found);
  }

 private:
  /// The notes with some lines more.
  struct Trial {
    Suggestion suggestion;
    Outcomes after;
    std::vector<Candidate> next;  // what its open rows ask for now

    [[nodiscard]] bool changes_nothing() const {
      return suggestion.settled.empty() && suggestion.worse.empty() && suggestion.lost.empty();
    }
  };

  void offer(const Candidate& candidate) {
    for (const std::vector<PlacedLine>& lines : candidate.alternatives)
      for (const PlacedLine& line : lines) offered_.insert(line.directive);
  }

  [[nodiscard]] bool accepts(const Suggestion& suggestion) const {
    if (!request_.accepts_worse && !suggestion.worse.empty()) return false;
    const auto decided =
        static_cast<std::size_t>(std::ranges::count_if(suggestion.worse, [](const RowChange& each) {
          return each.after != "error" && is_open_outcome(each.before);
        }));
    return suggestion.settled.size() + decided > suggestion.lost.size();
  }

  Trial trial_of(const std::vector<PlacedLine>& lines) const {
    std::vector<PlacedLine> all = accepted_;
    all.insert(all.end(), lines.begin(), lines.end());
    CheckOptions options = request_.options;
    options.directives = sidecar_lines(all);
    SourceMap sources;
    const FileReport report = check_text(sources, path_, text_, options);
    Trial trial{{}, outcomes_of(report, sources), candidates_of(report)};
    trial.suggestion = compared(before_, trial.after, lines);
    trial.suggestion.accepted = accepts(trial.suggestion);
    return trial;
  }

  /// Nothing: they were tried before, or too many were.
  std::optional<Trial> try_lines(const std::vector<PlacedLine>& lines, Suggestions& found) {
    if (lines.empty() || !tried_.insert(sidecar_lines(lines)).second) return std::nullopt;
    if (found.tried == most_candidates) {
      found.some_left = true;
      return std::nullopt;
    }
    ++found.tried;
    return trial_of(lines);
  }

  /// A row that a line leaves open may ask for another one now, of which nothing was said before; empty: none
  /// does.
  std::vector<PlacedLine> asked_for_next(const Trial& trial) const {
    for (const Candidate& candidate : trial.next) {
      const std::vector<PlacedLine>& lines = candidate.alternatives.front();
      if (!offered_.contains(lines.front().directive)) return lines;
    }
    return {};
  }

  std::optional<Trial> try_with_followers(std::vector<PlacedLine> lines, Suggestions& found) {
    std::optional<Trial> trial = try_lines(lines, found);
    for (std::size_t k = 0; k < most_followers && trial && trial->changes_nothing(); ++k) {
      const std::vector<PlacedLine> next = asked_for_next(*trial);
      if (next.empty() || is_one_of(next.front(), lines)) break;
      lines.insert(lines.end(), next.begin(), next.end());
      trial = try_lines(lines, found);
    }
    return trial;
  }

  void try_one(const Candidate& candidate, Suggestions& found) {
    std::optional<Trial> best;
    for (std::vector<PlacedLine> lines : candidate.alternatives) {
      std::erase_if(lines, [&](const PlacedLine& line) { return is_one_of(line, accepted_); });
      std::optional<Trial> trial = try_with_followers(std::move(lines), found);
      if (!trial) continue;
      trial->suggestion.why = candidate.why;
      const bool settles_all =
          trial->suggestion.accepted && trial->suggestion.settled.size() >= candidate.rows;
      if (!best || rank_of(trial->suggestion) > rank_of(best->suggestion)) best = std::move(trial);
      if (settles_all) break;
    }
    if (!best) return;
    Suggestion& suggestion = best->suggestion;
    const auto is_row = [](const RowChange& each) { return !each.before.empty(); };
    if (suggestion.settled.empty() && std::ranges::none_of(suggestion.worse, is_row)) return;
    if (suggestion.accepted) {
      accepted_.insert(accepted_.end(), suggestion.lines.begin(), suggestion.lines.end());
      before_ = std::move(best->after);
    }
    found.all.push_back(std::move(suggestion));
  }

  static std::tuple<bool, std::size_t, std::size_t> rank_of(const Suggestion& suggestion) {
    const auto proved =
        static_cast<std::size_t>(std::ranges::count(suggestion.settled, "proved", &RowChange::after));
    return {suggestion.accepted, suggestion.settled.size(), proved};
  }

  const std::string& path_;
  const std::string& text_;
  const SuggestRequest& request_;
  Outcomes before_ = {};  // with what is accepted
  std::vector<PlacedLine> accepted_ = {};
  std::set<std::string> tried_ = {};
  std::set<std::string> offered_ = {};  // directives, for the notes as they are
};

}  // namespace

Suggestions suggest_directives(SourceMap& sources, const std::string& path, const std::string& text,
                               const SuggestRequest& request) {
  Suggestions found{.report = check_text(sources, path, text, request.options)};
  if (found.report.unreadable) return found;
  for (const Step& step : found.report.steps) found.open += is_open_outcome(outcome_of_row(step)) ? 1 : 0;
  Search(path, text, request).run(found.report, sources, found);
  return found;
}

std::vector<PlacedLine> accepted_lines(const Suggestions& suggestions) {
  std::vector<PlacedLine> lines;
  for (const Suggestion& each : suggestions.all) {
    if (each.accepted) lines.insert(lines.end(), each.lines.begin(), each.lines.end());
  }
  return lines;
}

}  // namespace rigor
