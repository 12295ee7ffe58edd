// SPDX-License-Identifier: GPL-3.0-or-later
// A report as JUnit XML, as Jenkins, GitLab and others read it: a `testsuite` a file, a `testcase` a step,
// named after its tag and text; what belongs to no step is a test case of its own. There is a failure or an
// error exactly where `rigor check` does not end with 0. `docs/formats.md` describes it.
#pragma once

#include <string>

#include "report/wording/check_format.h"
#include "source/source_map.h"

namespace rigor {

/// Well-formed UTF-8 whatever the notes hold. Only the values of `time` differ between two runs.
[[nodiscard]] std::string to_junit(const Report& report, const SourceMap& sources,
                                   const CheckFormat& options);

}  // namespace rigor
