// SPDX-License-Identifier: GPL-3.0-or-later
#include <rigor/rigor.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "api/checked_step.h"
#include "check/entry/check.h"
#include "report/text/terminal.h"

namespace rigor {
namespace {

static_assert(static_cast<int>(StepVerdict::suspect) == static_cast<int>(Verdict::suspect) &&
              verdict_count == 9);

/// The exact side's libraries share memory between threads without asking, so that only one call runs.
[[nodiscard]] std::unique_lock<std::mutex> turn() {
  static std::mutex taken;
  return std::unique_lock(taken);
}

/// So that test frameworks, which indent and break at 80 columns, leave the lines of a message whole.
constexpr std::uint32_t message_width = 76;

/// From what settles least of a chain to what settles most.
std::size_t rank_of(StepVerdict verdict) {
  constexpr std::array order{StepVerdict::refuted,   StepVerdict::suspect, StepVerdict::not_understood,
                             StepVerdict::undecided, StepVerdict::skipped, StepVerdict::definition,
                             StepVerdict::given,     StepVerdict::law,     StepVerdict::proved};
  return static_cast<std::size_t>(std::ranges::find(order, verdict) - order.begin());
}

/// The worst step of the statement, with all diagnostics of the others and of the context.
CheckedStep worst_of(const FileReport& file, const SourceMap& sources, std::size_t statement_begin,
                     std::string_view statement) {
  CheckedStep worst;
  worst.file = file.path;
  worst.statement = statement;
  bool found = false;
  bool all_hold = true;
  for (const Step& each : file.steps) {
    CheckedStep checked = checked_step(file, each, sources, false);
    all_hold = all_hold && checked.holds;
    const bool in_context = each.span.file != file.file || each.span.begin < statement_begin;
    if (in_context || (found && rank_of(checked.verdict) >= rank_of(worst.verdict))) continue;
    worst = std::move(checked);
    found = true;
  }
  const RestOfNotes rest = rest_of_notes(file, sources, false);
  worst.holds = found && all_hold && !rest.wrong;
  worst.message = print_diagnostics(file, sources, {.width = message_width});
  if (worst.message.starts_with('\n')) worst.message.erase(0, 1);
  if (!found && worst.message.empty()) worst.message = "there is no relation in `" + worst.statement + "`\n";
  return worst;
}

}  // namespace

CheckedStep step(std::string_view statement, std::string_view context) {
  const auto lock = turn();
  std::string text(context);
  if (!text.empty() && !text.ends_with('\n')) text += '\n';
  const std::size_t begin = text.size();
  text.append("\\[ ").append(statement).append(" \\]\n");
  SourceMap sources;
  const FileReport file = check_text(sources, "<statement>.tex", std::move(text));
  return worst_of(file, sources, begin, statement);
}

CheckedNotes notes(const std::string& path, const NotesOptions& options) {
  const auto lock = turn();
  SourceMap sources;
  CheckOptions check_options;
  if (!options.sidecar.empty()) check_options.sidecar = options.sidecar;
  const FileReport file = check_file(sources, path, check_options);
  CheckedNotes checked;
  checked.file = path;
  checked.readable = !file.unreadable;
  checked.all_hold = checked.readable;
  for (const Step& each : file.steps) {
    checked.steps.push_back(checked_step(file, each, sources, options.strict));
    checked.all_hold = checked.all_hold && checked.steps.back().holds;
  }
  checked.all_hold = checked.all_hold && !rest_of_notes(file, sources, options.strict).wrong;
  checked.message = print_diagnostics(file, sources);
  if (checked.message.starts_with('\n')) checked.message.erase(0, 1);
  return checked;
}

}  // namespace rigor
