// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>

#include "app/command/commands.h"
#include "app/hole/write_back.h"
#include "app/host/outputs.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "report/suggest/suggest.h"
#include "report/text/suggestion_text.h"
#include "source/read_file.h"
#include "source/render.h"
#include "source/write_file.h"

namespace rigor {
namespace {

bool is_there(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

/// Where the lines go: what is named, the sidecar that is read, or the one beside the notes.
std::string sidecar_to_write(const SuggestCommand& command, const FileReport& report) {
  if (command.into) return *command.into;
  if (!report.sidecar.empty()) return report.sidecar;
  return std::filesystem::path(command.file).replace_extension(".rigor").string();
}

/// Adds the lines at the end of what is there.
Result<void> append_lines(const std::string& path, const std::vector<PlacedLine>& lines) {
  const std::string added = "# found by `rigor suggest`\n" + sidecar_lines(lines);
  if (!is_there(path)) return write_file(path, added);
  auto text = read_file(path);
  if (!text) return tl::make_unexpected(text.error());
  if (!text->empty() && text->back() != '\n') *text += '\n';
  if (!text->empty()) *text += '\n';
  return replace_file(path, *text + added);
}

}  // namespace

ExitCode suggest_lines(const SuggestCommand& command, std::ostream& out, std::ostream& err) {
  const auto text = read_file(command.file);
  if (!text) {
    err << fmt::format("rigor: {}: {}\n", printable(command.file), text.error().reason);
    return ExitCode::no_input;
  }
  SuggestRequest request{.accepts_worse = command.all};
  request.options.sidecar = command.sidecar;
  if (!command.sidecar && command.into && is_there(*command.into)) request.options.sidecar = command.into;
  SourceMap sources;
  const Suggestions found = suggest_directives(sources, command.file, *text, request);
  if (found.report.unreadable) {
    for (const Diagnostic& each : found.report.diagnostics) err << render(each, sources);
    return ExitCode::no_input;
  }
  out << suggestion_text(found, terminal_options(command.color, out));
  if (!command.write) return ExitCode::ok;
  const std::vector<PlacedLine> lines = accepted_lines(found);
  const std::string path = sidecar_to_write(command, found.report);
  if (same_file(path, command.file)) {
    err << fmt::format("rigor: `{}` are the notes, and no sidecar\n", printable(path));
    return ExitCode::usage;
  }
  if (lines.empty()) return ExitCode::ok;
  if (const auto written = append_lines(path, lines); !written) {
    err << fmt::format("rigor: `{}` cannot be written: {}\n", printable(path), written.error().reason);
    return ExitCode::no_input;
  }
  out << fmt::format("added to {}\n", printable(path));
  return ExitCode::ok;
}

}  // namespace rigor
