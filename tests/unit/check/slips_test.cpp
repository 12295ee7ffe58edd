// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "catch.h"
#include "check/checked.h"

namespace rigor {
namespace {

/// What is said of each refuted step: its help, and where the first wrong step is if it is another.
std::string slips_in(const std::string& chain) {
  const Checked checked(rigor_says("for all a, b, c") + "$$" + chain + "$$\n");
  std::string text;
  for (const Step& step : checked.report.steps) {
    if (step.verdict != Verdict::refuted) continue;
    for (const Diagnostic& diagnostic : step.diagnostics) {
      for (const std::string& help : diagnostic.help) text += help + "\n";
      for (const Label& label : diagnostic.labels) {
        if (label.text.empty()) continue;
        const LineColumn place = checked.sources.line_column(label.span.file, label.span.begin);
        text += std::to_string(place.column) + ": " + label.text + "\n";
      }
    }
  }
  return text;
}

TEST_CASE("a slip that the next step undoes is that of one side alone") {
  CHECK(slips_in("a + b = a - b = b + a") ==
        "`a - b` alone is wrong: `a + b = b + a` holds\n"
        "this step takes back the slip of the first wrong one: `a + b = b + a` holds\n"
        "9: the first wrong step of the chain\n");
}

TEST_CASE("a slip that is undone two steps later") {
  CHECK(slips_in("a(b + c) = ab - ac = -ac + ab = ac + ab") ==
        "the slip is undone later: `a(b + c) = ac + ab` holds\n"
        "this step takes back the slip of the first wrong one: `a(b + c) = ac + ab` holds\n"
        "12: the first wrong step of the chain\n");
}

TEST_CASE("a slip that stays to the end of the chain, or is at its end") {
  CHECK(slips_in("(a - b)^2 = a^2 - b^2 = (a + b)(a - b)") ==
        "the slip stays to the end of the chain: `(a - b)^2 = (a + b)(a - b)` does not hold, either\n");
  CHECK(slips_in("a + b = b + a = b - a") == "");
  CHECK(slips_in("a + b = b - a") == "");
}

TEST_CASE("a second slip on top of the first one") {
  CHECK(slips_in("a(b + c) = ab - ac = ab") ==
        "the slip stays to the end of the chain: `a(b + c) = ab` does not hold, either\n"
        "a further slip: the step is wrong even if the first wrong one is mended\n"
        "12: the first wrong step of the chain\n");
}

TEST_CASE("the chain of a slip ends before an order") {
  CHECK(slips_in("a^2 = 2a^2 \\ge -2a^2 = -2aa") == "");
  CHECK(slips_in("a^2 = 2a^2 = 2aa \\ge -2a^2 = -2aa") ==
        "the slip stays to the end of the chain: `a^2 = 2aa` does not hold, either\n");
}

TEST_CASE("steps of a chain are named by their positions in the file") {
  const Checked checked(rigor_says("scalar a, b") + "$$a = a$$\n$$a + b = a - b = b + a$$\n");
  REQUIRE(checked.report.steps.size() == 3);
  CHECK_FALSE(checked.report.steps[0].chain);
  REQUIRE(checked.report.steps[1].chain);
  CHECK(checked.report.steps[1].chain->first_wrong);
  CHECK(checked.report.steps[1].chain->undone_at == 2);
  REQUIRE(checked.report.steps[2].chain);
  CHECK(checked.report.steps[2].chain->undoes);
  CHECK(checked.report.steps[2].chain->first_step == 1);
}

}  // namespace
}  // namespace rigor
