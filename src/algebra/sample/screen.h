// SPDX-License-Identifier: GPL-3.0-or-later
// Many claims that are much alike, most of them false: which of them hold on a few exact samples that meet
// the assumptions? What passes is not proved.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algebra/engine/limits.h"
#include "expr/statement/statement.h"

namespace rigor {

enum class Screened : std::uint8_t { holds, fails, not_compared };

class SampleScreen {
 public:
  /// Draws the samples for the question's claim and other expressions, with its definitions and assumptions.
  /// The tree may not grow afterwards.
  SampleScreen(const Question& question, std::span<const ExprId> also, const Limits& limits = {});
  ~SampleScreen();
  SampleScreen(const SampleScreen&) = delete;
  SampleScreen& operator=(const SampleScreen&) = delete;

  /// With the same samples, for the tree as it has grown since. Counts the work of drawing them once more, as
  /// if they were.
  [[nodiscard]] std::unique_ptr<SampleScreen> after_growth() const;

  /// For each claim: does it hold wherever it was compared? A claim is compared only if the samples have all
  /// its symbols, and it has values there. What is not rational is enclosed; what cannot be told apart holds.
  [[nodiscard]] std::vector<Screened> screened(std::span<const Equation> claims);
  /// Was it compared, and does it hold?
  [[nodiscard]] std::vector<bool> passing(std::span<const Equation> claims);
  /// For each term, given as `term = 0` with the free indices of the claim: the number c ≠ 0 for which
  /// left − right = c · term on all samples; as exact text; none if there is none.
  [[nodiscard]] std::vector<std::optional<std::string>> multiples(const Equation& claim,
                                                                  std::span<const Equation> terms);

 private:
  class Samples;
  class InParts;
  SampleScreen(const Question& question, const Limits& limits);
  Question question_;
  Limits limits_;
  std::unique_ptr<Samples> samples_;  // none: the question is about complex numbers
};

}  // namespace rigor
