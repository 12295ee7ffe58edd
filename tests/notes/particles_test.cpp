// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over particles: what holds for any number of them is proved, and what holds for some numbers only is
// refuted by a body with another number.
#include "catch.h"
#include "check/entry/check.h"
#include "program.h"

namespace rigor {
namespace {

const std::string declared = R"(<!-- rigor:
particles \alpha, \beta, \gamma
scalar m_\alpha, q_\alpha
vector \mathbf{r}_\alpha
for all m_\alpha, q_\alpha, \mathbf{r}_\alpha
-->

)";

bool holds_for_any_number(const Step& step) {
  return step.verdict == Verdict::proved && step.route.find("any number of particles") != std::string::npos;
}

/// The one step of a page with this equation.
Step step_of(const std::string& equation) {
  SourceMap sources;
  const FileReport report = check_text(sources, "particles.md", declared + "$$" + equation + "$$\n");
  INFO(equation);
  REQUIRE(report.steps.size() == 1);
  return report.steps[0];
}

void check_proved(const std::string& equation) {
  const Step step = step_of(equation);
  INFO(equation);
  INFO(name_of(step.verdict) << " by " << step.route);
  CHECK(step.diagnostics.empty());
  CHECK(holds_for_any_number(step));
}

/// The number of particles of the body that refutes the equation.
std::uint32_t refuting_particles(const std::string& equation) {
  const Step step = step_of(equation);
  INFO(equation);
  REQUIRE(name_of(step.verdict) == "refuted");
  REQUIRE(step.counterexample.has_value());
  CHECK(step.counterexample->left != step.counterexample->right);
  for (const Counterexample::Value& value : step.counterexample->values)
    CHECK(value.particle <= step.counterexample->particles);
  return step.counterexample->particles;
}

TEST_CASE("the rotational energy as a quadratic form, Eq. (7), is proved for any number of particles") {
  SourceMap sources;
  const FileReport report = check_file(sources, "../../derivations/rigid-bodies.md");
  int steps = 0;
  for (const Step& step : report.steps) {
    if (step.tag != "(7)") continue;
    ++steps;
    INFO(step.source);
    CHECK(holds_for_any_number(step));
  }
  CHECK(steps == 2);
}

TEST_CASE("products of sums over particles are proved for any number of them") {
  // Lagrange's identity in as many dimensions as there are particles.
  check_proved(R"(\sum_\alpha m_\alpha^2\sum_\beta q_\beta^2 - \Bigl(\sum_\alpha m_\alpha q_\alpha\Bigr)^2
    = \tfrac12\sum_\alpha\sum_\beta(m_\alpha q_\beta - m_\beta q_\alpha)^2)");
  // Distances between the particles and distances from the centre.
  check_proved(R"(\sum_\alpha\sum_\beta m_\alpha m_\beta|\mathbf{r}_\alpha - \mathbf{r}_\beta|^2
    = 2\sum_\alpha m_\alpha\sum_\beta m_\beta r_\beta^2 - 2\Bigl|\sum_\alpha m_\alpha\mathbf{r}_\alpha\Bigr|^2)");
}

TEST_CASE("what is true for two particles only is refuted") {
  CHECK(refuting_particles(R"(\sum_\alpha 1 = 2)") != 2);
  CHECK(refuting_particles(R"(\sum_\alpha\sum_\beta m_\beta = 2\sum_\alpha m_\alpha)") != 2);
}

TEST_CASE("what is true for one particle only is refuted by two") {
  CHECK(refuting_particles(R"(\Bigl(\sum_\alpha m_\alpha\Bigr)^2 = \sum_\alpha m_\alpha^2)") == 2);
  CHECK(refuting_particles(R"(\sum_\alpha m_\alpha\sum_\beta r_\beta^2 = \sum_\alpha m_\alpha r_\alpha^2)") ==
        2);
}

TEST_CASE("what is true for one and for two particles is refuted by three") {
  // Two dyads r r span a plane at most: the determinant of their sum is zero.
  CHECK(refuting_particles(R"(\varepsilon_{ijk}\sum_\alpha r_{\alpha 1}r_{\alpha i}
    \sum_\beta r_{\beta 2}r_{\beta j}\sum_\gamma r_{\gamma 3}r_{\gamma k} = 0)") == 3);
}

}  // namespace
}  // namespace rigor
