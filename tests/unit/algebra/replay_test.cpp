// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a sample is replayed with its own numbers", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named s = page.scalar("s");
  const Question& question = page.claim(s * a, a / s);
  Sample sample;
  sample.values = {{s.symbol, 0, {"1/2"}}, {a.symbol, 0, {"0", "-3", "1"}}};
  sample.axes = {2};
  const auto sides = replay(question, sample);
  REQUIRE(sides.has_value());
  CHECK(sides->left == "-3/2");
  CHECK(sides->right == "-6");
}

TEST_CASE("a sample that does not fit the question is not replayed", "[algebra]") {
  Page page;
  const Named n = page.unit("n");
  const Named s = page.symmetric("S");
  const Named m = page.scalars("m");
  const Named x = page.scalar("x");
  const ParticleId a = page.particle("\\alpha");
  const Question& question = page.claim(dot(n, dot(s, n)) / x, over(a, m(a)));
  Sample good;
  good.particles = 1;
  good.values = {{n.symbol, 0, {"0", "3/5", "4/5"}},
                 {s.symbol, 0, {"1", "2", "0", "2", "1", "0", "0", "0", "1"}},
                 {m.symbol, 1, {"2"}},
                 {x.symbol, 0, {"2"}}};
  REQUIRE(replay(question, good).has_value());
  CHECK(replay(question, good)->right == "2");

  const auto changed = [&](std::size_t value, std::vector<std::string> components) {
    Sample sample = good;
    sample.values[value].components = std::move(components);
    return replay(question, sample).has_value();
  };
  CHECK_FALSE(changed(0, {"0", "3/5", "3/5"}));  // not a unit vector
  CHECK_FALSE(changed(1, {"1", "2", "0", "0", "1", "0", "0", "0", "1"}));
  CHECK_FALSE(changed(2, {"two"}));
  CHECK_FALSE(changed(2, {"1", "2"}));
  CHECK_FALSE(changed(3, {"0"}));  // division by zero
  Sample missing = good;
  missing.values.pop_back();
  CHECK_FALSE(replay(question, missing).has_value());
  Sample more_particles = good;
  more_particles.particles = 2;
  CHECK_FALSE(replay(question, more_particles).has_value());
  Sample with_axis = good;
  with_axis.axes = {1};
  CHECK_FALSE(replay(question, with_axis).has_value());
}

TEST_CASE("what speaks against a sample is said", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(x, 2 * y);
  const Question& question = page.claim(x / y, page.number("2"));
  const auto fault = [&](const char* of_x, const char* of_y) {
    Sample sample;
    sample.values = {{x.symbol, 0, {of_x}}, {y.symbol, 0, {of_y}}};
    return replay_closely(question, sample);
  };
  CHECK(fault("2", "1").fault == Replay::Fault::none);
  CHECK_FALSE(fault("2", "1").differ);
  CHECK(fault("2", "3").fault == Replay::Fault::assumption);
  CHECK(fault("0", "0").fault == Replay::Fault::undefined);
  for (const std::string& hostile :
       {std::string("1/0"), std::string("-"), std::string(""), std::string("0x1"), std::string("nan"),
        std::string("1e9"), std::string(1'000'000, '9')}) {
    const Replay replay = fault("2", hostile.c_str());
    CHECK(replay.fault == Replay::Fault::value);
    CHECK(replay.symbol == y.symbol);
  }
  Sample crowded;
  crowded.particles = 4'000'000'000u;
  CHECK(replay_closely(question, crowded).fault == Replay::Fault::place);
  CHECK(symbols_of_sample(question) == std::vector<SymbolId>{x.symbol, y.symbol});
}

TEST_CASE("a sample has to satisfy the assumptions", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(x, 2 * y);
  const Question& question = page.claim(x * y, page.zero());
  Sample sample;
  sample.values = {{x.symbol, 0, {"2"}}, {y.symbol, 0, {"1"}}};
  CHECK(replay(question, sample).has_value());
  sample.values[1].components = {"3"};
  CHECK_FALSE(replay(question, sample).has_value());
}
