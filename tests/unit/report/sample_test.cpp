// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/sample.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("a sample without particles is one line, with the component where the sides differ") {
  const Counterexample sample{
      0,
      {{"\\mathbf{A}", 0, 1, {"1", "0", "0"}}, {"\\mathbf{B}", 0, 1, {"0", "1", "0"}}},
      {{"i", 3}},
      "1",
      "-1"};
  CHECK(print_sample(sample) ==
        "sample: \\mathbf{A} = (1, 0, 0), \\mathbf{B} = (0, 1, 0); component i = 3: left 1, right -1\n");
}

TEST_CASE("each particle has a line of its own") {
  const Counterexample sample{2,
                              {{"\\mathbf{r}_{\\alpha}", 2, 1, {"0", "1/2", "0"}},
                               {"m_{\\alpha}", 1, 0, {"1"}},
                               {"\\mathbf{R}", 0, 1, {"0", "0", "1"}},
                               {"\\mathbf{r}_{\\alpha}", 1, 1, {"1", "0", "0"}},
                               {"m_{\\alpha}", 2, 0, {"2"}}},
                              {{"i", 1}, {"j", 2}},
                              "1",
                              "-3/2"};
  CHECK(print_sample(sample) ==
        "sample: 2 particles, \\mathbf{R} = (0, 0, 1)\n"
        "  particle 1: m_{\\alpha} = 1, \\mathbf{r}_{\\alpha} = (1, 0, 0)\n"
        "  particle 2: \\mathbf{r}_{\\alpha} = (0, 1/2, 0), m_{\\alpha} = 2\n"
        "  component i = 1, j = 2: left 1, right -3/2\n");
}

TEST_CASE("one particle is not called particles, and a scalar equation has no component") {
  const Counterexample sample{1, {{"m_{\\alpha}", 1, 0, {"1"}}}, {}, "1", "2"};
  CHECK(print_sample(sample) == "sample: 1 particle\n  particle 1: m_{\\alpha} = 1\n  left 1, right 2\n");
}

TEST_CASE("an axis of a vector equation has no name, and a sample may need no values") {
  CHECK(print_sample({0, {}, {{"", 2}}, "1", "0"}) == "sample: component 2: left 1, right 0\n");
  CHECK(print_sample({0, {}, {}, "0", "0", {}, true}) == "sample: |left - right|^2 is 0\n");
  CHECK(print_sample({0, {}, {}, "1", "0"}) == "sample: left 1, right 0\n");
}

TEST_CASE("a tensor is printed row by row, whatever its rank") {
  const Counterexample rank_2{0, {{"I", 0, 2, {"1", "2", "3", "4", "5", "6", "7", "8", "9"}}}, {}, "1", "0"};
  CHECK(print_sample(rank_2) == "sample: I = ((1, 2, 3), (4, 5, 6), (7, 8, 9)); left 1, right 0\n");
  const Counterexample rank_3{0, {{"E", 0, 3, std::vector<std::string>(27, "0")}}, {}, "1", "0"};
  CHECK(print_sample(rank_3).starts_with("sample: E = (((0, 0, 0), (0, 0, 0), (0, 0, 0)), ((0, "));
}

TEST_CASE("components that do not fill their rank are listed as they are") {
  CHECK(print_sample({0, {{"I", 0, 2, {"1", "2"}}}, {}, "1", "0"}) ==
        "sample: I = (1, 2); left 1, right 0\n");
  CHECK(print_sample({0, {{"I", 0, 40, {}}}, {}, "1", "0"}) == "sample: I = (); left 1, right 0\n");
}

TEST_CASE("what follows from the values stands behind them, and what nobody needs is left out") {
  Counterexample plain{0, {{"m", 0, 0, {"2"}}, {"\\ddot{x}", 0, 0, {"3"}, true}}, {}, "1", "0"};
  plain.follows = {{"p", 0, 0, {"4"}}};
  CHECK(print_sample(plain) == "sample: m = 2; hence p = 4; left 1, right 0\n");
  Counterexample body{1, {{"m", 1, 0, {"2"}}}, {}, "1", "0"};
  body.follows = {{"M", 0, 0, {"2"}}, {"\\mathbf{p}", 1, 1, {"1", "0", "0"}}};
  CHECK(print_sample(body) ==
        "sample: 1 particle; hence M = 2\n"
        "  particle 1: m = 2; hence \\mathbf{p} = (1, 0, 0)\n"
        "  left 1, right 0\n");
}

TEST_CASE("symbols that differ in their number of indices only are printed with them") {
  Counterexample moments{0, {{"I", 0, 1, {"1", "0", "0"}}, {"\\omega", 0, 0, {"2"}}}, {}, "1", "0"};
  CHECK(print_sample(moments) == "sample: I = (1, 0, 0), \\omega = 2; left 1, right 0\n");
  moments.follows = {{"I", 0, 2, {"1", "0", "0", "0", "0", "0", "0", "0", "0"}}};
  CHECK(print_sample(moments) ==
        "sample: I_i = (1, 0, 0), \\omega = 2; hence I_{ij} = ((1, 0, 0), (0, 0, 0), (0, 0, 0)); left 1, "
        "right 0\n");
}

}  // namespace
}  // namespace rigor
