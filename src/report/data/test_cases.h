// SPDX-License-Identifier: GPL-3.0-or-later
// A report on one file of notes as cases for a test runner: one a step, and one for all that is said of no
// step. Their names hold while the notes keep their tags:
//
//   notes/euler (6) step 2          the second step with the tag (6)
//   notes/euler line 57             a step without a tag; `line 57 step 2`, if it is not the first there
//   notes/euler: parts/a.tex (1) step 1     a step in a file that the notes read
//   notes/euler (whole file)        unused directives, bad macros, ...
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

enum class CaseOutcome : std::uint8_t { passed, failed, open };

struct TestCase {
  std::string name;  // printable, on one line; no two of a file are the same
  CaseOutcome outcome = CaseOutcome::passed;
  std::string text;  // the place and the verdict; of what did not pass, why: diagnostics, sample, repair
};

struct TestCaseOptions {
  std::string name;     // of the notes: what each case begins with
  bool strict = false;  // warnings count as errors
};

/// In the order of the notes; the case of the whole file comes last.
[[nodiscard]] std::vector<TestCase> test_cases(const FileReport& file, const SourceMap& sources,
                                               const TestCaseOptions& options);

/// As one JSON object that `read_test_cases` reads. Ends with a line break.
[[nodiscard]] std::string test_cases_json(const std::vector<TestCase>& cases);
/// Never throws, whatever the text is.
[[nodiscard]] Result<std::vector<TestCase>> read_test_cases(std::string_view json);

}  // namespace rigor
