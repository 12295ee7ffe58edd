// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the page one slip of the pen away from a row that is left open.
#include <algorithm>
#include <string>
#include <vector>

#include "catch.h"
#include "check/checked.h"
#include "check/entry/check.h"
#include "source/source_map.h"

using namespace rigor;

namespace {

Step last_step(const std::string& note, Repairs repairs) {
  SourceMap sources;
  const FileReport report = check_text(sources, "note.md", note, {.repairs = repairs});
  REQUIRE(!report.steps.empty());
  return report.steps.back();
}

std::vector<std::string> offered(const Step& step) {
  std::vector<std::string> statements;
  for (const Repair& repair : step.repairs) statements.push_back(repair.statement);
  return statements;
}

bool has_help(const Step& step, const std::string& text) {
  return std::ranges::any_of(step.diagnostics, [&](const Diagnostic& diagnostic) {
    return std::ranges::find(diagnostic.help, text) != diagnostic.help.end();
  });
}

const std::string masses =
    "The masses move as $$m_1\\ddot x = T - m_1g, \\tag{1}$$ $$m_2\\ddot x = m_2g - T. \\tag{2}$$\n\n";
const std::string too_heavy = "$$(m_1 + m_2)\\ddot x = (m_2 - m_1)gm_2$$";

}  // namespace

TEST_CASE("near a law stands what follows from the laws above it, with their names") {
  const Step step = last_step(masses + too_heavy, Repairs::and_of_laws);
  CHECK(step.verdict == Verdict::law);
  CHECK(step.diagnostics.empty());
  REQUIRE(!step.repairs.empty());
  CHECK(step.repairs[0].statement == "(m_1 + m_2)\\ddot x = (m_2 - m_1)g");
  CHECK(step.repairs[0].uses == std::vector<std::string>{"law (2)", "law (1)"});
}

TEST_CASE("a letter of another row may have been meant") {
  const Step step = last_step(masses + "$$(m_1 + m_2)\\ddot x = (m_2 - m_1)T$$", Repairs::and_of_laws);
  CHECK(offered(step) == std::vector<std::string>{"(m_1 + m_2)\\ddot x = (m_2 - m_1)g"});
}

TEST_CASE("nobody is told what is near a law if that is not asked for") {
  for (const Repairs repairs : {Repairs::none, Repairs::of_unexpected, Repairs::of_all})
    CHECK(offered(last_step(masses + too_heavy, repairs)).empty());
}

TEST_CASE("a law that says something new has nothing near it") {
  for (const char* law : {"$$m_1 = 2m_2$$", "$$T = -kx$$", "$$\\dot x = gt$$"})
    CHECK(offered(last_step(masses + law, Repairs::and_of_laws)).empty());
}

TEST_CASE("a conclusion without a ground names what follows near it as a help") {
  const Step step = last_step(masses + "Hence " + too_heavy, Repairs::of_unexpected);
  CHECK(step.verdict == Verdict::undecided);
  CHECK(has_help(step, "one slip away, `(m_1 + m_2)\\ddot x = (m_2 - m_1)g` follows from law (2), law (1)"));
  CHECK(offered(last_step(masses + "Hence " + too_heavy, Repairs::none)).empty());
}

TEST_CASE("what a directive states as a law has nothing near it") {
  CHECK(offered(last_step(masses + rigor_says("law next") + too_heavy, Repairs::and_of_laws)).empty());
}

TEST_CASE("rows with values of functions are searched as they are read") {
  const std::string page =
      "The equation is $$y'(x) + p(x)\\,y(x) = q(x), \\tag{1}$$ and the factor has "
      "$$\\mu'(x) = p(x)\\,\\mu(x). \\tag{2}$$ Then ";
  CHECK(last_step(page + "$$\\frac{d}{dx}[\\mu(x)\\,y(x)] = \\mu(x)\\,q(x)$$", Repairs::none).verdict ==
        Verdict::proved);
  const Step step =
      last_step(page + "$$\\frac{d}{dx}[\\mu(x)\\,y(x)] = -\\mu(x)\\,q(x)$$", Repairs::of_unexpected);
  CHECK(step.verdict == Verdict::suspect);
  CHECK(offered(step) == std::vector<std::string>{"\\frac{d}{dx}[\\mu(x)\\,y(x)] = \\mu(x)\\,q(x)"});
}

TEST_CASE("near a series that is left open stands one that holds to its order") {
  const Step step = last_step("$$(1+x)^p = 1 + p^2x + \\frac{p(p-1)}{2}x^2 + O(x^3)$$", Repairs::and_of_laws);
  const std::vector<std::string> found = offered(step);
  CHECK(std::ranges::find(found, "(1+x)^p = 1 + px + \\frac{p(p-1)}{2}x^2 + O(x^3)") != found.end());
}

TEST_CASE("near a number stands what agrees to its digits, with the constants that it is made of") {
  const Step step = last_step(
      "For the electron $$\\frac{h}{m^2c} \\approx 2.43\\times10^{-12}\\,\\mathrm m$$", Repairs::and_of_laws);
  REQUIRE(!step.repairs.empty());
  CHECK(step.repairs[0].statement == "\\frac{h}{mc} \\approx 2.43\\times10^{-12}\\,\\mathrm m");
  CHECK(step.repairs[0].uses.size() == 3);
}

TEST_CASE("near a number that other digits contradict stands nothing") {
  CHECK(offered(last_step("For the electron $$\\frac{h}{m^2c} \\approx 7.7\\times10^{-12}\\,\\mathrm m$$",
                          Repairs::and_of_laws))
            .empty());
}

TEST_CASE("a vector beside its component is no number, whatever decimals stand there") {
  const std::string page = "With $\\mathbf v = (v_x, v_y, v_z)$ we have ";
  for (const char* row : {"$$|2\\mathbf v|\\cdot 3 = 0.71\\,v_x$$", "$$|\\mathbf v|^2 \\approx 0.5\\,v_x$$"})
    CHECK(last_step(page + row, Repairs::and_of_laws).verdict != Verdict::proved);
}

TEST_CASE("a row that cannot be read is told what stands near it") {
  const std::string page =
      "The fields obey $$\\nabla\\times\\mathbf E = -\\frac{\\partial\\mathbf B}{\\partial t}. \\tag{1}$$ "
      "Then ";
  const Step step = last_step(page +
                                  "$$\\nabla\\times(\\nabla\\times\\mathbf E) = -\\frac{\\partial}{\\partial "
                                  "t^2}(\\nabla\\times\\mathbf B)$$",
                              Repairs::of_unexpected);
  CHECK(step.verdict == Verdict::not_understood);
  const std::string meant =
      "\\nabla\\times(\\nabla\\times\\mathbf E) = -\\frac{\\partial}{\\partial t}(\\nabla\\times\\mathbf B)";
  CHECK(offered(step) == std::vector<std::string>{meant});
  CHECK(has_help(step, "one slip away, `" + meant + "` follows from law (1)"));
}

TEST_CASE("operators that exchange their places are found, and are nothing trivial") {
  const Step step = last_step(
      "For all operators $$[\\hat x,\\hat p^2] = [\\hat x,\\hat p]\\,\\hat p + \\hat p\\,[\\hat p,\\hat x]$$",
      Repairs::of_unexpected);
  const std::vector<std::string> found = offered(step);
  for (const std::string meant :
       {"[\\hat x,\\hat p^2] = [\\hat x,\\hat p]\\,\\hat p + \\hat p\\,[\\hat x,\\hat p]",
        "[\\hat x,\\hat p^2] = [\\hat x,\\hat p]\\,\\hat p - \\hat p\\,[\\hat p,\\hat x]"})
    CHECK(std::ranges::find(found, meant) != found.end());
}

TEST_CASE("a dot too many shows nothing of what is near") {
  const std::string page =
      "$$x(t) = a\\cos\\omega t + b\\sin\\omega t \\tag{1}$$ $$x(0) = x_0 \\tag{2}$$ So ";
  CHECK(last_step(page + "$$a = x_0$$", Repairs::none).verdict == Verdict::proved);
  for (const char* row : {"$$a = x_0'$$", "$$a = \\dot x_0$$"}) {
    const std::vector<std::string> found = offered(last_step(page + row, Repairs::and_of_laws));
    CHECK(std::ranges::find(found, "a = x_0") != found.end());
  }
}

TEST_CASE("a letter of a derivative that holds another one may be that of another row") {
  const std::string page = "For a gas $$dU = T\\,dS - p\\,dV. \\tag{1}$$ Hence ";
  const Step step = last_step(page +
                                  "$$\\left(\\frac{\\partial U}{\\partial V}\\right)_T = "
                                  "T\\left(\\frac{\\partial U}{\\partial V}\\right)_T - p$$",
                              Repairs::of_unexpected);
  CHECK(offered(step) ==
        std::vector<std::string>{"(\\frac{\\partial U}{\\partial V})_T = T(\\frac{\\partial S}{\\partial "
                                 "V})_T - p"});
}

TEST_CASE("a slip in a general solution is suspect") {
  const std::string page = "The mass obeys $$\\ddot x + \\omega^2x = 0. \\tag{1}$$ Its solution is ";
  CHECK(last_step(page + "$$x(t) = a\\cos\\omega t + b\\sin\\omega t$$", Repairs::none).verdict ==
        Verdict::proved);
  const Step step = last_step(page + "$$x(t) = a\\cos\\omega^2t + b\\sin\\omega t$$", Repairs::of_unexpected);
  CHECK(step.verdict == Verdict::suspect);
  CHECK(offered(step) == std::vector<std::string>{"x(t) = a\\cos\\omega t + b\\sin\\omega t"});
}

TEST_CASE("no fraction that is one is offered beside another statement") {
  const std::string page = "Let $$x = \\gamma y \\tag{1}$$ Hence ";
  const std::vector<std::string> found =
      offered(last_step(page + "$$x = \\frac{1}{2}\\gamma y$$", Repairs::of_unexpected));
  REQUIRE(!found.empty());
  CHECK(found[0] == "x = \\gamma y");
  CHECK(std::ranges::find(found, "x = \\frac{2}{2}\\gamma y") == found.end());
}

TEST_CASE("what is not decided has nothing near it") {
  const std::string page = "The speed is $$v = \\beta c \\tag{1}$$ and ";
  for (const char* row : {"$$v \\ll 2\\beta c$$", "$$v \\propto 2\\beta c$$", "$$v = ? + 2\\beta c$$"})
    CHECK(offered(last_step(page + row, Repairs::and_of_laws)).empty());
}

TEST_CASE("what is constant since nothing differentiates it is not differentiated near by") {
  for (const char* row : {"$$\\dot u_0 = 2\\dot w_0$$", "$$\\dot\\pi = -kq$$", "$$ab = 0$$"})
    CHECK(offered(last_step(row, Repairs::and_of_laws)).empty());
  const std::vector<std::string> found =
      offered(last_step("$$\\frac{d}{dt}(uw) = 2u\\dot w$$", Repairs::and_of_laws));
  CHECK(std::ranges::find(found, "\\frac{d}{dt}(uw) + u\\dot w = 2u\\dot w") == found.end());
}

TEST_CASE("a value at a place has no value at another place near it") {
  for (const char* row : {"$$w(0) = 0$$", "$$f'(0) = 0$$"})
    CHECK(offered(last_step(row, Repairs::and_of_laws)).empty());
}

TEST_CASE("a row that is read and not understood otherwise is no slip") {
  const Step step =
      last_step(rigor_says("given a < 0") + "$$(\\sqrt a)^2 + b = 2b + a$$", Repairs::of_unexpected);
  CHECK(step.verdict == Verdict::not_understood);
  CHECK(offered(step).empty());
}
