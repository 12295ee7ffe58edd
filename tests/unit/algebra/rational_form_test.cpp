// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/form/rational_form.h"

#include <string>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

/// Expressions asked for, in one tree.
struct AskedExpressions {
  explicit AskedExpressions(std::vector<std::string> asked) {
    SourceMap sources;
    std::string text = "$$0 = 0";
    for (const std::string& each : asked) text += " = " + each;
    FormRequest request{.asked = std::move(asked)};
    forms = read_forms_of_text(sources, "", text + "$$\n", request).forms;
  }
  [[nodiscard]] std::string print(std::optional<ExprId> id) const {
    return id ? print_latex(forms.tree, *id) : "nothing";
  }
  ExprTree& tree() { return forms.tree; }
  [[nodiscard]] ExprId at(std::size_t k) const { return forms.asked.at(k).expr; }

  WrittenForms forms;
};

std::string in_rational_form(const std::string& latex, RationalForm form) {
  AskedExpressions asked({latex});
  return asked.print(rational_form(asked.tree(), asked.at(0), form));
}

}  // namespace

TEST_CASE("terms stand in the order in which the expression names its parts") {
  CHECK(in_rational_form("(a + b)^2 - c", RationalForm::expanded) == "a^2 + 2 a b + b^2 - c");
  CHECK(in_rational_form("(b + a)^2", RationalForm::expanded) == "b^2 + 2 b a + a^2");
}

TEST_CASE("common factors are cancelled") {
  CHECK(in_rational_form(R"(\frac{a^2 - b^2}{a - b})", RationalForm::expanded) == "a + b");
  CHECK(in_rational_form(R"(\frac{2a}{4b})", RationalForm::expanded) == R"(\frac{a}{2 b})");
}

TEST_CASE("a difference is written with its positive term first") {
  CHECK(in_rational_form("-(a - b)", RationalForm::expanded) == "b - a");
  CHECK(in_rational_form("-(a - b)^3", RationalForm::factored) == "(b - a)^3");
}

TEST_CASE("factors are irreducible, with whole coefficients") {
  CHECK(in_rational_form("a^2 - b^2", RationalForm::factored) == "(a + b)(a - b)");
  CHECK(in_rational_form("2 a b + 2 a c", RationalForm::factored) == "2 a(b + c)");
}

TEST_CASE("a vector's square and its length are one") {
  CHECK(in_rational_form(R"(\mathbf{A}\cdot\mathbf{A} - A^2)", RationalForm::expanded) == "0");
}

TEST_CASE("a division by zero has no form") {
  CHECK(in_rational_form(R"(\frac{a}{b - b})", RationalForm::expanded) == "nothing");
}

TEST_CASE("a polynomial is collected by what is given") {
  AskedExpressions asked({"a x + b x + a b", "x"});
  const ExprId by[] = {asked.at(1)};
  CHECK(asked.print(collected_by(asked.tree(), asked.at(0), by)) == R"((a + b)\,x + a b)");
}

TEST_CASE("what is of second order falls out, and only that") {
  AskedExpressions asked({R"(\frac{(1 + x)^3}{1 - x})", "x"});
  const ExprId in[] = {asked.at(1)};
  CHECK(asked.print(to_first_order(asked.tree(), asked.at(0), in)) == "1 + 4 x");
}

TEST_CASE("a linear equation has one root, a quadratic two") {
  AskedExpressions linear({"a x - b", "x"});
  const Roots one = solved_for(linear.tree(), linear.at(0), linear.at(1));
  REQUIRE(one.values.size() == 1);
  CHECK(linear.print(one.values[0]) == R"(\frac{b}{a})");
  AskedExpressions quadratic({"x^2 - c", "x"});
  CHECK(solved_for(quadratic.tree(), quadratic.at(0), quadratic.at(1)).values.size() == 2);
}

TEST_CASE("what cannot be solved for says why") {
  AskedExpressions cubic({"x^3 - c", "x"});
  CHECK(solved_for(cubic.tree(), cubic.at(0), cubic.at(1)).obstacle ==
        "it occurs to a power higher than the second");
  AskedExpressions hidden({R"(x + \sin x)", "x"});
  CHECK(solved_for(hidden.tree(), hidden.at(0), hidden.at(1)).values.empty());
}

TEST_CASE("a sum over many denominators is given up before it is multiplied out") {
  std::string sum = "0";
  for (int k = 1; k <= 25; ++k) sum += R"( + \frac{1}{x_{)" + std::to_string(k) + "} + y}";
  CHECK(in_rational_form(sum, RationalForm::expanded) == "nothing");
  CHECK(in_rational_form(R"(\frac{1}{)" + sum + "}", RationalForm::expanded) == "nothing");
}

}  // namespace rigor
