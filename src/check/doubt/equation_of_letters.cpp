// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/equation_of_letters.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/among.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// Since the last display.
std::vector<std::string_view> last_words(std::string_view lead) {
  const auto display = lead.rfind('\n');
  return words_of(display == std::string_view::npos ? lead : lead.substr(display + 1));
}

bool is_of_scalars(const ExprTree& tree, ExprId side) {
  const std::vector<SymbolId> symbols = symbols_in(tree, side);
  return tree[side].rank == 0 && std::ranges::all_of(symbols, [&](SymbolId id) {
           const Symbol& symbol = tree.symbols[id];
           return !symbol.derivation && !symbol.rotation && !symbol.per_particle && !symbol.is_fixed();
         });
}

template <class Test>
bool holds_anywhere(const ExprTree& tree, ExprId id, const Test& test) {
  return std::ranges::any_of(nodes_below(tree, {id}), [&](ExprId each) { return test(tree[each]); });
}

bool has_sum(const ExprTree& tree, ExprId id) {
  return holds_anywhere(tree, id, [](const ExprNode& node) { return node.op == Op::add; });
}

/// `(u - v)^2`, `m(v + u)^2`: to be expanded.
bool is_product_of_sums(const ExprTree& tree, ExprId id) {
  const Op op = tree[id].op;
  return (op == Op::power || op == Op::multiply) && has_sum(tree, id);
}

/// `u^2 - 2uv + v^2`
bool is_expanded(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::add) return false;
  return std::ranges::none_of(tree.children(id), [&](ExprId term) { return has_sum(tree, term); });
}

bool divides(const ExprTree& tree, ExprId id) {
  while (tree[id].op == Op::negate) id = tree.children(id)[0];
  return tree[id].op == Op::divide;
}

/// `1/a + 1/b`
bool is_sum_of_fractions(const ExprTree& tree, ExprId id) {
  if (tree[id].op != Op::add) return false;
  return std::ranges::all_of(tree.children(id), [&](ExprId term) { return divides(tree, term); });
}

/// `(a + c)/(b + d)`
bool is_one_fraction(const ExprTree& tree, ExprId id) {
  return tree[id].op == Op::divide && has_sum(tree, tree.children(id)[1]);
}

/// The highest degree in all letters together.
std::optional<int> degree_of(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  if (node.op == Op::symbol) return 1;
  if (symbols_in(tree, id).empty()) return 0;
  std::optional<int> total;
  for (const ExprId child : tree.children(id)) {
    const auto degree = degree_of(tree, child);
    if (!degree) return std::nullopt;
    switch (node.op) {
      case Op::negate:
        return degree;
      case Op::power:
        return *degree * node.exponent;
      case Op::multiply:
        total = total.value_or(0) + *degree;
        break;
      case Op::divide:
        total = total ? *total - *degree : *degree;
        break;
      case Op::add:
        total = std::max(total.value_or(*degree), *degree);
        break;
      default:
        return std::nullopt;
    }
  }
  return total;
}

/// Does the value depend on a letter? Not that of π, or of an integral between numbers.
bool has_letter(const ExprTree& tree, ExprId root) {
  return std::ranges::any_of(symbols_in(tree, root), [&](SymbolId each) {
    const Symbol& symbol = tree.symbols[each];
    if (!symbol.integral) return !symbol.circle_number;
    const auto inside = [&](ExprId part) {
      return std::ranges::any_of(symbols_in(tree, part), [&](SymbolId letter) {
        return letter != symbol.integral->variable && !tree.symbols[letter].circle_number;
      });
    };
    const auto open = [&](const std::optional<Limit>& limit) {
      return !limit || (limit->at && inside(*limit->at));
    };
    return inside(symbol.integral->integrand) || open(symbol.integral->lower) || open(symbol.integral->upper);
  });
}

/// `\sum_{k=1}^nk = n^2`, but for `\sum_{k=1}^nk = 55`: a sum up to a letter or to infinity, and on the other
/// side all of its letters.
bool says_what_a_sum_is(const ExprTree& tree, ExprId side, ExprId other) {
  if (tree[side].op != Op::symbol) return false;
  const auto& sum = tree.symbols[tree[side].symbol].integral;
  if (!sum || !sum->sum || (sum->upper->at && symbols_in(tree, *sum->upper->at).empty())) return false;
  const std::vector<SymbolId> shown = symbols_in(tree, other);
  bool any = false;
  for (const ExprId part : parts_of(*sum)) {
    for (const SymbolId letter : symbols_in(tree, part)) {
      if (letter == sum->variable) continue;
      any = true;
      if (!is_one_of(letter, shown)) return false;
    }
  }
  return any;
}

}  // namespace

bool may_be_an_equation_of_letters(const ExprTree& tree, const Equation& equation) {
  const auto is_index_sum = [](const ExprNode& node) { return node.op == Op::index_sum; };
  if (says_what_a_sum_is(tree, equation.left, equation.right) ||
      says_what_a_sum_is(tree, equation.right, equation.left))
    return false;
  return (has_letter(tree, equation.left) || has_letter(tree, equation.right)) &&
         equation.relation == Relation::equal && equation.indices.empty() &&
         is_of_scalars(tree, equation.left) && is_of_scalars(tree, equation.right) &&
         !holds_anywhere(tree, equation.left, is_index_sum) &&
         !holds_anywhere(tree, equation.right, is_index_sum);
}

bool reads_as_identity(const ExprTree& tree, const Equation& equation) {
  const auto has_axes = [](const ExprNode& node) { return node.rank > 0; };
  if (holds_anywhere(tree, equation.left, has_axes) || holds_anywhere(tree, equation.right, has_axes))
    return true;
  const bool adds_fractions =
      (is_one_fraction(tree, equation.left) && is_sum_of_fractions(tree, equation.right)) ||
      (is_one_fraction(tree, equation.right) && is_sum_of_fractions(tree, equation.left));
  const bool expands = (is_product_of_sums(tree, equation.left) && is_expanded(tree, equation.right)) ||
                       (is_product_of_sums(tree, equation.right) && is_expanded(tree, equation.left));
  const auto left = degree_of(tree, equation.left);
  return (expands || adds_fractions) && left && left == degree_of(tree, equation.right);
}

bool announces_an_identity(std::string_view lead) {
  static constexpr std::array<std::string_view, 38> announcing{
      "identity",    "identities", "identically",  "expand",    "expanding", "expanded", "expansion",
      "formula",     "theorem",    "lemma",        "corollary", "algebra",   "simplify", "simplifies",
      "simplifying", "factor",     "factoring",    "factorise", "factorize", "rewrite",  "rewriting",
      "rewritten",   "multiply",   "multiplying",  "therefore", "hence",     "thus",     "so",
      "follows",     "conclude",   "consequently", "always",    "every",     "square",   "squaring",
      "cube",        "binomial",   "manipulation"};
  const std::vector<std::string_view> words = last_words(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (is_one_of(words[k], announcing)) return true;
    const std::string_view next = k + 1 < words.size() ? words[k + 1] : std::string_view{};
    if (words[k] == "for" && (next == "all" || next == "any")) return true;
    if (words[k] == "in" && next == "general") return true;
  }
  return false;
}

bool names_an_equation_of_letters(std::string_view lead) {
  static constexpr std::array<std::string_view, 60> naming{
      "curve",       "curves",     "circle",       "ellipse",     "parabola",   "hyperbola",  "sphere",
      "surface",     "surfaces",   "locus",        "orbit",       "trajectory", "boundary",   "boundaries",
      "shell",       "caustic",    "envelope",     "contour",     "contours",   "constraint", "constraints",
      "condition",   "conditions", "conservation", "conserved",   "conserves",  "balance",    "balances",
      "equilibrium", "resonance",  "resonances",   "root",        "roots",      "eigenvalue", "eigenvalues",
      "spectrum",    "dispersion", "equality",     "criterion",   "threshold",  "maximum",    "maxima",
      "minimum",     "minima",     "extrema",      "zeros",       "poles",      "nodes",      "intersection",
      "crossing",    "crossings",  "degeneracy",   "constant",    "unchanged",  "stationary", "constrained",
      "constrains",  "unknown",    "unknowns",     "quantization"};
  const std::vector<std::string_view> words = last_words(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (is_one_of(words[k], naming)) return true;
    // "Kirchhoff's rule", "Hooke's law"
    const bool rule =
        words[k] == "rule" || words[k] == "law" || words[k] == "equation" || words[k] == "relation";
    if (rule && k > 0 && (words[k - 1].ends_with("'s") || words[k - 1].ends_with("s'"))) return true;
  }
  return false;
}

bool asks_for_values(std::string_view lead) {
  static constexpr std::array<std::string_view, 8> asking{
      "solve", "root", "roots", "zeros", "intersection", "unknown", "intersections", "transcendental"};
  return !announces_an_identity(lead) &&
         std::ranges::any_of(last_words(lead), [](std::string_view word) { return is_one_of(word, asking); });
}

}  // namespace rigor
