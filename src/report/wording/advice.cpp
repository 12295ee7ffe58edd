// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/wording/figures.h"

namespace rigor {
namespace {

constexpr double alike = 8.0;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Without a value more often than another form is.
bool lacks_values(const TrialResult& trial, std::size_t form) {
  const std::size_t own = in_double(trial.forms[form]).undefined;
  return std::ranges::any_of(trial.forms,
                             [&](const FormResult& other) { return in_double(other).undefined < own; });
}

double error_on(const TrialResult& trial, std::size_t form) {
  return lacks_values(trial, form) ? infinite : failing_error(in_double(trial.forms[form]));
}

double loss_of(const TrialResult& trial, std::size_t form) {
  double least = infinite;
  for (std::size_t k = 0; k < trial.forms.size(); ++k) least = std::min(least, error_on(trial, k));
  if (std::isinf(least)) return 1.0;  // where all fail, none is worse
  const double error = error_on(trial, form);
  return std::max(error, unit_roundoff) / std::max(least, unit_roundoff);
}

/// The forms are equal there, and at least one of them can be compared to an exact value.
bool counts(const TrialResult& trial) {
  return trial.met && std::ranges::any_of(trial.forms, [](const FormResult& form) {
           return in_double(form).compared + in_double(form).zeros > 0;
         });
}

/// On the trial where it is greatest.
struct Loss {
  double factor = 1.0;
  const TrialResult* trial = nullptr;
};

Loss greatest_loss(const ChainResult& result, std::size_t form) {
  Loss greatest;
  for (const TrialResult& trial : result.trials) {
    if (!counts(trial)) continue;
    const double factor = loss_of(trial, form);
    if (greatest.trial == nullptr || factor > greatest.factor) greatest = {factor, &trial};
  }
  return greatest;
}

/// Over the trials, the median; where no time was measured, the operations.
double cost_of(const ChainResult& result, std::size_t form) {
  std::vector<double> times;
  for (const TrialResult& trial : result.trials) times.push_back(in_double(trial.forms[form]).nanoseconds);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  const double median = times[times.size() / 2];
  if (median > 0) return median;
  const ChainResult::Form& counted = result.forms[form];
  return static_cast<double>(counted.operations + counted.operations_per_particle);
}

bool has_times(const ChainResult& result) { return in_double(result.trials[0].forms[0]).nanoseconds > 0; }

std::string cost_text(const ChainResult& result, std::size_t form) {
  const double cost = cost_of(result, form);
  return has_times(result) ? fmt::format("{} ns", short_number(cost))
                           : fmt::format("{:.0f} operation{}", cost, cost == 1 ? "" : "s");
}

std::string error_text(const FormResult& form) {
  const ErrorMeasure& measure = in_double(form);
  const std::size_t samples = form.measure.measured;
  if (measure.undefined > 0 && measure.compared == 0)
    return fmt::format("has no value in {} of {}", measure.undefined, samples);
  if (measure.overflows > 0) return fmt::format("overflows in {} of {}", measure.overflows, samples);
  if (measure.not_a_number > 0)
    return fmt::format("is not a number in {} of {}", measure.not_a_number, samples);
  std::string text = fmt::format("errs by {}", short_number(failing_error(measure)));
  if (measure.wrong_signs > 0)
    text += fmt::format(" and has the wrong sign in {} of {}", measure.wrong_signs, samples);
  return text;
}

}  // namespace

double failing_error(const ErrorMeasure& measure) {
  if (measure.overflows > 0 || measure.not_a_number > 0) return infinite;
  if (measure.compared > 0) return measure.relative.worst;
  return measure.zeros > 0 ? measure.worst_at_zero : 0.0;
}

std::optional<Advice> advise(const ChainResult& all) {
  ChainResult result = all;
  std::erase_if(result.trials, [](const TrialResult& trial) { return !counts(trial); });
  const std::size_t count = result.forms.size();
  if (count < 2 || result.trials.empty() || !result.not_comparable.empty()) return std::nullopt;
  std::vector<double> losses;
  std::vector<double> costs;
  for (std::size_t k = 0; k < count; ++k) {
    losses.push_back(greatest_loss(result, k).factor);
    costs.push_back(cost_of(result, k));
  }
  const double least = std::ranges::min(losses);
  Advice advice;
  advice.all_alike = std::ranges::max(losses) <= alike * least;
  bool found = false;
  for (std::size_t k = 0; k < count; ++k) {
    if (losses[k] > alike * least || (found && costs[k] >= costs[advice.form])) continue;
    advice.form = k;
    found = true;
  }
  for (std::size_t k = 0; k < count; ++k) {
    bool beaten = false;
    for (std::size_t other = 0; other < count && !beaten; ++other) {
      const bool no_worse = losses[other] <= losses[k] && costs[other] <= costs[k];
      beaten = no_worse && (losses[other] < losses[k] || costs[other] < costs[k]);
    }
    if (!beaten) advice.fronts.push_back(k);
  }
  return advice;
}

std::string form_letter(std::size_t form) {
  return form < 26 ? std::string(1, static_cast<char>('A' + form)) : fmt::format("F{}", form + 1);
}

std::string advice_text(const ChainResult& result, const Advice& advice) {
  const std::string best = form_letter(advice.form);
  const std::string cost = cost_text(result, advice.form);
  if (advice.all_alike) {
    const std::size_t count = result.forms.size();
    const std::string all = count == 2 ? "Both forms" : fmt::format("All {} forms", count);
    return fmt::format("{} are equally accurate; {} is the cheapest ({}).", all, best, cost);
  }
  std::string text = fmt::format("Compute {} ({}).", best, cost);
  for (std::size_t k = 0; k < result.forms.size(); ++k) {
    const Loss loss = greatest_loss(result, k);
    if (k == advice.form || loss.factor <= alike) continue;
    const TrialResult& trial = *loss.trial;
    text += fmt::format(" {} ({}) {} on `{}`, where {} {}.", form_letter(k), cost_text(result, k),
                        error_text(trial.forms[k]), trial.name, best, error_text(trial.forms[advice.form]));
  }
  return text;
}

}  // namespace rigor
