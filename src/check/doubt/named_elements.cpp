// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/named_elements.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>

#include "base/ascii.h"
#include "check/meaning/identity_reading.h"

namespace rigor {
namespace {

/// Without blanks.
std::string closed_up(std::string_view text) {
  static constexpr std::array<std::string_view, 5> blanks{"\\,", "\\;", "\\:", "\\ ", "\\!"};
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool control = std::ranges::find(blanks, text.substr(at, 2)) != blanks.end();
    if (!control && text[at] != ' ' && text[at] != '~') result += text[at];
    at += control ? 2 : 1;
  }
  return result;
}

/// Behind a cycle at `at`: `(132)`; `at` where there is none.
std::size_t behind_cycle(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '(') return at;
  std::set<char> digits;
  std::size_t end = at + 1;
  for (; end < text.size() && is_digit(text[end]); ++end) {
    if (text[end] == '0' || !digits.insert(text[end]).second) return at;
  }
  return digits.size() > 1 && end < text.size() && text[end] == ')' ? end + 1 : at;
}

/// Behind `^{-1}` and `^3`.
std::size_t behind_power(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '^') return at;
  std::size_t end = at + 1;
  if (end < text.size() && is_digit(text[end])) return end + 1;
  if (end >= text.size() || text[end] != '{') return at;
  for (++end; end < text.size() && (is_digit(text[end]) || text[end] == '-');) ++end;
  return end < text.size() && text[end] == '}' ? end + 1 : at;
}

/// How many cycles, a power as two; nothing where anything else is there.
std::optional<int> cycles_in(std::string_view text) {
  int cycles = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t behind = behind_cycle(text, at);
    if (behind == at) return std::nullopt;
    ++cycles;
    at = behind_power(text, behind);
    if (at > behind) ++cycles;
  }
  return cycles > 0 ? std::optional(cycles) : std::nullopt;
}

bool is_unit_element(std::string_view text) {
  return text == "1" || (!text.empty() && std::ranges::none_of(text, is_digit));
}

/// Factors that number elements, in one term.
int degree_in(const ExprTree& tree, ExprId term, SymbolId letter) {
  const ExprNode& node = tree[term];
  if (node.op == Op::symbol) return node.symbol == letter ? 1 : 0;
  if (node.op != Op::multiply && node.op != Op::negate && node.op != Op::divide) return 0;
  int degree = 0;
  for (const ExprId child : tree.children(term)) degree += degree_in(tree, child, letter);
  return degree;
}

bool has_degree(ExprTree& tree, ExprId side, SymbolId letter, int degree) {
  if (tree.is_zero_literal(side)) return false;
  return std::ranges::all_of(signed_terms(tree, side), [&](const SignedTerm& term) {
    return degree_in(tree, term.id, letter) == degree;
  });
}

}  // namespace

bool may_be_cycles(std::string_view left, std::string_view right) {
  const std::string first = closed_up(left);
  const std::string second = closed_up(right);
  const auto one = cycles_in(first);
  const auto other = cycles_in(second);
  if (one && other) return true;
  return (one && *one > 1 && is_unit_element(second)) || (other && *other > 1 && is_unit_element(first));
}

bool may_multiply_elements(ExprTree& tree, const Equation& equation) {
  if (equation.relation != Relation::equal || equation.indices.empty()) return false;
  std::set<SymbolId> letters;
  for (const ExprId id : nodes_below(tree, {equation.left, equation.right})) {
    const ExprNode& node = tree[id];
    if (node.op == Op::symbol && node.slot_count > 0) letters.insert(node.symbol);
  }
  return std::ranges::any_of(letters, [&](SymbolId letter) {
    return (has_degree(tree, equation.left, letter, 2) && has_degree(tree, equation.right, letter, 1)) ||
           (has_degree(tree, equation.left, letter, 1) && has_degree(tree, equation.right, letter, 2));
  });
}

}  // namespace rigor
