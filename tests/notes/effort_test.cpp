// SPDX-License-Identifier: GPL-3.0-or-later
// No step of our notes takes more work than a step has by default, nor comes near it.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "catch.h"
#include "check/check.h"

using namespace rigor;

TEST_CASE("no step takes more work than a third of the default", "[notes]") {
  std::uint64_t most = 0;
  for (const char* folder : {"../../derivations", "pass", "fail"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".md" && extension != ".tex") continue;
      SourceMap sources;
      const FileReport report = check_file(sources, entry.path().string());
      for (const Step& step : report.steps) {
        INFO(report.path << ": " << step.source);
        CHECK(step.work < default_effort / 3);
        most = std::max(most, step.work);
      }
    }
  }
  CHECK(most > 1000);
}
