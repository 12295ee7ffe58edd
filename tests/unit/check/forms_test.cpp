// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/form/forms.h"
#include "check/entry/read_forms.h"

#include <algorithm>

#include "catch.h"

using namespace rigor;

namespace {

constexpr const char* notes = R"(
# Energy

<!-- rigor:
particles \alpha
scalar m_\alpha, g
vector \mathbf{r}_\alpha, \boldsymbol{\omega}
let \mathbf{v}_\alpha = \boldsymbol{\omega}\times\mathbf{r}_\alpha
-->
$$T_{\text{rot}} = \frac{1}{2}\sum_\alpha m_\alpha |\mathbf{v}_\alpha|^2
  = \frac{1}{2}\sum_\alpha m_\alpha \mathbf{v}_\alpha\cdot\mathbf{v}_\alpha \tag{1}$$
$$M = \sum_\alpha m_\alpha \tag{2}$$

## Weight

$$W = Mg \tag{3}$$
Therefore
$$W = 2Mg$$
)";

FormsReading read(const FormRequest& request, const std::string& text = notes) {
  SourceMap sources;
  return read_forms_of_text(sources, "energy.md", text, request);
}

std::vector<std::string> messages(const FormsReading& reading) {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : reading.report.diagnostics) {
    texts.push_back(diagnostic.message);
    for (const std::string& help : diagnostic.help) texts.push_back(help);
  }
  return texts;
}

}  // namespace

TEST_CASE("every chain of the notes is handed over with its forms as they were written") {
  const FormsReading reading = read({});
  const auto& chains = reading.forms.chains;
  REQUIRE(chains.size() == 5);  // with that of `let`
  CHECK(chains[0].assumed);
  CHECK(chains[1].tag == "(1)");
  REQUIRE(chains[1].forms.size() == 3);
  CHECK(chains[1].forms[2].source ==
        "\\frac{1}{2}\\sum_\\alpha m_\\alpha \\mathbf{v}_\\alpha\\cdot\\mathbf{v}_\\alpha");
  CHECK(chains[1].steps[0].defines);
  CHECK(chains[1].steps[1].outcome == Outcome::proved);
  CHECK(chains[1].steps[1].question.has_value());
  CHECK(chains[4].section == "Weight");
}

TEST_CASE("a chain has the definitions that its forms rest on, and not the others") {
  const FormsReading reading = read({});
  const auto names = [&](const WrittenFormChain& chain) {
    std::vector<std::string> defined;
    for (const Definition& definition : chain.definitions)
      defined.push_back(reading.forms.tree.symbols[definition.symbol].name);
    std::sort(defined.begin(), defined.end());
    return defined;
  };
  CHECK(names(reading.forms.chains[1]) == std::vector<std::string>{"T_{\\text{rot}}", "\\mathbf{v}"});
  CHECK(names(reading.forms.chains[3]) == std::vector<std::string>{"M", "W"});
}

TEST_CASE("a refuted step keeps the sample of the exact side") {
  const FormsReading reading = read({});
  const WrittenStep& wrong = reading.forms.chains[4].steps[0];
  REQUIRE(wrong.outcome == Outcome::refuted);
  REQUIRE(wrong.sample.has_value());
  CHECK(wrong.sample->left != wrong.sample->right);
}

TEST_CASE("what is asked is read in the notes' own letters, with the definitions that it needs") {
  const FormsReading reading = read({.asked = {"T_{rot}", "\\mathbf{v}_\\alpha", "m_\\alpha"}, .only = {{}}});
  CHECK(messages(reading).empty());
  REQUIRE(reading.forms.asked.size() == 3);
  const ExprTree& tree = reading.forms.tree;
  CHECK(tree.symbols[tree[reading.forms.asked[0].expr].symbol].name == "T_{\\text{rot}}");
  CHECK(reading.forms.asked[1].particles.size() == 1);
  CHECK(reading.forms.definitions.size() == 2);
}

TEST_CASE("what is asked may have brackets that grow, as in a display") {
  const FormsReading reading = read({.asked = {"\\left(\\sum_\\alpha m_\\alpha\\right)g"}, .only = {{}}});
  REQUIRE(reading.forms.asked.size() == 1);
  CHECK(dump(reading.forms.tree, reading.forms.asked[0].expr) ==
        "(multiply (particle-sum \\alpha m{\\alpha}) g)");
}

TEST_CASE("what nothing asked for needs is neither elaborated nor decided") {
  const FormsReading reading = read({.asked = {"T_{\\text{rot}}"}, .only = {{}}});
  CHECK(reading.chains_passed_over == 3);
  CHECK(reading.forms.chains.size() == 2);  // of `let` and (1)
  const auto& steps = reading.forms.chains[1].steps;
  CHECK(std::none_of(steps.begin(), steps.end(),
                     [](const WrittenStep& step) { return step.outcome.has_value(); }));
}

TEST_CASE("a chain is asked for by its tag, or with its section, and brings what it rests on") {
  CHECK(read({.only = {{"(3)"}}}).forms.chains.size() == 3);  // with M and W = 2Mg, which begins with W
  CHECK(read({.only = {{"3"}}}).forms.chains.size() == 3);
  CHECK(read({.only = {{"Weight"}}}).forms.chains.size() == 3);
  const FormsReading unknown = read({.only = {{"Wieght"}}});
  CHECK(messages(unknown) ==
        std::vector<std::string>{"no equation and no section is named `Wieght`", "did you mean `Weight`?"});
}

TEST_CASE("a quantity that is nowhere in the notes is reported with the nearest one") {
  const FormsReading reading = read({.asked = {"T_{rod}"}, .only = {{}}});
  CHECK(messages(reading) ==
        std::vector<std::string>{"`T_{rod}` is nowhere in the notes", "did you mean `T_{rot}`?"});
  CHECK(reading.forms.asked.empty());
}

TEST_CASE("what cannot be read of what is asked is reported, and nothing is asked then") {
  for (const char* bad : {"", "T_{rot", "\\frac{1}", "M +", "\\mathbf{v}_\\alpha\\times"}) {
    INFO(bad);
    const FormsReading reading = read({.asked = {"M", bad}, .only = {{}}});
    CHECK(!messages(reading).empty());
    CHECK(reading.forms.asked.empty());
  }
}

TEST_CASE("the letter π is the number for the floating-point side, unless it is declared") {
  const auto defined = [&](const std::string& text) {
    return !read({}, text).forms.chains.back().definitions.empty();
  };
  CHECK(defined("$$(\\pi + 1)a = \\pi a + a$$\n"));
  CHECK_FALSE(defined("<!-- rigor: scalar \\pi -->\n$$(\\pi + 1)a = \\pi a + a$$\n"));
}

TEST_CASE("the units that notes declare are handed over") {
  const FormsReading reading = read({}, "<!-- rigor:\nscalar m\nunits m: kg\n-->\n$$m + m = 2m$$\n");
  CHECK(reading.forms.units.size() == 1);
  CHECK(reading.forms.units.begin()->second.text() == "M");
}

TEST_CASE("nothing is known in notes without equations") {
  const FormsReading reading = read({.asked = {"M"}, .only = {{}}}, "Only words.\n");
  CHECK(messages(reading) == std::vector<std::string>{"`M` is nowhere in the notes"});
}

TEST_CASE("what is asked means what it means at the place that is named") {
  const std::string text =
      "# A\n\n$$a = 2b \\tag{1}$$\n\n# B\n\n<!-- rigor: scalar a -->\n$$c = 3a \\tag{2}$$\n\n# C\n\n$$d = "
      "b$$\n";
  const auto defined = [&](std::optional<std::string> at) {
    const FormsReading reading = read({.asked = {"a"}, .at = std::move(at)}, text);
    return !reading.forms.definitions.empty();
  };
  CHECK(defined("(1)"));
  CHECK(!defined("(2)"));
  CHECK(!defined("B"));
}

TEST_CASE("what is small is defined as 0 in the question about the order that was decided") {
  const FormsReading reading =
      read({}, "<!-- rigor:\nscalar a, x\nsmall x\n-->\n$$(a + x)^2 \\approx a^2 + 2ax$$\n");
  REQUIRE(reading.forms.chains.size() == 1);
  const auto& question = reading.forms.chains[0].steps[0].question;
  REQUIRE(question.has_value());
  const ExprTree& tree = reading.forms.tree;
  CHECK(question->zeroed.empty());
  CHECK(std::any_of(question->definitions.begin(), question->definitions.end(), [&](const Definition& each) {
    return tree.symbols[each.symbol].name == "x" && tree.is_zero_literal(each.body);
  }));
}
