// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/paint.h"
#include "base/utf8.h"
#include "report/diagnostics_of.h"
#include "report/sample.h"
#include "source/render.h"

namespace rigor {
namespace {

constexpr std::size_t least_width = 60;
constexpr std::size_t longest_tag = 12;
constexpr std::size_t verdict_width = 20;  // room that is left for the last column

/// One step as the four columns of its line.
struct Row {
  std::string line;
  std::string tag;
  std::string step;
  std::string verdict;
  Paint style = Paint::plain;
};

std::string print_tag(const std::string& tag) {
  if (tag.empty()) return "";
  return shorten(tag.starts_with('(') ? tag : fmt::format("({})", tag), longest_tag);
}

std::string print_verdict(const Step& step) {
  std::string text(name_of(step.verdict));
  std::replace(text.begin(), text.end(), '-', ' ');
  if (!step.expected_refuted) return text;
  return text + (step.verdict == Verdict::refuted ? ", as expected" : ", not refuted as expected");
}

Paint paint_of(const Step& step) {
  const bool is_refuted = step.verdict == Verdict::refuted;
  if (is_refuted != step.expected_refuted) return Paint::bad;
  switch (step.verdict) {
    case Verdict::proved:
    case Verdict::refuted:
      return Paint::good;
    case Verdict::given:
    case Verdict::definition:
      return Paint::plain;
    case Verdict::undecided:
    case Verdict::not_understood:
      return Paint::open;
    case Verdict::skipped:
      return Paint::faint;
  }
  return Paint::plain;
}

Row row_of(const Step& step, const SourceMap& sources) {
  const std::uint32_t line = sources.line_column(step.span.file, step.span.begin).line;
  return {fmt::format("{:>5}", line), print_tag(step.tag), {}, print_verdict(step), paint_of(step)};
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t used = cells(text);
  return used < width ? text + std::string(width - used, ' ') : text;
}

std::string print_steps(const FileReport& file, const SourceMap& sources, const TerminalOptions& options) {
  std::vector<Row> rows;
  std::size_t line_width = 0;
  std::size_t tag_width = 0;
  for (const Step& step : file.steps) {
    rows.push_back(row_of(step, sources));
    line_width = std::max(line_width, rows.back().line.size());
    tag_width = std::max(tag_width, cells(rows.back().tag));
  }
  const std::size_t before = line_width + 2 + (tag_width == 0 ? 0 : tag_width + 2);
  const std::size_t room = std::max<std::size_t>(options.width, least_width) - before - 2 - verdict_width;
  std::size_t step_width = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].step = shorten(file.steps[i].source, room);
    step_width = std::max(step_width, cells(rows[i].step));
  }
  std::string text;
  for (const Row& row : rows) {
    text += fmt::format("{:>{}}  ", row.line, line_width);
    if (tag_width > 0) text += padded(row.tag, tag_width) + "  ";
    text +=
        fmt::format("{}  {}\n", padded(row.step, step_width), paint(row.verdict, row.style, options.color));
  }
  return text;
}

/// The refutations that no diagnostic speaks of, such as those that a directive expects, as diagnostics.
Diagnostics silent_refutations(const Step& step) {
  const auto is_refutation = [](const Diagnostic& d) { return d.kind == DiagnosticKind::refuted; };
  if (step.verdict != Verdict::refuted || !step.counterexample) return {};
  if (std::any_of(step.diagnostics.begin(), step.diagnostics.end(), is_refutation)) return {};
  return {{DiagnosticKind::refuted,
           step.relation_span,
           step.expected_refuted ? "the sides differ, as expected" : "the sides differ",
           {},
           {}}};
}

std::string print_diagnostics(FileReport file, const SourceMap& sources, const TerminalOptions& options) {
  for (Step& step : file.steps)
    for (Diagnostic& diagnostic : silent_refutations(step)) step.diagnostics.push_back(std::move(diagnostic));
  const RenderOptions render_options{options.color, std::max<std::uint32_t>(options.width, least_width)};
  std::string text;
  for (const PlacedDiagnostic& placed : diagnostics_of(file)) {
    text += "\n" + render(*placed.diagnostic, sources, render_options);
    const bool has_sample = placed.step != nullptr && placed.step->counterexample.has_value();
    if (has_sample && placed.diagnostic->kind == DiagnosticKind::refuted)
      text += print_sample(*placed.step->counterexample, options.color);
  }
  return text;
}

}  // namespace

std::string print_report(const Report& report, const SourceMap& sources, const TerminalOptions& options) {
  std::string text;
  for (const FileReport& file : report.files) {
    text += paint(printable(file.path), Paint::strong, options.color) + "\n";
    text += print_steps(file, sources, options);
    text += print_diagnostics(file, sources, options);
    text += "\n";
  }
  return text + print_summary(report) + "\n";
}

}  // namespace rigor
