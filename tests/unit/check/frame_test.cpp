// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/frame.h"

#include <algorithm>
#include <utility>

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
  CHECK(verdict_on_claim("\\dot S_{ij} = S_{ik}\\epsilon_{kjl}\\omega_l", quaternion).starts_with("refuted"));
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
  CHECK(verdict_on_claim(left + coriolis + centrifugal,
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
  CHECK(verdict_on_claim("\\mathbf{p} = m" + rate("\\mathbf{r}", "rot"), before).starts_with("refuted"));
}

TEST_CASE("what was constant before a frame is constant along the fixed axes") {
  const std::string constant = rigor_says("constant \\mathbf{A}");
  const std::string turns = turning_a + " = -\\boldsymbol{\\omega}\\times\\mathbf{A}";
  for (const std::string& said : {constant, rigor_says("given \\dot{\\mathbf{A}} = 0")}) {
    const std::string notes = vectors + said + frame;
    CHECK(verdict_on(fixed_a + " = 0", notes) == "proved");
    CHECK(verdict_on(turns, notes) == "proved");
    CHECK(verdict_on("\\frac{d}{dt}A^2 = 0", notes) == "proved");
    CHECK(verdict_on_claim(turning_a + " = 0", notes).starts_with("refuted"));
    CHECK(verdict_on_claim(fixed_a + " = \\boldsymbol{\\omega}\\times\\mathbf{A}", notes)
              .starts_with("refuted"));
  }
  CHECK(verdict_on(turning_a + " = 0", vectors + frame + constant) == "proved");
  CHECK(verdict_on_claim(fixed_a + " = 0", vectors + frame + constant).starts_with("refuted"));
  const std::string behind =
      "# One\n\n" + vectors + constant + "## Turning\n\n" + frame + "$$" + turns + "$$\n\n## Fixed\n\n";
  CHECK(verdict_on("\\dot{\\mathbf{A}} = 0", behind) == "proved");
}

TEST_CASE("what is constant bears on the angular velocity where something else speaks of it") {
  const std::string constant = vectors + rigor_says("constant \\mathbf{A}") + frame;
  const Checked alone(constant + "$$A_1 = A_1$$\n\n" +
                      rigor_says("claim \\boldsymbol{\\omega}\\times\\mathbf{r} = 0"));
  REQUIRE(alone.report.steps.back().counterexample.has_value());
  for (const Counterexample::Value& value : alone.report.steps.back().counterexample->values)
    CHECK(value.symbol.find('A') == std::string::npos);
  const std::string resting = constant + rigor_says("given " + turning_a + " = 0") +
                              rigor_says("given A_1 = 0") + rigor_says("given A_2 = 0") +
                              rigor_says("given A_3 = 2");
  CHECK(verdict_on("\\omega_1 = 0", resting) == "proved");
  CHECK(verdict_on_claim("\\omega_3 = 0", resting).starts_with("refuted"));
}

TEST_CASE("a constant vector of each particle, and a constant component") {
  const std::string particles = vectors + rigor_says("vector \\mathbf{s}_\\alpha");
  const std::string notes = particles + rigor_says("constant \\mathbf{s}_\\alpha") + frame;
  CHECK(verdict_on(rate("\\mathbf{s}_\\alpha", "in") + " = 0", notes) == "proved");
  CHECK(verdict_on_claim(rate("\\mathbf{s}_\\alpha", "rot") + " = 0", notes).starts_with("refuted"));
  const std::string third = vectors + rigor_says("constant A_3") + frame;
  CHECK(verdict_on(fixed_a + "\\cdot\\mathbf{e}_3 = 0", third) == "proved");
  CHECK(verdict_on_claim("\\dot A_3 = 0", third).starts_with("refuted"));
}

TEST_CASE("a tensor changes with the axes like vectors") {
  const std::string tensor = rigor_says("tensor K_{ij}") + vectors;
  for (const auto& [kind, said] : {std::pair{"symmetric tensor K_{ij}", "constant K_{ij}"},
                                   std::pair{"tensor K_{ij}", "given \\dot K_{ij} = 0"}}) {
    const std::string notes = rigor_says(kind) + vectors + rigor_says(said) + frame;
    CHECK(verdict_on_claim("\\dot K_{12} = 0", notes).starts_with("refuted"));
    CHECK(verdict_on("\\frac{d}{dt}K_{ii} = 0", notes) == "proved");
    CHECK(verdict_on("\\dot K_{ij} = -\\epsilon_{kli}\\omega_kK_{lj} - \\epsilon_{klj}\\omega_kK_{il}",
                     notes) == "proved");
    CHECK(verdict_on_claim("\\dot K_{ij} = -\\epsilon_{kli}\\omega_kK_{lj} + \\epsilon_{klj}\\omega_kK_{il}",
                           notes)
              .starts_with("refuted"));
  }
  const std::string product = tensor + rigor_says("constant K_{ij}, \\mathbf{A}") +
                              rigor_says("let \\mathbf{B} = \\mathsf{K}\\cdot\\mathbf{A}") + frame;
  CHECK(verdict_on(rate("\\mathbf{B}", "in") + " = 0", product) == "proved");
  CHECK(verdict_on_claim(rate("\\mathbf{B}", "rot") + " = 0", product).starts_with("refuted"));
}

TEST_CASE("a tensor that is constant from within the frame is constant along the turning axes") {
  CHECK(verdict_on("\\dot K_{12} = 0", rigor_says("tensor K_{ij}") + vectors + frame +
                                           rigor_says("constant K_{ij}")) == "proved");
}

TEST_CASE("what was defined by components stands along the fixed axes") {
  for (const char* body :
       {"(0, 0, -g)", "-g\\mathbf{e}_3", "\\begin{pmatrix} 0 \\\\ 0 \\\\ -g \\end{pmatrix}"}) {
    const std::string notes = vectors + rigor_says("scalar g") + rigor_says("constant g") +
                              rigor_says("let \\mathbf{G} = " + std::string(body)) + frame;
    CHECK(verdict_on(rate("\\mathbf{G}", "in") + " = 0", notes) == "proved");
    CHECK(verdict_on(rate("\\mathbf{G}", "rot") + " = \\mathbf{G}\\times\\boldsymbol{\\omega}", notes) ==
          "proved");
    CHECK(verdict_on("G^2 = g^2", notes) == "proved");
    CHECK(verdict_on_claim(rate("\\mathbf{G}", "rot") + " = 0", notes).starts_with("refuted"));
    CHECK(verdict_on_claim(rate("\\mathbf{G}", "in") + " = \\boldsymbol{\\omega}\\times\\mathbf{G}", notes)
              .starts_with("refuted"));
  }
}

TEST_CASE("a component that was named before a frame is one along a fixed axis") {
  const std::string notes = vectors + rigor_says("constant \\mathbf{A}") + rigor_says("let c = A_1") +
                            rigor_says("let D_{ij} = \\delta_{i3}A_j") + frame;
  CHECK(verdict_on("c = A_1", notes) == "proved");
  CHECK(verdict_on("\\dot c = 0", notes) == "proved");
  CHECK(verdict_on_claim("\\dot c = \\dot A_1", notes).starts_with("refuted"));
  CHECK(verdict_on_claim("\\dot D_{33} = 0", notes).starts_with("refuted"));
  CHECK(verdict_on("\\frac{d}{dt}D_{ii} = 0", notes) == "proved");
  const std::string given = vectors + rigor_says("given A_3 = 0") + frame;
  CHECK(verdict_on("A_3 = 0", given) == "proved");
  CHECK(verdict_on(fixed_a + "\\cdot\\mathbf{e}_3 = 0", given) == "proved");
  CHECK(verdict_on_claim("\\dot A_3 = 0", given).starts_with("refuted"));
}

TEST_CASE("what is defined in a frame holds behind it, along fixed axes") {
  const std::string notes =
      vectors + rigor_says("constant m") + "## Turning\n\n" + frame +
      "$$\\mathbf{v} = " + rate("\\mathbf{r}", "in") + "$$\n\n$$\\mathbf{u} = " + rate("\\mathbf{r}", "rot") +
      "$$\n\n$$\\mathbf{b} = " + rate("\\mathbf{u}", "rot") + "$$\n\n$$\\mathbf{a} = " + second_rate("in") +
      "$$\n\n$$\\mathbf{q} = " + second_rate("rot") + "$$\n\n$$T = \\frac12mv^2$$\n\n## Fixed\n\n";
  CHECK(verdict_on("\\mathbf{v} = \\dot{\\mathbf{r}}", notes) == "proved");
  CHECK(verdict_on("\\dot{\\mathbf{v}} = \\mathbf{a} = \\ddot{\\mathbf{r}}", notes) == "proved");
  CHECK(verdict_on("\\mathbf{u} = \\dot{\\mathbf{r}} - \\boldsymbol{\\omega}\\times\\mathbf{r}", notes) ==
        "proved");
  CHECK(verdict_on("\\mathbf{q} = \\mathbf{b}", notes) == "proved");
  CHECK(verdict_on("\\ddot{\\mathbf{r}} = \\mathbf{b} + 2\\boldsymbol{\\omega}\\times\\mathbf{u} + "
                   "\\dot{\\boldsymbol{\\omega}}\\times\\mathbf{r} + "
                   "\\boldsymbol{\\omega}\\times(\\boldsymbol{\\omega}\\times\\mathbf{r})",
                   notes) == "proved");
  CHECK(verdict_on("\\dot T = m\\mathbf{v}\\cdot\\mathbf{a}", notes) == "proved");
  CHECK(verdict_on_claim("\\mathbf{v} = -\\dot{\\mathbf{r}}", notes).starts_with("refuted"));
  CHECK(verdict_on_claim("\\mathbf{u} = \\dot{\\mathbf{r}}", notes).starts_with("refuted"));
  CHECK(verdict_on_claim("\\mathbf{q} = \\ddot{\\mathbf{r}}", notes).starts_with("refuted"));
  const std::string again = notes + frame;
  CHECK(verdict_on("\\mathbf{u} = " + rate("\\mathbf{r}", "rot"), again) == "proved");
  CHECK(verdict_on("\\mathbf{b} = " + rate("\\mathbf{u}", "rot"), again) == "proved");
  CHECK(verdict_on_claim("\\mathbf{u} = " + rate("\\mathbf{r}", "in"), again).starts_with("refuted"));
}

TEST_CASE("a tensor's rate that a frame's definition has is converted behind it") {
  const std::string notes = rigor_says("tensor K_{ij}") + vectors + "## Turning\n\n" + frame +
                            "$$N_{ij} = \\dot K_{ij}$$\n\n## Fixed\n\n";
  CHECK(verdict_on("N_{ii} = \\frac{d}{dt}K_{ii}", notes) == "proved");
  CHECK(verdict_on("N_{ij} = \\dot K_{ij} - \\epsilon_{kli}\\omega_kK_{lj} - \\epsilon_{klj}\\omega_kK_{il}",
                   notes) == "proved");
  CHECK(verdict_on_claim("N_{12} = \\dot K_{12}", notes).starts_with("refuted"));
}

TEST_CASE("what a frame's definition says along its axes holds for the moment behind it") {
  const std::string notes = vectors + rigor_says("scalar g") + rigor_says("constant g") + "## Turning\n\n" +
                            frame + "$$\\mathbf{G} = (0, 0, -g)$$\n\n## Fixed\n\n";
  CHECK(verdict_on("\\mathbf{G}\\cdot\\mathbf{G} = g^2", notes) == "proved");
  CHECK(verdict_on("\\dot{\\mathbf{G}} = 0", notes) == "law");
  CHECK(verdict_on("\\dot{\\mathbf{G}} = \\boldsymbol{\\omega}\\times\\mathbf{G}", notes) == "law");
}

TEST_CASE("another meaning that a symbol got in a frame stays") {
  const std::string notes = "# One\n\n" + vectors + "$$\\mathbf{v} = \\dot{\\mathbf{r}}$$\n\n" +
                            "# Turning\n\n" + frame +
                            "$$\\mathbf{v} = \\boldsymbol{\\omega}\\times\\mathbf{b}$$\n\n" + "# Fixed\n\n";
  CHECK(verdict_on("\\mathbf{v}\\cdot\\mathbf{b} = 0", notes) == "proved");
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

TEST_CASE("rates that are too large to be taken over leave the frame undeclared") {
  const std::string dots = "\\frac{d^9}{dt^9}\\frac{d^9}{dt^9}\\mathbf{A}";
  const Checked checked(vectors + rigor_says("given " + dots + " = 0") + frame + "$$a = a$$\n");
  const auto& told = checked.report.diagnostics;
  CHECK(std::any_of(told.begin(), told.end(), [](const Diagnostic& each) {
    return each.kind == DiagnosticKind::unsupported && each.message.find("too large") != std::string::npos;
  }));
}
