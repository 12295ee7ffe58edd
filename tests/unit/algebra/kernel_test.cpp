// SPDX-License-Identifier: GPL-3.0-or-later
// Principal axes: a tensor that has one has a vanishing determinant.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

[[nodiscard]] Term determinant_of(Page& page, const Named& tensor, const Named& moment) {
  std::vector<Term> rows;
  for (const int i : {1, 2, 3}) {
    for (const int j : {1, 2, 3}) rows.push_back(i == j ? at(tensor, i, j) - moment : Term(at(tensor, i, j)));
  }
  return page.determinant(rows);
}

void give_axis(Page& page, const Named& tensor, const Named& axis, const Named& moment) {
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  page.given(sum({j}, at(tensor, i, j) * at(axis, j)), moment * at(axis, i), {i});
}

}  // namespace

TEST_CASE("a moment about a principal axis is a root of the characteristic polynomial", "[algebra]") {
  for (const bool symmetric : {false, true}) {
    Page page;
    const Named tensor = symmetric ? page.symmetric("S") : page.tensor("B");
    const Named moment = page.scalar("\\mu");
    const Named axis = page.unit("n");
    give_axis(page, tensor, axis, moment);
    CHECK(is_proved(page.claim(determinant_of(page, tensor, moment), page.zero())));
    CHECK_FALSE(is_proved(page.claim(determinant_of(page, tensor, moment), moment)));
  }
}

TEST_CASE("what may be zero is no axis", "[algebra]") {
  Page page;
  const Named tensor = page.tensor("B");
  const Named moment = page.scalar("\\mu");
  const Named axis = page.vector("u");
  give_axis(page, tensor, axis, moment);
  CHECK_FALSE(is_proved(page.claim(determinant_of(page, tensor, moment), page.zero())));
}

TEST_CASE("the inertia tensor of any body has such moments", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const Named tensor = page.tensor("I");
  const IndexId k = page.index("k");
  const IndexId l = page.index("l");
  page.define(tensor,
              over(a, m(a) * (squared(r(a)) * page.delta(k, l) - component(r(a), k) * component(r(a), l))),
              {k, l});
  const Named moment = page.scalar("\\mu");
  give_axis(page, tensor, page.unit("n"), moment);
  const Decision decision = decide(page.claim(determinant_of(page, tensor, moment), page.zero()));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.unfolded.empty());
}
