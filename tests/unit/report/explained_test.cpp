// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/explained.h"

#include "catch.h"

namespace rigor {
namespace {

/// Mathematics between dollar signs.
std::string parts_of(const std::string& rule) {
  std::string text;
  for (const RulePart& part : rule_parts(rule)) text += part.is_math ? "$" + part.text + "$" : part.text;
  return text;
}

}  // namespace

TEST_CASE("names in a rule are mathematics and its words are words") {
  CHECK(parts_of("definition of \\mathbf{v}_\\alpha") == "definition of $\\mathbf{v}_\\alpha$");
  CHECK(parts_of("definition of M") == "definition of $M$");
  CHECK(parts_of("given \\sum_\\alpha m_\\alpha = 0") == "given $\\sum_\\alpha m_\\alpha = 0$");
  CHECK(parts_of("T_{ij} is 0") == "$T_{ij}$ is 0");
  CHECK(parts_of("the square of a length") == "the square of a length");
  CHECK(parts_of("Eq. (8)") == "Eq. (8)");
  CHECK(parts_of("") == "");
}

TEST_CASE("what is known or expected to be refuted is no step to explain") {
  ExplainedChain chain;
  chain.steps = {ExplainedAs::known, ExplainedAs::expected_refuted};
  CHECK(tally_text(tally({chain})) == "explained 0 of 0 steps in 0 chains");
  chain.steps = {ExplainedAs::known, ExplainedAs::small, ExplainedAs::by_cases, ExplainedAs::open};
  CHECK(tally_text(tally({chain})) == "explained 2 of 3 steps in 1 chain, 1 component by component");
  chain.steps = {ExplainedAs::refuted};
  CHECK(tally_text(tally({chain})) == "explained 0 of 1 step in 1 chain; 1 refuted");
  ExplainedChain whole;
  whole.steps = {ExplainedAs::small};
  CHECK(tally_text(tally({whole, chain, whole})) ==
        "explained 2 of 3 steps in 3 chains, 2 of them whole (66 %); 1 refuted");
}

}  // namespace rigor
