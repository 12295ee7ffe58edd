// SPDX-License-Identifier: GPL-3.0-or-later
// Names of kets, and what products of kets and bras are.
#include "expr/tree/state.h"

#include <array>

#include "catch.h"

namespace rigor {
namespace {

ExprId ket(ExprTree& tree, const char* name) {
  return tree.add({.op = Op::symbol, .symbol = symbol_of_ket(tree, label_of(name), {})});
}

ExprId bra(ExprTree& tree, const char* name) {
  const ExprId of = ket(tree, name);
  return tree.add({.op = Op::conjugate}, std::span(&of, 1));
}

ExprId product(ExprTree& tree, ExprId a, ExprId b) {
  const std::array both{a, b};
  return tree.add({.op = Op::multiply}, both);
}

}  // namespace

TEST_CASE("the name of a ket has a letter and a number in each part") {
  CHECK(label_of("n+1") == std::vector<LabelPart>{{"n", "", 1}});
  CHECK(label_of("j, m-1") == std::vector<LabelPart>{{"j", "", 0}, {"m", "", -1}});
  CHECK(label_of("0") == std::vector<LabelPart>{{"", "", 0}});
  CHECK(label_of("n^{(0)}") == std::vector<LabelPart>{{"n", "^{(0)}", 0}});
  CHECK(label_of("\\psi_{n}") == std::vector<LabelPart>{{"n", "\\psi", 0}});
  CHECK(label_of("n_{1}") == std::vector<LabelPart>{{"n_{1}", "", 0}});
  for (const char* name : {"n + 1", "j, m - 1", "0", "\\uparrow", "n^{(0)}", "\\psi_{n}", "+", "\\psi(t)"})
    CHECK(text_of_label(label_of(name)) == name);
}

TEST_CASE("a bra before a ket is a number, a ket before a bra an operator") {
  ExprTree tree;
  CHECK(state_shape(tree, product(tree, bra(tree, "a"), ket(tree, "b"))) == StateShape::number);
  CHECK(state_shape(tree, product(tree, ket(tree, "a"), bra(tree, "b"))) == StateShape::operators);
  CHECK(state_shape(tree, product(tree, ket(tree, "a"), ket(tree, "b"))) == StateShape::none);
}

TEST_CASE("δ of two states is 1 for one number, 0 for different ones, and symmetric") {
  ExprTree tree;
  const auto delta = [&](const LabelPart& a, const LabelPart& b) {
    return dump(tree, kronecker_of_states(tree, a, b, {}));
  };
  CHECK(delta({"n", "", 1}, {"n", "", 1}) == "1");
  CHECK(delta({"n", "", 0}, {"n", "", 1}) == "0");
  CHECK(delta({"m", "", 0}, {"n", "", 0}) == delta({"n", "", 0}, {"m", "", 0}));
  CHECK(delta({"m", "", 1}, {"n", "", 1}) == delta({"n", "", 0}, {"m", "", 0}));
}

}  // namespace rigor
