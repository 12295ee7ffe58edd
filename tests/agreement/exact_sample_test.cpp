// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_sample.h"

#include <cmath>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("a rational number becomes the nearest double") {
  CHECK(nearest_double("0") == 0.0);
  CHECK(nearest_double("-3/2") == -1.5);
  CHECK(nearest_double("1/3") == 1.0 / 3.0);
  CHECK(nearest_double("-010") == -10.0);
  CHECK(nearest_double("08/0010") == 0.8);
  CHECK(nearest_double("9007199254740993") == 9007199254740992.0);  // 2^53 + 1, to even
  CHECK(nearest_double("9007199254740993/9007199254740992") == 1.0);
  CHECK(nearest_double("1" + std::string(400, '0') + "/1" + std::string(399, '0')) == 10.0);
  CHECK(std::isinf(*nearest_double("1" + std::string(400, '0'))));
}

TEST_CASE("what is no rational number has no double") {
  for (const char* text : {"", "-", "1/", "/2", "1/0", "1.5", "1/-2", "x", "1/2/3"}) {
    INFO(text);
    CHECK_FALSE(nearest_double(text));
  }
}

std::vector<double> column(const Samples& samples, SymbolId symbol, std::uint32_t component) {
  const Column* found = samples.find(symbol, component);
  REQUIRE(found != nullptr);
  return {found->values.begin(), found->values.end()};
}

TEST_CASE("a symbol of particles has a column with a value for each, 0 where the sample has none") {
  ExprTree tree;
  const SymbolId mass = tree.symbols.add({.name = "m", .per_particle = true});
  const SymbolId spin = tree.symbols.add({.name = "\\mathbf{w}", .rank = 1});
  Sample sample;
  sample.particles = 3;
  sample.values = {{mass, 1, {"2"}}, {mass, 3, {"1/2"}}, {spin, 0, {"0", "-1", "7"}}};
  const Samples samples = samples_of(tree, sample);
  CHECK(samples.samples() == 1);
  CHECK(samples.particles() == 3);
  CHECK(column(samples, mass, 0) == std::vector<double>{2, 0, 0.5});
  CHECK(column(samples, spin, 2) == std::vector<double>{7});
  CHECK(samples.find(spin, 3) == nullptr);
}

}  // namespace
}  // namespace rigor
