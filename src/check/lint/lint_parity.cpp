// SPDX-License-Identifier: GPL-3.0-or-later
// An axial quantity set equal to a polar one: `\mathbf{L} = \mathbf{r}` together with `\mathbf{L} =
// \mathbf{r}\times\mathbf{p}`.
//
// Everything in space is mirrored through the origin, and the axes stay. A quantity then changes its sign (1)
// or does not (0): 1 for polar vectors, 0 for axial ones, 0 for numbers, 1 for pseudoscalars. Products,
// `\cdot`, `\times` and ε add signs modulo 2, ∇ adds 1, terms and sides agree. The position changes its sign,
// what is declared `polar` does; of other symbols nothing is assumed, so that each equation is linear in
// unknown signs, and a contradiction between equations is one whatever they are. Cost: that of the
// elimination, cubic in the number of symbols at most.

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"

namespace rigor {
namespace {

/// The sign's exponent: a sum of the unknowns of symbols, plus one if `odd`.
struct Parity {
  std::set<SymbolId> symbols;
  bool odd = false;
  friend bool operator==(const Parity&, const Parity&) = default;
};

template <class T>
void add_modulo_2(std::set<T>& into, const std::set<T>& other) {
  for (const T& each : other) {
    if (!into.erase(each)) into.insert(each);
  }
}

Parity sum_of(Parity a, const Parity& b) {
  add_modulo_2(a.symbols, b.symbols);
  a.odd = a.odd != b.odd;
  return a;
}

/// A parity that must be even, and the equations that it follows from.
struct Constraint {
  Parity parity;
  std::set<std::size_t> from;
};

/// Elimination modulo 2, one constraint after the other.
class Elimination {
 public:
  /// If the constraint contradicts earlier ones, it is left out, and their equations are returned.
  std::optional<std::set<std::size_t>> add(Constraint constraint) {
    while (!constraint.parity.symbols.empty()) {
      const SymbolId leading = *constraint.parity.symbols.begin();
      const auto pivot = pivots_.find(leading);
      if (pivot == pivots_.end()) {
        pivots_.emplace(leading, std::move(constraint));
        return std::nullopt;
      }
      constraint.parity = sum_of(std::move(constraint.parity), pivot->second.parity);
      add_modulo_2(constraint.from, pivot->second.from);
    }
    return constraint.parity.odd ? std::optional(std::move(constraint.from)) : std::nullopt;
  }

 private:
  std::map<SymbolId, Constraint> pivots_;
};

/// The parity of an expression, with what its sums demand. Nothing: it fits any, or is not known.
[[nodiscard]] bool is_odd(Function function) {
  return function == Function::sin || function == Function::arcsin || function == Function::arctan;
}

class ParityReader {
 public:
  explicit ParityReader(const LintInput& input) : tree_(input.tree), declared_(input.mirrored) {}

  std::optional<Parity> read(ExprId root) {
    std::vector<ExprId> nodes = nodes_below(tree_, {root});
    std::ranges::sort(nodes);  // children before parents
    for (const ExprId id : nodes) known_.try_emplace(id, of(id));
    return known_.at(root);
  }
  std::vector<Parity> demands;  // each must be even

 private:
  std::optional<Parity> symbol(SymbolId id) const {
    const Symbol& symbol = tree_.symbols[id];
    const SymbolId base = base_of(tree_.symbols, id);
    const std::string& name = tree_.symbols[base].name;
    Parity parity;
    parity.odd = symbol.order(By::space) % 2 == 1;
    if (tree_.symbols[base].rotation) return parity;
    const bool position = tree_.symbols[base].rank == 1 && (name == "\\mathbf{r}" || name == "\\mathbf{x}");
    if (position) return Parity{{}, !parity.odd};
    const auto declared = declared_.find(base);
    if (declared != declared_.end()) return Parity{{}, parity.odd != declared->second};
    parity.symbols = {base};
    return parity;
  }

  /// Factors, all of them known.
  std::optional<Parity> product(std::span<const ExprId> factors) const {
    Parity parity;
    for (const ExprId factor : factors) {
      const auto& own = known_.at(factor);
      if (!own) return std::nullopt;
      parity = sum_of(std::move(parity), *own);
    }
    return parity;
  }

  std::optional<Parity> terms(std::span<const ExprId> terms) {
    std::optional<Parity> first;
    for (const ExprId term : terms) {
      const auto& own = known_.at(term);
      if (own && first) demands.push_back(sum_of(*own, *first));
      if (own && !first) first = own;
    }
    return first;
  }

  /// Of components that are all mirrored alike; a zero fits any.
  std::optional<Parity> common(std::span<const ExprId> components) const {
    std::optional<Parity> first;
    for (const ExprId component : components) {
      const auto& own = known_.at(component);
      if (!own && !tree_.is_zero_literal(component)) return std::nullopt;
      if (own && first && *own != *first) return std::nullopt;
      if (own) first = own;
    }
    return first;
  }

  std::optional<Parity> of(ExprId id) {
    const ExprNode& node = tree_[id];
    const auto children = tree_.children(id);
    switch (node.op) {
      case Op::number:
        return tree_.is_zero_literal(id) ? std::nullopt : std::optional(Parity{});
      case Op::symbol:
        return symbol(node.symbol);
      case Op::basis:
      case Op::delta:
      case Op::epsilon:
      case Op::imaginary_unit:
      case Op::length:
      case Op::absolute:
      case Op::root:
      case Op::real_power:
        return Parity{};
      case Op::add:
        return terms(children);
      case Op::multiply:
      case Op::divide:
      case Op::dot:
      case Op::cross:
      case Op::negate:
      case Op::component:
      case Op::conjugate:
      case Op::real_part:
      case Op::imaginary_part:
      case Op::index_sum:
      case Op::particle_sum:
      case Op::transpose:
      case Op::trace:
        return product(children);
      case Op::matrix_determinant:
        return Parity{};
      case Op::power:
        return node.exponent % 2 == 0 ? Parity{} : known_.at(children[0]);
      case Op::function:
        return is_odd(node.function) ? known_.at(children[0]) : Parity{};
      case Op::tuple:
        return common(children);
      case Op::determinant:
      case Op::table:
        return std::nullopt;
    }
    return std::nullopt;
  }

  const ExprTree& tree_;
  const std::map<SymbolId, bool>& declared_;
  std::map<ExprId, std::optional<Parity>> known_;
};

}  // namespace

Findings lint_parity(const LintInput& input) {
  Elimination elimination;
  ParityReader reader(input);
  Findings findings;
  for (std::size_t k = 0; k < input.stated.size(); ++k) {
    const StatedEquation& stated = input.stated[k];
    if (!stated.is_equation() || input.report.steps[stated.step].verdict == Verdict::refuted) continue;
    reader.demands.clear();
    const auto left = reader.read(stated.left);
    const auto right = reader.read(stated.right);
    if (left && right) reader.demands.push_back(sum_of(*left, *right));
    for (Parity& demand : reader.demands) {
      auto contradicted = elimination.add({std::move(demand), {k}});
      if (!contradicted) continue;
      contradicted->erase(k);
      Diagnostic diagnostic{
          DiagnosticKind::mixed_parity, stated.relation,
          "an axial and a polar quantity are set equal or added: in a mirror only one changes its sign"};
      for (const std::size_t other : *contradicted)
        diagnostic.labels.push_back(
            {input.stated[other].relation, "this says which of them is axial or polar"});
      findings.push_back({std::move(diagnostic)});
      break;
    }
  }
  return findings;
}

}  // namespace rigor
