// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/bench_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>

#include "report/picture/plot.h"
#include "report/wording/advice.h"
#include "report/wording/figures.h"

namespace rigor {
namespace {

constexpr std::array<const char*, arithmetic_count> arithmetic_names{"float", "double", "long double",
                                                                     "double-double"};

constexpr std::array<const char*, arithmetic_count> short_names{"float", "double", "long", "dd"};

const ErrorMeasure& at(const TrialResult& trial, std::size_t form, std::size_t arithmetic) {
  return trial.forms[form].measure.arithmetics[arithmetic];
}

constexpr auto plain = static_cast<std::size_t>(Arithmetic::plain);

/// By how many digits the forms differ in double.
double spread_of(const TrialResult& trial) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t form = 0; form < trial.forms.size(); ++form) {
    const double error = std::max(failing_error(at(trial, form, plain)), unit_roundoff);
    least = std::min(least, error);
    most = std::max(most, error);
  }
  if (std::isinf(least)) return 0;
  return std::isinf(most) ? 1000 : std::log10(most / least);
}

Plot panel(const TrialResult& trial) {
  Plot plot{.title = trial.name,
            .x = {.label = "ns an evaluation", .logarithmic = true},
            .y = {.label = "worst relative error", .logarithmic = true},
            .series = {}};
  for (std::size_t form = 0; form < trial.forms.size(); ++form) {
    PlotSeries series{
        .name = form_letter(form), .points = {}, .mark = mark_at(form), .stroke = Stroke::none, .colour = -1};
    for (std::size_t k = 0; k < arithmetic_count; ++k)
      series.points.push_back(
          {at(trial, form, k).nanoseconds, failing_error(at(trial, form, k)), short_names[k]});
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(pareto_front("not beaten", plot.series));
  return plot;
}

/// What a cell says next to the error.
std::string event(const ErrorMeasure& measure) {
  if (measure.overflows > 0) return " (overflow)";
  if (measure.not_a_number > 0) return " (not a number)";
  if (measure.wrong_signs > 0) return fmt::format(" ({} wrong signs)", measure.wrong_signs);
  return "";
}

std::string cell(const ErrorMeasure& measure) {
  if (measure.compared == 0) return measure.zeros > 0 ? "exactly 0" : "";
  return short_number(failing_error(measure)) + event(measure);
}

double median_time(const ChainResult& result, std::size_t form, std::size_t arithmetic) {
  std::vector<double> times;
  for (const TrialResult& trial : result.trials) times.push_back(at(trial, form, arithmetic).nanoseconds);
  std::ranges::sort(times);
  return times[times.size() / 2];
}

/// A bar would end the cell.
std::string in_table(std::string text) {
  for (std::size_t k = text.find('|'); k != std::string::npos; k = text.find('|', k + 2))
    text.insert(k, "\\");
  return text;
}

}  // namespace

std::vector<std::size_t> telling_trials(const ChainResult& result, std::size_t most) {
  std::vector<std::size_t> order(result.trials.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return spread_of(result.trials[a]) > spread_of(result.trials[b]);
  });
  order.resize(std::min(order.size(), most));
  std::ranges::sort(order);
  return order;
}

std::string bench_picture(const EvaluatedChain& evaluated, const std::vector<std::size_t>& trials) {
  std::vector<Plot> panels;
  for (const std::size_t trial : trials) panels.push_back(panel(evaluated.result.trials[trial]));
  return to_svg(panels);
}

std::string bench_markdown(const EvaluatedChain& evaluated, const std::vector<std::size_t>& trials,
                           const SourceMap& sources, const std::optional<std::string>& picture) {
  const auto& [chain, result] = evaluated;
  std::string text = fmt::format("### {}\n\n", place_of(*chain, sources));
  for (std::size_t k = 0; k < result.forms.size(); ++k)
    text += fmt::format("* {}: `{}`\n", form_letter(k), chain->forms[result.forms[k].side].source);
  if (const auto advice = advise(result)) text += fmt::format("\n{}\n", advice_text(result, *advice));
  if (picture) text += fmt::format("\n![time against error]({})\n", *picture);
  text += "\n| form | arithmetic | ns |";
  for (const std::size_t trial : trials) text += fmt::format(" {} |", in_table(result.trials[trial].name));
  text += "\n|---|---|---:|";
  for (std::size_t k = 0; k < trials.size(); ++k) text += "---:|";
  text += "\n";
  for (std::size_t form = 0; form < result.forms.size(); ++form) {
    for (std::size_t k = 0; k < arithmetic_count; ++k) {
      text += fmt::format("| {} | {} | {} |", form_letter(form), arithmetic_names[k],
                          short_number(median_time(result, form, k)));
      for (const std::size_t trial : trials)
        text += fmt::format(" {} |", cell(at(result.trials[trial], form, k)));
      text += "\n";
    }
  }
  return text + "\n";
}

std::string bench_rows_head() {
  return "### Equally accurate forms\n\n| place | forms | cheapest | ns | worst error "
         "|\n|---|---:|---|---:|---:|\n";
}

std::string bench_row(const EvaluatedChain& evaluated, const SourceMap& sources) {
  const auto& [chain, result] = evaluated;
  const auto advice = advise(result);
  if (!advice) return "";
  double worst = 0;
  for (const TrialResult& trial : result.trials)
    worst = std::max(worst, failing_error(at(trial, advice->form, plain)));
  return fmt::format("| {} | {} | `{}` | {} | {} |\n", place_of(*chain, sources), result.forms.size(),
                     in_table(chain->forms[result.forms[advice->form].side].source),
                     short_number(median_time(result, advice->form, plain)), short_number(worst));
}

std::string file_name_of(const WrittenFormChain& chain, const SourceMap& sources) {
  std::string name = std::filesystem::path(sources.path(chain.span.file)).stem().string();
  std::string tag;
  for (const char c : chain.tag) {
    const bool fits = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (fits) tag += c;
  }
  const std::uint32_t line = sources.line_column(chain.span.file, chain.span.begin).line;
  name += tag.empty() ? fmt::format("-line-{}", line) : fmt::format("-{}", tag);
  return chain.image > 0 ? fmt::format("{}-{}", name, chain.image) : name;
}

}  // namespace rigor
