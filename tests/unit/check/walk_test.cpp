// SPDX-License-Identifier: GPL-3.0-or-later
// Chains, sections and directives: what holds where, and what nothing uses. Single steps are in
// row_test.cpp.
#include "check/walk/walk.h"
#include "check/question/decision_cache.h"

#include <algorithm>

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

const std::string square = "$$|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2$$\n\n";
const std::string perpendicular = rigor_says("given \\mathbf{A}\\cdot\\mathbf{B} = 0");
const std::string commuted = "$$\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}$$\n\n";

}  // namespace

TEST_CASE("each relation of a chain is a step with its own verdict") {
  CHECK(lines_of("$$\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A} = A_iB_i = 2A_iB_i$$") ==
        "proved\nproved\nrefuted 1:66 refuted\n");
}

TEST_CASE("a chain runs over the rows of a display") {
  CHECK(lines_of("\\begin{align}\n(\\mathbf{A}\\times\\mathbf{B})^2 &= "
                 "\\epsilon_{ijk}A_jB_k\\epsilon_{ilm}A_lB_m \\\\\n"
                 "&= A^2B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2 \\\\\n&= A^2B^2\n\\end{align}\n") ==
        "proved\nproved\nrefuted 4:2 refuted\n");
}

TEST_CASE("a side that is not read spoils the steps beside it only") {
  CHECK(lines_of("$$\\mathbf{A}\\cdot\\mathbf{B} = \\foo x = A_iB_i = \\mathbf{B}\\cdot\\mathbf{A}$$") ==
        "not-understood 1:31 unsupported\nnot-understood 1:31 unsupported\nproved\n");
}

TEST_CASE("a step knows its tag, label, section and text") {
  const Checked checked("# Products\n\n$$\\mathbf{A}\\times\\mathbf{A}\n = 0 \\tag{6} \\label{eq:a}$$\n");
  REQUIRE(checked.report.steps.size() == 1);
  const Step& step = checked.report.steps[0];
  CHECK(step.tag == "(6)");
  CHECK(step.label == "eq:a");
  CHECK(step.section == "Products");
  CHECK(step.source == "\\mathbf{A}\\times\\mathbf{A} = 0");
  CHECK(step.left == "\\mathbf{A}\\times\\mathbf{A}");
  CHECK(step.relation == "=");
  CHECK(step.right == "0");
  CHECK(checked.sources.text(step.relation_span) == "=");
}

TEST_CASE("verdicts are counted") {
  const Checked checked("$$\\delta_{ii} = 3 = 2$$\n\n$$\\delta_{ii} \\ll 3$$\n");
  CHECK(checked.report.counts == Counts{1, 1, 0, 0, 0, 1, 0});
}

TEST_CASE("an expression without a relation is no step") {
  CHECK(lines_of(commuted + "$$\\mathbf{A}\\cdot\\mathbf{B}$$\n") == "proved\n3:3 no-relation\n");
}

TEST_CASE("an assumption holds to the end of its section") {
  CHECK(lines_of(square) == "refuted 1:34 refuted\n");
  CHECK(lines_of(perpendicular + square) == "given\nproved\n");
  CHECK(lines_of("# One\n" + perpendicular + square + "# Two\n" + square) ==
        "given\nproved\nrefuted 6:34 refuted\n");
  CHECK(lines_of("# One\n" + perpendicular + "## Two\n" + square) == "given\nproved\n");
  CHECK(lines_of("# One\n## Two\n" + perpendicular + square + "## Three\n" + square) ==
        "given\nproved\nrefuted 7:34 refuted\n");
}

TEST_CASE("an assumption that no sample satisfies is an error, and nothing is proved from it") {
  CHECK(lines_of(rigor_says("given \\mathbf{A}\\cdot\\mathbf{A} = -1") + square)
            .starts_with("given 1:19 no-sample\nundecided 2:34 undecided\n"));
  CHECK(lines_of(perpendicular + rigor_says("given \\mathbf{A}\\cdot\\mathbf{B} = 1")).find("no-sample") !=
        std::string::npos);
}

TEST_CASE("where there is no sample, none is looked for, and behind it there is one again") {
  const std::string one = rigor_says("given a = 1");
  const std::string two = rigor_says("where a = 2");
  const std::string more = rigor_says("where b = 3");
  CHECK(lines_of(one + two + more + "$$b = 3$$\n" + more + "$$b = 3$$\n") ==
        "given\ngiven 2:19 no-sample\ngiven\nundecided 4:5 undecided\ngiven\nproved\n");
}

TEST_CASE("what is constant and yet changes is said at the directive, and decides nothing") {
  const std::string declared = rigor_says("for all a, z") + rigor_says("vector \\mathbf{w}");
  const auto lines = [&](const std::string& first, const std::string& second, const std::string& claim) {
    const std::string all =
        lines_of(declared + rigor_says(first) + rigor_says(second) + "$$" + claim + "$$\n");
    return all.substr(0, all.find("\n1:"));  // without what is not used of the declarations
  };
  const std::string at_first = "given 3:19 no-sample\n";  // what is constant is so in its whole section
  for (const char* claim : {"\\dot z = 1", "a^3 = a"}) {
    CHECK(lines("given \\dot z = 1", "constant z", claim).starts_with("given 3:19 no-sample\nundecided 5:"));
    CHECK(lines("constant z", "given \\dot z = 1", claim).starts_with("given 4:19 no-sample\nundecided 5:"));
  }
  CHECK(lines("given \\dot w_1 = 1", "constant \\mathbf{w}", "a^3 = a").starts_with(at_first));
  CHECK(lines("given \\dot w_1 = 1", "constant w_1", "a^3 = a").starts_with(at_first));
  CHECK(lines("given \\dot w_1 = 1", "constant w_2", "a^3 = a").starts_with("given\nrefuted"));
  CHECK(lines("given \\dot z = a", "constant z", "a = 0").starts_with("given\nproved\n"));
  CHECK(lines("given \\dot z = a", "constant z", "a^3 = 1").starts_with("given\nrefuted"));
}

TEST_CASE("an assumption about a sum over particles is used inside other sums") {
  const std::string centre = rigor_says("given \\sum_\\alpha m_\\alpha\\mathbf{r}_\\alpha = 0");
  const std::string split =
      "$$\\sum_\\alpha m_\\alpha(\\mathbf{r}_\\alpha+\\mathbf{R})^2 = \\sum_\\alpha m_\\alpha r_\\alpha^2 + "
      "R^2\\sum_\\alpha "
      "m_\\alpha$$\n";
  CHECK(lines_of(centre + split) == "given\nproved\n");
  CHECK(lines_of(split).starts_with("refuted"));
}

TEST_CASE("a declaration makes a letter hold for all values") {
  const std::string symmetric = "$$T_{ij} = T_{ji}$$\n";
  CHECK(lines_of(symmetric) == "law\n");
  CHECK(lines_of(rigor_says("for all T_{ij}") + symmetric) == "refuted 2:10 refuted\n");
  CHECK(lines_of(rigor_says("symmetric tensor T") + symmetric) == "proved\n");
  CHECK(lines_of(rigor_says("for all T_{ij}") + rigor_says("symmetric tensor S") + symmetric +
                 "\n$$S_{ij} = S_{ji}$$\n") == "refuted 3:10 refuted\nproved\n");
}

TEST_CASE("a unit vector has length 1") {
  CHECK(lines_of(rigor_says("unit vector \\mathbf{n}") + "$$\\mathbf{n}\\cdot\\mathbf{n} = 1$$\n") ==
        "proved\n");
  CHECK(lines_of(rigor_says("unit vector \\mathbf{n}") + "$$\\mathbf{n}\\cdot\\mathbf{n} = 2$$\n") ==
        "refuted 2:29 refuted\n");
}

TEST_CASE("a plain letter that is declared a vector is one") {
  CHECK(lines_of(rigor_says("vector A, B") + "$$A_1B_1 + A_2B_2 + A_3B_3 = A_iB_i$$\n") == "proved\n");
  CHECK(lines_of(rigor_says("vector A, B") + "$$A_1B_1 + A_2B_2 - A_3B_3 = A_iB_i$$\n") ==
        "refuted 2:28 refuted\n");
}

TEST_CASE("a declared plain letter is the vector, not its length") {
  CHECK(lines_of(rigor_says("vector A, B") + "$$A\\times B = -B\\times A$$\n") == "proved\n");
  CHECK(lines_of(rigor_says("vector A, B") + "$$A\\times B = B\\times A$$\n") == "refuted 2:13 refuted\n");
}

TEST_CASE("letters that label particles by a directive are no indices") {
  const std::string sum = "$$\\sum_i m_i\\mathbf{r}_i\\cdot\\mathbf{r}_i = ";
  CHECK(lines_of(rigor_says("particles i") + sum + "\\sum_i m_i r_i^2$$\n") == "proved\n");
  CHECK(lines_of(rigor_says("particles i") + sum + "2\\sum_i m_i r_i^2$$\n") == "refuted 2:43 refuted\n");
}

TEST_CASE("a claim is a statement that no display makes") {
  const Checked checked(rigor_says("claim \\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}"));
  CHECK(checked.lines() == "proved\n");
  CHECK(lines_of(rigor_says("claim \\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}")) ==
        "refuted 1:46 refuted\n");
}

TEST_CASE("an expected refutation is marked, one that fails to come is an error") {
  const Checked wrong(rigor_says("expect refuted") + "$$\\delta_{ii} = 3 = 2$$\n");
  REQUIRE(wrong.report.steps.size() == 2);
  CHECK_FALSE(wrong.report.steps[0].expected_refuted);
  CHECK(wrong.report.steps[1].expected_refuted);
  CHECK(wrong.report.diagnostics.empty());
  CHECK(lines_of(rigor_says("expect refuted") + commuted) == "proved\n1:13 unexpected-verdict\n");
  CHECK(lines_of(rigor_says("expect refuted") + commuted + "$$\\delta_{ii} = 2$$\n") ==
        "proved\nrefuted 4:15 refuted\n1:13 unexpected-verdict\n");
}

TEST_CASE("each expectation excuses one refuted step of the next chain") {
  const std::string scalars = rigor_says("for all a, b");
  const std::string expect = rigor_says("expect refuted");
  const auto excused = [](const std::string& text) {
    const Checked checked(text);
    std::string marks;
    for (const Step& step : checked.report.steps)
      marks += step.expected_refuted ? "e" : step.verdict == Verdict::refuted ? "r" : ".";
    for (const Diagnostic& each : checked.report.diagnostics)
      marks += " " + std::string(info(each.kind).name);
    return marks;
  };
  CHECK(excused(scalars + expect + "$$a = 2a = 3a = 4b$$\n") == "err");
  CHECK(excused(scalars + expect + expect + "$$a = 2a = 3a = 4b$$\n") == "eer");
  CHECK(excused(scalars + expect + expect + "$$a = 2a = a + a$$\n") == "e. unexpected-verdict");
  CHECK(excused(scalars + expect + "$$a = 2a, \\quad b = 3b$$\n") == "er");
  CHECK(excused(scalars + expect + "$$b = b, \\quad a = 2a$$\n") == ".r unexpected-verdict");
  const std::string cyclic = "$$A_1B_2 = B_1A_2 \\quad\\text{and cyclic permutations}$$\n";
  CHECK(excused(rigor_says("vector \\mathbf{A}, \\mathbf{B}") + expect + cyclic) == "eee");
}

TEST_CASE("what is said of the next statement is over with it, also where it is not read") {
  const std::string scalars = rigor_says("for all a, b") + rigor_says("small b");
  const std::string unread = "$$\\frac{a}{c$$\n";
  const std::string bare = "$$a$$\n";
  const std::string square = "$$a^2 = 1$$\n";
  const std::string where = rigor_says("where a = 1");
  const auto last = [](const std::string& text) {
    const Checked checked(text);
    return std::string(name_of(checked.report.steps.back().verdict)) +
           (checked.report.steps.back().expected_refuted ? " as expected" : "");
  };
  CHECK(last(scalars + where + square) == "proved");
  CHECK(last(scalars + where + unread + square) == "refuted");
  CHECK(last(scalars + where + bare + square) == "refuted");
  CHECK(last(scalars + where + rigor_says("skip a figure") + bare + square) == "refuted");
  const std::string first_order = rigor_says("first order");
  const std::string small = "$$(a + b)^2 = a^2 + 2ab$$\n";
  CHECK(last(scalars + first_order + small) == "proved");
  CHECK(last(scalars + first_order + unread + small) == "refuted");
  CHECK(last(scalars + first_order + rigor_says("skip a figure") + bare + small) == "refuted");
  const std::string expect = rigor_says("expect refuted");
  for (const std::string& passed_over : {unread, bare, rigor_says("skip a figure") + square}) {
    const Checked checked(scalars + expect + passed_over + square);
    CHECK_FALSE(checked.report.steps.back().expected_refuted);
    CHECK(
        std::any_of(checked.report.diagnostics.begin(), checked.report.diagnostics.end(),
                    [](const Diagnostic& each) { return each.kind == DiagnosticKind::unexpected_verdict; }));
  }
  CHECK(last(scalars + expect + "# Another section\n" + rigor_says("for all a") + square) == "refuted");
}

TEST_CASE("a definition or an assumption is not what is expected to be refuted") {
  CHECK(lines_of(rigor_says("expect refuted") + rigor_says("let c = 2") + "$$c = 3$$\n") ==
        "definition\nrefuted 3:5 refuted\n");
  CHECK(lines_of(rigor_says("expect refuted") + rigor_says("claim \\delta_{ii} = 2")) ==
        "refuted 2:31 refuted\n");
}

TEST_CASE("a display that is skipped is counted step by step") {
  const Checked checked(rigor_says("skip a table") + "$$\\delta_{ii} = 2 = 1$$\n\n$$\\delta_{ii} = 2$$\n");
  CHECK(checked.lines() == "skipped\nskipped\nrefuted 4:15 refuted\n");
  CHECK(checked.report.steps[0].route == "skip a table");
}

TEST_CASE("a directive that nothing uses is an error at its place") {
  for (const char* directive : {"vector \\mathbf{C}", "scalar c", "symmetric tensor S", "constant k",
                                "let c = 2", "given \\mathbf{C}\\cdot\\mathbf{D} = 0", "particles \\alpha"}) {
    INFO(directive);
    CHECK(lines_of(rigor_says(directive) + commuted).ends_with("1:13 unused-directive\n"));
  }
  CHECK(lines_of(commuted + rigor_says("expect refuted")) == "proved\n3:13 unused-directive\n");
  CHECK(lines_of(commuted + rigor_says("skip it")) == "proved\n3:13 unused-directive\n");
}

TEST_CASE("a directive that something uses is none") {
  CHECK(lines_of(rigor_says("vector \\mathbf{A}") + commuted) == "proved\n");
  CHECK(lines_of(rigor_says("constant k") + "$$k a + b = b + k a$$\n") == "proved\n");
  CHECK(lines_of(rigor_says("let \\mathbf{C} = 2\\mathbf{A}") + "$$\\mathbf{A}\\times\\mathbf{C} = 0$$\n") ==
        "definition\nproved\n");
}

TEST_CASE("a letter is a vector in the whole file, before and behind its bold form") {
  CHECK(lines_of("$$A^2 = A_iA_i$$\n\n$$\\mathbf{A}\\cdot\\mathbf{A} = A^2$$\n") == "proved\nproved\n");
}

TEST_CASE("a display that is not read is one step that is not understood") {
  CHECK(lines_of("$$\\def\\a{\\a\\a} \\a = 0$$\n").starts_with("not-understood 1:"));
  CHECK(lines_of("$$" + std::string(max_display_bytes + 1, 'a') + "$$\n") ==
        "not-understood 1:1 display-too-long\n");
}

TEST_CASE("a mistake that two sides share is reported once a step") {
  CHECK(lines_of(rigor_says("vector \\mathbf A, \\mathbf B, \\mathbf C") + "$$A_iB_iC_i = 0$$") ==
        "not-understood 2:11 index-repeats\n");
  CHECK(lines_of("$$\\foo A = \\foo A$$") == "not-understood 1:3 unsupported, 1:12 unsupported\n");
}

TEST_CASE("progress is told after each event") {
  SourceMap sources;
  Diagnostics diagnostics;
  const FileId file = sources.add("notes.md", "# One\n\n" + commuted + commuted);
  const Notes notes = read_notes(sources, file, nullptr, diagnostics);
  FileReport report;
  std::string told;
  DecisionCache cache;
  const CheckOptions options{
      .progress = [&](std::size_t done,
                      std::size_t all) { told += std::to_string(done) + "/" + std::to_string(all) + " "; },
      .cache = &cache};
  static_cast<void>(walk_through(sources, notes, report, options));
  CHECK(told == "1/3 2/3 3/3 ");
}

TEST_CASE("where is for the next statement only, whatever stands between") {
  const std::string where = rigor_says("where \\mathbf{A}\\cdot\\mathbf{B} = 0");
  CHECK(lines_of(where + square + square) == "given\nproved\nrefuted 4:34 refuted\n");
  CHECK(lines_of(rigor_says("for all a, c") + rigor_says("where a = 1") + rigor_says("let c = 2") +
                 "$$a = 1$$\n\n$$c = 2$$\n\n$$2a = 2$$\n")
            .starts_with("given\ndefinition\nproved\nproved\nrefuted"));
}

TEST_CASE("a heading between where and its statement brings nothing back") {
  const std::string notes = "## One\n\n" + rigor_says("scalar a, b") + rigor_says("given a = 1") +
                            rigor_says("where b = 2") + "## Two\n\n" + rigor_says("scalar a, b") +
                            "$$2b = 4$$\n\n$$2a = 2$$\n";
  CHECK(lines_of(notes).find("proved\nproved") == std::string::npos);
}

TEST_CASE("what is defined under a where stays") {
  CHECK(lines_of(rigor_says("for all a") + rigor_says("where a = 1") +
                 "$$c = a + 1$$\n\n$$c = a + 1$$\n\nHence\n$$c = 2$$\n")
            .starts_with("given\ndefinition\nproved\nrefuted"));
}

TEST_CASE("where, first order and expect go together in any order") {
  const std::string small = rigor_says("scalar x, b") + rigor_says("small x");
  const std::string where = rigor_says("where b = 1");
  const std::string order = rigor_says("first order");
  const std::string expect = rigor_says("expect refuted");
  for (const std::string& words : {where + order + expect, expect + where + order, order + expect + where}) {
    const Checked checked(small + words + "$$(b+x)^2 = 1 + x$$\n");
    CHECK(checked.report.steps.back().expected_refuted);
    CHECK(verdict_on("(b+x)^2 = 1 + 2x", small + where + order) == "proved");
  }
}

TEST_CASE("rules for three components are one for the vector, as long as all three hold") {
  const std::string two = rigor_says("scalar a") + rigor_says("vector \\mathbf{r}") +
                          rigor_says("given \\dot r_2 = 0") + rigor_says("given \\dot r_3 = 0");
  CHECK(verdict_on("\\dot{\\mathbf{r}} = a\\mathbf{e}_1", two + rigor_says("given \\dot r_1 = a")) ==
        "proved");
  CHECK(verdict_on_claim("\\dot r_1 = a", two + rigor_says("where \\dot r_1 = a") + "$$\\dot r_1 = a$$\n\n")
            .starts_with("refuted"));
}

TEST_CASE("a square in brackets defines what is not negative") {
  const std::string notes = rigor_says("scalar a") + "$$(\\Omega)^2 = a^2$$\n\n";
  CHECK(verdict_on("\\Omega^2 = a^2", notes) == "proved");
  CHECK(verdict_on_claim("\\Omega = a", notes).starts_with("refuted"));
}

TEST_CASE("cyclic images are steps of their own") {
  const std::string notes = rigor_says("vector \\mathbf{A}, \\mathbf{B}");
  CHECK(lines_of(notes + "$$(\\mathbf{A}\\times\\mathbf{B})_1 = A_2B_3 - A_3B_2 \\quad \\text{and cyclic "
                         "permutations}$$\n") == "proved\nproved\nproved\n");
}

TEST_CASE("a letter that is free on the other side is not summed, and a prime may only name the axes") {
  const std::string principal = "$$I_{ij} = I_i\\delta_{ij}$$\n\n";
  CHECK(verdict_on("I_{ij}\\omega_j = I_i\\omega_i", principal).starts_with("proved"));
  CHECK(verdict_on_claim("I_{ij}\\omega_j = 2I_i\\omega_i", principal).starts_with("refuted"));
  const std::string primed = rigor_says("rotation \\lambda") + rigor_says("vector \\mathbf{A}");
  CHECK(verdict_on("A_{i'} = \\lambda_{i'j}A_j", primed) == "proved");
  CHECK(verdict_on_claim("A_{i'} = \\lambda_{j'i}A_j", primed).starts_with("refuted"));
  CHECK(verdict_on_claim("A_{i'} = \\lambda_{ji}A_j", primed).starts_with("not-understood"));
  CHECK(verdict_on_claim("A_{i'} = A_i", primed).starts_with("refuted"));
}

TEST_CASE("a dot on a particle's length is read on the vector only where that proves the step") {
  const std::string vector =
      rigor_says("vector \\mathbf{r}, \\mathbf{r}_\\alpha") + rigor_says("particles \\alpha");
  const std::string of_particle =
      "\\dot r_\\alpha^2 = \\dot{\\mathbf{r}}_\\alpha\\cdot\\dot{\\mathbf{r}}_\\alpha";
  CHECK(verdict_on(of_particle, vector).find("dotted-length") != std::string::npos);
  CHECK(verdict_on_claim("\\dot r^2 = \\dot{\\mathbf{r}}\\cdot\\dot{\\mathbf{r}}", vector)
            .starts_with("refuted"));
  CHECK(verdict_on("r\\dot r = \\mathbf{r}\\cdot\\dot{\\mathbf{r}}", vector) == "proved");
  CHECK(verdict_on_claim("\\dot r^2 = 2\\dot{\\mathbf{r}}\\cdot\\dot{\\mathbf{r}}", vector)
            .starts_with("refuted"));
}

TEST_CASE("what a check does not ask for is not kept for each display") {
  std::string text;
  for (int k = 0; k < 600; ++k) text += commuted;
  SourceMap sources;
  const FileId file = sources.add("notes.md", text);
  FileReport report;
  const Notes notes = read_notes(sources, file, nullptr, report.diagnostics);
  DecisionCache counting;
  CheckOptions options;
  options.cache = &counting;
  const Ledger ledger = walk_through(sources, notes, report, options, {});
  CHECK(ledger.behind_events.empty());
  CHECK(report.steps.size() == 600);
  CHECK(report.steps.capacity() == 600);
}
