// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/library_function.h"

namespace rigor {
namespace {

/// x of f(x).
std::optional<ExprId> argument_of(const ExprTree& tree, ExprId id, Function function) {
  const ExprNode& node = tree[id];
  if (node.op != Op::function || node.function != function) return std::nullopt;
  return tree.children(id)[0];
}

/// eˣ ± e⁻ˣ, with the sign of the second.
struct ExponentialPair {
  ExprId argument{};
  bool is_difference = false;
};

std::optional<ExponentialPair> exponential_pair(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::add || tree.children(id).size() != 2) return std::nullopt;
  const auto grows = argument_of(tree, tree.children(id)[0], Function::exp);
  ExprId second = tree.children(id)[1];
  const bool is_difference = tree[second].op == Op::negate;
  if (is_difference) second = tree.children(second)[0];
  const auto falls = argument_of(tree, second, Function::exp);
  if (!grows || !falls || tree[*falls].op != Op::negate || tree.children(*falls)[0] != *grows)
    return std::nullopt;
  return ExponentialPair{*grows, is_difference};
}

}  // namespace

std::optional<LibraryFunction> library_function(const ExprTree& tree, ExprId quotient) {
  if (!tree[quotient].spelled_out || tree[quotient].op != Op::divide) return std::nullopt;
  const ExprId above = tree.children(quotient)[0];
  const ExprId below = tree.children(quotient)[1];
  const auto sine = argument_of(tree, above, Function::sin);
  const auto cosine = argument_of(tree, below, Function::cos);
  if (sine && cosine && *sine == *cosine) return LibraryFunction{Instruction::tan, *sine};
  const auto pair = exponential_pair(tree, above);
  if (!pair) return std::nullopt;
  if (tree[below].op == Op::number && tree.digits(below) == "2")
    return LibraryFunction{pair->is_difference ? Instruction::sinh : Instruction::cosh, pair->argument};
  const auto whole = exponential_pair(tree, below);
  if (!whole || !pair->is_difference || whole->is_difference || whole->argument != pair->argument)
    return std::nullopt;
  return LibraryFunction{Instruction::tanh, pair->argument};
}

}  // namespace rigor
