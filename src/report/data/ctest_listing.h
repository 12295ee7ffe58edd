// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of some notes as a script that ctest reads before it runs anything.
#pragma once

#include <string>
#include <vector>

#include "report/data/test_cases.h"

namespace rigor {

/// Adds a test for each case, which runs `${rigor_program} case ${rigor_results} NAME`, needs
/// `${rigor_fixture}`, has `${rigor_labels}` and is skipped if it ends with `${rigor_skip_code}`. If a file
/// that was read has changed since, as far as the dates of the files and of `${rigor_listing}` say, it adds
/// nothing and sets `rigor_stale`, unless `rigor_listed` says that it was written just now. Names and paths
/// may have any characters.
[[nodiscard]] std::string ctest_listing(const std::vector<TestCase>& cases, const FileReport& file,
                                        const SourceMap& sources);

/// A text as one argument in CMake, whatever its characters are.
[[nodiscard]] std::string cmake_argument(const std::string& text);

}  // namespace rigor
