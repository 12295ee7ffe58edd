// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "report/text/terminal.h"
#include "report/wording/diagnostics_of.h"

namespace rigor {
namespace {

std::string count_of(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string print_time(double milliseconds) {
  return fmt::format("{:.{}f} ms", milliseconds, milliseconds < 10 ? 1 : 0);
}

struct Extras {
  std::size_t steps = 0;
  std::size_t expected = 0;  // refuted, as a directive says
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t silenced = 0;
};

Extras count_extras(const Report& report) {
  Extras extras;
  for (const FileReport& file : report.files) {
    extras.steps += file.steps.size();
    extras.silenced += file.silenced.size();
    for (const Step& step : file.steps)
      if (step.verdict == Verdict::refuted && step.expected_refuted) ++extras.expected;
    for (const PlacedDiagnostic& placed : diagnostics_of(file)) {
      if (placed.diagnostic->severity() == Severity::error) ++extras.errors;
      if (placed.diagnostic->severity() == Severity::warning) ++extras.warnings;
    }
  }
  return extras;
}

}  // namespace

std::string print_summary(const Report& report) {
  const Extras extras = count_extras(report);
  const auto count = [&](Verdict verdict) { return report.counts[static_cast<std::size_t>(verdict)]; };
  std::string text = count_of(extras.steps, "step");
  if (report.files.size() > 1) text += fmt::format(" in {} files", report.files.size());
  text += fmt::format(": {} proved, {}, {} given, ", count(Verdict::proved),
                      count_of(count(Verdict::definition), "definition"), count(Verdict::given));
  if (count(Verdict::law) > 0) text += count_of(count(Verdict::law), "law") + ", ";
  text += fmt::format("{} refuted", count(Verdict::refuted));
  if (extras.expected > 0) text += fmt::format(" ({} as expected)", extras.expected);
  if (count(Verdict::suspect) > 0) text += fmt::format(", {} suspect", count(Verdict::suspect));
  text += fmt::format("; {} undecided, {} not understood, {} skipped", count(Verdict::undecided),
                      count(Verdict::not_understood), count(Verdict::skipped));
  if (extras.errors > 0) text += "; " + count_of(extras.errors, "error");
  if (extras.warnings > 0) text += (extras.errors > 0 ? ", " : "; ") + count_of(extras.warnings, "warning");
  if (extras.silenced > 0) text += fmt::format("; {} silenced", extras.silenced);
  return text + "; " + print_time(report.milliseconds);
}

}  // namespace rigor
