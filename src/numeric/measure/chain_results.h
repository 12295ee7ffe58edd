// SPDX-License-Identifier: GPL-3.0-or-later
// How the forms of one chain fare in floating point: each on several trials, which are families of numbers or
// sample bodies.
#pragma once

#include <cstddef>
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
};

struct TrialOptions {
  bool times = true;
  std::size_t samples = 1024;          // of a trial, at most; at least 16
  std::size_t operations = 4'000'000;  // with many digits, for one form on one trial
  std::uint64_t seed = 1;
};

/// With bodies, one trial for each and any spin; without, the families that concern the forms' letters.
[[nodiscard]] ChainResult measure_chain(const WrittenForms& forms, const WrittenFormChain& chain,
                                        std::span<const Body> bodies, const TrialOptions& options = {});

}  // namespace rigor
