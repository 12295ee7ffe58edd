// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/eval_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/paint.h"
#include "base/utf8.h"
#include "report/wording/advice.h"
#include "report/wording/figures.h"

namespace rigor {
namespace {

constexpr std::size_t longest_value = 36;

constexpr std::array<const char*, 8> heads{"", "value", "error", "median", "ulp", "bits", "condition", "ns"};
using TrialRow = std::array<std::string, heads.size()>;

/// What cannot be said in a column.
std::string events(const TrialResult& trial, const FormResult& form) {
  const ErrorMeasure& measure = in_double(form);
  const std::size_t samples = form.measure.measured;
  std::vector<std::string> texts;
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) texts.push_back(fmt::format("{} {} of {}", what, count, samples));
  };
  if (!trial.met) texts.emplace_back("the assumptions do not hold here");
  if (samples == 0 && trial.samples > 0) texts.emplace_back("too large to be compared with exact values");
  say(measure.overflows, "overflow in");
  say(measure.not_a_number, "not a number in");
  say(measure.wrong_signs, "wrong sign in");
  if (measure.zeros > 0)
    texts.push_back(fmt::format("exactly 0 in {} of {}, computed up to {}", measure.zeros, samples,
                                short_number(measure.worst_at_zero)));
  say(measure.undefined, "no value in");
  say(measure.unknown, "exact value not known in");
  return fmt::format("{}", fmt::join(texts, "; "));
}

TrialRow row_of(const TrialResult& trial, const FormResult& form) {
  const ErrorMeasure& measure = in_double(form);
  TrialRow row;
  row[0] = printable(trial.name);
  row[1] = shorten(value_text(form.first), longest_value);
  if (measure.compared > 0) {
    row[2] = short_number(measure.relative.worst);
    row[3] = short_number(measure.relative.median);
    row[4] = short_number(measure.ulps.worst);
    row[5] = fmt::format("{:.1f}", std::abs(measure.bits_kept.worst));
  }
  if (form.measure.condition_known > 0) row[6] = short_number(form.measure.condition.worst);
  if (measure.nanoseconds > 0) row[7] = short_number(measure.nanoseconds);
  return row;
}

std::string aligned(const TrialRow& row, const std::array<std::size_t, heads.size()>& widths) {
  std::string line = "     ";
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (widths[k] == 0) continue;
    const std::string blanks(widths[k] - cells(row[k]), ' ');
    line += " " + (k == 0 ? row[k] + blanks : " " + blanks + row[k]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// The table of one form.
std::string table(const ChainResult& result, std::size_t form, bool color) {
  std::vector<std::pair<TrialRow, std::string>> rows;
  std::array<std::size_t, heads.size()> widths{};
  for (const TrialResult& trial : result.trials) {
    rows.emplace_back(row_of(trial, trial.forms[form]), events(trial, trial.forms[form]));
    for (std::size_t k = 0; k < heads.size(); ++k)
      widths[k] = std::max(widths[k], cells(rows.back().first[k]));
  }
  TrialRow head;
  for (std::size_t k = 0; k < heads.size(); ++k) {
    if (widths[k] == 0) continue;
    head[k] = heads[k];
    widths[k] = std::max(widths[k], head[k].size());
  }
  std::string text = paint(aligned(head, widths), Paint::faint, color) + "\n";
  for (const auto& [row, event] : rows) {
    text += aligned(row, widths);
    if (!event.empty()) text += "   " + paint(event, Paint::open, color);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string place_of(const WrittenFormChain& chain, const SourceMap& sources) {
  std::string place = fmt::format("{}:{}", printable(sources.path(chain.span.file)),
                                  sources.line_column(chain.span.file, chain.span.begin).line);
  if (!chain.tag.empty())
    place += chain.tag.starts_with('(') ? " " + chain.tag : fmt::format(" ({})", chain.tag);
  if (chain.image > 0) place += fmt::format(", cyclic image {}", chain.image);
  return place;
}

std::string print_evaluation(const EvaluatedNotes& notes, const SourceMap& sources,
                             const TerminalOptions& options) {
  std::string text;
  for (const auto& [chain, result] : notes.chains) {
    text += paint(place_of(*chain, sources), Paint::strong, options.color) + "\n";
    if (!result.taken_for.empty()) text += fmt::format("  of the bodies: {}\n", printable(result.taken_for));
    for (const ChainResult::LeftOut& each : result.left_out)
      text += fmt::format("  {}\n      not evaluated: {}\n", printable(chain->forms[each.side].source),
                          printable(each.why));
    for (std::size_t k = 0; k < result.forms.size(); ++k) {
      text += fmt::format("  {}  {}\n", form_letter(k), printable(chain->forms[result.forms[k].side].source));
      text += result.trials.empty() ? fmt::format("      not evaluated: {}\n", result.no_trials)
                                    : table(result, k, options.color);
    }
    if (const auto advice = advise(result)) text += "  " + printable(advice_text(result, *advice)) + "\n";
    text += "\n";
  }
  return text;
}

}  // namespace rigor
