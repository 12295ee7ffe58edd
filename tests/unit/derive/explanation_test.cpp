// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/explanation.h"

#include "algebra/decide/decide.h"
#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "expr/print/print_latex.h"

using namespace rigor;

namespace {

/// Notes, and the explanation of one of their steps.
struct Explained {
  FormsReading reading;
  Explanation explanation;
  std::size_t chain = 0;

  Explained(const std::string& notes, std::size_t which_chain, std::size_t step = 0) : chain(which_chain) {
    SourceMap sources;
    reading = read_forms_of_text(sources, "notes.md", notes, {});
    REQUIRE(chain < reading.forms.chains.size());
    explanation = explain_step(reading.forms, chain, step);
  }

  [[nodiscard]] std::string latex(ExprId id) const {
    return print_latex(reading.forms.tree, id, notation_at(reading.forms, reading.forms.chains[chain]));
  }
  /// One line each: `= EXPRESSION  [RULE]`; what is open last.
  [[nodiscard]] std::string lines() const {
    std::string text = latex(explanation.start) + "\n";
    for (const SmallStep& step : explanation.steps)
      text += (step.nearly ? "≈ " : "= ") + latex(step.expr) + "  [" + step.rule + "]\n";
    if (explanation.gap) text += "? " + *explanation.gap + "\n";
    return text;
  }
};

std::string explained(const std::string& notes, std::size_t chain = 0, std::size_t step = 0) {
  return Explained(notes, chain, step).lines();
}

}  // namespace

TEST_CASE("the square of a cross product is worked out in components") {
  const std::string notes = "$$|\\mathbf A\\times\\mathbf B|^2 = A_iA_iB_jB_j - A_iB_iA_jB_j$$";
  CHECK(explained(notes) ==
        "|\\mathbf{A}\\times\\mathbf{B}|^2\n"
        "= \\varepsilon_{ijk} A_j B_k\\varepsilon_{ilm} A_l B_m  [definition of ×, the square of a "
        "length]\n"
        "= \\delta_{jl}\\delta_{km} A_j B_k A_l B_m - \\delta_{jm}\\delta_{kl} A_j B_k A_l B_m  [ε–δ]\n"
        "= A_i A_i B_j B_j - A_i B_i A_j B_j  [δ contracted]\n");
}

TEST_CASE("vectors stay vectors where that is shorter, but no rule explains itself") {
  const std::string sum = "$$(\\mathbf A+\\mathbf B)\\cdot(\\mathbf A-\\mathbf B) = A^2 - B^2$$";
  CHECK(explained(sum) ==
        "(\\mathbf{A} + \\mathbf{B})\\cdot(\\mathbf{A} - \\mathbf{B})\n"
        "= A^2 - \\mathbf{A}\\cdot\\mathbf{B} + \\mathbf{B}\\cdot\\mathbf{A} - B^2  [multiplied out]\n"
        "= A^2 - B^2  [like terms collected]\n");
  const std::string rule =
      "$$\\mathbf A\\times(\\mathbf B\\times\\mathbf C) = (\\mathbf A\\cdot\\mathbf C)\\mathbf B - "
      "(\\mathbf A\\cdot\\mathbf B)\\mathbf C$$";
  const Explained itself(rule, 0);
  CHECK(itself.explanation.letters.size() == 1);
  CHECK(itself.lines().find("[ε–δ]") != std::string::npos);
}

TEST_CASE("definitions are unfolded by the names of their equations") {
  const std::string notes =
      "<!-- rigor: vector \\mathbf{u}, \\mathbf{v} -->\n"
      "$$E = \\mathbf u\\cdot\\mathbf v \\tag{1}$$\n\n$$2E = 2\\,u_iv_i$$\n";
  CHECK(explained(notes, 1) ==
        "2 E\n"
        "= 2\\,\\mathbf{u}\\cdot\\mathbf{v}  [Eq. (1)]\n"
        "= 2 u_i v_i  [definition of ·]\n");
}

TEST_CASE("an earlier equation is used where it makes the chain shorter") {
  const std::string notes =
      "<!-- rigor: vector \\mathbf{u}, \\mathbf{v}, \\mathbf{w} -->\n"
      "$$\\mathbf c = \\mathbf u\\times(\\mathbf v\\times\\mathbf w) = "
      "(\\mathbf u\\cdot\\mathbf w)\\mathbf v - (\\mathbf u\\cdot\\mathbf v)\\mathbf w \\tag{1}$$\n\n"
      "$$\\mathbf c\\cdot\\mathbf v = (\\mathbf u\\cdot\\mathbf w)\\,\\mathbf v\\cdot\\mathbf v - "
      "(\\mathbf u\\cdot\\mathbf v)(\\mathbf w\\cdot\\mathbf v)$$\n";
  const Explained reading(notes, 1);
  CHECK_FALSE(reading.explanation.gap);
  REQUIRE_FALSE(reading.explanation.steps.empty());
  CHECK(reading.explanation.steps[0].rule == "Eq. (1)");
  CHECK(reading.lines().find("×") == std::string::npos);
}

TEST_CASE("an assumption is used by its own words") {
  const std::string notes =
      "<!-- rigor:\nparticles \\alpha\nscalar m_\\alpha\nvector \\mathbf{r}_\\alpha, \\mathbf{a}\n"
      "given \\sum_\\alpha m_\\alpha\\mathbf{r}_\\alpha = 0\n-->\n"
      "$$\\sum_\\alpha m_\\alpha(\\mathbf a + \\mathbf r_\\alpha) = \\mathbf a\\sum_\\alpha m_\\alpha$$\n";
  const std::string lines = explained(notes, 1);
  CHECK(lines.find("[given \\sum_\\alpha m_\\alpha\\mathbf{r}_\\alpha = 0]") != std::string::npos);
  CHECK(lines.find('?') == std::string::npos);
}

TEST_CASE("a length inside its own vector is left as it is") {
  const std::string own =
      "<!-- rigor: given \\mathbf B = (0, 0, B), \\mathbf E = (E, 0, 0) -->\n$$\\mathbf B\\cdot\\mathbf E = "
      "0$$";
  CHECK(explained(own, 2).find('?') == std::string::npos);
  const std::string each_others =
      "<!-- rigor: given \\mathbf B = (0, 0, E), \\mathbf E = (B, 0, 0) -->\n$$\\mathbf B\\cdot\\mathbf E = "
      "0$$";
  CHECK(explained(each_others, 2).find('?') == std::string::npos);
}

TEST_CASE("to first order, what has two small factors is left out in a step that says so") {
  const std::string notes = "<!-- rigor:\nscalar x, d\nsmall d\n-->\n$$(x + d)^2 \\approx x^2 + 2xd$$\n";
  CHECK(explained(notes) ==
        "(x + d)^2\n"
        "= x^2 + x d + d x + d^2  [multiplied out]\n"
        "≈ x^2 + x d + d x  [first order in d]\n"
        "= x^2 + 2 x d  [like terms collected]\n");
}

TEST_CASE("along numbered axes sums are written out") {
  const std::string notes = "$$(\\mathbf A\\times\\mathbf B)_3 = A_1B_2 - A_2B_1$$";
  CHECK(explained(notes).find("[components along the axes 1, 2, 3]") != std::string::npos);
}

TEST_CASE("quotients are brought over a common denominator") {
  const std::string notes = "$$\\frac1x - \\frac1y = \\frac{y - x}{xy}$$";
  const Explained reading(notes, 0);
  CHECK_FALSE(reading.explanation.gap);
}

TEST_CASE("a rule says what was done") {
  const auto rule = [](const std::string& claim, const std::string& before = "") {
    const Explained reading(before + "$$" + claim + "$$", 0);
    INFO(reading.lines());
    REQUIRE(reading.explanation.steps.size() == 1);
    return reading.explanation.steps[0].rule;
  };
  CHECK(rule("|\\mathbf a\\times\\mathbf b|^2 = (\\mathbf a\\times\\mathbf b)\\cdot(\\mathbf "
             "a\\times\\mathbf b)") == "the square of a length");
  CHECK(rule("\\mathbf a\\times\\mathbf b = -\\mathbf b\\times\\mathbf a") ==
        "a×b = −b×a, a·(b×c) = b·(c×a)");
  CHECK(rule("\\varepsilon_{ijk}a_jb_k = b_k\\varepsilon_{ijk}a_j") == "order of terms and factors");
  CHECK(rule("\\varepsilon_{ijk}a_jb_k = -\\varepsilon_{ikj}a_jb_k") == "ε is antisymmetric");
  CHECK(rule("a_ib_i = a_jb_j") == "renamed dummies");
  const std::string numbers = "<!-- rigor: scalar a, b -->\n";
  CHECK(rule("a^2b = baa", numbers) == "powers as products");
  CHECK(rule("baa = a^2b", numbers) == "equal factors as a power");
  CHECK(rule("\\frac ab + \\frac cd = \\frac{ad + bc}{bd}") == "common denominator");
  CHECK(rule("\\frac{ad + bc}{bd} = \\frac ab + \\frac cd") == "divided out");
  CHECK(rule("\\sqrt a\\sqrt a = a") == "square of a root");
  CHECK(rule("\\frac{1}{\\sqrt 2} = \\frac12\\sqrt 2") == "no root in a denominator");
  CHECK(rule("a(b + c) = ab + ac") == "multiplied out");
  CHECK(rule("ab + ac = a(b + c)") == "factored");
}

TEST_CASE("no line is written twice") {
  const std::string notes =
      "$$\\mathbf a\\times\\mathbf b = (a_2b_3 - a_3b_2, a_3b_1 - a_1b_3, a_1b_2 - a_2b_1)$$";
  CHECK(Explained(notes, 0).explanation.steps.size() == 1);
  CHECK(Explained("$$\\frac{1}{a - b} + \\frac{1}{b - a} = 0$$", 0).explanation.steps.size() == 1);
}

TEST_CASE("what is refuted has a gap and no steps") {
  const Explained reading("$$|\\mathbf A\\times\\mathbf B|^2 = A^2B^2 + (\\mathbf A\\cdot\\mathbf B)^2$$", 0);
  CHECK(reading.explanation.steps.empty());
  CHECK(reading.explanation.gap == "it is refuted");
}

TEST_CASE("a question whose claim is false is not explained, whoever asks") {
  Explained reading("$$\\mathbf A\\cdot\\mathbf B = \\mathbf B\\cdot\\mathbf A$$", 0);
  WrittenForms& forms = reading.reading.forms;
  Question question = *forms.chains[0].steps[0].question;
  question.claim.right = forms.tree.add_number({}, "1");
  const Explanation open = explain(forms.tree, question, {});
  CHECK(open.steps.empty());
  CHECK(open.gap == "it is not proved");
}

TEST_CASE("a definition is nothing to be explained") {
  const Explained reading("$$E = \\mathbf u\\cdot\\mathbf v$$", 0);
  CHECK(reading.explanation.gap.has_value());
  CHECK(reading.explanation.steps.empty());
}

TEST_CASE("what is too large to be multiplied out ends with a reason") {
  std::string many = "x_{0}";
  for (int k = 1; k < 12; ++k) many += " + x_{" + std::to_string(k) + "}";
  const Explained reading("$$(" + many + ")^5 - (" + many + ")^5 = 0$$", 0);
  CHECK(reading.explanation.gap.has_value());
}

TEST_CASE("the same notes give the same explanation") {
  const std::string notes =
      "$$[\\mathbf A\\cdot(\\mathbf B\\times\\mathbf C)]^2 = A^2B^2C^2 "
      "+ 2(\\mathbf A\\cdot\\mathbf B)(\\mathbf B\\cdot\\mathbf C)(\\mathbf C\\cdot\\mathbf A) "
      "- A^2(\\mathbf B\\cdot\\mathbf C)^2 - B^2(\\mathbf C\\cdot\\mathbf A)^2 - C^2(\\mathbf "
      "A\\cdot\\mathbf B)^2$$";
  const std::string first = explained(notes);
  CHECK(first == explained(notes));
  CHECK(first.find('?') == std::string::npos);
}
