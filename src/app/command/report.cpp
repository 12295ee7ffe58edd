// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <utility>

#include "app/host/outputs.h"
#include "app/host/progress.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "check/entry/check.h"
#include "check/entry/read_forms.h"
#include "check/entry/read_rows.h"
#include "report/page/document.h"
#include "report/page/page.h"
#include "report/wording/escape.h"
#include "source/render.h"
#include "source/write_file.h"

namespace rigor {
namespace {

/// All that the documents are made of.
struct Reported {
  SourceMap sources;
  Report report;
  std::deque<FormsReading> readings;  // of the files, for derivations and forms
  std::vector<std::vector<WorkedStep>> derivations;
  std::vector<EvaluatedNotes> evaluated;
  std::vector<NotesReading> rows;  // of the files: how each was read
};

void check_all_notes(const ReportCommand& command, Reported& reported, Progress& progress) {
  for (const std::string& path : command.files) {
    const CheckOptions options{
        .sidecar = command.sidecar,
        .progress = [&](std::size_t done, std::size_t all) { progress.update(path, done, all); },
        .repairs = Repairs::and_of_laws};
    reported.report.files.push_back(check_file(reported.sources, path, options));
    const Counts& counts = reported.report.files.back().counts;
    for (std::size_t i = 0; i < verdict_count; ++i) reported.report.counts[i] += counts[i];
  }
}

/// The expressions of all files, and why each proved step holds.
void explain_all(const ReportCommand& command, Reported& reported, Progress& progress) {
  FormRequest request;
  request.sidecar = command.sidecar;
  for (const std::string& path : command.files) {
    progress.update(path, 0, 1, "files explained");
    FormsReading& reading = reported.readings.emplace_back(read_forms(reported.sources, path, request));
    reported.derivations.push_back(worked_steps(reading.forms));
  }
}

/// How each row was read.
void read_all(const ReportCommand& command, Reported& reported) {
  for (const std::string& path : command.files)
    reported.rows.push_back(read_rows(reported.sources, path, {.sidecar = command.sidecar}));
}

/// Claims only: what is assumed is not computed.
void evaluate_all_notes(Reported& reported, Progress& progress) {
  for (const FormsReading& reading : reported.readings) {
    const std::string& path = reading.report.path;
    EvaluatedNotes notes{.path = path, .chains = {}};
    TrialOptions trials;
    trials.samples = 256;
    trials.operations = 200'000;
    std::size_t done = 0;
    for (const WrittenFormChain& chain : reading.forms.chains) {
      progress.update(path, done++, reading.forms.chains.size(), "chains in floating point");
      if (chain.assumed || chain.forms.size() < 2) continue;
      ChainResult result = measure_chain(reading.forms, chain, {}, trials);
      if (result.forms.size() > 1) notes.chains.push_back({&chain, std::move(result)});
    }
    reported.evaluated.push_back(std::move(notes));
  }
}

/// From the folder of the page to the notes; empty where no relative path leads there.
std::string link_from(const std::string& page, const std::string& notes) {
  std::error_code error;
  const std::filesystem::path folder =
      std::filesystem::absolute(page, error).parent_path().lexically_normal();
  if (error) return {};
  const std::filesystem::path target = std::filesystem::absolute(notes, error).lexically_normal();
  return error ? std::string() : uri_of_path(target.lexically_relative(folder).string());
}

/// Is there something that is no file, such as a device? Writing to it destroys nothing.
bool is_device(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_other(path, error) && !error;
}

/// Why the outputs cannot be written without destroying notes, or one another; empty: they can.
std::string collision(const ReportCommand& command, const Reported& reported) {
  std::vector<std::string> read;
  for (std::size_t k = 0; k < reported.sources.size(); ++k)
    read.push_back(reported.sources.path(static_cast<FileId>(k)));
  for (const FileReport& file : reported.report.files) read.push_back(file.sidecar);
  const std::pair<std::string_view, const std::optional<std::string>&> outputs[] = {
      {"--html", command.html}, {"--latex", command.latex}};
  for (const auto& [option, path] : outputs) {
    if (!path || *path == "-") continue;
    for (const std::string& each : read) {
      if (!each.empty() && same_file(each, *path))
        return fmt::format("`{} {}` would overwrite `{}`, which is read", option, *path, each);
    }
  }
  const bool both = command.html && command.latex && *command.html != "-" && *command.latex != "-";
  if (both && !is_device(*command.html) && same_file(*command.html, *command.latex))
    return fmt::format("`--html {}` and `--latex {}` are one file", *command.html, *command.latex);
  return {};
}

/// False, with a message, where the text cannot be written.
bool write_to(const std::string& path, const std::string& text, std::ostream& out, std::ostream& err) {
  if (path == "-") {
    out << text;
    return true;
  }
  const Result<void> written = write_file(path, text);
  if (!written)
    err << fmt::format("rigor: {}: cannot be written: {}\n", printable(path), written.error().reason);
  return written.has_value();
}

ShownNotes shown(Reported& reported, std::size_t file) {
  ShownNotes notes = show_notes(reported.sources, reported.report.files[file]);
  notes.derivations = reported.derivations[file];
  return notes;
}

std::vector<PageNotes> page_notes(Reported& reported, const std::string& page) {
  std::vector<PageNotes> notes;
  for (std::size_t k = 0; k < reported.report.files.size(); ++k) {
    const FileReport& file = reported.report.files[k];
    notes.push_back({.shown = shown(reported, k),
                     .link = page == "-" ? std::string() : link_from(page, file.path),
                     .reading = k < reported.rows.size() ? &reported.rows[k] : nullptr,
                     .evaluated = k < reported.evaluated.size() ? reported.evaluated[k] : EvaluatedNotes{}});
  }
  return notes;
}

}  // namespace

ExitCode write_reports(const ReportCommand& command, std::ostream& out, std::ostream& err) {
  Reported reported;
  {
    Progress progress(err, screen_of(err).is_terminal);
    check_all_notes(command, reported, progress);
  }
  if (const std::string why = collision(command, reported); !why.empty()) {
    err << "rigor: " << printable(why) << "\n";
    return ExitCode::usage;
  }
  bool readable = false;
  for (const FileReport& file : reported.report.files) {
    readable = readable || !file.unreadable;
    if (!file.unreadable) continue;
    for (const Diagnostic& each : file.diagnostics) err << render(each, reported.sources);
  }
  if (!readable) return ExitCode::no_input;
  {
    Progress progress(err, screen_of(err).is_terminal);
    explain_all(command, reported, progress);
    if (command.html) read_all(command, reported);
    if (command.html && command.forms) evaluate_all_notes(reported, progress);
  }
  if (command.html) {
    std::vector<PageNotes> notes = page_notes(reported, *command.html);
    if (!write_to(*command.html, html_page(notes, reported.sources), out, err)) return ExitCode::no_input;
  }
  if (command.latex) {
    std::vector<ShownNotes> notes;
    for (std::size_t k = 0; k < reported.report.files.size(); ++k) notes.push_back(shown(reported, k));
    if (!write_to(*command.latex, latex_document(notes, reported.sources), out, err))
      return ExitCode::no_input;
  }
  return exit_code(reported.report, usual_rule(false));
}

}  // namespace rigor
