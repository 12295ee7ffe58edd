// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <algorithm>
#include <utility>

#include "app/host/asked_places.h"
#include "app/host/progress.h"
#include "app/host/screen.h"
#include "check/entry/read_rows.h"
#include "report/read/reading_json.h"
#include "report/read/reading_text.h"
#include "source/render.h"

namespace rigor {
namespace {

std::vector<EquationPlace> places_of_rows(const NotesReading& reading) {
  std::vector<EquationPlace> places;
  for (const ReadRow& row : reading.rows) {
    const Step& step = reading.report.steps[row.step];
    places.push_back({step.tag, step.label, row.headings, step.span});
  }
  return places;
}

}  // namespace

ExitCode show_reading(const ReadCommand& command, std::ostream& out, std::ostream& err) {
  SourceMap sources;
  Progress progress(err, screen_of(err).is_terminal);
  NotesReading reading = read_rows(
      sources, command.file, {.sidecar = command.sidecar, .progress = [&](std::size_t done, std::size_t all) {
                                progress.update(command.file, done, all);
                              }});
  progress.clear();
  for (const Diagnostic& each : reading.report.diagnostics) {
    if (each.severity() == Severity::error) err << render(each, sources);
  }
  if (reading.report.unreadable) return ExitCode::no_input;
  const AskedPlaces places(command.places, places_of_rows(reading), reading.report.file, sources);
  if (!places.are_all_known(command.file, err)) return ExitCode::wrong;
  std::vector<ReadRow> wanted;
  for (std::size_t k = 0; k < reading.rows.size(); ++k) {
    if (places.wants(k)) wanted.push_back(std::move(reading.rows[k]));
  }
  reading.rows = std::move(wanted);
  out << (command.json ? reading_json(reading, sources)
                       : reading_text(reading, sources, terminal_options(command.color, out)));
  const bool unread = std::ranges::count(reading.rows, RowRole::unread, &ReadRow::role) > 0;
  return unread ? ExitCode::open : ExitCode::ok;
}

}  // namespace rigor
