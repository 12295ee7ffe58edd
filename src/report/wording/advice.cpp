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
constexpr double digits_of_double = 16;
constexpr double least_shown = 0.5;  // of lost digits
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

/// What a form does at a point, without the point. Nothing where the measured errors do not show a loss: the
/// search goes by expected ones.
std::string fault_of(const FormResult& form, const FormResult& best) {
  const ErrorMeasure& measure = in_double(form);
  if (measure.overflows > 0) return "overflows";
  if (measure.not_a_number > 0) return "is not a number";
  if (measure.compared == 0) return "has no value";
  if (std::ranges::all_of(form.first, [](double x) { return x == 0; })) return "gives 0";
  const double error = std::max(measure.relative.worst, unit_roundoff);
  const double other = std::max(in_double(best).relative.worst, unit_roundoff);
  const double lost = std::clamp(std::log10(error / other), 0.0, digits_of_double);
  if (lost < least_shown) return "";
  std::string text = lost >= digits_of_double - 0.5
                         ? "has no right digit"
                         : fmt::format("loses {:.0f} of 16 digits", std::max(lost, 1.0));
  if (measure.wrong_signs > 0)
    text += lost >= digits_of_double - 0.5 ? " and not the right sign" : " and its sign";
  return text;
}

/// ` A (2 operations) loses 8 of 16 digits at x = 1e-08: it errs by 6.1e-09, B by 1.1e-16.`
std::string loss_text(const ChainResult& result, const WorstPoint& worst, std::size_t best) {
  const FormResult& here = worst.forms[worst.form];
  const std::string fault = fault_of(here, worst.forms[best]);
  if (fault.empty()) return "";
  std::string text = fmt::format(" {} ({}) {} at {}", form_letter(worst.form), cost_text(result, worst.form),
                                 fault, worst.at);
  const ErrorMeasure& own = in_double(here);
  const ErrorMeasure& other = in_double(worst.forms[best]);
  if (own.compared == 0 || other.compared == 0) return text + ".";
  const std::string others = fmt::format("{} by {}", form_letter(best), short_number(failing_error(other)));
  if (own.overflows + own.not_a_number > 0)
    return fmt::format("{}, where {} errs{}.", text, form_letter(best),
                       others.substr(form_letter(best).size()));
  return fmt::format("{}: it errs by {}, {}.", text, short_number(failing_error(own)), others);
}

/// The form that loses least where it loses most.
std::size_t least_losing(const SearchResult& search) {
  const auto least = std::ranges::min_element(search.losing, {}, [](const WorstPoint& worst) {
    return failing_error(in_double(worst.forms[worst.form]));
  });
  return least == search.losing.end() ? 0 : least->form;
}

bool is_alike(const SearchResult& search) {
  return search.ranges.size() == 1 && search.ranges[0].losing.empty();
}

std::string search_text(const ChainResult& result, const SearchResult& search) {
  if (search.ranges.empty()) {
    std::string text = "No form keeps its digits in a range that has a name.";
    for (const WorstPoint& worst : search.losing) {
      std::size_t best = 0;
      for (std::size_t k = 0; k < worst.forms.size(); ++k) {
        if (failing_error(in_double(worst.forms[k])) < failing_error(in_double(worst.forms[best]))) best = k;
      }
      text += loss_text(result, worst, best);
    }
    return text;
  }
  const FormForRange& first = search.ranges[0];
  const auto named = [&](const FormForRange& range) {
    return fmt::format("{} ({}){}", form_letter(range.form), cost_text(result, range.form), range.where);
  };
  if (is_alike(search)) {
    const std::size_t count = result.forms.size();
    const std::string all = count == 2 ? "Both forms" : fmt::format("All {} forms", count);
    return fmt::format("{} are equally accurate{}; {} is the cheapest ({}).", all, first.where,
                       form_letter(first.form), cost_text(result, first.form));
  }
  std::string text = "Compute " + named(first);
  text += search.ranges.size() == 1 ? "." : fmt::format(", and {}.", named(search.ranges[1]));
  for (const FormForRange& range : search.ranges) {
    for (const WorstPoint& worst : range.losing) text += loss_text(result, worst, range.form);
  }
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
  const bool has_grounds = !result.trials.empty() || result.search.has_value();
  if (count < 2 || !has_grounds || !result.not_comparable.empty()) return std::nullopt;
  std::vector<double> losses;
  std::vector<double> costs;
  for (std::size_t k = 0; k < count; ++k) {
    losses.push_back(greatest_loss(result, k).factor);
    costs.push_back(cost_of(all, k));
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
  if (result.search) {
    const SearchResult& search = *result.search;
    advice.form = search.ranges.empty() ? least_losing(search) : search.ranges[0].form;
    advice.all_alike = is_alike(search);
  }
  return advice;
}

std::string form_letter(std::size_t form) {
  return form < 26 ? std::string(1, static_cast<char>('A' + form)) : fmt::format("F{}", form + 1);
}

std::string advice_text(const ChainResult& result, const Advice& advice) {
  if (result.search) return search_text(result, *result.search);
  const std::string best = form_letter(advice.form);
  const std::string cost = cost_text(result, advice.form);
  const std::string there = result.at_given_numbers ? " at these numbers" : "";  // one point says no more
  if (advice.all_alike) {
    const std::size_t count = result.forms.size();
    const std::string all = count == 2 ? "Both forms" : fmt::format("All {} forms", count);
    return fmt::format("{} are equally accurate{}; {} is the cheapest ({}).", all, there, best, cost);
  }
  std::string text = fmt::format("Compute {} ({}){}.", best, cost, there);
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
