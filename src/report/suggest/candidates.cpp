// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/suggest/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "base/among.h"
#include "report/wording/causes.h"

namespace rigor {
namespace {

/// These change no reading, and need no second look to be known.
bool only_silences_or_asks(std::string_view directive) {
  static constexpr std::string_view openings[] = {"claim ", "expect ", "law next", "skip", "allow ", "warn "};
  return std::ranges::any_of(openings, [&](std::string_view each) { return directive.starts_with(each); });
}

constexpr std::size_t most_headings = 3;
constexpr const char* from_the_start = "at start";

/// The headings that these steps stand below; nothing if there are too many, or one cannot be named.
std::vector<std::string> headings_of(const FileReport& file, const std::vector<Span>& places) {
  std::vector<std::string> anchors;
  for (const Step& step : file.steps) {
    if (!is_one_of(step.span, places)) continue;
    if (step.section.empty() || step.section.find_first_of("#\"\n") != std::string::npos) return {};
    std::string anchor = fmt::format("at section \"{}\"", step.section);
    if (!is_one_of(anchor, anchors)) anchors.push_back(std::move(anchor));
  }
  if (anchors.size() > most_headings) anchors.clear();
  return anchors;
}

/// The directives below each heading of the rows; and, where these are several or none, from the start.
std::vector<std::vector<PlacedLine>> placed_lines(const FileReport& file, const std::vector<Span>& places,
                                                  const std::vector<std::string>& directives) {
  std::vector<std::vector<PlacedLine>> ways;
  const auto below = [&](const std::vector<std::string>& anchors) {
    std::vector<PlacedLine> lines;
    for (const std::string& anchor : anchors)
      for (const std::string& directive : directives) lines.push_back({anchor, directive});
    ways.push_back(std::move(lines));
  };
  const std::vector<std::string> headings = headings_of(file, places);
  if (!headings.empty()) below(headings);
  if (headings.size() != 1) below({from_the_start});
  return ways;
}

/// What one of the causes offers, in the same order.
std::vector<std::string> useful(const Cause& cause) {
  std::vector<std::string> directives;
  for (const std::string& each : cause.directives) {
    if (!only_silences_or_asks(each) && !is_one_of(each, directives)) directives.push_back(each);
  }
  return directives;
}

/// The first directive of each of several causes, for the steps that have them all.
Candidate together(const FileReport& file, const std::vector<Cause>& causes,
                   const std::set<std::size_t>& which, const std::vector<Span>& places) {
  Candidate candidate{.rows = places.size()};
  std::vector<std::string> directives;
  for (const std::size_t each : which) {
    directives.push_back(useful(causes[each]).front());
    candidate.why.push_back(causes[each].words);
  }
  candidate.alternatives = placed_lines(file, places, directives);
  return candidate;
}

}  // namespace

std::vector<Candidate> candidates_of(const FileReport& file) {
  Report report;
  report.files = {file};
  const std::vector<Cause> causes = causes_of(report);
  std::vector<Candidate> candidates;
  for (const Cause& cause : causes) {
    Candidate candidate{.rows = cause.places.size(), .why = {cause.words}};
    for (const std::string& directive : useful(cause)) {
      for (std::vector<PlacedLine>& lines : placed_lines(file, cause.places, {directive}))
        candidate.alternatives.push_back(std::move(lines));
    }
    if (!candidate.alternatives.empty()) candidates.push_back(std::move(candidate));
  }
  std::vector<std::pair<std::set<std::size_t>, std::vector<Span>>> groups;
  for (const Step& step : file.steps) {
    std::set<std::size_t> own;
    bool all_help = true;
    for (std::size_t k = 0; k < causes.size(); ++k) {
      if (!is_one_of(step.span, causes[k].places)) continue;
      own.insert(k);
      all_help = all_help && !useful(causes[k]).empty();
    }
    if (own.size() < 2 || !all_help) continue;
    const auto known = std::ranges::find(groups, own, [](const auto& group) { return group.first; });
    if (known != groups.end()) {
      known->second.push_back(step.span);
    } else {
      groups.push_back({std::move(own), {step.span}});
    }
  }
  std::ranges::stable_sort(groups, std::ranges::greater(),
                           [](const auto& group) { return group.second.size(); });
  for (const auto& [which, places] : groups) candidates.push_back(together(file, causes, which, places));
  return candidates;
}

std::string sidecar_lines(const std::vector<PlacedLine>& lines) {
  std::vector<std::string> anchors;
  for (const PlacedLine& line : lines) {
    if (!is_one_of(line.anchor, anchors)) anchors.push_back(line.anchor);
  }
  std::string text;
  for (const std::string& anchor : anchors) {
    text += anchor + "\n";
    for (const PlacedLine& line : lines) {
      if (line.anchor == anchor) text += line.directive + "\n";
    }
  }
  return text;
}

}  // namespace rigor
