// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/runner.h"

#include <array>

#include "catch.h"
#include "numeric/on_sample.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a runner gives what a batch gives, call after call", "[numeric]") {
  for (const std::size_t particles : {3u, 40u}) {
    Page page;
    const Named m = page.scalars("m");
    const Named r = page.vectors("r");
    const Named w = page.vector("w");
    const ParticleId alpha = page.particle("\\alpha");
    const IndexId i = page.index("i");
    const IndexId j = page.index("j");
    const Named inertia = page.tensor("I");
    page.define(
        inertia,
        over(alpha, m(alpha) * (squared(r(alpha)) * page.delta(i, j) - at(r(alpha), i) * at(r(alpha), j))),
        {i, j});
    const Program program = compiled(page, sum({j}, at(inertia, i, j) * at(w, j)), {i});
    Samples body(1, particles);
    std::vector<double> column(particles);
    for (std::uint32_t axis = 0; axis < 4; ++axis) {
      for (std::size_t k = 0; k < particles; ++k) column[k] = 1.0 / static_cast<double>(k + axis + 1);
      body.set_particles(axis == 3 ? m.symbol : r.symbol, axis % 3, column);
    }
    const std::array<ProgramInput, 3> spin{
        {{w.symbol, 2, false}, {w.symbol, 0, false}, {w.symbol, 1, false}}};
    Runner made(program, body, spin);
    Runner runner = std::move(made);
    for (int call = 0; call < 3; ++call) {
      const std::array<double, 3> values{0.5 + call, -0.25, 1.0 / 3.0};
      std::array<double, 3> results{};
      runner(values.data(), results.data());
      Samples one = body;
      one.set_each(w.symbol, 2, {values[0]});
      one.set_each(w.symbol, 0, {values[1]});
      one.set_each(w.symbol, 1, {values[2]});
      const std::vector<double> batch = evaluate(program, one);
      for (std::size_t k = 0; k < 3; ++k) CHECK(results[k] == Approx(batch[k]).epsilon(1e-14));
    }
  }
}
