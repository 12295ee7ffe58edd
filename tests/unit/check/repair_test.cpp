// SPDX-License-Identifier: GPL-3.0-or-later
// A small wrong note in, the nearest true statements out.
#include "check/repair/repair.h"

#include <algorithm>

#include "catch.h"
#include "check/checked.h"
#include "check/question/decision_cache.h"
#include "check/walk/walk.h"

using namespace rigor;

namespace {

const Step& refuted_step(const Checked& checked) {
  const auto found = std::find_if(checked.report.steps.begin(), checked.report.steps.end(),
                                  [](const Step& step) { return step.verdict == Verdict::refuted; });
  REQUIRE(found != checked.report.steps.end());
  return *found;
}

/// What is offered first for the first wrong step of a note, and in which words.
Repair nearest(const std::string& note) {
  const Checked checked(note);
  const Step& step = refuted_step(checked);
  REQUIRE(!step.repairs.empty());
  return step.repairs.front();
}

}  // namespace

TEST_CASE("a wrong sign is named by its term") {
  const Repair repair =
      nearest("$$(\\mathbf{A}\\times\\mathbf{B})^2 = A^2B^2 + (\\mathbf{A}\\cdot\\mathbf{B})^2$$");
  CHECK(repair.statement == "(\\mathbf{A}\\times\\mathbf{B})^2 = A^2B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2");
  CHECK(repair.change == "term 2 on the right has the opposite sign");
  CHECK_FALSE(repair.on_left);
}

TEST_CASE("a wrong coefficient is calculated, whatever it is") {
  const Repair repair = nearest(rigor_says("scalar a, b") + "$$(a + b)^3 = a^3 + 7a^2b + 3ab^2 + b^3$$");
  CHECK(repair.statement == "(a + b)^3 = a^3 + 3a^2b + 3ab^2 + b^3");
  CHECK(repair.change == "term 2 on the right must be 3/7 times as large");
}

TEST_CASE("a term that is one too many, and one that is missing") {
  CHECK(nearest(rigor_says("scalar a, b, c") + "$$a(b + c) = ab + ac + bc$$").statement ==
        "a(b + c) = ab + ac");
  CHECK(
      nearest(
          "$$\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C}) = \\mathbf{B}(\\mathbf{A}\\cdot\\mathbf{C})$$")
          .statement ==
      "\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C}) = \\mathbf{B}(\\mathbf{A}\\cdot\\mathbf{C}) - "
      "\\mathbf{C}(\\mathbf{A}\\cdot\\mathbf{B})");
  CHECK(nearest(rigor_says("scalar a, b") + "$$(a + b)^2 = a^2 + b^2$$").statement ==
        "(a + b)^2 = a^2 + b^2 + 2ab");
}

TEST_CASE("swapped and replaced indices are found") {
  CHECK(nearest("$$\\epsilon_{ijk}A_jB_k = (\\mathbf{B}\\times\\mathbf{A})_i$$").statement ==
        "\\epsilon_{ijk}A_jB_k = (\\mathbf{A}\\times\\mathbf{B})_i");
  const Repair repair = nearest(rigor_says("tensor T_{ij}") + "$$T_{ij}A_iB_j = T_{ij}B_iA_j$$");
  CHECK(repair.statement == "T_{ij}A_iB_j = T_{ji}B_iA_j");
  CHECK(repair.change == "`ji` for `ij` on the right side");
}

TEST_CASE("integrals, sums and roots are mended where no sample has their values") {
  const auto mended = [](const std::string& row) {
    return nearest(rigor_says("claim") + "$$" + row + "$$").statement;
  };
  CHECK(mended("\\int_0^\\pi\\cos x\\,dx = 2") == "\\int_0^\\pi\\sin x\\,dx = 2");
  CHECK(mended("\\int_{-\\infty}^\\infty e^{-ax^2}\\,dx = 2\\sqrt{\\frac{\\pi}{a}}") ==
        "\\int_{-\\infty}^\\infty e^{-ax^2}\\,dx = \\sqrt{\\frac{\\pi}{a}}");
  CHECK(mended("\\sum_{k=0}^\\infty q^k = \\frac{1}{1 + q}") == "\\sum_{k=0}^\\infty q^k = \\frac{1}{1 - q}");
}

TEST_CASE("logarithms and roots are compared by numbers between which they lie") {
  const std::string positive =
      rigor_says("for all a, b") + rigor_says("given a > 0") + rigor_says("given b > 0");
  CHECK(nearest(positive + "$$-\\ln(ab) = \\ln a + \\ln b$$").statement == "\\ln(ab) = \\ln a + \\ln b");
  CHECK(nearest(positive + "$$\\ln(ab) = \\ln a + 3\\ln b$$").change ==
        "term 2 on the right must be 1/3 times as large");
  CHECK(nearest(positive + "$$\\sqrt{a} - \\sqrt{b} = \\frac{a + b}{\\sqrt{a} + \\sqrt{b}}$$").statement ==
        "\\sqrt{a} - \\sqrt{b} = \\frac{a - b}{\\sqrt{a} + \\sqrt{b}}");
}

TEST_CASE("series are mended up to their order, which stays") {
  const std::string small = "For small $x$,\n";
  CHECK(nearest(small + "$$\\cos x = 1 + \\frac{x^2}{2} + O(x^4)$$").statement ==
        "\\cos x = 1 - \\frac{x^2}{2} + O(x^4)");
  CHECK(nearest(small + "$$\\ln(1 + x) = x - x^2 + O(x^3)$$").replacement == "x - \\frac{1}{2}x^2 + O(x^3)");
  CHECK(nearest(small + "$$e^{2x} = 1 + x + O(x^2)$$").on_left == false);
}

TEST_CASE("a component and a letter of a line above can be missing, and a digit one too many") {
  const auto offers = [](const std::string& note, const std::string& statement) {
    const Checked checked(note);
    return std::ranges::any_of(checked.report.steps, [&](const Step& step) {
      return std::ranges::any_of(step.repairs,
                                 [&](const Repair& each) { return each.statement == statement; });
    });
  };
  CHECK(offers("$$\\mathbf{a}\\cdot\\mathbf{b} = a_i$$", "\\mathbf{a}\\cdot\\mathbf{b} = a_ib_i"));
  CHECK(offers(rigor_says("let r = \\frac{2GM}{c^2}") + rigor_says("for all G, M, c") +
                   "$$M + G = G + M$$ $$3r = \\frac{6GG}{c^2}$$",
               "3r = \\frac{6GM}{c^2}"));
  CHECK(offers(rigor_says("for all a") + "$$\\frac{a}{2} + \\frac{a}{2} = \\frac{2a}{12}$$",
               "\\frac{a}{2} + \\frac{a}{2} = \\frac{2a}{2}"));
}

TEST_CASE("the letter that only one side has, and a number in a bracket, can be missing") {
  const auto offers = [](const std::string& note, const std::string& statement) {
    const Checked checked(rigor_says("for all a, b, c") + "$$" + note + "$$");
    const std::vector<Repair>& repairs = refuted_step(checked).repairs;
    return std::any_of(repairs.begin(), repairs.end(),
                       [&](const Repair& repair) { return repair.statement == statement; });
  };
  CHECK(offers("a(b + c) = ab + aa", "a(b + c) = ab + ac"));
  CHECK(offers("(a - 1)(a) = a^2 - 1", "(a - 1)(a + 1) = a^2 - 1"));
}

TEST_CASE("a term of the line before can be the missing one") {
  const std::string note = rigor_says("particles \\alpha") + rigor_says("vector \\mathbf{V}") +
                           "$$\\sum_\\alpha m_\\alpha|\\mathbf{V} + \\mathbf{v}_\\alpha|^2 = \\sum_\\alpha "
                           "m_\\alpha V^2 + 2\\mathbf{V}\\cdot\\sum_\\alpha m_\\alpha\\mathbf{v}_\\alpha + "
                           "\\sum_\\alpha m_\\alpha v_\\alpha^2$$\n\n"
                           "$$\\sum_\\alpha m_\\alpha|\\mathbf{V} + \\mathbf{v}_\\alpha|^2 = \\sum_\\alpha "
                           "m_\\alpha V^2 + \\sum_\\alpha m_\\alpha v_\\alpha^2$$\n";
  CHECK(nearest(note).change ==
        "`+ 2\\mathbf{V}\\cdot\\sum_\\alpha m_\\alpha\\mathbf{v}_\\alpha` is missing on the right side");
}

TEST_CASE("the side that another step supports is believed") {
  const Repair repair = nearest(
      "$$\\mathbf{A}\\cdot(\\mathbf{B} + \\mathbf{C}) = \\mathbf{A}\\cdot\\mathbf{B} + "
      "\\mathbf{A}\\cdot\\mathbf{C} = \\mathbf{B}\\cdot\\mathbf{A} - \\mathbf{C}\\cdot\\mathbf{A}$$");
  CHECK_FALSE(repair.on_left);
}

TEST_CASE("a definition on the left is not what is wrong") {
  const std::string note = rigor_says("scalar m, v") + "$$T = \\frac{1}{2}mv^2$$\n\nHence\n$$T = mv^2$$\n";
  CHECK(nearest(note).statement == "T = \\frac{1}{2}mv^2");
}

TEST_CASE("what holds to first order is mended to first order") {
  const std::string note = rigor_says("scalar x") + rigor_says("small x") + "$$(1 + x)^2 \\approx 1 + x$$\n";
  CHECK(nearest(note).statement == "(1 + x)^2 \\approx 1 + 2x");
}

TEST_CASE("an order is mended, too") {
  CHECK(nearest(rigor_says("for all \\mathbf{A}") + "$$-|\\mathbf{A}|^2 \\ge 0$$").statement ==
        "|\\mathbf{A}|^2 \\ge 0");
}

TEST_CASE("indices that do not fit are mended as well") {
  const Checked checked("$$(\\mathbf{A}\\times\\mathbf{B})_i = \\epsilon_{ijk}A_jB_j$$");
  const Step& step = checked.report.steps.at(0);
  CHECK(step.verdict == Verdict::not_understood);
  REQUIRE(!step.repairs.empty());
  CHECK(step.repairs[0].statement == "(\\mathbf{A}\\times\\mathbf{B})_i = \\epsilon_{ijk}A_jB_k");
  CHECK(step.repairs[0].change == "`k` for `j` on the right side");
}

TEST_CASE("what is true already is not offered: a = a, 0 = 0") {
  const Checked checked("$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$");
  for (const Repair& repair : refuted_step(checked).repairs) {
    CHECK(repair.statement != "\\mathbf{A}\\times\\mathbf{B} = \\mathbf{A}\\times\\mathbf{B}");
    CHECK(repair.statement != "\\mathbf{B}\\times\\mathbf{A} = \\mathbf{B}\\times\\mathbf{A}");
  }
}

TEST_CASE("a term that only repeats the other side is not offered") {
  const Checked zero(rigor_says("vector \\mathbf a") +
                     "$$\\mathbf a\\cdot\\mathbf a = \\mathbf a^2 + 1 - 2$$" + rigor_says("for all \\theta") +
                     "$$\\cos2\\theta = \\cos^2\\theta + \\sin^2\\theta - 1$$");
  for (const Step& step : zero.report.steps) {
    for (const Repair& repair : step.repairs) {
      CHECK_FALSE(repair.statement.starts_with("0 ="));
      CHECK(repair.statement.find("+ \\cos2\\theta") == std::string::npos);
    }
  }
}

TEST_CASE("one missing term is offered once on each side, whatever its order") {
  const Checked checked(rigor_says("unit vector \\mathbf n") +
                        "$$(\\mathbf s - 2(\\mathbf s\\cdot\\mathbf n)\\mathbf n)^2 = s^2 - 4(\\mathbf "
                        "s\\cdot\\mathbf n)^2 + 2(\\mathbf s\\cdot\\mathbf n)^2$$");
  const std::vector<Repair>& repairs = refuted_step(checked).repairs;
  for (const bool on_left : {true, false})
    CHECK(std::ranges::count_if(
              repairs, [&](const Repair& each) { return each.adds_a_term && each.on_left == on_left; }) == 1);
}

TEST_CASE("a change is shown with the faces of its letters") {
  const Repair repair = nearest(rigor_says("for all \\mathbf a") + "$$\\mathbf a\\cdot\\mathbf a = 0$$");
  CHECK(repair.change == "`\\mathbf a\\times\\mathbf a` for `\\mathbf a\\cdot\\mathbf a` on the left side");
}

TEST_CASE("where a side is 0, no term is missing on the other") {
  const Checked checked(rigor_says("for all \\mathbf a, \\mathbf b") +
                        "$$\\mathbf a\\cdot(\\mathbf a\\times\\mathbf b) = \\mathbf a\\cdot\\mathbf b$$");
  const std::vector<Repair>& repairs = refuted_step(checked).repairs;
  REQUIRE(repairs.size() == 1);
  CHECK(repairs[0].change == "the right side is 0");
}

TEST_CASE("what is offered says something, and TeX can set it") {
  for (const std::string statement : {"$$\\mathbf v = 0$$", "$$\\mathbf u - \\mathbf v = 0$$",
                                      "$$\\mathbf v + \\mathbf v = 0$$", "$$\\mathbf u = \\dot{\\mathbf u}$$",
                                      "$$\\mathbf u\\cdot\\mathbf v = \\dot{\\mathbf u}\\cdot\\mathbf v$$",
                                      "$$\\mathbf A\\times\\mathbf B = \\mathbf B\\times\\mathbf A$$"}) {
    const Checked checked(rigor_says("vector \\mathbf u, \\mathbf v") + statement);
    for (const Step& step : checked.report.steps) {
      for (const Repair& repair : step.repairs) {
        INFO(repair.statement << ": " << repair.change);
        CHECK(repair.statement.find("\\mathbf v - \\mathbf v") == std::string::npos);
        CHECK(repair.statement.find("\\mathbf\\dot") == std::string::npos);
        CHECK(repair.change.find("``") == std::string::npos);
        CHECK(!repair.statement.starts_with(" "));
        CHECK(!repair.statement.ends_with("= "));
      }
    }
  }
}

TEST_CASE("brackets make nothing else of a side") {
  const Checked checked(rigor_says("for all a, b") + "$$|a - b| = a - b$$");
  for (const Repair& repair : refuted_step(checked).repairs) CHECK(repair.statement != "(a - b) = a - b");
}

TEST_CASE("each statement that is offered is proved when it is written so") {
  const std::string wrong =
      "$$\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C}) = \\mathbf{B}(\\mathbf{A}\\cdot\\mathbf{C}) + "
      "\\mathbf{C}(\\mathbf{A}\\cdot\\mathbf{B})$$";
  const Checked checked(wrong);
  REQUIRE(!refuted_step(checked).repairs.empty());
  for (const Repair& repair : refuted_step(checked).repairs)
    CHECK(lines_of("$$" + repair.statement + "$$") == "proved\n");
}

TEST_CASE("the search leaves no trace: what follows is read as without it") {
  const std::string wrong = "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n\n";
  const std::string next = "$$\\dot{\\mathbf{A}} = \\mathbf{B}'$$\n\n$$\\mathbf{A}'\\cdot\\mathbf{B} = 0$$\n";
  const auto verdicts = [&](Repairs repairs) {
    SourceMap sources;
    std::string text;
    for (const Step& step : check_text(sources, "note.md", wrong + next, {.repairs = repairs}).steps) {
      text += std::string(name_of(step.verdict)) + " ";
      if (!step.counterexample) continue;
      for (const Counterexample::Value& value : step.counterexample->values)
        text += value.symbol + " " + value.components.front() + " ";
    }
    return text;
  };
  CHECK(verdicts(Repairs::of_all) == verdicts(Repairs::none));
}

TEST_CASE("bars without an argument, and very long sides, do no harm") {
  CHECK_FALSE(refuted_step(Checked(rigor_says("vector \\mathbf{A}") + "$$\\abs*{\\mathbf{A}}^2 = 2A_iA_i$$"))
                  .repairs.empty());
  std::string sum = "A_iA_i";
  for (int k = 0; k < 100; ++k) sum += " + A_iA_i";
  const Checked checked("$$" + sum + " = 2A_iA_i$$");
  CHECK(refuted_step(checked).repairs.empty());
}

TEST_CASE("what is expected to be refuted is mended only if all is asked for") {
  const std::string note =
      rigor_says("expect refuted") + "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n";
  const auto offered = [&](Repairs repairs) {
    SourceMap sources;
    return check_text(sources, "note.md", note, {.repairs = repairs}).steps.at(0).repairs.size();
  };
  CHECK(offered(Repairs::of_unexpected) == 0);
  CHECK(offered(Repairs::of_all) > 0);
}

namespace {

/// Notes that were read and decided, to be asked about one of their rows.
struct Page {
  explicit Page(std::string text) {
    report.file = sources.add("notes.md", std::move(text));
    Diagnostics ignored;
    notes = read_notes(sources, report.file, nullptr, ignored);
    ledger = walk_through(sources, notes, report, {.cache = &cache});
    for (const LedgerEntry& entry : ledger.entries) {
      if (const auto* statement = std::get_if<Statement>(&entry.what))
        rows.push_back({statement, entry.scope});
    }
  }

  /// The first true neighbour of the last row, where the first row is assumed to hold.
  [[nodiscard]] std::vector<TrueNeighbour> near_the_last(bool with_first) {
    Names names = *rows.back().scope;
    const Statement& law = *rows.front().statement;
    Equation equation;
    equation.left = law.sides.at(0)->id;
    equation.right = law.sides.at(1)->id;
    if (with_first) assume(names.scope, {equation, {"the law", {}, std::nullopt}, 0});
    const NeighbourProof by_judge = [](ExprTree& tree, const Names& read, const Claim& claim,
                                       Slip) -> std::optional<std::vector<std::string>> {
      Judgement judgement = judge(tree, read, claim);
      if (judgement.verdict != Verdict::proved) return std::nullopt;
      return judgement.uses;
    };
    return true_neighbours(ledger.tree, names, {.parsed = *rows.back().statement->chain}, by_judge);
  }

  struct Row {
    const Statement* statement;
    std::shared_ptr<const Names> scope;
  };
  SourceMap sources;
  DecisionCache cache;
  FileReport report;
  Notes notes;
  Ledger ledger;
  std::vector<Row> rows;
};

}  // namespace

TEST_CASE("a row is mended by a law that is assumed, and names it") {
  Page page("$$m\\ddot x = -kx$$\n\n$$mx\\ddot x = kx^2$$\n");
  CHECK(page.near_the_last(false).empty());
  const std::vector<TrueNeighbour> found = page.near_the_last(true);
  REQUIRE(!found.empty());
  CHECK(found[0].repair.statement == "mx\\ddot x = -kx^2");
  CHECK(found[0].slip == Slip::sign);
  CHECK(found[0].uses == std::vector<std::string>{"the law"});
}
