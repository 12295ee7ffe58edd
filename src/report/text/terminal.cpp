// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/paint.h"
#include "base/utf8.h"
#include "report/wording/causes.h"
#include "report/wording/diagnostics_of.h"
#include "report/wording/laws_of.h"
#include "report/wording/sample.h"
#include "source/render.h"

namespace rigor {
namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t longest_tag = 12;
constexpr std::size_t least_step = 20;
constexpr std::uint32_t gutter = 8;  // cells of a line number and its bar

/// One step as the four columns of its line.
struct StepRow {
  FileId file = 0;
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
  std::ranges::replace(text, '-', ' ');
  const bool as_expected = step.verdict == Verdict::refuted && step.expected_refuted;
  return as_expected ? text + ", as expected" : text;
}

Paint paint_of(const Step& step) {
  switch (step.verdict) {
    case Verdict::proved:
      return Paint::good;
    case Verdict::refuted:
      return step.expected_refuted ? Paint::good : Paint::bad;
    case Verdict::given:
    case Verdict::definition:
    case Verdict::law:
      return Paint::plain;
    case Verdict::undecided:
    case Verdict::not_understood:
    case Verdict::suspect:
      return Paint::open;
    case Verdict::skipped:
      return Paint::faint;
  }
  return Paint::plain;
}

StepRow row_of(const Step& step, const SourceMap& sources) {
  const std::uint32_t line = sources.line_column(step.span.file, step.span.begin).line;
  return {step.span.file, fmt::format("{:>5}", line), print_tag(step.tag), {}, print_verdict(step),
          paint_of(step)};
}

struct ColumnWidths {
  std::size_t line = 0;
  std::size_t tag = 0;
  std::size_t step = 0;
  std::size_t verdict = 0;
};

/// The rows of a file, and how wide each column must be; steps are cut so that a line fits into `width`.
std::pair<std::vector<StepRow>, ColumnWidths> rows_of(const FileReport& file, const SourceMap& sources,
                                                      std::size_t width) {
  std::vector<StepRow> rows;
  ColumnWidths widths;
  for (const Step& step : file.steps) {
    const StepRow& row = rows.emplace_back(row_of(step, sources));
    widths.line = std::max(widths.line, row.line.size());
    widths.tag = std::max(widths.tag, cells(row.tag));
    widths.verdict = std::max(widths.verdict, row.verdict.size());
  }
  const std::size_t others =
      widths.line + gap + (widths.tag == 0 ? 0 : widths.tag + gap) + gap + widths.verdict;
  const std::size_t room = width > others + least_step ? width - others : least_step;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].step = shorten(file.steps[i].source, room);
    widths.step = std::max(widths.step, cells(rows[i].step));
  }
  return {std::move(rows), widths};
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t used = cells(text);
  return used < width ? text + std::string(width - used, ' ') : text;
}

/// Steps of another file, such as one that `\input` names, are below that file's path.
std::string print_steps(const FileReport& file, const SourceMap& sources, const TerminalOptions& options) {
  const auto [rows, widths] = rows_of(file, sources, options.width);
  const std::string between(gap, ' ');
  std::string text = paint(printable(file.path), Paint::strong, options.color) + "\n";
  FileId current = file.file;
  for (const StepRow& row : rows) {
    if (row.file != current)
      text += paint(printable(sources.path(row.file)), Paint::strong, options.color) + "\n";
    current = row.file;
    text += fmt::format("{:>{}}", row.line, widths.line) + between;
    if (widths.tag > 0) text += padded(row.tag, widths.tag) + between;
    text += padded(row.step, widths.step) + between + paint(row.verdict, row.style, options.color) + "\n";
  }
  return text;
}

/// The nearest true statements, the first one with what was changed.
std::string print_repairs(const Step& step, bool color) {
  std::string text;
  for (const Repair& repair : step.repairs) {
    const std::string head = paint(text.empty() ? "true is:" : "     or:", Paint::strong, color);
    text += fmt::format("{} {}\n         {}\n", head, printable(repair.statement), printable(repair.change));
  }
  for (const std::string& condition : step.conditions)
    text += fmt::format("{} {}\n", paint("holds if:", Paint::strong, color), printable(condition));
  return text;
}

/// One line a symbol, below the diagnostics.
std::string print_dimensions(const FileReport& file) {
  std::size_t width = 0;
  for (const SymbolDimension& entry : file.dimensions)
    width = std::max(width, cells(printable(entry.symbol)));
  std::string text = "\ndimensions:\n";
  for (const SymbolDimension& entry : file.dimensions)
    text += "  " + padded(printable(entry.symbol), width) + "  " + entry.dimension.value_or("free") + "\n";
  return text;
}

}  // namespace

std::string print_diagnostics(const FileReport& file, const SourceMap& sources,
                              const TerminalOptions& options) {
  const RenderOptions render_options{options.color, options.width > gutter ? options.width - gutter : 0};
  std::string text;
  for (const PlacedDiagnostic& placed : diagnostics_of(file)) {
    if (options.known != nullptr && options.known->has(*placed.diagnostic)) continue;
    text += "\n" + render(*placed.diagnostic, sources, render_options);
    if (placed.step == nullptr || !shows_repairs(placed.diagnostic->kind)) continue;
    const Step& step = *placed.step;
    if (placed.diagnostic->kind == DiagnosticKind::refuted && step.counterexample)
      text += print_sample(*step.counterexample, options.color);
    const auto first = std::ranges::find_if(step.diagnostics,
                                            [](const Diagnostic& each) { return shows_repairs(each.kind); });
    if (&*first == placed.diagnostic) text += print_repairs(step, options.color);
  }
  return text;
}

std::string print_report(const Report& report, const SourceMap& sources, const TerminalOptions& options) {
  std::string text;
  for (const FileReport& file : report.files) {
    text += print_steps(file, sources, options);
    text += print_diagnostics(file, sources, options);
    if (!file.failure.empty())
      text += paint("internal error: ", Paint::bad, options.color) + printable(file.failure) + "\n";
    if (options.dimensions) text += print_dimensions(file);
    if (const std::string laws = print_laws(laws_of(file, sources)); !laws.empty())
      text += "\n" + printable(laws) + "\n";
    text += "\n";
  }
  const std::string causes = print_causes(
      report, sources, options.known != nullptr ? *options.known : KnownFindings(), options.all_causes);
  if (!causes.empty()) text += causes + "\n";
  return text + print_summary(report) + "\n";
}

}  // namespace rigor
