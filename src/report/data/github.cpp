// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/github.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "report/text/terminal.h"
#include "report/wording/escape.h"
#include "report/wording/finding.h"

namespace rigor {
namespace {

/// Columns are read only where a place is on one line.
std::string properties_of(Span span, const SourceMap& sources, const std::string& folder) {
  const LineColumn begin = sources.line_column(span.file, span.begin);
  const LineColumn end = sources.line_column(span.file, std::max(span.begin, span.end));
  std::string text =
      fmt::format("file={},line={},endLine={}", workflow_property(path_from(sources.path(span.file), folder)),
                  begin.line, end.line);
  if (begin.line == end.line) text += fmt::format(",col={},endColumn={}", begin.column, end.column);
  return text;
}

std::string annotation(const PlacedDiagnostic& placed, const SourceMap& sources, const CheckFormat& options) {
  const Weight weight = weight_of(placed, options.rule);
  if (weight == Weight::expected || weight == Weight::known) return "";
  std::string message = printable(placed.diagnostic->message) + "\n" + details_of(placed, sources);
  message.pop_back();
  return fmt::format("::{} {},title={}::{}\n", weight == Weight::wrong ? "error" : "warning",
                     properties_of(placed.diagnostic->span, sources, options.folder),
                     workflow_property(info(placed.diagnostic->kind).name), workflow_message(message));
}

}  // namespace

std::string to_github(const Report& report, const SourceMap& sources, const CheckFormat& options) {
  std::string text;
  for (const FileReport& file : report.files) {
    for (const PlacedDiagnostic& placed : diagnostics_of(file)) text += annotation(placed, sources, options);
    if (!file.failure.empty())
      text += fmt::format("::error file={},title=internal error::{}\n",
                          workflow_property(path_from(file.path, options.folder)),
                          workflow_message(file.failure));
  }
  return text + print_summary(report) + "\n";
}

}  // namespace rigor
