// SPDX-License-Identifier: GPL-3.0-or-later
#include <rigor/catch.h>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("matchers tell proved, refuted and not understood steps apart") {
  CHECK_THAT(step("1 = 1"), is_proved());
  CHECK_THAT(step("1 = 1"), holds());
  CHECK_THAT(step("1 = 2"), is_refuted());
  CHECK_THAT(step("1 = 2"), !is_proved());
  CHECK_THAT(step("\\oint f(s)\\,ds = 0"), is_not_understood());
  CHECK_THAT(step("1 = 1", "% rigor: vector \\mathbf{Q}"), !is_proved());
  CHECK_THAT(notes("/nowhere/notes.md"), !all_hold());
}

TEST_CASE("what a matcher says names the verdict") {
  CHECK(is_proved().describe() == "is proved");
  CHECK(is_refuted().describe() == "is refuted");
  CHECK(is_undecided().describe() == "is undecided");
}

TEST_CASE("a step that fails is shown with its sample and the nearest true statement") {
  const std::string shown =
      Catch::Detail::stringify(step(R"(\mathbf{A}\times\mathbf{B} = \mathbf{B}\times\mathbf{A})"));
  CHECK(shown.find("sample: \\mathbf{A} = (1, 0, 0)") != std::string::npos);
  CHECK(shown.find("true is: ") != std::string::npos);
}

}  // namespace
}  // namespace rigor
