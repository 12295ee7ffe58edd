// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/quantity_dimension.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "latex/unit/units.h"
#include "scene/file/quantity_text.h"

namespace rigor {
namespace {

/// Recursion is bounded: a tree is at most as deep as the parser allows, and each symbol is unfolded once.
class Inference {
 public:
  Inference(const ExprTree& tree, std::span<const Definition> definitions,
            const std::function<std::optional<Dimension>(SymbolId)>& dimension_of)
      : tree_(tree), definitions_(definitions), dimension_of_(dimension_of) {}

  std::optional<Dimension> of(ExprId id) {
    if (const auto found = known_.find(id); found != known_.end()) return found->second;
    const auto dimension = fresh(id);
    known_[id] = dimension;
    return dimension;
  }

  [[nodiscard]] std::string take_clash() { return std::move(clash_); }

 private:
  std::optional<Dimension> fresh(ExprId id) {
    const ExprNode& node = tree_[id];
    const auto children = tree_.children(id);
    switch (node.op) {
      case Op::number:
      case Op::basis:
      case Op::delta:
      case Op::epsilon:
      case Op::imaginary_unit:
      case Op::function:
        return Dimension();
      case Op::symbol:
        return of_symbol(node.symbol);
      case Op::add:
      case Op::tuple:
      case Op::table:
        return common(children);
      case Op::multiply:
      case Op::dot:
      case Op::cross:
        return product(children);
      case Op::divide: {
        const auto above = of(children[0]);
        const auto below = of(children[1]);
        return above && below ? std::optional(*above - *below) : std::nullopt;
      }
      case Op::power:
        return scaled(of(children[0]), SmallRational(node.exponent));
      case Op::real_power:
        return of(children[0]) == Dimension() ? std::optional(Dimension()) : std::nullopt;
      case Op::root:
        return scaled(of(children[0]), SmallRational(1, 2));
      case Op::determinant: {  // any product in it has the dimension of the diagonal
        const std::size_t step = children.size() == 9 ? 4 : 1;
        std::vector<ExprId> diagonal;
        for (std::size_t i = 0; i < children.size(); i += step) diagonal.push_back(children[i]);
        return product(diagonal);
      }
      case Op::negate:
      case Op::length:
      case Op::absolute:
      case Op::component:
      case Op::conjugate:
      case Op::real_part:
      case Op::imaginary_part:
      case Op::index_sum:
      case Op::particle_sum:
      case Op::transpose:
      case Op::trace:
        return of(children[0]);
      case Op::matrix_determinant:
        break;
    }
    return std::nullopt;
  }

  static std::optional<Dimension> scaled(const std::optional<Dimension>& dimension, const SmallRational& by) {
    return dimension ? std::optional(*dimension * by) : std::nullopt;
  }

  std::optional<Dimension> product(std::span<const ExprId> factors) {
    Dimension all;
    for (const ExprId factor : factors) {
      const auto dimension = of(factor);
      if (!dimension) return std::nullopt;
      all += *dimension;
    }
    return all;
  }

  /// A written 0 has any dimension.
  std::optional<Dimension> common(std::span<const ExprId> terms) {
    std::optional<Dimension> first;
    for (const ExprId term : terms) {
      if (tree_.is_zero_literal(term)) continue;
      const auto dimension = of(term);
      if (!dimension) continue;
      if (first && *first != *dimension && clash_.empty()) {
        clash_ = fmt::format("terms of {} and of {} are added", si_unit(*first), si_unit(*dimension));
      }
      if (!first) first = dimension;
    }
    return first;
  }

  std::optional<Dimension> of_symbol(SymbolId id) {
    const Symbol& symbol = tree_.symbols[id];
    if (symbol.derivation) {
      const auto base = of_symbol(symbol.derivation->base);
      if (!base) return std::nullopt;
      return *base - time_dimension() * SmallRational(symbol.order(By::time)) -
             length_dimension() * SmallRational(symbol.order(By::space));
    }
    if (symbol.unit_of_measure) return symbol.unit_of_measure;
    if (symbol.unit || symbol.rotation) return Dimension();
    if (const auto given = dimension_of_(id)) return given;
    if (!unfolding_.insert(id).second) return std::nullopt;
    std::optional<Dimension> result;
    for (auto each = definitions_.rbegin(); each != definitions_.rend(); ++each) {
      if (each->symbol != id) continue;
      result = of(each->body);  // by square, too: the body is the root
      break;
    }
    unfolding_.erase(id);
    return result;
  }

  const ExprTree& tree_;
  std::span<const Definition> definitions_;
  const std::function<std::optional<Dimension>(SymbolId)>& dimension_of_;
  std::map<ExprId, std::optional<Dimension>> known_;
  std::set<SymbolId> unfolding_;
  std::string clash_;
};

}  // namespace

QuantityDimension quantity_dimension(const ExprTree& tree, std::span<const Definition> definitions,
                                     ExprId root,
                                     const std::function<std::optional<Dimension>(SymbolId)>& dimension_of) {
  Inference inference(tree, definitions, dimension_of);
  const auto dimension = inference.of(root);
  return {dimension && dimension->is_valid() ? dimension : std::nullopt, inference.take_clash()};
}

std::string si_unit(const Dimension& dimension) {
  std::string above;
  std::string below;
  int factors_below = 0;
  for (std::size_t i = 0; i < base_quantity_count; ++i) {
    const SmallRational& exponent = dimension.exponents()[i];
    if (exponent.is_zero()) continue;
    const bool negative = exponent.over() < 0;
    const std::string power =
        power_text(std::string(base_units[i]), negative ? exponent * SmallRational(-1) : exponent);
    std::string& side = negative ? below : above;
    side += (side.empty() ? "" : " ") + power;
    factors_below += negative ? 1 : 0;
  }
  if (below.empty()) return above.empty() ? "1" : above;
  if (factors_below > 1) below = "(" + below + ")";
  return (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace rigor
