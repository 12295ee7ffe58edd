// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/frame.h"

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

const std::string vectors = rigor_says("vector \\mathbf{r}, \\mathbf{A}, \\boldsymbol{\\omega}");
const std::string frame = rigor_says("frame rot rotates with \\boldsymbol{\\omega} in in");

std::string rate(const std::string& of, const std::string& label) {
  return "\\left(\\frac{d" + of + "}{dt}\\right)_{\\text{" + label + "}}";
}
std::string second_rate(const std::string& label) {
  return "\\left(\\frac{d^2\\mathbf{r}}{dt^2}\\right)_{\\text{" + label + "}}";
}
std::string in_frame(const std::string& statement) { return verdict_on(statement, vectors + frame); }

const std::string fixed_a = rate("\\mathbf{A}", "in");
const std::string turning_a = rate("\\mathbf{A}", "rot");

}  // namespace

TEST_CASE("the transport theorem follows from the rotation") {
  CHECK(in_frame(fixed_a + " = " + turning_a + " + \\boldsymbol{\\omega}\\times\\mathbf{A}") == "proved");
  CHECK(in_frame(fixed_a + " = " + turning_a + " - \\boldsymbol{\\omega}\\times\\mathbf{A}")
            .starts_with("refuted"));
  CHECK(in_frame(fixed_a + " = " + turning_a).starts_with("refuted"));
}

TEST_CASE("the rate of a frame's rotation is that of a quaternion's, q' = q w/2") {
  const std::string quaternion =
      vectors + rigor_says("vector \\mathbf{q}") + rigor_says("scalar s") +
      rigor_says("let N = s^2 + \\mathbf{q}\\cdot\\mathbf{q}") +
      rigor_says(
          "let S_{ij} = \\frac{(s^2 - \\mathbf{q}\\cdot\\mathbf{q})\\delta_{ij} + 2q_iq_j - "
          "2s\\epsilon_{ijk}q_k}{N}") +
      rigor_says("given \\dot s = -\\frac12\\mathbf{q}\\cdot\\boldsymbol{\\omega}") +
      rigor_says(
          "given \\dot{\\mathbf{q}} = \\frac12 s\\,\\boldsymbol{\\omega} + "
          "\\frac12\\mathbf{q}\\times\\boldsymbol{\\omega}");
  CHECK(verdict_on("\\dot S_{ij} = -S_{ik}\\epsilon_{kjl}\\omega_l", quaternion) == "proved");
  CHECK(verdict_on("\\dot S_{ij} = S_{ik}\\epsilon_{kjl}\\omega_l", quaternion).starts_with("refuted"));
}

TEST_CASE("a scalar changes alike in both frames, and ω as well") {
  CHECK(in_frame("\\left(\\frac{d}{dt}(\\mathbf{A}\\cdot\\mathbf{r})\\right)_{\\text{in}} = "
                 "\\left(\\frac{d}{dt}(\\mathbf{A}\\cdot\\mathbf{r})\\right)_{\\text{rot}}") == "proved");
  CHECK(in_frame(rate("\\boldsymbol{\\omega}", "in") + " = " + rate("\\boldsymbol{\\omega}", "rot")) ==
        "proved");
}

TEST_CASE("the second rate has the terms of Coriolis, of Euler and of the centrifugal force") {
  const std::string coriolis = " + 2\\boldsymbol{\\omega}\\times" + rate("\\mathbf{r}", "rot");
  const std::string half = " + \\boldsymbol{\\omega}\\times" + rate("\\mathbf{r}", "rot");
  const std::string centrifugal = " + \\boldsymbol{\\omega}\\times(\\boldsymbol{\\omega}\\times\\mathbf{r})";
  const std::string euler = " + " + rate("\\boldsymbol{\\omega}", "rot") + "\\times\\mathbf{r}";
  const std::string left = second_rate("in") + " = " + second_rate("rot");
  CHECK(in_frame(left + coriolis + centrifugal + euler) == "proved");
  CHECK(in_frame(left + half + centrifugal + euler).starts_with("refuted"));
  CHECK(in_frame(left + coriolis + euler).starts_with("refuted"));
  CHECK(verdict_on(left + coriolis + centrifugal,
                   vectors + rigor_says("variable \\boldsymbol{\\omega}") + frame)
            .starts_with("refuted"));
}

TEST_CASE("a vector's rate without a frame is open while a frame is in force") {
  CHECK(in_frame("\\frac{d\\mathbf{A}}{dt} = 0").find("ambiguous-reading") != std::string::npos);
  CHECK(in_frame("\\dot{\\mathbf{A}} = 0").find("ambiguous-reading") != std::string::npos);
}

TEST_CASE("what was defined before a frame is meant along fixed axes") {
  const std::string before =
      rigor_says("constant m") + vectors + "$$\\mathbf{p} = m\\dot{\\mathbf{r}}$$\n\n" + frame;
  CHECK(verdict_on("\\mathbf{p} = m" + rate("\\mathbf{r}", "in"), before) == "proved");
  CHECK(verdict_on(
            "\\mathbf{p} = m" + rate("\\mathbf{r}", "rot") + " + m\\boldsymbol{\\omega}\\times\\mathbf{r}",
            before) == "proved");
  CHECK(verdict_on("\\mathbf{p} = m" + rate("\\mathbf{r}", "rot"), before).starts_with("refuted"));
}

TEST_CASE("a vector that was constant before a frame may turn in it") {
  const std::string constant = rigor_says("constant \\mathbf{A}");
  CHECK(verdict_on(turning_a + " = 0", vectors + constant + frame) != "proved");
  CHECK(verdict_on(turning_a + " = 0", vectors + frame + constant) == "proved");
  CHECK(verdict_on(turning_a + " = -\\boldsymbol{\\omega}\\times\\mathbf{A}",
                   vectors + rigor_says("given \\dot{\\mathbf{A}} = 0") + frame) == "proved");
}

TEST_CASE("what was assumed before a frame comes back behind its section") {
  const std::string before = "# Both\n\n" + rigor_says("constant m") +
                             rigor_says("given m\\ddot{\\mathbf{r}} = \\mathbf{F}") + "## Turning\n\n" +
                             frame + "$$" + fixed_a + " = " + turning_a +
                             " + \\boldsymbol{\\omega}\\times\\mathbf{A}$$\n\n## Fixed\n\n";
  CHECK(verdict_on("m\\ddot{\\mathbf{r}} = \\mathbf{F}", before) == "proved");
}

TEST_CASE("one frame is in force at a time, and a new section ends it") {
  const std::string second = rigor_says("frame top rotates with \\mathbf{r} in in");
  const std::string same = turning_a + " = " + rate("\\mathbf{A}", "top");
  CHECK(verdict_on(same, vectors + frame + second).starts_with("not-understood"));
  CHECK(verdict_on(fixed_a + " = " + rate("\\mathbf{A}", "top") + " + \\mathbf{r}\\times\\mathbf{A}",
                   vectors + "## One\n\n" + frame + "$$" + fixed_a + " = " + turning_a +
                       " + \\boldsymbol{\\omega}\\times\\mathbf{A}$$\n\n## Two\n\n" + second) == "proved");
}

TEST_CASE("an angular velocity is a vector") {
  CHECK(
      lines_of(rigor_says("scalar w") + rigor_says("frame rot rotates with w in in")).find("bad-directive") !=
      std::string::npos);
}
