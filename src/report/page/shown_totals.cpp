// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/shown_totals.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/page/shown_notes.h"

namespace rigor {
namespace {

std::string plural(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

void add_to(ShownTotals& totals, const FileReport& report) {
  for (const Step& step : report.steps) {
    ++totals.steps;
    ++totals.counts.at(static_cast<std::size_t>(step.verdict));
    if (needs_attention(step)) ++totals.attention;
    if (std::ranges::any_of(step.diagnostics,
                            [](const Diagnostic& each) { return each.severity() == Severity::warning; }))
      ++totals.warned;
  }
  for (const Diagnostic& each : report.diagnostics)
    ++(each.severity() == Severity::warning ? totals.remarks : totals.problems);
  if (!report.failure.empty()) ++totals.problems;
}

std::string attention_words(const ShownTotals& totals, std::string_view open, std::string_view close) {
  std::string words = totals.steps == 0 ? "There is no step to check" : plural(totals.steps, "step");
  if (totals.attention > 0) {
    words += fmt::format(": {}{} need{} attention{}", open, totals.attention,
                         totals.attention == 1 ? "s" : "", close);
  } else if (totals.steps > 0) {
    words += totals.problems > 0 ? ": none needs attention" : ", and nothing needs attention";
  }
  if (totals.problems > 0)
    words += fmt::format(", {} {}{}{} with the notes as a whole{}", totals.attention > 0 ? "and" : "but",
                         totals.steps == 0      ? ""
                         : totals.problems == 1 ? "there is "
                                                : "there are ",
                         open, plural(totals.problems, "problem"), close);
  if (totals.remarks > 0)
    words += fmt::format("; {}{}", plural(totals.remarks, "warning"),
                         totals.problems > 0 ? "" : " about the notes as a whole");
  return words;
}

std::string counted(Verdict verdict, std::size_t count) {
  if (verdict == Verdict::definition) return plural(count, "definition");
  std::string words(name_of(verdict));
  std::ranges::replace(words, '-', ' ');
  return fmt::format("{} {}", count, words);
}

}  // namespace rigor
