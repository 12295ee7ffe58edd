// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/covariance.h"

#include <algorithm>
#include <map>
#include <optional>

namespace rigor {
namespace {

/// How often each letter is in a term, the summed ones left out; nothing where axes matter.
using LettersOfClaim = std::optional<std::map<IndexId, int>>;

class Counting {
 public:
  Counting(const ExprTree& tree, const Names& names) : tree_(tree), names_(names) {}

  LettersOfClaim letters(ExprId id) const {
    if (is_zero(id)) return std::map<IndexId, int>{};
    switch (tree_[id].op) {
      case Op::number:
        return std::map<IndexId, int>{};
      case Op::symbol:
        if (is_principal_value(names_.symbols, tree_.symbols, tree_[id].symbol)) return std::nullopt;
        return with_slots(id, std::map<IndexId, int>{});
      case Op::basis:
      case Op::delta:
      case Op::epsilon:
        return with_slots(id, std::map<IndexId, int>{});
      case Op::component:
        return with_slots(id, of_product(id));
      case Op::negate:
      case Op::particle_sum:
      case Op::multiply:
      case Op::dot:
      case Op::cross:
        return of_product(id);
      case Op::add:
        return of_sum(id);
      case Op::index_sum:
        return of_index_sum(id);
      case Op::power:
        return of_power(id);
      case Op::divide:
        return has_no_letter(child(id, 1)) ? letters(child(id, 0)) : std::nullopt;
      case Op::real_power:
        return has_no_letter(child(id, 0)) && has_no_letter(child(id, 1))
                   ? LettersOfClaim(std::map<IndexId, int>{})
                   : std::nullopt;
      case Op::root:
      case Op::length:
      case Op::absolute:
      case Op::function:
        return has_no_letter(child(id, 0)) ? LettersOfClaim(std::map<IndexId, int>{}) : std::nullopt;
      case Op::tuple:
      case Op::table:
      case Op::determinant:
      case Op::imaginary_unit:
      case Op::conjugate:
      case Op::real_part:
      case Op::imaginary_part:
      case Op::transpose:
      case Op::trace:
      case Op::matrix_determinant:
        return std::nullopt;
    }
    return std::nullopt;
  }

  /// A written 0 of any rank.
  bool is_zero(ExprId id) const {
    if (tree_[id].op != Op::tuple) return tree_.is_zero_literal(id);
    return std::ranges::all_of(tree_.children(id), [this](ExprId each) { return is_zero(each); });
  }

 private:
  [[nodiscard]] ExprId child(ExprId id, std::size_t which) const { return tree_.children(id)[which]; }

  bool has_no_letter(ExprId id) const {
    const LettersOfClaim inside = letters(id);
    return inside && inside->empty();
  }

  LettersOfClaim with_slots(ExprId id, LettersOfClaim inside) const {
    for (const Slot& slot : tree_.slots(id)) {
      if (!inside || slot.axis != 0) return std::nullopt;
      ++(*inside)[slot.variable];
    }
    return inside;
  }

  LettersOfClaim of_product(ExprId id) const {
    std::map<IndexId, int> all;
    for (const ExprId factor : tree_.children(id)) {
      const LettersOfClaim own = letters(factor);
      if (!own) return std::nullopt;
      for (const auto& [letter, times] : *own) all[letter] += times;
    }
    return all;
  }

  LettersOfClaim of_sum(ExprId id) const {
    LettersOfClaim common;
    for (const ExprId term : tree_.children(id)) {
      if (is_zero(term)) continue;
      LettersOfClaim own = letters(term);
      if (!own || (common && *common != *own)) return std::nullopt;
      common = std::move(own);
    }
    return common;
  }

  LettersOfClaim of_index_sum(ExprId id) const {
    LettersOfClaim inside = letters(child(id, 0));
    if (!inside) return std::nullopt;
    const auto summed = inside->find(tree_[id].index);
    if (summed == inside->end() || summed->second != 2) return std::nullopt;
    inside->erase(summed);
    return inside;
  }

  /// A_i² counts as A_i A_i.
  LettersOfClaim of_power(ExprId id) const {
    LettersOfClaim inside = letters(child(id, 0));
    if (!inside || inside->empty()) return inside;
    if (tree_[id].exponent < 1) return std::nullopt;
    for (auto& [letter, times] : *inside) times *= tree_[id].exponent;
    return inside;
  }

  const ExprTree& tree_;
  const Names& names_;
};

}  // namespace

bool is_covariant(const ExprTree& tree, const Names& names, ExprId root, const std::vector<IndexId>& free) {
  const Counting counting(tree, names);
  if (counting.is_zero(root)) return true;
  const LettersOfClaim found = counting.letters(root);
  if (!found) return false;
  std::map<IndexId, int> once;
  for (const IndexId letter : free) once[letter] = 1;
  return *found == once;
}

}  // namespace rigor
