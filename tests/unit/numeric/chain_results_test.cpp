// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/chain_results.h"

#include <algorithm>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "numeric/body/body_letters.h"
#include "report/wording/advice.h"

namespace rigor {
namespace {

struct Measured {
  SourceMap sources;
  FormsReading reading;
  const WrittenFormChain* chain = nullptr;
  ChainResult result;

  explicit Measured(const std::string& notes, const std::vector<Body>& bodies = {}) {
    reading = read_forms_of_text(sources, "notes.md", notes, {});
    chain = &reading.forms.chains.back();
    result = measure_chain(reading.forms, *chain, bodies, {.times = false});
  }
  [[nodiscard]] const ErrorMeasure& in_double(const std::string& trial, std::size_t form) const {
    const auto found = std::find_if(result.trials.begin(), result.trials.end(),
                                    [&](const TrialResult& each) { return each.name == trial; });
    REQUIRE(found != result.trials.end());
    return found->forms[form].measure.arithmetics[static_cast<std::size_t>(Arithmetic::plain)];
  }
};

const std::string square_of_cross =
    "$$|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2$$";

const std::string energy =
    "<!-- rigor:\nparticles \\alpha\nvector \\mathbf{r}_\\alpha, \\boldsymbol{\\omega}\n-->\n"
    "$$T = \\frac{1}{2}\\sum_\\alpha m_\\alpha |\\boldsymbol{\\omega}\\times\\mathbf{r}_\\alpha|^2 = "
    "\\frac{1}{2}\\sum_\\alpha m_\\alpha(\\omega^2r_\\alpha^2 - "
    "(\\boldsymbol{\\omega}\\cdot\\mathbf{r}_\\alpha)^2)$$";

Body rod(double half) {
  auto body = point_masses("rod", {1, 1}, {{0, 0, half}, {0, 0, -half}});
  REQUIRE(body.has_value());
  return *body;
}

}  // namespace

TEST_CASE("nearly parallel vectors show which form of a cross product's square keeps its digits") {
  const Measured measured(square_of_cross);
  REQUIRE(measured.result.forms.size() == 2);
  CHECK(measured.in_double("random", 1).relative.worst < 1e-9);
  CHECK(measured.in_double("angle 1e-08", 0).relative.worst < 1e-6);
  CHECK(measured.in_double("angle 1e-08", 1).relative.worst > 1);
  CHECK(measured.in_double("angle 1e-08", 1).wrong_signs > 0);
  CHECK(measured.in_double("lengths 1e+160", 0).overflows == 0);
  CHECK(measured.in_double("lengths 1e+160", 1).overflows > 0);
  const auto advice = advise(measured.result);
  REQUIRE(advice);
  CHECK(advice->form == 0);
  CHECK_FALSE(advice->all_alike);
  const std::string text = advice_text(measured.result, *advice);
  CHECK(text.starts_with(
      "Compute A (14 operations). B (18 operations) overflows in 1024 of 1024 on `lengths 1e+160`"));
}

TEST_CASE("forms that err alike are told apart by what they cost") {
  const Measured measured("<!-- rigor: scalar a -->\n$$3a + a - a = 3a$$");
  const auto cheaper = advise(measured.result);
  REQUIRE(cheaper);
  CHECK(cheaper->form == 1);
  const Measured alike("<!-- rigor: scalar a -->\n$$a + a = 2a$$");
  const auto advice = advise(alike.result);
  REQUIRE(advice);
  CHECK(advice->all_alike);
  CHECK(advice_text(alike.result, *advice) ==
        "Both forms are equally accurate; A is the cheapest (1 operation).");
}

TEST_CASE("nothing is advised between forms that are not proved to be equal") {
  const auto why = [](const std::string& notes) { return Measured(notes).result.not_comparable; };
  CHECK(why(square_of_cross).empty());
  CHECK(why("$$|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 + (\\mathbf{A}\\cdot\\mathbf{B})^2$$") ==
        "`|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 + (\\mathbf{A}\\cdot\\mathbf{B})^2` is refuted");
  CHECK(why("<!-- rigor: scalar a, b -->\n$$a^2 + b^2 \\ge 2ab$$") == "`a^2 + b^2 \\ge 2ab` is no equality");
  CHECK(why("<!-- rigor:\nscalar a, x\nsmall x\n-->\n$$(a + x)^2 \\approx a^2 + 2ax$$") ==
        "`(a + x)^2 \\approx a^2 + 2ax` is no equality");
  const Measured wrong("$$\\mathbf{A}\\times\\mathbf{B} = 2\\mathbf{B}\\times\\mathbf{A}$$");
  CHECK_FALSE(advise(wrong.result));
}

TEST_CASE("a form without a value where another has one is not advised") {
  const Measured measured(
      "<!-- rigor: scalar a, b, c -->\n$$a^2 - b^2 = \\frac{(a^2 - b^2)(c - c)}{c - c}$$");
  REQUIRE(measured.result.forms.size() == 2);
  CHECK(measured.in_double("random", 1).undefined > 0);
  if (const auto advice = advise(measured.result)) CHECK(advice->form == 0);
}

TEST_CASE("numbers that break an assumption do not count for the advice") {
  const Measured measured("<!-- rigor:\nscalar a, b\ngiven a + b = 0\n-->\n$$a^3 = -b^3$$");
  REQUIRE(measured.result.trials.size() > 1);
  for (const TrialResult& trial : measured.result.trials) CHECK_FALSE(trial.met);
  CHECK_FALSE(advise(measured.result));
  const Measured positive("<!-- rigor:\nscalar a\ngiven a > 0\n-->\n$$3a + a - a = 3a$$");
  CHECK(positive.result.trials[0].met);
  CHECK(advise(positive.result));
}

TEST_CASE("a name is not computed beside what it names, and a bare letter is not computed at all") {
  const Measured measured(energy);
  REQUIRE(measured.result.forms.size() == 2);
  CHECK(measured.result.forms[0].side == 1);
  CHECK(measured.result.forms[1].side == 2);
  const Measured letter("<!-- rigor: scalar a, b -->\n$$a = b$$");
  CHECK(letter.result.forms.empty());
  CHECK(letter.result.trials.empty());
}

TEST_CASE("with bodies there is a trial for each, and one about its thin axis") {
  const Measured measured(energy, {rod(1)});
  std::vector<std::string> names;
  for (const TrialResult& trial : measured.result.trials) names.push_back(trial.name);
  CHECK(names == std::vector<std::string>{"rod", "rod, thin axis"});
  CHECK(measured.result.trials[0].particles == 2);
  CHECK(measured.result.taken_for == "`m` for the masses, `\\mathbf{r}` for the positions");
  CHECK(measured.in_double("rod", 0).relative.worst < 1e-14);
}

TEST_CASE("a form that is not understood is named, and the others are evaluated") {
  const Measured measured("<!-- rigor: scalar a -->\n$$a + a = 2a = \\oint a \\, dx$$");
  REQUIRE(measured.result.left_out.size() == 1);
  CHECK(measured.result.left_out[0].side == 2);
  CHECK(measured.result.forms.size() == 2);
}

TEST_CASE("letters that could each be the mass are not guessed") {
  const std::string two =
      "<!-- rigor:\nparticles \\alpha\nscalar a_\\alpha, b_\\alpha\n-->\n$$\\sum_\\alpha a_\\alpha b_\\alpha "
      "+ "
      "\\sum_\\alpha b_\\alpha a_\\alpha = 2\\sum_\\alpha a_\\alpha b_\\alpha$$";
  const Measured measured(two, {rod(1)});
  CHECK(measured.result.trials.empty());
  CHECK(measured.result.no_trials == "each of `a`, `b` can be the mass of the particles");
}

TEST_CASE("the same seed gives the same results") {
  const Measured first(square_of_cross);
  const Measured second(square_of_cross);
  for (std::size_t k = 0; k < first.result.trials.size(); ++k) {
    CHECK(first.result.trials[k].forms[1].first == second.result.trials[k].forms[1].first);
    CHECK(first.in_double(first.result.trials[k].name, 1).relative.worst ==
          second.in_double(first.result.trials[k].name, 1).relative.worst);
  }
}

}  // namespace rigor
