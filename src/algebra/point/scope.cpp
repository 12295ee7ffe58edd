// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/point/scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "algebra/engine/undecidable.h"
#include "base/among.h"
#include "base/check.h"
#include "expr/tree/marks.h"

namespace rigor {
namespace {

void note_size(const ExprTree& tree, ExprId id, Reach& reached) {
  if (reached.too_large) return;
  const ExprNode& node = tree[id];
  if (node.rank > largest_rank) {
    reached.too_large =
        fmt::format("a tensor of rank {} is beyond the {} that are evaluated", node.rank, largest_rank);
  } else if (node.op == Op::power && std::abs(static_cast<long>(node.exponent)) > largest_exponent) {
    reached.too_large = fmt::format("the exponent {} is beyond ±{}", node.exponent, largest_exponent);
  } else if (node.op == Op::number && tree.digits(id).size() > largest_digits) {
    reached.too_large =
        fmt::format("a number has {} digits, more than {}", tree.digits(id).size(), largest_digits);
  }
}

void note_operation(const ExprNode& node, Reach& reached) {
  switch (node.op) {
    case Op::root:
    case Op::length:
    case Op::absolute:
    case Op::real_power:
      reached.roots = true;
      break;
    case Op::particle_sum:
      reached.particles = true;
      reached.particle_sums = true;
      break;
    case Op::function:
      reached.functions = true;
      reached.roots = reached.roots || node.function > Function::exp;
      break;
    default:
      break;
  }
  if (node.op == Op::symbol && node.particle != no_particle) reached.particles = true;
}

[[nodiscard]] bool share(const std::vector<SymbolId>& some, const std::vector<SymbolId>& others) {
  return std::ranges::any_of(some, [&](SymbolId symbol) { return is_one_of(symbol, others); });
}

}  // namespace

Scope::Scope(const Question& question, Definitions definitions)
    : question_(&question),
      definition_(question.tree->symbols.size(), nullptr),
      defined_(question.tree->symbols.size(), false),
      zeroed_(question.tree->symbols.size(), false) {
  for (const SymbolId symbol : question.zeroed) zeroed_[static_cast<std::size_t>(symbol)] = true;
  for (const Definition& definition : question.definitions) {
    const Symbol& named = question.tree->symbols[definition.symbol];
    const bool by_components = !definition.indices.empty();
    RIGOR_CHECK(!by_components || static_cast<int>(definition.indices.size()) == named.rank, named.name,
                named.rank);
    RIGOR_CHECK((*question.tree)[definition.body].rank == (by_components ? 0 : named.rank), named.name,
                named.rank);
    RIGOR_CHECK(definition.particle == no_particle || named.per_particle, named.name);
    const auto symbol = static_cast<std::size_t>(definition.symbol);
    defined_[symbol] = true;
    const bool unfold = (definitions == Definitions::unfolded ||
                         (definitions == Definitions::opaque_but_squares && definition.by_square)) &&
                        !zeroed_[symbol];
    if (unfold && definition_[symbol] == nullptr) definition_[symbol] = &definition;
  }
}

/// What sees a symbol, a bit for each.
enum Seen : std::uint8_t { plainly = 1, by_angle_functions = 2, by_exponential = 4 };

/// What its argument is seen by.
[[nodiscard]] Seen seen_by(Function function) {
  if (function == Function::exp) return by_exponential;
  return function == Function::sin || function == Function::cos ? by_angle_functions : plainly;
}

/// Goes through all expressions with the innermost function around them, definitions once for each such.
void note_what_functions_see(const Scope& scope, std::span<const ExprId> roots, Reach& reached) {
  const ExprTree& tree = scope.tree();
  std::vector<std::uint8_t> seen(tree.symbols.size(), 0);
  std::vector<std::pair<ExprId, Seen>> open;
  for (const ExprId root : roots) open.emplace_back(root, plainly);
  while (!open.empty()) {
    const auto [id, by] = open.back();
    open.pop_back();
    const ExprNode& node = tree[id];
    Seen inside = by;
    if (node.op == Op::function) inside = seen_by(node.function);
    if (node.op == Op::real_power) inside = plainly;
    for (const ExprId child : tree.children(id)) open.emplace_back(child, inside);
    if (node.op != Op::symbol) continue;
    std::uint8_t& of_symbol = seen[static_cast<std::size_t>(node.symbol)];
    if ((of_symbol & by) != 0) continue;
    of_symbol |= by;
    if (const Definition* definition = scope.definition_of(node.symbol))
      open.emplace_back(definition->body, by);
  }
  for (const SymbolId symbol : reached.symbols) {
    if (tree.symbols[symbol].unit || tree.symbols[symbol].rotation) continue;
    const std::uint8_t by = seen[static_cast<std::size_t>(symbol)];
    if (by == by_angle_functions) reached.angles.push_back(symbol);
    if (by == by_exponential) reached.exponents.push_back(symbol);
  }
}

Reach reach(const Scope& scope, std::span<const ExprId> roots) {
  const ExprTree& tree = scope.tree();
  Reach reached;
  static thread_local Marks seen;
  seen.clear(tree.symbols.size());
  std::vector<ExprId> open(roots.rbegin(), roots.rend());
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    const ExprNode& node = tree[id];
    note_size(tree, id, reached);
    note_operation(node, reached);
    const auto children = tree.children(id);
    open.insert(open.end(), children.rbegin(), children.rend());
    if (node.op != Op::symbol || !seen.mark(static_cast<std::size_t>(node.symbol))) continue;
    if (const Definition* definition = scope.definition_of(node.symbol)) {
      reached.unfolded.push_back(node.symbol);
      open.push_back(definition->body);
    } else if (!scope.is_zeroed(node.symbol) && !scope.is_circle_number(node.symbol)) {
      reached.symbols.push_back(node.symbol);
    }
  }
  if (reached.functions) note_what_functions_see(scope, roots, reached);
  return reached;
}

Reach reach(const Scope& scope, const Equation& equation) {
  return reach(scope, std::array{equation.left, equation.right});
}

std::vector<std::size_t> relevant_assumptions(const Scope& scope) {
  const std::vector<Equation>& assumptions = scope.question().assumptions;
  std::vector<std::vector<SymbolId>> concerns;
  for (const Equation& each : assumptions) concerns.push_back(reach(scope, each).symbols);
  std::vector<SymbolId> concerned = reach(scope, scope.question().claim).symbols;
  std::vector<bool> taken(assumptions.size(), false);
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t i = 0; i < assumptions.size(); ++i) {
      if (taken[i] || (!concerns[i].empty() && !share(concerns[i], concerned))) continue;
      taken[i] = grew = true;
      concerned.insert(concerned.end(), concerns[i].begin(), concerns[i].end());
    }
  }
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) positions.push_back(i);
  }
  return positions;
}

namespace {

/// How many numbers a symbol or an equation of so many components has, if there were a few particles.
[[nodiscard]] std::size_t count_numbers(std::size_t components, std::size_t particles) {
  for (std::size_t i = 0; i < particles; ++i) components *= 2;
  return components;
}

[[nodiscard]] std::size_t component_count(const ExprTree& tree, const Equation& equation) {
  std::size_t count = rigor::component_count(tree[equation.left]);
  for (const IndexId index : equation.indices) count *= tree.space(index).dimension;
  return count;
}

}  // namespace

std::vector<std::size_t> core_assumptions(const Scope& scope, const std::vector<std::size_t>& positions) {
  const ExprTree& tree = scope.tree();
  struct Candidate {
    std::size_t position;
    std::size_t numbers;
    std::vector<SymbolId> symbols;
  };
  std::vector<Candidate> open;
  for (const std::size_t position : positions) {
    const Equation& each = scope.question().assumptions[position];
    open.push_back({position, count_numbers(component_count(tree, each), each.particles.size()),
                    reach(scope, each).symbols});
  }
  std::vector<SymbolId> needed = reach(scope, scope.question().claim).symbols;
  const auto is_loose = [&](SymbolId symbol) {
    if (is_one_of(symbol, needed)) return false;
    std::size_t equations = 0;
    for (const Candidate& each : open) {
      if (share(each.symbols, {symbol})) equations += each.numbers;
    }
    const Symbol& named = tree.symbols[symbol];
    return equations <= count_numbers(rigor::component_count(named), named.per_particle ? 1 : 0);
  };
  const auto fixes_what_is_loose = [&](const Candidate& each) {
    return std::ranges::any_of(each.symbols, is_loose);
  };
  for (;;) {
    const auto loose = std::ranges::find_if(open, fixes_what_is_loose);
    if (loose == open.end()) break;
    open.erase(loose);
  }
  std::vector<std::size_t> core;
  for (const Candidate& each : open) core.push_back(each.position);
  return core;
}

}  // namespace rigor
