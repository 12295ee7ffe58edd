// SPDX-License-Identifier: GPL-3.0-or-later
// A statement that holds under a condition names it; one that is plainly wrong does not.
#include "check/repair/missing_condition.h"

#include <algorithm>

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

std::vector<std::string> conditions(const std::string& note) {
  const Checked checked(note);
  const auto& steps = checked.report.steps;
  const auto found = std::find_if(steps.begin(), steps.end(),
                                  [](const Step& step) { return step.verdict == Verdict::refuted; });
  REQUIRE(found != steps.end());
  return found->conditions;
}

std::string first(const std::string& note) {
  const std::vector<std::string> all = conditions(note);
  return all.empty() ? "" : all.front();
}

}  // namespace

TEST_CASE("the centre of mass") {
  CHECK(
      first(rigor_says("particles \\alpha") + rigor_says("vector \\mathbf{R}") +
            "$$\\sum_\\alpha m_\\alpha|\\mathbf{R} + \\mathbf{r}_\\alpha|^2 = \\sum_\\alpha m_\\alpha R^2 + "
            "\\sum_\\alpha m_\\alpha r_\\alpha^2$$\n") == "\\sum_\\alpha m_\\alpha \\mathbf{r}_\\alpha = 0");
}

TEST_CASE("a symmetric tensor, a unit vector, a right angle, equal numbers") {
  CHECK(first(rigor_says("tensor T_{ij}") + "$$T_{ij}A_iB_j = T_{ij}B_iA_j$$\n") == "T_{ij} = T_{ji}");
  CHECK(first(rigor_says("for all x, \\mathbf{n}") + "$$\\mathbf{n}\\cdot(\\mathbf{n}\\,x) = x$$\n") ==
        "|\\mathbf{n}| = 1");
  CHECK(first("$$|\\mathbf{A} + \\mathbf{B}|^2 = A^2 + B^2$$\n") == "\\mathbf{A}\\cdot\\mathbf{B} = 0");
  CHECK(first(rigor_says("scalar I_1, I_2, x") + rigor_says("for all I_1, I_2, x") +
              "$$(I_1 - I_2)x = 0$$\n") == "I_{1} = I_{2}");
}

TEST_CASE("something constant") {
  CHECK(first(rigor_says("for all \\mathbf{v}, m") +
              "$$\\frac{d}{dt}(m\\mathbf{v}) = \\dot{m}\\mathbf{v} + m\\dot{\\mathbf{v}} = "
              "m\\dot{\\mathbf{v}}$$\n") == "\\dot{m} = 0");
}

TEST_CASE("ordered numbers, for an order") {
  CHECK(first(rigor_says("scalar I_1, I_2") + rigor_says("for all I_1, I_2") + "$$I_2 - I_1 > 0$$\n") ==
        "I_{1} < I_{2}");
}

TEST_CASE("to first order in what is small") {
  CHECK(first(rigor_says("scalar x") + "$$(1 + x)^2 = 1 + 2x$$\n") == "x is small, to first order");
}

TEST_CASE("a condition can be given as it is offered") {
  const std::string wrong = "$$T_{ij}A_iB_j = T_{ij}B_iA_j$$\n";
  const std::string tensor = rigor_says("tensor T_{ij}");
  CHECK(lines_of(tensor + rigor_says("given " + first(tensor + wrong)) + wrong) == "given\nproved\n");
}

TEST_CASE("a condition that contradicts what is given is none") {
  CHECK(conditions(rigor_says("vector \\mathbf{A}, \\mathbf{B}") +
                   rigor_says("given \\mathbf{A}\\cdot\\mathbf{B} = 1") +
                   "$$|\\mathbf{A} + \\mathbf{B}|^2 = A^2 + B^2$$\n")
            .empty());
}

TEST_CASE("the step itself is no condition, and none is named twice") {
  CHECK(conditions(rigor_says("for all \\mathbf{A}, \\mathbf{B}") + "$$\\mathbf{A}\\times\\mathbf{B} = 0$$\n")
            .empty());
  CHECK(conditions(rigor_says("scalar a, b") +
                   "$$\\frac{d^2}{dt^2}(ab) = \\ddot ab + \\dot a\\dot b + a\\ddot b$$\n") ==
        std::vector<std::string>{"\\dot{a} = 0", "\\dot{b} = 0"});
}

TEST_CASE("a wrong number holds under no condition") {
  CHECK(conditions("$$\\epsilon_{ijk}\\epsilon_{ijk} = 5$$\n").empty());
}

TEST_CASE("whether each of many terms vanishes is asked without samples for a blackboard") {
  std::string left = "x_{0}";
  for (int k = 1; k < 200; ++k) left += " + x_{" + std::to_string(k) + "}";
  const Checked checked("$$" + left + " = x_{0} + " + left + "$$\n");
  CHECK(checked.report.steps[0].work < 500'000);  // 2,600,000 with them
}
