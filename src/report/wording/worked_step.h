// SPDX-License-Identifier: GPL-3.0-or-later
// Why a proved step holds, in small steps, as LaTeX for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/step/report.h"
#include "expr/statement/written_forms.h"
#include "source/source_map.h"

namespace rigor {

struct WorkedLine {
  std::string relation;  // `=`, `\approx`
  std::string latex;
  std::string rule;  // in words
};

/// The step between two forms of a chain, from its left side on.
struct WorkedStep {
  Span span;  // of both sides; the notes may have been read a second time, so that only the path names the
              // file
  int image = 0;  // of "and cyclic permutations"
  std::string start;
  std::vector<WorkedLine> lines;
  std::optional<std::string> gap = {};  // why the other side was not reached
};

/// Of every step that is proved and no definition, cyclic images included; in the order of the chains. Cost:
/// up to some hundred small decisions a step.
[[nodiscard]] std::vector<WorkedStep> worked_steps(WrittenForms& forms);

/// Which image of "and cyclic permutations" the step is: 1 or 2; 0 for the statement itself, which alone is
/// written out in the step's sides.
[[nodiscard]] int cyclic_image_of(const Step& step);

/// The one that belongs to the step, if the step is proved and there is one that has lines or a gap.
[[nodiscard]] const WorkedStep* worked_step_of(const std::vector<WorkedStep>& all, const SourceMap& sources,
                                               const Step& step);

}  // namespace rigor
