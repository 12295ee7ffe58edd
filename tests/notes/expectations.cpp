// SPDX-License-Identifier: GPL-3.0-or-later
#include "expectations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>

#include "latex/document/document.h"
#include "report/wording/diagnostics_of.h"

namespace rigor {
namespace {

using Words = std::vector<std::string>;

bool has(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool lies_in(Span inner, Span outer) {
  return inner.file == outer.file && inner.begin >= outer.begin && inner.begin < outer.end;
}

std::string place(Span span, const SourceMap& sources) {
  const LineColumn at = sources.line_column(span.file, span.begin);
  return fmt::format("{}:{}:{}", sources.path(span.file), at.line, at.column);
}

std::string_view kind_of(const Diagnostic& diagnostic) { return info(diagnostic.kind).name; }

/// What stands in a line that is a comment and nothing else, indented or not.
std::optional<std::string_view> comment_in(std::string_view line, Format format) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  const std::string_view open = format == Format::latex ? "% " : "<!-- ";
  const std::string_view close = format == Format::latex ? "" : " -->";
  if (!line.starts_with(open) || !line.ends_with(close)) return std::nullopt;
  return line.substr(open.size(), line.size() - open.size() - close.size());
}

Words split(std::string_view text) {
  std::istringstream stream{std::string(text)};
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_verdict(std::string_view word) {
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (name_of(static_cast<Verdict>(i)) == word) return true;
  return false;
}

bool is_kind(std::string_view word) {
  return std::ranges::any_of(diagnostic_table(),
                             [&](const DiagnosticInfo& info) { return info.name == word; });
}

/// Enters one comment; what is wrong with it is returned.
std::string enter(std::string_view comment, std::uint32_t offset, Expectations& into) {
  const std::size_t colon = comment.find(": ");
  if (!comment.starts_with("expect-") || colon == std::string_view::npos) return "";
  const std::string_view key = comment.substr(0, colon);
  const Words values = split(comment.substr(colon + 2));
  if (key == "expect-in-file") {
    into.kinds_in_file.insert(into.kinds_in_file.end(), values.begin(), values.end());
    return values.size() == 1 && is_kind(values[0]) ? "" : "no single diagnostic kind";
  }
  const auto display = std::ranges::find_if(
      into.displays, [&](const Expectations::Display& each) { return each.span.begin >= offset; });
  if (display == into.displays.end()) return "no display stands below";
  if (key == "expect-diagnostic") {
    display->kinds.insert(display->kinds.end(), values.begin(), values.end());
    return values.size() == 1 && is_kind(values[0]) ? "" : "no single diagnostic kind";
  }
  if (key == "expect-verdict") {
    display->verdicts = values;
    return !values.empty() && std::ranges::all_of(values, is_verdict) ? "" : "no verdicts";
  }
  return "an unknown key";
}

/// The steps of one display, in order.
std::vector<const Step*> steps_in(Span span, const FileReport& report) {
  std::vector<const Step*> steps;
  for (const Step& step : report.steps)
    if (lies_in(step.span, span)) steps.push_back(&step);
  return steps;
}

class Comparison {
 public:
  Comparison(const FileReport& report, const SourceMap& sources, const Expectations& expected)
      : report_(report), sources_(sources), expected_(expected), reported_(diagnostics_of(report)) {}

  Words run() {
    for (const Expectations::Display& display : expected_.displays) {
      missing_kinds(display.kinds, display.span, &display.span);
      verdicts(display);
    }
    missing_kinds(expected_.kinds_in_file, {report_.file, 0, 0}, nullptr);
    for (const Step& step : report_.steps)
      if (display_of(step.span) == nullptr) directive(step);
    for (const PlacedDiagnostic& placed : reported_) surprise(placed);
    return std::move(problems_);
  }

 private:
  void missing_kinds(const Words& kinds, Span at, const Span* within) {
    for (const std::string& kind : kinds) {
      const bool found = std::ranges::any_of(reported_, [&](const PlacedDiagnostic& placed) {
        return kind_of(*placed.diagnostic) == kind && (!within || lies_in(placed.diagnostic->span, *within));
      });
      if (!found) add(at, fmt::format("expected [{}], got {}", kind, reported_kinds(within)));
    }
  }

  std::string reported_kinds(const Span* within) const {
    Words kinds;
    for (const PlacedDiagnostic& placed : reported_) {
      const std::string name = fmt::format("[{}]", kind_of(*placed.diagnostic));
      if ((!within || lies_in(placed.diagnostic->span, *within)) && !has(kinds, name)) kinds.push_back(name);
    }
    return kinds.empty() ? "no diagnostic" : fmt::format("{}", fmt::join(kinds, " "));
  }

  void verdicts(const Expectations::Display& display) {
    if (display.verdicts.empty() && (!display.kinds.empty() || shows_kind_of_file(display.span))) return;
    const auto steps = steps_in(display.span, report_);
    if (steps.empty()) return add(display.span, "expected a step, got none");
    if (display.verdicts.size() > 1 && display.verdicts.size() != steps.size())
      return add(display.span,
                 fmt::format("expected {} steps, got {}", display.verdicts.size(), steps.size()));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string_view got = name_of(steps[i]->verdict);
      if (display.verdicts.empty()) {
        if (got != "proved" && got != "definition") wrong_verdict(*steps[i], "proved or definition");
      } else {
        const std::string& verdict = display.verdicts[display.verdicts.size() == 1 ? 0 : i];
        if (got != verdict) wrong_verdict(*steps[i], verdict);
      }
    }
  }

  /// A step that a directive states holds, unless a diagnostic that is announced for the file is about it.
  void directive(const Step& step) {
    if (step.verdict == Verdict::refuted && step.expected_refuted) return;
    if (step.verdict != Verdict::refuted && step.verdict != Verdict::undecided &&
        step.verdict != Verdict::not_understood)
      return;
    if (!shows_kind_of_file(step.span)) wrong_verdict(step, "a directive that holds");
  }

  /// A diagnostic that nothing announces.
  void surprise(const PlacedDiagnostic& placed) {
    const Diagnostic& diagnostic = *placed.diagnostic;
    const Expectations::Display* display = display_of(diagnostic.span);
    if (has(expected_.kinds_in_file, kind_of(diagnostic))) return;
    if (display != nullptr && has(display->kinds, kind_of(diagnostic))) return;
    if (placed.step != nullptr) {
      if (placed.step->verdict == Verdict::not_understood) return;
      if (placed.step->verdict == Verdict::refuted && diagnostic.kind == DiagnosticKind::refuted) return;
    }
    add(diagnostic.span,
        fmt::format("expected nothing, got [{}] {}", kind_of(diagnostic), diagnostic.message));
  }

  bool shows_kind_of_file(Span span) const {
    return std::ranges::any_of(reported_, [&](const PlacedDiagnostic& placed) {
      return lies_in(placed.diagnostic->span, span) &&
             has(expected_.kinds_in_file, kind_of(*placed.diagnostic));
    });
  }

  const Expectations::Display* display_of(Span span) const {
    for (const Expectations::Display& display : expected_.displays)
      if (lies_in(span, display.span)) return &display;
    return nullptr;
  }

  void wrong_verdict(const Step& step, std::string_view expected) {
    std::string text = fmt::format("expected {}, got {}: {}", expected, name_of(step.verdict), step.source);
    for (const Diagnostic& diagnostic : step.diagnostics)
      text += fmt::format("\n  [{}] {}", kind_of(diagnostic), diagnostic.message);
    add(step.span, text);
  }

  void add(Span span, const std::string& text) { problems_.push_back(place(span, sources_) + ": " + text); }

  const FileReport& report_;
  const SourceMap& sources_;
  const Expectations& expected_;
  std::vector<PlacedDiagnostic> reported_;
  Words problems_;
};

}  // namespace

Expectations read_expectations(SourceMap& sources, FileId file) {
  Expectations result;
  Diagnostics ignored;
  for (const Item& item : read_document(sources, file, ignored).items)
    if (const auto* display = std::get_if<Display>(&item)) result.displays.push_back({display->span, {}, {}});

  const Format format = format_of(sources.path(file));
  for (std::uint32_t line = 1; line <= sources.line_count(file); ++line) {
    const auto comment = comment_in(sources.line_text(file, line), format);
    if (!comment) continue;
    const std::string wrong = enter(*comment, sources.line_start(file, line), result);
    if (!wrong.empty())
      result.problems.push_back(fmt::format("{}:{}: {}: {}", sources.path(file), line, wrong, *comment));
  }
  return result;
}

std::vector<std::string> differences(const FileReport& report, SourceMap& sources) {
  const Expectations expected = read_expectations(sources, report.file);
  Words problems = Comparison(report, sources, expected).run();
  problems.insert(problems.begin(), expected.problems.begin(), expected.problems.end());
  return problems;
}

std::vector<std::string> flaws(const FileReport& report, const SourceMap& sources) {
  Words problems;
  for (const Step& step : report.steps) {
    const bool holds = step.verdict == Verdict::proved || step.verdict == Verdict::definition ||
                       step.verdict == Verdict::given || step.verdict == Verdict::skipped;
    if (!holds && !(step.verdict == Verdict::refuted && step.expected_refuted))
      problems.push_back(fmt::format("{}: expected a step that holds, got {}: {}", place(step.span, sources),
                                     name_of(step.verdict), step.source));
  }
  for (const PlacedDiagnostic& placed : diagnostics_of(report)) {
    const Diagnostic& diagnostic = *placed.diagnostic;
    const bool expected =
        diagnostic.kind == DiagnosticKind::refuted && placed.step && placed.step->expected_refuted;
    if (!expected)
      problems.push_back(fmt::format("{}: expected no diagnostic, got [{}] {}",
                                     place(diagnostic.span, sources), kind_of(diagnostic),
                                     diagnostic.message));
  }
  return problems;
}

}  // namespace rigor
