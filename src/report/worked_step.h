// SPDX-License-Identifier: GPL-3.0-or-later
// Why a proved step holds, in small steps, as LaTeX for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "expr/written_forms.h"
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
  std::string start;
  std::vector<WorkedLine> lines;
  std::optional<std::string> gap = {};  // why the other side was not reached
};

/// Of every step that is proved and no definition; in the order of the chains. Cost: up to some hundred small
/// decisions a step.
[[nodiscard]] std::vector<WorkedStep> worked_steps(WrittenForms& forms);

/// The one that belongs to these bytes of this file, if there is one that says something.
[[nodiscard]] const WorkedStep* worked_step_at(const std::vector<WorkedStep>& all, const SourceMap& sources,
                                               Span step);

}  // namespace rigor
