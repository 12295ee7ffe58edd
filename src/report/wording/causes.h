// SPDX-License-Identifier: GPL-3.0-or-later
// Why steps are open, most first: what an author with ten minutes should say before all else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/step/failure_rule.h"
#include "source/source_map.h"

namespace rigor {

/// Steps that are open or malformed for the same reason.
struct Cause {
  std::string words;                         // `nothing says whether `m` changes`; `…` where steps differ
  std::vector<std::string> directives = {};  // any of them may settle it: `constant m`; none: none can
  std::uint32_t steps = 0;
  std::uint32_t alone = 0;        // of these, steps that have no other cause
  std::vector<Span> places = {};  // of the steps, in the order of the report
};

/// First causes that a directive may settle, then the others; in each part those that alone keep most steps
/// open come first. Two diagnostics have the same cause if their help begins with the same directive, or else
/// if they are worded alike but for what they quote. What is known is left out.
[[nodiscard]] std::vector<Cause> causes_of(const Report& report, const KnownFindings& known = {});

/// The directives that a help line offers whole, without `rigor:`; one with `…` in it is only a pattern.
[[nodiscard]] std::vector<std::string> directives_in(const std::string& help);

/// At most a screen, unless `all`; each line ends with a line break. Empty with fewer than three open steps,
/// whose diagnostics say it all.
[[nodiscard]] std::string print_causes(const Report& report, const SourceMap& sources,
                                       const KnownFindings& known, bool all);

}  // namespace rigor
