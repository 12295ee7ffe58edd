// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/judge.h"

#include <memory>

#include "catch.h"
#include "check/checked.h"
#include "check/directive/directive.h"
#include "elaborate/notation/elaborate.h"
#include "elaborate/reading/equation.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// Statements that are judged beside the names that are in force.
struct Court {
  SyntaxTree syntax;
  ExprTree tree;
  Names names;
  std::vector<std::unique_ptr<Stretch>> stretches;

  struct Elaborated {
    std::unique_ptr<Reading> reading;
    Equation equation;
    WrittenChain written;
  };

  Elaborated elaborate(const std::string& statement) {
    stretches.push_back(std::make_unique<Stretch>(statement));
    Stretch& stretch = *stretches.back();
    const ParsedChain chain = parse_chains(stretch.tokens, "", syntax, stretch.diagnostics).at(0);
    for (const SyntaxId side : chain.sides) sight_sums(syntax, side, names.symbols.sightings.write());
    for (const SyntaxId side : chain.sides) sight_faces(syntax, side, names);
    sight_indices(syntax, chain.sides, names);
    Elaborated result;
    result.reading.reset(
        new Reading{syntax, tree, names, read_letters(syntax, chain.sides, names), stretch.diagnostics});
    const Typed left = rigor::elaborate(*result.reading, chain.sides.at(0)).value();
    const Typed right = rigor::elaborate(*result.reading, chain.sides.at(1)).value();
    result.equation = equate(*result.reading, left, right, {{}, stretch.diagnostics}).value();
    result.written = chain.written;
    return result;
  }

  Judgement judge(const std::string& statement, const Limits& limits = {}) {
    const Elaborated claim = elaborate(statement);
    return rigor::judge(tree, names,
                        {.equation = claim.equation,
                         .relation = claim.written.relations.at(0).span,
                         .left = claim.written.sides.at(0).span,
                         .right = claim.written.sides.at(1).span,
                         .reading = claim.reading.get()},
                        limits);
  }

  void given(const std::string& statement, std::size_t directive) {
    assume(names.scope, {elaborate(statement).equation, {"given " + statement, "", directive}, 0});
  }
};

Verdict verdict(const std::string& statement) { return Court().judge(statement).verdict; }

DiagnosticKind first_kind(const Judgement& judgement) { return judgement.diagnostics.at(0).kind; }

}  // namespace

TEST_CASE("a true equation is proved and its false twins are refuted") {
  CHECK(verdict("|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2") ==
        Verdict::proved);
  CHECK(verdict("|\\mathbf{B}\\times\\mathbf{A}|^2 = A^2B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2") ==
        Verdict::proved);
  CHECK(verdict("|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 + (\\mathbf{A}\\cdot\\mathbf{B})^2") ==
        Verdict::refuted);
  CHECK(verdict("|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B - (\\mathbf{A}\\cdot\\mathbf{B})^2") ==
        Verdict::refuted);
  CHECK(verdict("|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 - \\mathbf{A}\\cdot\\mathbf{B}") ==
        Verdict::refuted);
  CHECK(verdict("|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2") == Verdict::refuted);
}

TEST_CASE("a refutation shows the values, the component and both sides") {
  const Judgement judgement = Court().judge("\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}");
  REQUIRE(judgement.verdict == Verdict::refuted);
  REQUIRE(judgement.counterexample.has_value());
  const Counterexample& example = *judgement.counterexample;
  REQUIRE(example.values.size() == 2);
  CHECK(example.values[0].symbol == "\\mathbf{A}");
  CHECK(example.values[0].rank == 1);
  CHECK(example.values[0].components.size() == 3);
  REQUIRE(example.component.size() == 1);
  CHECK(example.component[0].index.empty());
  CHECK(example.right == "-" + example.left);
  CHECK(first_kind(judgement) == DiagnosticKind::refuted);
  CHECK(judgement.diagnostics[0].labels.size() == 2);
}

TEST_CASE("a refutation in index notation names the indices' values") {
  const Judgement judgement = Court().judge("(\\mathbf{A}\\times\\mathbf{B})_i = \\epsilon_{ijk}A_kB_j");
  REQUIRE(judgement.counterexample.has_value());
  REQUIRE(judgement.counterexample->component.size() == 1);
  CHECK(judgement.counterexample->component[0].index == "i");
}

TEST_CASE("a refutation of a sum over particles needs few of them") {
  const Judgement judgement =
      Court().judge("\\sum_\\alpha m_\\alpha v_\\alpha = -\\sum_\\alpha m_\\alpha v_\\alpha");
  REQUIRE(judgement.counterexample.has_value());
  CHECK(judgement.counterexample->particles >= 1);
  CHECK(judgement.counterexample->particles <= 3);
  CHECK(judgement.counterexample->values.at(0).particle == 1);
}

TEST_CASE("a law is not refuted") {
  const Judgement judgement = Court().judge("m\\mathbf{a} = \\mathbf{F}");
  CHECK(judgement.verdict == Verdict::law);
  CHECK(judgement.not_for_all.size() == 3);
  CHECK(judgement.diagnostics.empty());
  CHECK_FALSE(judgement.counterexample.has_value());
}

TEST_CASE("two constant sides that differ are refuted, though their symbols are not declared") {
  CHECK(verdict("\\mathbf{A}\\cdot(\\mathbf{A}\\times\\mathbf{B}) = 1") == Verdict::refuted);
  CHECK(verdict("\\frac{\\mathbf{A}\\cdot\\mathbf{A}}{A^2} = 2") == Verdict::refuted);
  CHECK(verdict("\\mathbf{A}\\cdot\\mathbf{B} = 1") == Verdict::law);
  CHECK(verdict("\\delta_{ii} = 2") == Verdict::refuted);
  CHECK(verdict("\\delta_{ii} = 3") == Verdict::proved);
}

TEST_CASE("a reading by guess can be proved and never refuted") {
  Court court;
  court.elaborate("\\mathbf{R} = 0");
  CHECK(court.judge("R(R + 1) = R^2 + R").verdict == Verdict::proved);
  const Judgement judgement = court.judge("R_1R_2 = R(R_1 + R_2)");
  CHECK(judgement.verdict == Verdict::not_understood);
  CHECK(first_kind(judgement) == DiagnosticKind::ambiguous_reading);
  CHECK_FALSE(judgement.counterexample.has_value());
}

TEST_CASE("words that may restrict an equation stop its refutation, not its proof") {
  Court court;
  const Obstacle doubt{DiagnosticKind::unsupported, "the words `nearly` may restrict it", {}};
  const auto judged = [&](const std::string& statement) {
    const Court::Elaborated claim = court.elaborate(statement);
    return rigor::judge(court.tree, court.names,
                        {.equation = claim.equation, .reading = claim.reading.get(), .doubt = &doubt});
  };
  CHECK(judged("\\mathbf{A}\\times\\mathbf{B} = -\\mathbf{B}\\times\\mathbf{A}").verdict == Verdict::proved);
  const Judgement judgement = judged("\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}");
  CHECK(judgement.verdict == Verdict::not_understood);
  CHECK(first_kind(judgement) == DiagnosticKind::unsupported);
}

TEST_CASE("nothing is proved from an assumption that no sample satisfies") {
  Court court;
  court.given("\\mathbf{A}\\cdot\\mathbf{A} = -1", 0);
  doubt_last_assumption(court.names.scope);
  CHECK(court.judge("\\mathbf{A}\\cdot\\mathbf{A} = -1").verdict == Verdict::undecided);
}

TEST_CASE("zero on both sides is reported unless a zero was written") {
  Court court;
  const Judgement hidden = court.judge(
      "\\mathbf{A}\\cdot(\\mathbf{A}\\times\\mathbf{B}) = \\mathbf{B}\\cdot(\\mathbf{A}\\times\\mathbf{B})");
  CHECK(hidden.verdict == Verdict::proved);
  CHECK(first_kind(hidden) == DiagnosticKind::zero_equals_zero);
  CHECK(hidden.route.ends_with("0 = 0"));
  const Judgement written = court.judge("\\mathbf{A}\\cdot(\\mathbf{A}\\times\\mathbf{B}) = 0");
  CHECK(written.verdict == Verdict::proved);
  CHECK(written.diagnostics.empty());
}

TEST_CASE("a proof says which assumptions and conventions it used") {
  Court court;
  court.given("\\mathbf{A}\\cdot\\mathbf{B} = 0", 3);
  const Judgement judgement = court.judge("|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2");
  CHECK(judgement.verdict == Verdict::proved);
  REQUIRE(judgement.uses.size() == 3);
  CHECK(judgement.uses[0] == "given \\mathbf{A}\\cdot\\mathbf{B} = 0");
  CHECK(judgement.uses[1] == "convention: `A` is the length of `\\mathbf{A}`");
  CHECK(judgement.used == std::set<std::size_t>{3});
}

TEST_CASE("a proof that needs no assumption uses none") {
  Court court;
  court.given("\\mathbf{A}\\cdot\\mathbf{B} = 0", 3);
  const Judgement judgement = court.judge("\\mathbf{A}\\times\\mathbf{B} = -\\mathbf{B}\\times\\mathbf{A}");
  CHECK(judgement.uses.empty());
  CHECK(judgement.used.empty());
}

TEST_CASE("a sample that refutes satisfies the assumptions") {
  Court court;
  court.given("\\mathbf{A}\\cdot\\mathbf{B} = 0", 0);
  const Judgement judgement = court.judge("|\\mathbf{A}\\times\\mathbf{B}|^2 = 2A^2B^2");
  REQUIRE(judgement.counterexample.has_value());
  CHECK(judgement.counterexample->left != "0");
  CHECK(judgement.used == std::set<std::size_t>{0});
}

TEST_CASE("assumptions have a sample, or none") {
  Court possible;
  CHECK(sample_of_assumptions(possible.tree, possible.names).has_value());
  possible.given("\\mathbf{A}\\cdot\\mathbf{B} = 0", 0);
  CHECK(sample_of_assumptions(possible.tree, possible.names).has_value());
  Court impossible;
  impossible.given("\\mathbf{A}\\cdot\\mathbf{A} = -1", 0);
  CHECK_FALSE(sample_of_assumptions(impossible.tree, impossible.names).has_value());
}

TEST_CASE("an order is decided, with its equality cases") {
  const std::string numbers = rigor_says("scalar a, b");
  CHECK(verdict_on("a^2 + b^2 \\ge 2ab", numbers) == "proved");
  CHECK(verdict_on_claim("a^2 + b^2 > 2ab", numbers).starts_with("refuted"));
  CHECK(verdict_on_claim("a^2 + b^2 \\ne 2ab", numbers).starts_with("refuted"));
  CHECK(verdict_on_claim("a^2 < b^2", numbers + rigor_says("given a < b")).starts_with("refuted"));
}

TEST_CASE("an order of vectors may be meant in each component, one with a number's name is none") {
  CHECK(verdict_on("\\mathbf{a} < \\mathbf{b}") == "not-understood 2:12 ambiguous-reading");
  CHECK(verdict_on("m < \\mathbf{b}", rigor_says("scalar m")).find("rank-mismatch") != std::string::npos);
}

TEST_CASE("a counterexample to a greater-than shows the sides as they were written") {
  const Checked checked("$$0 > 1$$\n");
  REQUIRE(checked.report.steps.back().counterexample.has_value());
  CHECK(checked.report.steps.back().counterexample->left == "0");
  CHECK(checked.report.steps.back().counterexample->right == "1");
}

TEST_CASE("nearly equal compares both orders") {
  const std::string small = rigor_says("scalar a, x") + rigor_says("small x");
  CHECK(verdict_on("(a+x)^3 \\approx a^3 + 3a^2x", small) == "proved");
  CHECK(verdict_on_claim("(a+x)^3 \\approx a^3", small).starts_with("refuted"));
  CHECK(verdict_on_claim("(a+x)^3 \\approx 2a^3 + 3a^2x", small).starts_with("refuted"));
}

TEST_CASE("what is differentiated and may change is a doubt, not a refutation") {
  CHECK(verdict_on("\\frac{d}{dt}(m\\mathbf{v}) = m\\dot{\\mathbf{v}}") == "proved");
  CHECK(verdict_on("\\mathbf{v}\\times\\frac{d}{dt}(m\\mathbf{v}) = m\\mathbf{v}\\times\\dot{\\mathbf{v}}") ==
        "proved");
  CHECK(verdict_on_claim("\\frac{d}{dt}(m\\mathbf{v}) = m\\dot{\\mathbf{v}}",
                         rigor_says("scalar m") + rigor_says("vector \\mathbf{v}") + rigor_says("variable m"))
            .starts_with("refuted"));
}

TEST_CASE("a component that is declared as a number of its own is not refuted") {
  const std::string tensor =
      rigor_says("symmetric tensor I_{ij}") + rigor_says("given I_{ij} = I_i\\delta_{ij} (\\text{no sum})");
  CHECK(verdict_on("I_{11} = I_1", tensor) == "proved");
  CHECK(
      verdict_on("I_{11} = I_1", rigor_says("scalar I_1, I_2, I_3") + tensor).starts_with("not-understood"));
  CHECK_FALSE(verdict_on("I_{11} = 2I_1", tensor) == "proved");
}

TEST_CASE(
    "where sides are nearly equal only if a divisor is not 0, their first-order parts are asked as well") {
  const Checked checked(rigor_says("scalar a, b, d, p, q, r, e") + rigor_says("small e") +
                        rigor_says("let a = \\frac{b}{d}") + rigor_says("given d p = d q") +
                        rigor_says("for all p, q, r, e, d") + "$$p \\approx q + er$$\n\n$$p \\approx q$$");
  const std::size_t count = checked.report.steps.size();
  CHECK(checked.report.steps.at(count - 2).verdict == Verdict::refuted);
  CHECK(checked.report.steps.at(count - 1).verdict == Verdict::proved);
}

TEST_CASE("where only proofs count, what is not proved is not weighed") {
  Limits limits;
  limits.only_proofs = true;
  Court court;
  CHECK(court.judge("\\mathbf{A}\\times\\mathbf{B} = -\\mathbf{B}\\times\\mathbf{A}", limits).verdict ==
        Verdict::proved);
  const std::string wrong = "\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}";
  CHECK(court.judge(wrong).verdict == Verdict::refuted);
  const Judgement judgement = court.judge(wrong, limits);
  CHECK(judgement.verdict == Verdict::undecided);
  CHECK_FALSE(judgement.counterexample);
  CHECK_FALSE(judgement.sample);
}
