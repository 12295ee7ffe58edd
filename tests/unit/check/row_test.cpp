// SPDX-License-Identifier: GPL-3.0-or-later
// One step: a definition, an assumption, a claim, or what stands in the way.
#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

std::string display(const std::string& statement) { return "$$" + statement + "$$\n\n"; }

/// The verdicts alone, without places: `definition proved`.
std::string verdicts(const std::string& text) {
  const Checked checked(text);
  std::string names;
  for (const Step& step : checked.report.steps)
    names += (names.empty() ? "" : " ") + std::string(name_of(step.verdict));
  return names;
}

}  // namespace

TEST_CASE("an equation whose left side is a new symbol defines it") {
  const std::string momentum = display("\\mathbf{p} = m\\mathbf{v}");
  CHECK(verdicts(momentum) == "definition");
  CHECK(verdicts(momentum + display("\\mathbf{p}\\cdot\\mathbf{v} = mv^2")) == "definition proved");
  CHECK(verdicts(momentum + display("\\mathbf{p}\\cdot\\mathbf{v} = 2mv^2")) == "definition refuted");
  CHECK(verdicts(momentum + display("\\mathbf{p} = m\\mathbf{v}")) == "definition proved");
  CHECK(verdicts(momentum + "Hence\n" + display("\\mathbf{p} = -m\\mathbf{v}")) == "definition refuted");
}

TEST_CASE("the rest of a chain behind a definition is claimed") {
  CHECK(verdicts(display("C = \\mathbf{A}\\cdot\\mathbf{A} = A^2")) == "definition proved");
  CHECK(verdicts(display("C = \\mathbf{A}\\cdot\\mathbf{A} = 2A^2")) == "definition refuted");
}

TEST_CASE("a verdict names the definitions that it used") {
  const Checked checked(display("\\mathbf{L} = \\mathbf{r}\\times\\mathbf{p} \\tag{8}") +
                        display("\\mathbf{L}\\cdot\\mathbf{r} = 0"));
  REQUIRE(checked.report.steps.size() == 2);
  CHECK(checked.report.steps[1].uses == std::vector<std::string>{"definition \\mathbf{L} (8)"});
  const Checked untagged(display("\\mathbf{L} = \\mathbf{r}\\times\\mathbf{p}") +
                         display("\\mathbf{L}\\cdot\\mathbf{r} = 0"));
  CHECK(untagged.report.steps.at(1).uses == std::vector<std::string>{"definition \\mathbf{L} in line 1"});
}

TEST_CASE("a symbol that an equation used before is not defined by the next, except with :=") {
  const std::string before = display("C + D = E");
  CHECK(verdicts(before + display("C = \\mathbf{A}\\cdot\\mathbf{A}")) == "law law");
  CHECK(verdicts(before + display("C := \\mathbf{A}\\cdot\\mathbf{A}") + display("C = A^2")) ==
        "law definition proved");
}

TEST_CASE("what stands on the right side is not defined") {
  CHECK(verdicts(display("\\mathbf{A}\\cdot\\mathbf{A} = C")) == "law");
  CHECK(verdicts(display("2C = \\mathbf{A}\\cdot\\mathbf{A}")) == "law");
}

TEST_CASE("a definition in index notation holds for the whole vector, and for other letters") {
  const std::string momentum = display("L_i = \\epsilon_{ijk}r_jp_k");
  CHECK(verdicts(momentum + display("\\mathbf{L} = \\mathbf{r}\\times\\mathbf{p}")) == "definition proved");
  CHECK(verdicts(momentum + "Hence\n" + display("\\mathbf{L} = \\mathbf{p}\\times\\mathbf{r}")) ==
        "definition refuted");
  CHECK(verdicts(momentum + display("L_m r_m = 0")) == "definition proved");
}

TEST_CASE("a definition of a tensor by components is contracted") {
  const std::string dyad = display("Q_{ij} = A_iB_j");
  CHECK(verdicts(dyad + display("Q_{kl}B_l = A_kB_mB_m")) == "definition proved");
  CHECK(verdicts(dyad + display("Q_{kl}B_k = A_lB_mB_m")) == "definition refuted");
  CHECK(verdicts(dyad + "Hence\n" + display("Q_{ij} = A_jB_i")) == "definition refuted");
}

TEST_CASE("a symbol with a literal or a repeated index is not defined") {
  CHECK(verdicts(rigor_says("for all Q_{ij}") + display("Q_{12} = 3")) == "refuted");
  CHECK(verdicts(display("Q_{ii} = A_jA_j")) == "law");
}

TEST_CASE("a definition for each particle is used in sums over all") {
  const std::string momenta = display("\\mathbf{p}_\\alpha = m_\\alpha\\mathbf{v}_\\alpha");
  CHECK(verdicts(momenta +
                 display("\\sum_\\alpha\\mathbf{p}_\\alpha = \\sum_\\beta m_\\beta\\mathbf{v}_\\beta")) ==
        "definition proved");
  CHECK(verdicts(momenta +
                 display("\\sum_\\alpha\\mathbf{p}_\\alpha = 2\\sum_\\beta m_\\beta\\mathbf{v}_\\beta")) ==
        "definition refuted");
}

TEST_CASE("two equations in a circle are one definition and one claim") {
  CHECK(verdicts(display("C = D") + display("D = C")) == "definition proved");
  CHECK(verdicts(display("C = D + E") + display("D = C - E")) == "definition proved");
}

TEST_CASE("a symbol is not defined by itself") {
  CHECK(verdicts(display("C = C + D - D")) == "proved");
  CHECK(verdicts(display("C = 2C")) == "law");
}

TEST_CASE("another section may give a symbol another meaning, in other symbols or as a number") {
  const std::string momentum = "# One\n" + display("\\mathbf{L} = \\mathbf{r}\\times\\mathbf{p}");
  CHECK(lines_of(momentum + "# Two\n" + display("\\mathbf{L} = I\\boldsymbol{\\omega}")) ==
        "definition\ndefinition 5:14 redefinition\n");
  CHECK(verdicts(momentum + "# Two\n" + display("\\mathbf{L} = I\\boldsymbol{\\omega}") +
                 display("\\mathbf{L}\\times\\boldsymbol{\\omega} = 0")) == "definition definition proved");
  CHECK(verdicts("# One\n" + display("c = 2") + "# Two\n" + display("c = 3") + display("c^2 = 9")) ==
        "definition definition proved");
  CHECK(verdicts("# One\n" + display("c = 2") + "Hence\n" + display("c = 3")) == "definition refuted");
}

TEST_CASE("a definition in the same symbols is a claim in every section") {
  const std::string momentum = "# One\n" + display("\\mathbf{L} = \\mathbf{r}\\times\\mathbf{p}") + "# Two\n";
  CHECK(verdicts(momentum + display("\\mathbf{L} = \\mathbf{r}\\times\\mathbf{p}")) == "definition proved");
  CHECK(verdicts(momentum + rigor_says("use \\mathbf{L}") + "Hence\n" +
                 display("\\mathbf{L} = \\mathbf{p}\\times\\mathbf{r}")) == "definition refuted");
}

TEST_CASE("let defines in its section and overrides nothing that is refuted") {
  const std::string let = rigor_says("let C = \\mathbf{A}\\cdot\\mathbf{A}");
  CHECK(verdicts(let + display("C = A^2")) == "definition proved");
  CHECK(verdicts(let + display("\\mathbf{A}^2 + C = 3A^2")) == "definition refuted");
  CHECK(verdicts("# One\n" + let + display("C = A^2") + "# Two\n" + display("C = 2A^2")) ==
        "definition proved definition");
}

TEST_CASE("let defines one symbol alone") {
  CHECK(lines_of(rigor_says("let a + b = c")).starts_with("not-understood 1:23 bad-directive\n"));
}

TEST_CASE("a symbol that let defines through itself is circular") {
  CHECK(lines_of(rigor_says("let C = C + 1")).starts_with("not-understood 1:19 circular-definition\n"));
  CHECK(lines_of(rigor_says("let \\mathbf{p} = \\mathbf{q} + \\mathbf{r}") +
                 rigor_says("let \\mathbf{q} = \\mathbf{p} - \\mathbf{r}") +
                 display("\\mathbf{p} - \\mathbf{q} = \\mathbf{r}")) ==
        "definition\nnot-understood 2:28 circular-definition\nproved\n");
}

TEST_CASE("a given equation is an assumption, which a verdict names") {
  const Checked checked(rigor_says("given \\mathbf{u} = \\mathbf{v}") +
                        display("\\mathbf{u}\\times\\mathbf{v} = 0"));
  REQUIRE(checked.lines() == "given\nproved\n");
  CHECK(checked.report.steps[1].uses == std::vector<std::string>{"given \\mathbf{u} = \\mathbf{v}"});
}

TEST_CASE("laws are not refuted") {
  for (const char* law : {"m\\mathbf{a} = q\\mathbf{v}\\times\\mathbf{B}", "v^2 = u^2 + 2as",
                          "\\mathbf{r}\\cdot\\mathbf{v} = 0", "\\lambda^2 - 5\\lambda + 6 = 0",
                          "\\mathbf{F}_1 + \\mathbf{F}_2 = 0", "|\\mathbf{p}| = mc",
                          "\\sum_\\alpha m_\\alpha\\mathbf{r}_\\alpha = 0", "m_1v_1 + m_2v_2 = (m_1+m_2)V",
                          "T_{ij} = T_{ji}"}) {
    INFO(law);
    CHECK(verdicts(display(law)) == "law");
  }
}

TEST_CASE("wrong identities are refuted") {
  for (const char* wrong :
       {"(a+b)^2 = a^2 + b^2",
        "\\mathbf{A}\\cdot(\\mathbf{B}\\times\\mathbf{C}) = \\mathbf{A}\\cdot(\\mathbf{C}\\times\\mathbf{B})",
        "\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C}) = "
        "(\\mathbf{A}\\times\\mathbf{B})\\times\\mathbf{C}",
        "\\epsilon_{ijk}\\epsilon_{ilm} = \\delta_{jl}\\delta_{km} + \\delta_{jm}\\delta_{kl}",
        "\\frac{a}{b} + \\frac{c}{d} = \\frac{a+c}{b+d}", "\\delta_{ii} = 2", "\\epsilon_{213} = 1",
        "\\mathbf{A}\\cdot(\\mathbf{A}\\times\\mathbf{B}) = 1", "1 + 1 = 3"}) {
    INFO(wrong);
    CHECK(verdicts(display(wrong)) == "refuted");
  }
}

TEST_CASE("a zero stands for the zero vector, and is no proof of 0 = 0") {
  CHECK(verdict_on("\\mathbf{A}\\times\\mathbf{A} = 0") == "proved");
  CHECK(verdict_on("0 = \\epsilon_{ijk}A_jA_k") == "proved");
  CHECK(verdict_on("\\mathbf{A}\\times\\mathbf{A} = \\mathbf{B}\\times\\mathbf{B}") ==
        "proved 2:28 zero-equals-zero");
  CHECK(verdict_on("0 = \\mathbf{A}\\times\\mathbf{A} = \\mathbf{B}\\times\\mathbf{B}") ==
        "proved 2:32 zero-equals-zero");
}

TEST_CASE("a relation that is not decided says so at its place") {
  CHECK(verdict_on("\\delta_{ii} \\ll 4") == "not-understood 2:13 unsupported");
  CHECK(verdict_on("\\delta_{ii} \\overset{!}{=} 3") == "not-understood 2:13 unsupported");
  CHECK(verdict_on("\\delta_{ii} \\equiv 3") == "proved");
}

TEST_CASE("a condition beside an equation leaves it unjudged") {
  CHECK(verdict_on("\\delta_{ij} = 0 \\quad \\text{if } i \\ne j") == "undecided 2:13 restricted");
  CHECK(verdict_on("\\delta_{ij} = 0, \\quad i \\ne j") == "undecided 2:13 restricted");
  CHECK(verdict_on("\\delta_{ij}A_j = A_i, \\quad i = 1,2,3 \\quad (7)") == "proved");
}

TEST_CASE("words that may restrict an equation stop its refutation only") {
  const std::string wrong = "(a+b)^2 = a^2 + 2ab";
  CHECK(verdicts("In the limit " + display(wrong + " + b^2")) == "proved");
  CHECK(verdicts("In the limit " + display(wrong)) == "undecided");
  CHECK(verdicts(display(wrong + " \\quad \\text{to first order}")) == "undecided");
  CHECK(verdicts(display("(a+b)^2 = a^2 + 2ab \\quad \\text{(Newton's identity)}")) == "refuted");
}

TEST_CASE("ranks and free indices that differ are mistakes, not refutations") {
  CHECK(verdict_on("\\mathbf{a}\\cdot\\mathbf{b} = \\mathbf{a}") == "not-understood 2:27 rank-mismatch");
  CHECK(verdict_on("(\\mathbf{A}\\times\\mathbf{B})_i = \\epsilon_{ijk}A_jB_l")
            .starts_with("not-understood 2:"));
  CHECK(verdict_on("\\epsilon_{ijk}A_j = B_i") == "not-understood 2:13 free-index-mismatch");
  CHECK(verdict_on("A_iA_iC_i = 0") == "not-understood 2:9 index-repeats");
  CHECK(verdict_on("\\boldsymbol{\\omega}_iL_i = \\boldsymbol{\\omega}\\cdot\\mathbf{L}") ==
        "proved 2:1 bold-index");
}

TEST_CASE("a definition by cases of δ or ε is compared with the built-in one") {
  const std::string even = "1 & ijk = 123 \\text{ or cyclic permutations}\\\\";
  const std::string odd = "-1 & ijk = 132 \\text{ or cyclic permutations}\\\\";
  CHECK(verdict_on("\\epsilon_{ijk} = \\begin{cases}" + even + odd + "0 & \\text{otherwise}\\end{cases}") ==
        "definition");
  CHECK(verdict_on("\\epsilon_{ijk} = \\begin{cases}" + even + "0 & \\text{otherwise}\\end{cases}") ==
        "refuted 2:16 refuted");
  CHECK(verdict_on("\\delta_{ij} = \\begin{cases}1 & i = j\\\\ 0 & i \\ne j\\end{cases}") == "definition");
  CHECK(verdict_on("\\delta_{ij} = \\begin{cases}0 & i = j\\\\ 1 & i \\ne j\\end{cases}") ==
        "refuted 2:13 refuted");
}

TEST_CASE("vectors and tensors are unequal as a whole") {
  const std::string declared = rigor_says("vector \\mathbf{A}, \\mathbf{B}") + rigor_says("tensor S_{ij}");
  CHECK(verdict_on("\\mathbf{e}_1 \\ne \\mathbf{e}_2") == "proved");
  CHECK(verdict_on("\\mathsf{S} + \\mathbf{e}_1\\mathbf{e}_2 \\ne \\mathsf{S}", declared) == "proved");
  CHECK(verdict_on("A > 0", declared + rigor_says("where \\mathbf{A} \\ne 0")) == "proved");
  CHECK(verdict_on("A > 0", declared + rigor_says("where 0 \\ne \\mathbf{A}")) == "proved");
  CHECK(verdict_on("A_1 \\ne 0", declared + rigor_says("where \\mathbf{A} \\ne 0")).starts_with("refuted"));
  CHECK(verdict_on("A_i \\ne B_i", declared) == "not-understood 4:5 ambiguous-reading");
  const Checked equal(declared + rigor_says("claim \\mathbf{A} \\ne (1, 0, 2)"));
  const Step& step = equal.report.steps.back();
  REQUIRE(step.counterexample.has_value());
  CHECK(step.counterexample->squared_distance);
  CHECK(step.counterexample->component.empty());
  CHECK(step.counterexample->values.at(0).components == std::vector<std::string>{"1", "0", "2"});
  CHECK(step.diagnostics.at(0).message == "the sides are equal, component by component");
}

TEST_CASE(
    "what does not follow from assumptions is asked for by a claim, and what is no law is not called one") {
  const std::string spring = rigor_says("constant m, k") + rigor_says("given m\\ddot x = -kx") + "\n";
  const std::string energy = "\\frac{d}{dt}(m\\dot x^3 - kx^3) = 0";
  const Checked open(spring + display(energy));
  const Diagnostic& diagnostic = open.report.steps.back().diagnostics.at(0);
  CHECK(diagnostic.message.starts_with("it does not follow from what is assumed, and nothing says"));
  const std::string help = diagnostic.help.at(0);
  REQUIRE(help.starts_with("`rigor: claim " + energy + "`"));
  CHECK(verdicts(spring + rigor_says("claim " + energy)) == "given refuted");
  CHECK(verdicts(spring + display(energy)) == "given undecided");
  CHECK(verdicts(display("m\\ddot x = -kx")) == "law");
}

TEST_CASE("a symbol that looks like a known one is suggested for a conclusion that follows from nothing") {
  const Checked checked(display("m\\mathbf{v} = \\mathbf{F}") + "Hence\n" +
                        display("m\\mathbf{a} = \\mathbf{F}'"));
  const Diagnostic& diagnostic = checked.report.steps.back().diagnostics.at(0);
  CHECK(diagnostic.kind == DiagnosticKind::follows_from_nothing);
  CHECK(diagnostic.help.at(0) == "is `\\mathbf{F}` meant for `\\mathbf{F}'`?");
}
