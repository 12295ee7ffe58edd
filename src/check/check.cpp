// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/check.h"

#include <algorithm>
#include <filesystem>

#include "check/notes.h"
#include "check/session.h"
#include "source/read_file.h"

namespace rigor {
namespace {

FileReport unreadable(SourceMap& sources, const std::string& path, const std::string& reason) {
  FileReport report;
  report.path = path;
  report.file = sources.add(path, "");
  report.unreadable = true;
  report.diagnostics.push_back({DiagnosticKind::unreadable_file, {report.file, 0, 0}, reason});
  return report;
}

/// The named sidecar, or the one beside the notes if there is one.
std::optional<std::string> sidecar_path(const std::string& notes, const CheckOptions& options) {
  if (options.sidecar) return options.sidecar;
  std::filesystem::path beside(notes);
  beside.replace_extension(".rigor");
  std::error_code error;
  const bool there = beside.string() != notes && std::filesystem::is_regular_file(beside, error);
  return there ? std::optional(beside.string()) : std::nullopt;
}

}  // namespace

FileReport check_text(SourceMap& sources, const std::string& path, std::string text,
                      const CheckOptions& options) {
  FileReport report;
  report.path = path;
  std::optional<FileId> sidecar;
  if (const auto beside = sidecar_path(path, options)) {
    auto content = read_file(*beside);
    if (!content) return unreadable(sources, *beside, content.error().reason);
    report.sidecar = *beside;
    Diagnostics mended = mend_text(*content, 0);
    sidecar = sources.add(*beside, std::move(*content));
    for (Diagnostic& diagnostic : mended) diagnostic.span.file = *sidecar;
    report.diagnostics = std::move(mended);
  }
  Diagnostics mended = mend_text(text, 0);
  report.file = sources.add(path, std::move(text));
  for (Diagnostic& diagnostic : mended) diagnostic.span.file = report.file;
  report.diagnostics.insert(report.diagnostics.end(), mended.begin(), mended.end());
  const Notes notes = read_notes(sources, report.file, sidecar ? &*sidecar : nullptr, report.diagnostics);
  Session(sources, notes, report, options).run();
  if (report.steps.empty() && report.diagnostics.empty()) {
    report.diagnostics.push_back(
        {DiagnosticKind::no_equations, {report.file, 0, 0}, "no displayed equation was found"});
  }
  return report;
}

FileReport check_file(SourceMap& sources, const std::string& path, const CheckOptions& options) {
  auto text = read_file(path);
  if (!text) return unreadable(sources, path, text.error().reason);
  return check_text(sources, path, std::move(*text), options);
}

}  // namespace rigor
