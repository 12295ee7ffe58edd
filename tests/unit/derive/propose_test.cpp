// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/answer/propose.h"

#include <string>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "derive/answer/coefficient.h"
#include "derive/answer/isolate.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

/// The first reading of a statement's only hole.
struct OneHole {
  explicit OneHole(const std::string& statement) {
    SourceMap sources;
    FormRequest request;
    request.answer_holes = true;
    reading = read_forms_of_text(sources, "", "$$" + statement + "$$\n", request);
  }
  [[nodiscard]] const HoleReading& hole() const { return reading.holes.at(0).readings.at(0); }
  ExprTree& tree() { return reading.forms.tree; }
  [[nodiscard]] std::string print(std::optional<ExprId> id) const {
    return id ? print_latex(reading.forms.tree, *id) : "nothing";
  }
  Proposals proposals(AnswerForm form = AnswerForm::contracted) {
    const HoleProblem problem{.question = hole().questions.at(0),
                              .claim = hole().claim,
                              .hole = hole().symbol,
                              .node = hole().node,
                              .names = {}};
    return propose(tree(), problem, {.form = form});
  }

  FormsReading reading;
};

std::string isolated_from(const std::string& statement) {
  OneHole one(statement);
  const Isolation isolation = isolated(one.tree(), one.hole().claim, one.hole().symbol);
  return isolation.value ? one.print(isolation.value) : isolation.obstacle;
}

}  // namespace

TEST_CASE("sums, products and quotients around a hole are undone") {
  CHECK(isolated_from(R"(a = b + c\square)") == R"(\frac{a - b}{c})");
  CHECK(isolated_from(R"(\frac{a}{\square} = b)") == R"(\frac{a}{b})");
  CHECK(isolated_from(R"(a = -\square)") == "-a");
}

TEST_CASE("what is not linear in a hole is not undone") {
  CHECK(isolated_from(R"(a = \square^2)").find("not linear") != std::string::npos);
  CHECK(isolated_from(R"(a = \cos\square)").find("not linear") != std::string::npos);
}

TEST_CASE("a number before a vector is found by multiplying with the vector") {
  CHECK(isolated_from(R"(\mathbf{A} = \square\,\mathbf{B})") ==
        R"(\frac{\mathbf{A}\cdot\mathbf{B}}{\mathbf{B}\cdot\mathbf{B}})");
}

TEST_CASE("a tensor before two vectors is found by comparing coefficients") {
  OneHole one(R"(A^2 B^2 - (\mathbf{A}\cdot\mathbf{B})^2 = \square\, B_i B_j)");
  const auto value = coefficient_of_vectors(one.tree(), one.hole().claim, one.hole().symbol);
  CHECK(one.print(value) == R"(A^2\delta_{ij} - A_i A_j)");
}

TEST_CASE("a term without the vectors has no coefficient") {
  OneHole one(R"(A^2 B^2 - c = \square\, B_i B_j)");
  CHECK_FALSE(coefficient_of_vectors(one.tree(), one.hole().claim, one.hole().symbol));
}

TEST_CASE("a claim that does not depend on its hole and does not hold is impossible") {
  CHECK(OneHole(R"((a - a)\square = 1)").proposals().impossible);
  CHECK_FALSE(OneHole(R"(a\square = 1)").proposals().impossible);
}

TEST_CASE("what can be added to a vector is found") {
  OneHole cross(R"(\mathbf{A}\times\square = \mathbf{C})");
  const Proposals many = cross.proposals();
  CHECK(cross.print(many.may_be_added) == R"(\mathbf{A})");
  CHECK_FALSE(many.any_vector);
  CHECK(OneHole(R"(\mathbf{A}\cdot\square = c)").proposals().any_vector);
  CHECK_FALSE(OneHole(R"(2\square = \mathbf{C})").proposals().may_be_added);
}

TEST_CASE("components are written out along the axes") {
  OneHole one(R"(\mathbf{A}\cdot\mathbf{B} = \square)");
  const Proposals proposals = one.proposals(AnswerForm::components);
  REQUIRE(proposals.values.size() >= 1);
  CHECK(one.print(proposals.values[0]) == "A_1 B_1 + A_2 B_2 + A_3 B_3");
}

}  // namespace rigor
