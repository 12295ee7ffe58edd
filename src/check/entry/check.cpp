// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/entry/check.h"
#include "check/entry/read_forms.h"
#include "check/entry/read_rows.h"

#include <fmt/format.h>

#include <filesystem>

#include "check/event/notes.h"
#include "check/form/forms.h"
#include "check/form/written_forms_of_notes.h"
#include "check/question/decision_cache.h"
#include "check/review/review.h"
#include "check/shown/rows_as_read.h"
#include "check/walk/walk.h"
#include "latex/text/format.h"
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

struct Sidecar {
  std::string path;
  std::string refused = {};  // why it is not read
};

/// A sidecar next to the notes is read although nobody named it. A link could show any file's lines in
/// diagnostics.
std::string refusal(const std::filesystem::path& sidecar) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder =
      fs::canonical(sidecar.has_parent_path() ? sidecar.parent_path() : fs::path("."), error);
  const fs::path real = fs::weakly_canonical(sidecar, error);
  const fs::path relative = real.lexically_relative(folder);
  const char* const named = "a sidecar next to the notes";
  if (error || relative.empty() || *relative.begin() == "..")
    return fmt::format("{} must lie in their folder, and this link leads out of it", named);
  if (!fs::is_regular_file(real, error)) return fmt::format("{} must be a regular file", named);
  return {};
}

/// The named sidecar, or the one next to the notes if there is one.
std::optional<Sidecar> find_sidecar(const std::string& notes, const CheckOptions& options) {
  if (options.sidecar) return Sidecar{*options.sidecar};
  if (notes.empty() || notes == standard_input) return std::nullopt;
  std::filesystem::path beside(notes);
  beside.replace_extension(".rigor");
  std::error_code error;
  const bool there =
      beside.string() != notes && std::filesystem::exists(std::filesystem::symlink_status(beside, error));
  return there ? std::optional(Sidecar{beside.string(), refusal(beside)}) : std::nullopt;
}

/// What is in it, and below that what the options say.
Result<std::string> sidecar_text(const std::optional<Sidecar>& sidecar, const CheckOptions& options) {
  if (!sidecar) return options.directives;
  if (!sidecar->refused.empty()) return tl::make_unexpected(Error{sidecar->refused});
  auto content = read_file(sidecar->path);
  if (content && !options.directives.empty()) *content += "\n" + options.directives;
  return content;
}

/// Reads and decides the notes, and then looks at the ledger; with a request, also for what that asks for.
FormsReading decide_notes(SourceMap& sources, const Notes& notes, FileReport& report, CheckOptions options,
                          const FormRequest* request) {
  DecisionCache counting;
  if (options.cache == nullptr) options.cache = &counting;
  WalkRequest wanted{.explains = request != nullptr};
  ExprTree apart;
  Names beginning;
  if (request != nullptr) beginning = names_at_beginning(sources, notes, apart);
  if (request != nullptr && request->only)
    wanted.only = chains_of_request(*request, notes, beginning, report.diagnostics);
  Ledger ledger = walk_through(sources, notes, report, options, std::move(wanted));
  suggest_repairs(ledger, notes, options, report);
  FormsReading reading;
  if (request != nullptr)
    reading = written_forms_of_notes(ledger, *request, notes, beginning, sources, report);
  if (request == nullptr || !request->only) review(ledger, notes, sources, report);
  reading.forms.tree = std::move(ledger.tree);
  return reading;
}

/// Notes with their sidecar, as far as syntax goes.
struct OpenedNotes {
  FileReport report = {};
  std::optional<Notes> notes = {};  // nothing: the sidecar cannot be read
  std::vector<FileId> asked = {};
  std::optional<FileId> statement = {};
};

OpenedNotes open_notes(SourceMap& sources, const std::string& path, std::string text,
                       const CheckOptions& options, const FormRequest* request) {
  OpenedNotes opened;
  FileReport& report = opened.report;
  report.path = path;
  std::optional<FileId> sidecar;
  const auto beside = find_sidecar(path, options);
  if (beside || !options.directives.empty()) {
    auto content = sidecar_text(beside, options);
    if (!content) {
      report = unreadable(sources, beside->path, content.error().reason);
      return opened;
    }
    report.sidecar = beside ? beside->path : "";
    Diagnostics mended = mend_text(*content, 0);
    sidecar = sources.add(beside ? beside->path : "directives", std::move(*content));
    for (Diagnostic& diagnostic : mended) diagnostic.span.file = *sidecar;
    report.diagnostics = std::move(mended);
  }
  Diagnostics mended = mend_notes(text, 0);
  report.file = sources.add(path, std::move(text));
  for (Diagnostic& diagnostic : mended) diagnostic.span.file = report.file;
  report.diagnostics.insert(report.diagnostics.end(), mended.begin(), mended.end());
  if (request != nullptr) {
    for (const std::string& expression : request->asked)
      opened.asked.push_back(sources.add("what is asked", expression));
  }
  std::optional<AddedStatement> added;
  if (request != nullptr && request->statement) {
    opened.statement = sources.add("statement", *request->statement);
    added = AddedStatement{*opened.statement, request->at};
  }
  opened.notes = read_notes(sources, report.file, sidecar ? &*sidecar : nullptr, report.diagnostics,
                            opened.asked, added ? &*added : nullptr);
  for (const Event& event : opened.notes->events) {
    if (const auto* display = std::get_if<ParsedDisplay>(&event)) report.displays.push_back(display->span);
  }
  return opened;
}

void report_no_equations(FileReport& report) {
  if (!report.steps.empty() || !report.diagnostics.empty()) return;
  report.diagnostics.push_back(
      {DiagnosticKind::no_equations, {report.file, 0, 0}, "no displayed equation was found"});
}

FormsReading read_text(SourceMap& sources, const std::string& path, std::string text,
                       const CheckOptions& options, const FormRequest* request) {
  OpenedNotes opened = open_notes(sources, path, std::move(text), options, request);
  if (!opened.notes) return {.report = std::move(opened.report)};
  FormsReading reading = decide_notes(sources, *opened.notes, opened.report, options, request);
  if (request == nullptr || !request->only) report_no_equations(opened.report);
  reading.report = std::move(opened.report);
  reading.asked = std::move(opened.asked);
  reading.statement = opened.statement;
  return reading;
}

}  // namespace

FileReport check_text(SourceMap& sources, const std::string& path, std::string text,
                      const CheckOptions& options) {
  return read_text(sources, path, std::move(text), options, nullptr).report;
}

FormsReading read_forms_of_text(SourceMap& sources, const std::string& path, std::string text,
                                const FormRequest& request) {
  CheckOptions options{.sidecar = request.sidecar};
  options.repairs = Repairs::none;
  return read_text(sources, path, std::move(text), options, &request);
}

FormsReading read_forms(SourceMap& sources, const std::string& path, const FormRequest& request) {
  auto text = read_file(path);
  if (!text) return {.report = unreadable(sources, path, text.error().reason)};
  return read_forms_of_text(sources, path, std::move(*text), request);
}

NotesReading read_rows(SourceMap& sources, const std::string& path, CheckOptions options) {
  auto text = read_file(path);
  if (!text) return {.report = unreadable(sources, path, text.error().reason)};
  return read_rows_of_text(sources, path, std::move(*text), std::move(options));
}

NotesReading read_rows_of_text(SourceMap& sources, const std::string& path, std::string text,
                               CheckOptions options) {
  OpenedNotes opened = open_notes(sources, path, std::move(text), options, nullptr);
  if (!opened.notes) return {.report = std::move(opened.report)};
  DecisionCache counting;
  options.cache = &counting;
  options.repairs = Repairs::none;
  Ledger ledger = walk_through(sources, *opened.notes, opened.report, options, {.reads = true});
  std::vector<ReadRow> rows = rows_as_read(ledger, *opened.notes, sources, opened.report, options);
  report_no_equations(opened.report);
  return {.report = std::move(opened.report), .rows = std::move(rows)};
}

FileReport check_file(SourceMap& sources, const std::string& path, const CheckOptions& options) {
  auto text = read_file(path);
  if (!text) return unreadable(sources, path, text.error().reason);
  return check_text(sources, path, std::move(*text), options);
}

}  // namespace rigor
