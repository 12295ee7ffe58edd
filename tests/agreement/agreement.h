// SPDX-License-Identifier: GPL-3.0-or-later
// Two witnesses: what the exact side says of a step against both its sides evaluated in double, each with its
// error bound.
#pragma once

#include <span>
#include <string>

#include "expr/statement/statement.h"
#include "numeric/body/body.h"
#include "numeric/program/samples.h"

namespace rigor::agreement {

enum class Finding : std::uint8_t {
  related,      // the sides are as the claim says, within their bounds
  not_related,  // they are not, beyond their bounds
  open,         // a bound is infinite, or too large to tell
};

/// All components on all samples, for each particle that is free (together the same one). `uncertainty`: of
/// the inputs, relative. `detail` says where.
[[nodiscard]] Finding compare(const ExprTree& tree, const Question& question, const Samples& samples,
                              double uncertainty, std::string& detail);

/// At the place of a refutation's sample alone.
[[nodiscard]] Finding compare_at_sample(const ExprTree& tree, const Question& question, const Sample& sample,
                                        std::string& detail);

/// Do all assumptions hold on all samples, within their bounds?
[[nodiscard]] bool meets_assumptions(const ExprTree& tree, const Question& question, const Samples& samples,
                                     double uncertainty);

/// Numbers that meet the assumptions: exact ones from the exact side, families of numbers, and bodies.
struct Trials {
  std::vector<std::pair<std::string, Samples>> samples;
};
[[nodiscard]] Trials trials_for(const ExprTree& tree, const Question& question, std::span<const Body> bodies);

}  // namespace rigor::agreement
