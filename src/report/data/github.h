// SPDX-License-Identifier: GPL-3.0-or-later
// A report as workflow commands of GitHub Actions, which shows them at the lines of a change:
//
//   ::error file=notes/vectors.tex,line=12,endLine=12,col=28,endColumn=29,title=refuted::the sides differ…
//
// What is wrong is an error, what is open or a warning a warning; a refutation that is expected is nothing.
#pragma once

#include <string>

#include "report/wording/check_format.h"
#include "source/source_map.h"

namespace rigor {

/// A line a diagnostic, in the order of the text report, and its summary as the last line.
[[nodiscard]] std::string to_github(const Report& report, const SourceMap& sources,
                                    const CheckFormat& options);

}  // namespace rigor
