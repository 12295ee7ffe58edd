// SPDX-License-Identifier: GPL-3.0-or-later
// The work that a step counts is the same each time, so that no verdict near the end of the effort depends on
// the run. GiNaC orders its symbols by numbers that go on from note to note, and by addresses: the same notes
// again, in one process, meet other orders, like those of other processes.
#include <cstdint>
#include <string>
#include <vector>

#include "catch.h"
#include "checked.h"

using namespace rigor;

namespace {

std::vector<std::uint64_t> work_of(const std::string& note) {
  const Checked notes(note);
  std::vector<std::uint64_t> work;
  for (const Step& step : notes.report.steps) work.push_back(step.work);
  return work;
}

}  // namespace

TEST_CASE("a step counts the same work in whatever order GiNaC has its symbols", "[check]") {
  const std::string note = GENERATE(as<std::string>{},
                                    // roots, whose radicands are divided and taken apart
                                    R"(<!-- rigor: vector \mathbf r -->
<!-- rigor: constant k, m -->
$$E = \frac12m|\dot{\mathbf r}|^2 - \frac{k}{|\mathbf r|}, \qquad l = m|\mathbf r\times\dot{\mathbf r}|$$
$$p = \frac{l^2}{mk}, \qquad e = \sqrt{1 + \frac{El^2}{mk^2}}, \qquad a = \frac{p}{1-e^2}$$
$$b = a\sqrt{1-e^2} = \sqrt{ap}$$
)",
                                    // orders, whose sides are taken apart
                                    R"(<!-- rigor: for all x -->
<!-- rigor: given -1 < x < 1 -->
$$x^4 < x^2$$
)",
                                    // roots of quotients of differences
                                    R"(<!-- rigor: scalar \omega_1, \omega_2, \omega_3 -->
<!-- rigor: where 0 < I_1 < I_2 < I_3 -->
<!-- rigor: where \omega_1\omega_2\omega_3 \neq 0 -->
$$O = \frac{(I_3 - I_1)(I_2 - I_1)}{I_2I_3}\omega_1^2$$
$$\sqrt{O} > 0, \qquad \sqrt{O}^3 > 0, \qquad \frac{1}{(I_1 - I_2)(I_3 - I_1)} < 0$$
)");
  const std::vector<std::uint64_t> work = work_of(note);
  for (int again = 0; again < 12; ++again) CHECK(work_of(note) == work);
}
