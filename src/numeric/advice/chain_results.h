// SPDX-License-Identifier: GPL-3.0-or-later
// How the forms of one chain fare in floating point: each on several trials, which are families of numbers or
// sample bodies; and which of them to compute where, as a search of all numbers shows.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expr/statement/written_forms.h"
#include "numeric/body/body.h"
#include "numeric/measure/measure.h"

namespace rigor {

/// One form on one trial.
struct FormResult {
  std::vector<double> first;  // what it is worth on the first sample, in double, by components
  FormMeasure measure;
};
[[nodiscard]] inline const ErrorMeasure& in_double(const FormResult& form) {
  return form.measure.arithmetics[static_cast<std::size_t>(Arithmetic::plain)];
}

struct TrialResult {
  std::string name;  // `random`, `book`
  std::string what;  // one line
  std::size_t samples = 0;
  bool met = true;                // the assumptions in force hold on the samples, within error bounds
  std::size_t particles = 0;      // 0: nothing is summed over them
  std::vector<FormResult> forms;  // in the order of ChainResult::forms
};

/// The point at which a form loses most on the best one there: values for all letters, with all their digits.
struct WorstPoint {
  std::size_t form = 0;
  std::string at;  // `x = 1e-09, y = 3`
  std::map<std::string, std::vector<double>> values;
  std::vector<FormResult> forms;  // there, in the order of ChainResult::forms
};

/// One form for a range of numbers.
struct FormForRange {
  std::size_t form = 0;
  std::string where;               // ` where b > 0`, ` for numbers up to 8`; empty: everywhere
  std::vector<WorstPoint> losing;  // the other forms that lose digits there
};

/// What a search of all numbers within the conditions of the notes found.
struct SearchResult {
  std::vector<FormForRange>
      ranges;  // at most two; none: each form loses somewhere in any range that has a name
  std::vector<WorstPoint> losing;  // then
};

struct ChainResult {
  /// A form that was evaluated; others are not computed from anything, or name one that is.
  struct Form {
    std::size_t side = 0;                     // of the chain
    std::size_t operations = 0;               // once a sample
    std::size_t operations_per_particle = 0;  // and so many more for each particle
  };
  struct LeftOut {
    std::size_t side = 0;
    std::string why;
  };
  std::vector<Form> forms;
  std::vector<LeftOut> left_out;    // what could not be evaluated
  std::vector<TrialResult> trials;  // none: no form was evaluated
  std::string not_comparable;       // why no form can stand for another: a step that is not a proved equality
  std::string taken_for;            // with bodies: which letters were taken for masses and positions
  std::string no_trials;            // why not, if there are forms
  bool at_given_numbers = false;    // TrialOptions::values were given: the only trial is of them
  std::optional<SearchResult> search;  // only without bodies and particles, of forms that can be compared
};

/// Of a form, in nanoseconds: over the trials, the median. Where no time was measured, the operations.
[[nodiscard]] double cost_of(const ChainResult& result, std::size_t form);
[[nodiscard]] bool has_times(const ChainResult& result);

struct TrialOptions {
  bool times = true;
  std::size_t samples = 1024;          // of a trial, at most; at least 16
  std::size_t operations = 4'000'000;  // with many digits, for one form on one trial
  std::uint64_t seed = 1;
  std::map<std::string, std::vector<double>> values = {};  // of letters by name: the only trial
};

/// With bodies, one trial for each and any spin; without, the families that concern the forms' letters, and a
/// search.
[[nodiscard]] ChainResult measure_chain(const WrittenForms& forms, const WrittenFormChain& chain,
                                        std::span<const Body> bodies, const TrialOptions& options = {});

}  // namespace rigor
