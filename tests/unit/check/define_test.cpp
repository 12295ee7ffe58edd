// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of definitions, rules for derivatives and assumptions that speak of one symbol.
#include "catch.h"
#include "check/checked.h"
#include "check/walk/walk.h"

using namespace rigor;

namespace {

const std::string turning = rigor_says("vector \\mathbf{r}, \\boldsymbol{\\omega}, \\mathbf{F}") +
                            rigor_says("scalar m") + rigor_says("constant \\boldsymbol{\\omega}, m");
const std::string first = rigor_says("given \\dot{\\mathbf{r}} = \\boldsymbol{\\omega}\\times\\mathbf{r}");
const std::string second = rigor_says("given \\ddot{\\mathbf{r}} = \\mathbf{F}/m");

bool is_refuted(const std::string& line) { return line.starts_with("refuted"); }
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("two rules for one symbol's derivatives hold together") {
  for (const std::string& both : {first + second, second + first}) {
    const std::string notes = turning + both;
    CHECK(verdict_on("\\mathbf{F} = m\\boldsymbol{\\omega}\\times(\\boldsymbol{\\omega}\\times\\mathbf{r})",
                     notes) == "proved");
    CHECK(is_refuted(verdict_on_claim(
        "\\mathbf{F} = -m\\boldsymbol{\\omega}\\times(\\boldsymbol{\\omega}\\times\\mathbf{r})", notes)));
    CHECK(verdict_on("\\mathbf{F}\\cdot\\boldsymbol{\\omega} = 0", notes) == "proved");
    CHECK(is_refuted(verdict_on_claim("\\mathbf{F}\\cdot\\mathbf{r} = 0", notes)));
  }
}

TEST_CASE("laws of two orders hold together, whatever the claim's own order is") {
  const std::string notes =
      turning + rigor_says("given 2\\dot{\\mathbf{r}} = 2\\boldsymbol{\\omega}\\times\\mathbf{r}") +
      rigor_says("given m\\ddot{\\mathbf{r}} = \\mathbf{F}");
  CHECK(verdict_on("\\mathbf{F}\\cdot\\boldsymbol{\\omega} = 0", notes) == "proved");
  CHECK(is_refuted(verdict_on_claim("\\mathbf{F}\\cdot\\mathbf{r} = 0", notes)));
}

TEST_CASE("rules that contradict each other have no sample, and prove nothing") {
  const std::string notes =
      rigor_says("scalar x") + rigor_says("given \\dot x = 1") + rigor_says("given \\ddot x = 1");
  const std::string lines = lines_of(notes + "$$\\frac{d}{dt}(x\\dot x) = 1 + x$$\n\n$$\\ddot x = 1$$\n");
  CHECK(has(lines, "no-sample"));
  CHECK_FALSE(has(lines, "proved"));
}

TEST_CASE("an assumption without symbols that is false has no sample") {
  CHECK(
      has(lines_of(rigor_says("constant y") + rigor_says("given \\dot y = 1") + "$$y = y$$\n"), "no-sample"));
}

TEST_CASE("a rule for the rate of what is defined is an equation") {
  const std::string known = rigor_says("vector \\mathbf{v}, \\mathbf{g}, \\mathbf{u}, \\mathbf{a}") +
                            rigor_says("constant \\mathbf{g}");
  const std::string let = rigor_says("let \\mathbf{v} = \\mathbf{u} + \\mathbf{g}t");
  const std::string rule = rigor_says("given \\dot{\\mathbf{v}} = \\mathbf{a}");
  for (const std::string& both : {let + rule, rule + let}) {
    CHECK(verdict_on("\\mathbf{a} = \\mathbf{g} + \\dot{\\mathbf{u}}", known + both) == "proved");
    CHECK(is_refuted(verdict_on_claim("\\mathbf{a} = \\mathbf{g} - \\dot{\\mathbf{u}}", known + both)));
    CHECK(is_refuted(verdict_on_claim("\\mathbf{a} = \\dot{\\mathbf{u}}", known + both)));
  }
}

TEST_CASE("a rule that a definition made an equation holds to the end of its own section") {
  const std::string notes = "# One\n\n" + rigor_says("scalar v, a, u") + rigor_says("given \\dot v = a") +
                            "## Within\n\n" + rigor_says("let v = u") + "$$\\dot u = a$$\n\n## Behind\n\n";
  CHECK(verdict_on("\\dot v = a", notes) == "proved");
  CHECK(is_refuted(verdict_on_claim("\\dot u = a", notes)));
}

TEST_CASE("rules for three components are none for a vector that has one") {
  const std::string notes = rigor_says("vector \\mathbf{r}, \\mathbf{A}") +
                            rigor_says("given \\dot{\\mathbf{r}} = \\mathbf{A}") +
                            rigor_says("given \\ddot r_1 = r_2") + rigor_says("given \\ddot r_2 = r_3") +
                            rigor_says("given \\ddot r_3 = r_1");
  CHECK(verdict_on("\\dot A_1 = r_2", notes) == "proved");
  CHECK(is_refuted(verdict_on_claim("\\dot A_1 = r_3", notes)));
}

TEST_CASE("`where` with `:=` gives a plain letter a meaning for the next statement only") {
  const std::string vectors = rigor_says("vector \\mathbf{r}, \\mathbf{n}");
  const std::string local = vectors + rigor_says("where r := |\\mathbf{n}\\times\\mathbf{r}|");
  CHECK(verdict_on("r^2 = |\\mathbf{n}\\times\\mathbf{r}|^2", local) == "proved");
  CHECK(is_refuted(verdict_on_claim("r^2 = \\mathbf{r}\\cdot\\mathbf{r}", local)));
  const std::string behind = local + "$$r \\ge 0$$\n";
  CHECK(verdict_on("r^2 = \\mathbf{r}\\cdot\\mathbf{r}", behind).starts_with("proved"));
  CHECK(has(lines_of(local + "$$\\mathbf{n}\\times\\mathbf{n} = 0$$\n"), "unused-directive"));
}

TEST_CASE("`where` with `:=` leaves what it does not name alone, and sets no meaning aside") {
  const std::string defined = "$$s = 2a$$\n";
  CHECK(has(lines_of(defined + rigor_says("where s := 3a") + "$$s = 3a$$\n"), "bad-directive"));
  CHECK(verdict_on("s = 2a", defined + rigor_says("where u := 3a") + "$$u = 3a$$\n") == "proved");
  const std::string vector =
      rigor_says("vector \\mathbf{a}") + rigor_says("where \\mathbf{u} := 2\\mathbf{a}");
  CHECK(verdict_on("\\mathbf{u}\\times\\mathbf{a} = 0", vector) == "proved");
}

TEST_CASE("a second definition shows the first one") {
  const Checked checked("# A\n$$p = ab$$\n# B\n$$p = c + d$$\n");
  REQUIRE(checked.report.steps.size() == 2);
  const Diagnostics& diagnostics = checked.report.steps[1].diagnostics;
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics[0].kind == DiagnosticKind::redefinition);
  REQUIRE(diagnostics[0].labels.size() == 1);
  const Span first = diagnostics[0].labels[0].span;
  CHECK(checked.sources.line_column(first.file, first.begin).line == 2);
}
