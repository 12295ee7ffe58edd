// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of checking share: notes in memory and their verdicts as text.
#pragma once

#include <string>
#include <utility>

#include "check/entry/check.h"

namespace rigor {

/// Notes that were checked; Markdown unless the path says otherwise.
struct Checked {
  SourceMap sources;
  FileReport report;

  explicit Checked(std::string text, const std::string& path = "notes.md")
      : report(check_text(sources, path, std::move(text))) {}
  Checked(const Checked&) = delete;
  Checked& operator=(const Checked&) = delete;

  /// `refuted 1:7 refuted`: the verdict, and the place and kind of each diagnostic, with commas between.
  [[nodiscard]] std::string line_of(const Step& step) const {
    return std::string(name_of(step.verdict)) + places(step.diagnostics);
  }
  /// One line a step, then one line for each diagnostic that belongs to no step.
  [[nodiscard]] std::string lines() const {
    std::string text;
    for (const Step& step : report.steps) text += line_of(step) + "\n";
    for (const Diagnostic& diagnostic : report.diagnostics) text += places({diagnostic}).substr(1) + "\n";
    return text;
  }
  [[nodiscard]] std::string places(const Diagnostics& diagnostics) const {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
      const LineColumn place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
      text += (text.empty() ? " " : ", ") + std::to_string(place.line) + ":" + std::to_string(place.column) +
              " " + std::string(info(diagnostic.kind).name);
    }
    return text;
  }
};

/// The verdicts of all steps and the places of all other diagnostics, one a line.
[[nodiscard]] inline std::string lines_of(std::string text) { return Checked(std::move(text)).lines(); }

/// `<!-- rigor: … -->` on a line of its own.
[[nodiscard]] inline std::string rigor_says(const std::string& directive) {
  return "<!-- rigor: " + directive + " -->\n";
}

/// The last step's verdict in a display of its own, whose first line holds the whole statement; `before`
/// stands above.
[[nodiscard]] inline std::string verdict_on(const std::string& statement, const std::string& before = "") {
  const Checked checked(before + "$$\n" + statement + "\n$$\n");
  if (checked.report.steps.empty()) return checked.lines();
  return checked.line_of(checked.report.steps.back());
}

/// The same of a statement that a directive claims, which makes it meant for all values of its symbols.
[[nodiscard]] inline std::string verdict_on_claim(const std::string& statement,
                                                  const std::string& before = "") {
  const Checked checked(before + rigor_says("claim " + statement));
  if (checked.report.steps.empty()) return checked.lines();
  return checked.line_of(checked.report.steps.back());
}

}  // namespace rigor
