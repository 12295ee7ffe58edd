// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/chain_results.h"

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

  explicit Measured(const std::string& notes, const std::vector<Body>& bodies = {},
                    std::map<std::string, std::vector<double>> values = {}) {
    reading = read_forms_of_text(sources, "notes.md", notes, {});
    chain = &reading.forms.chains.back();
    result = measure_chain(reading.forms, *chain, bodies, {.times = false, .values = std::move(values)});
  }
  /// What is advised, in words.
  [[nodiscard]] std::string text() const {
    const auto advice = advise(result);
    REQUIRE(advice);
    return advice_text(result, *advice);
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
  CHECK(text.starts_with("Compute A (14 operations). B (18 operations) "));
  CHECK(text.find(" at \\mathbf{A} = (") != std::string::npos);
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

TEST_CASE("a library's function is one operation where the notes have its name, and a quotient stays one") {
  const Measured measured(
      "$$\\tanh x = \\frac{e^x - e^{-x}}{e^x + e^{-x}}$$\n\n"
      "$$\\tan x + \\sinh x + \\cosh x = \\frac{\\sin x}{\\cos x} + e^x$$");
  REQUIRE(measured.reading.forms.chains.size() == 2);
  const ChainResult tanh =
      measure_chain(measured.reading.forms, measured.reading.forms.chains[0], {}, {.times = false});
  REQUIRE(tanh.forms.size() == 2);
  CHECK(tanh.forms[0].operations == 1);
  CHECK(tanh.forms[1].operations == 6);
  REQUIRE(measured.result.forms.size() == 2);
  CHECK(measured.result.forms[0].operations == 5);
  CHECK(measured.result.forms[1].operations == 5);
  CHECK(measured.in_double("random", 0).relative.worst < 1e-12);
}

TEST_CASE("words beside a row say where its numbers lie, though its proof does not need them") {
  const std::string reduced = "$$\\frac{mM}{m+M} = \\frac{m}{1 + m/M}";
  const auto worst = [](const Measured& measured) {
    REQUIRE(measured.result.search);
    REQUIRE(measured.result.search->ranges.size() == 1);
    return measured.result.search->ranges[0].losing;
  };
  CHECK(worst(Measured(reduced + " \\qquad (m > 0, M > 0)$$")).empty());
  const std::vector<WorstPoint> losing = worst(Measured(reduced + "$$"));
  REQUIRE(losing.size() == 1);
  CHECK(losing[0].form == 1);
  CHECK(losing[0].values.at("m")[0] * losing[0].values.at("M")[0] < 0);
}

TEST_CASE("each half of the roots of a quadratic equation has its form") {
  const Measured measured(
      "$$\\frac{-b + \\sqrt{b^2-4ac}}{2a} = \\frac{-2c}{b + \\sqrt{b^2-4ac}} \\qquad (b^2 > 4ac)$$");
  REQUIRE(measured.result.search);
  const std::vector<FormForRange>& ranges = measured.result.search->ranges;
  REQUIRE(ranges.size() == 2);
  CHECK(ranges[0].form == 1);
  CHECK(ranges[0].where == " where b > 0");
  CHECK(ranges[1].form == 0);
  CHECK(ranges[1].where == " where b < 0");
}

TEST_CASE("a form that loses at some point errs there as it is said when the numbers are put in again") {
  const Measured measured("$$x^2 - y^2 = (x-y)(x+y)$$");
  REQUIRE(measured.result.search);
  REQUIRE(measured.result.search->ranges.size() == 1);
  REQUIRE(measured.result.search->ranges[0].losing.size() == 1);
  const WorstPoint& worst = measured.result.search->ranges[0].losing[0];
  CHECK(worst.form == 0);
  CHECK(in_double(worst.forms[0]).relative.worst > 1e-8);
  CHECK(in_double(worst.forms[1]).relative.worst < 1e-15);
  TrialOptions options{.times = false};
  options.values = worst.values;
  const ChainResult again = measure_chain(measured.reading.forms, *measured.chain, {}, options);
  REQUIRE(again.trials.size() == 1);
  for (std::size_t form = 0; form < 2; ++form) {
    CHECK(in_double(again.trials[0].forms[form]).relative.worst ==
          in_double(worst.forms[form]).relative.worst);
  }
  options.values.erase("y");
  CHECK(measure_chain(measured.reading.forms, *measured.chain, {}, options).no_trials == "`y` has no value");
  const Measured sum(energy);
  CHECK(measure_chain(sum.reading.forms, *sum.chain, {}, options)
            .no_trials.ends_with("belongs to particles, which only a body gives"));
}

TEST_CASE("a form that only overflows is not called equally accurate") {
  const Measured measured("For $a>0$ and $b>0$,\n$$\\frac{10^{60}a}{10^{60}b} = \\frac ab$$");
  const std::string text = measured.text();
  CHECK(text.starts_with("Compute B (1 operation). A (7 operations) "));
  CHECK(text.find("overflows at ") != std::string::npos);
}

TEST_CASE("given numbers say nothing of others") {
  const Measured measured("$$\\frac{a^2 - b^2}{a - b} = a + b$$", {}, {{"a", {3}}, {"b", {1}}});
  CHECK(measured.text() ==
        "Both forms are equally accurate at these numbers; B is the cheapest (1 operation).");
}

TEST_CASE("where a form is 0/0 in exact numbers no digits are lost") {
  const Measured measured("$$\\frac{a^2 - b^2}{a - b} = a + b$$");
  REQUIRE(measured.result.search);
  REQUIRE(measured.result.search->ranges.size() == 1);
  REQUIRE(measured.result.search->ranges[0].losing.size() == 1);
  const WorstPoint& worst = measured.result.search->ranges[0].losing[0];
  CHECK(worst.values.at("a") != worst.values.at("b"));
}

TEST_CASE("a point at which nothing is lost by the measured errors is left out") {
  Measured measured("$$\\frac{a^2 - b^2}{a - b} = a + b$$");
  WorstPoint& worst = measured.result.search->ranges[0].losing[0];
  worst.forms[0] = worst.forms[1];
  CHECK(measured.text() == "Compute B (1 operation).");
}

TEST_CASE("a point at which nothing can be compared has no value") {
  Measured measured("$$\\frac{a^2 - b^2}{a - b} = a + b$$");
  WorstPoint& worst = measured.result.search->ranges[0].losing[0];
  ErrorMeasure& in_double = worst.forms[0].measure.arithmetics[static_cast<std::size_t>(Arithmetic::plain)];
  in_double = {};
  in_double.undefined = 1;
  worst.at = "a = 1, b = 1";
  CHECK(measured.text() == "Compute B (1 operation). A (5 operations) has no value at a = 1, b = 1.");
}

TEST_CASE("forms of unit vectors alone are not searched") {
  const Measured measured(
      "<!-- rigor:\nunit vector \\mathbf{n}, \\mathbf{k}\n-->\n"
      "$$|\\mathbf{n}\\times\\mathbf{k}|^2 = 1 - (\\mathbf{n}\\cdot\\mathbf{k})^2$$");
  REQUIRE(measured.result.forms.size() == 2);
  CHECK_FALSE(measured.result.search);
  CHECK(advise(measured.result));
}

TEST_CASE("where no form keeps its digits the advice says where each loses") {
  const Measured measured("$$(x+y)^2 - x^2 - y^2 = (x - y)^2 - x^2 - y^2 + 4xy$$");
  REQUIRE(measured.result.search);
  const auto advice = advise(measured.result);
  REQUIRE(advice);
  const std::string text = advice_text(measured.result, *advice);
  if (measured.result.search->ranges.empty()) CHECK(text.starts_with("No form keeps its digits"));
  for (const FormForRange& range : measured.result.search->ranges) CHECK(range.form < 2);
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
