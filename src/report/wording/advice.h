// SPDX-License-Identifier: GPL-3.0-or-later
// Which of several forms to compute in double, and why, in a sentence or two.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "numeric/advice/chain_results.h"

namespace rigor {

/// What a form's worst error amounts to on a trial: the relative one, infinite where a result is not a number
/// or overflows; where all exact values are 0, the greatest result.
[[nodiscard]] double failing_error(const ErrorMeasure& measure);

/// A form without a value where another has one fails. A form is the safest if its worst loss is the least:
/// the loss on a trial is its error over the least error of any form there, taken as u at least. Forms within
/// a factor of 8 of the safest are as good; the fastest of them is advised.
struct Advice {
  std::size_t form = 0;             // of ChainResult::forms
  bool all_alike = false;           // no form's greatest loss is over 8 times the least one
  std::vector<std::size_t> fronts;  // forms that no other beats in greatest loss and time together
};

/// Nothing with fewer than two forms, without a trial, or where the forms are not proved to be equal.
[[nodiscard]] std::optional<Advice> advise(const ChainResult& result);

/// In words; forms are named by their letters.
[[nodiscard]] std::string advice_text(const ChainResult& result, const Advice& advice);

/// `A`, `B`, … for the forms of a chain, in their order.
[[nodiscard]] std::string form_letter(std::size_t form);

}  // namespace rigor
