// SPDX-License-Identifier: GPL-3.0-or-later
// Combinations of random equations: each one that is proved has cofactors that multiply out.
#include <random>

#include "algebra/replayed_proof.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// Random polynomials in four scalars.
class RandomTerms {
 public:
  RandomTerms(Page& page, std::uint32_t seed) : page_(page), random_(seed) {
    for (const char* name : {"x", "y", "z", "w"}) letters_.push_back(page.scalar(name));
  }
  [[nodiscard]] Term next(int terms, int factors) {
    Term sum = page_.number("0");
    for (int k = 0; k < terms; ++k) {
      Term product = number(1, 3) * (number(0, 1) == 0 ? page_.number("1") : -page_.number("1"));
      for (int i = number(0, factors); i > 0; --i)
        product = product * letters_[static_cast<std::size_t>(number(0, 3))];
      sum = sum + product;
    }
    return sum;
  }

 private:
  [[nodiscard]] int number(int least, int most) {
    return std::uniform_int_distribution(least, most)(random_);
  }

  Page& page_;
  std::mt19937 random_;
  std::vector<Named> letters_;
};

}  // namespace

TEST_CASE("cofactors of random combinations multiply out", "[algebra]") {
  int proved = 0;
  int combinations = 0;
  for (std::uint32_t seed = 1; seed <= 80; ++seed) {
    Page page;
    RandomTerms terms(page, seed);
    Term claim = page.zero();
    for (int k = 0; k < 3; ++k) {
      const Term left = terms.next(2, 2);
      const Term right = terms.next(2, 2);
      page.given(left, right);
      claim = claim + terms.next(2, 1) * (left - right);
    }
    const Term other = terms.next(2, 2);
    const Question& question = page.claim(claim + other, other);
    if (decide(question).outcome != Outcome::proved) continue;  // under what contradicts itself
    const Proof proof = proof_of(question);
    ++proved;
    bool all = true;
    for (const ProofStep& step : proof.steps) {
      CHECK(step.kind != ProofStep::Kind::long_combination);
      all = all && step.kind == ProofStep::Kind::combination;
    }
    if (!all) continue;
    ++combinations;
    INFO(seed);
    CHECK(multiplies_out(proof));
    CHECK(is_about(proof, question));
  }
  CHECK(proved > 40);
  CHECK(combinations > proved * 9 / 10);
}
