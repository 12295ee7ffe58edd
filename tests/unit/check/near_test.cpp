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
