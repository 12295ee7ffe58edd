// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/both_orders.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/meaning/ordered_product.h"

namespace rigor {
namespace {

/// A symbol, one component of it, or a sum in brackets.
struct Factor {
  SymbolId symbol{};  // of a sum: the first one
  std::string slots;  // empty: the whole
  std::string sum = {};
  friend auto operator<=>(const Factor&, const Factor&) = default;
};

std::string_view letter_of_key(const NameKey& key) {
  return std::string_view(key.base).substr(0, key.base.find_first_of("_^"));
}

/// Letters that usually stand for one matrix for each axis.
bool is_usual_generator(std::string_view letter) {
  static constexpr std::array<std::string_view, 9> letters{
      "\\gamma", "\\sigma", "\\tau", "\\theta", "\\psi", "\\lambda", "\\eta", "\\Gamma", "\\Sigma"};
  return is_capital_letter(letter) || is_one_of(letter, letters);
}

/// `a_x`: a component that is written as a number.
bool is_component(const NameKey& key) {
  return key.base.ends_with("_{x}") || key.base.ends_with("_{y}") || key.base.ends_with("_{z}");
}

class Products {
 public:
  Products(const ExprTree& tree, const Names& names) : tree_(tree), names_(names) {}

  /// The products in and below an expression.
  void look(ExprId id) {
    std::vector<Factor> word;
    flatten(id, word);
    if (word.size() > longest_word) return;
    for (std::size_t k = 0; k < word.size(); ++k) {
      for (std::size_t later = k + 1; later < word.size(); ++later) {
        if (word[k] != word[later]) before_.emplace(word[k], word[later]);
      }
    }
  }

  [[nodiscard]] std::set<SymbolId> found() const {
    std::set<SymbolId> symbols = in_exponents();
    for (const auto& [first, second] : before_) {
      if (!before_.contains({second, first}) || !may_have_order(first, second)) continue;
      add(first, symbols);
      add(second, symbols);
    }
    return symbols;
  }

 private:
  static constexpr std::size_t longest_word = 200;
  static constexpr std::uint32_t heaviest_sum = 60;

  void flatten(ExprId id, std::vector<Factor>& word) {
    const ExprNode& node = tree_[id];
    const std::span<const ExprId> children = tree_.children(id);
    switch (node.op) {
      case Op::symbol:
        add_symbol(id, word);
        return;
      case Op::add:
        add_sum(id, word);
        for (const ExprId child : children) look(child);
        return;
      case Op::length:  // `A` where `\vec A` is in another section
        if (tree_[children[0]].op != Op::symbol) return look(children[0]);
        if (const NameKey* key = key_of(names_.symbols, tree_[children[0]].symbol);
            key != nullptr && !names_.symbols.evidence->vectors.contains(std::string(letter_of_key(*key))))
          word.push_back({tree_[children[0]].symbol, {}});
        return;
      case Op::multiply:
        for (const ExprId child : children) flatten(child, word);
        return;
      case Op::negate:
        flatten(children[0], word);
        return;
      case Op::divide:
        flatten(children[0], word);
        look(children[1]);
        return;
      case Op::power:
        if (tree_[children[0]].op == Op::symbol) return flatten(children[0], word);
        if (node.exponent == -1) add_capitals(children[0], word);
        look(children[0]);
        return;
      case Op::function: {
        const bool outer = std::exchange(in_exponent_, in_exponent_ || node.function == Function::exp);
        look(children[0]);
        in_exponent_ = outer;
        return;
      }
      case Op::absolute: {
        const bool outer = std::exchange(in_bars_, true);
        look(children[0]);
        in_bars_ = outer;
        return;
      }
      default:
        for (const ExprId child : children) look(child);
    }
  }

  /// `(a + b)c = c(a + b)`.
  void add_sum(ExprId id, std::vector<Factor>& word) {
    std::vector<SymbolId> symbols = symbols_in(tree_, id);
    const bool numbers = std::ranges::any_of(symbols, [&](SymbolId symbol) {
      return tree_.symbols[symbol].rank != 0 || tree_.symbols[symbol].derivation.has_value();
    });
    if (symbols.empty() || numbers || in_bars_ || tree_[id].weight > heaviest_sum) return;
    word.push_back({symbols.front(), {}, dump(tree_, id)});
    sums_.emplace(word.back().sum, std::move(symbols));
  }

  void add(const Factor& factor, std::set<SymbolId>& symbols) const {
    if (factor.sum.empty()) {
      symbols.insert(factor.symbol);
    } else {
      const std::vector<SymbolId>& inside = sums_.at(factor.sum);
      symbols.insert(inside.begin(), inside.end());
    }
  }

  void add_symbol(ExprId id, std::vector<Factor>& word) {
    const SymbolId symbol = tree_[id].symbol;
    if (tree_[id].rank != 0) return;  // dyads keep their order anyway
    see_capital(symbol);
    const NameKey* key = key_of(names_.symbols, symbol);
    const bool number = in_bars_ && key != nullptr && !is_capital_letter(letter_of_key(*key));
    if (!number) word.push_back({symbol, slots_of(id)});
  }

  /// `(1 + A)^{-1}B = B(1 + A)^{-1}`: what is in the bracket is on its side.
  void add_capitals(ExprId id, std::vector<Factor>& word) const {
    for (const SymbolId symbol : symbols_in(tree_, id)) {
      const NameKey* key = key_of(names_.symbols, symbol);
      if (key != nullptr && key->rank == 0 && is_capital_letter(letter_of_key(*key)))
        word.push_back({symbol, {}});
    }
  }

  std::string slots_of(ExprId id) const {
    std::string text;
    for (const Slot& slot : tree_.slots(id)) {
      text += slot.axis != 0 ? std::to_string(slot.axis) : tree_.name(slot.variable);
      text += ' ';
    }
    return text;
  }

  void see_capital(SymbolId symbol) {
    const NameKey* key = key_of(names_.symbols, symbol);
    if (key == nullptr || key->rank != 0 || !is_capital_letter(letter_of_key(*key))) return;
    if (tree_.symbols[symbol].declared || is_number(*key) ||
        names_.symbols.evidence->vectors.contains(std::string(letter_of_key(*key))))
      return;
    const bool bare = is_capital_letter(key->base);
    if (in_exponent_ && !bare) labelled_exponents_.insert(symbol);
    if (bare) (in_exponent_ ? exponents_ : bases_).insert(symbol);
  }

  /// `e^Ae^B`, `e^ABe^{-A}`, `e^{H_0}e^V`, but not `e^{E_1}e^{E_2}`.
  std::set<SymbolId> in_exponents() const {
    std::set<SymbolId> all = exponents_;
    all.insert(bases_.begin(), bases_.end());
    all.insert(labelled_exponents_.begin(), labelled_exponents_.end());
    return exponents_.empty() || all.size() < 2 ? std::set<SymbolId>{} : all;
  }

  bool is_number(const NameKey& key) const {
    return names_.symbols.evidence->numbers.contains(std::string(letter_of_key(key)));
  }

  bool may_have_order(const Factor& first, const Factor& second) const {
    const NameKey* one = key_of(names_.symbols, first.symbol);
    const NameKey* other = key_of(names_.symbols, second.symbol);
    if (one == nullptr || other == nullptr) return false;      // a derivative, say
    if (one->shape.any() || other->shape.any()) return false;  // the entries of a matrix are numbers
    for (const SymbolId symbol : {first.symbol, second.symbol}) {
      const Symbol& each = tree_.symbols[symbol];
      if (each.declared || each.derivation || each.unit_of_measure || each.per_particle) return false;
    }
    if (first.slots.empty() != second.slots.empty()) return false;
    const bool speaks = names_.symbols.evidence->speaks_of_order || names_.symbols.evidence->order_in_heading;
    const bool same_letter = letter_of_key(*one) == letter_of_key(*other);
    const bool components = !first.slots.empty() || (is_component(*one) && is_component(*other));
    if (!components) return !is_number(*one) || !is_number(*other);
    const std::string letter(letter_of_key(*one));
    if (names_.symbols.evidence->vectors.contains(letter) &&
        !names_.symbols.evidence->labelled.contains(letter))
      return false;
    return same_letter ? speaks || is_usual_generator(letter) : speaks && first.slots.empty();
  }

  const ExprTree& tree_;
  const Names& names_;
  std::set<std::pair<Factor, Factor>> before_;
  std::map<std::string, std::vector<SymbolId>> sums_;
  std::set<SymbolId> exponents_;
  std::set<SymbolId> labelled_exponents_;
  std::set<SymbolId> bases_;
  bool in_exponent_ = false;
  bool in_bars_ = false;
};

}  // namespace

std::set<SymbolId> symbols_in_both_orders(const ExprTree& tree, const Names& names, const Equation& claim) {
  Products products(tree, names);
  products.look(claim.left);
  products.look(claim.right);
  return products.found();
}

namespace {

/// Below a fraction, a root or a sine only numbers stand.
void remove_numbers(const ExprTree& tree, ExprId root, std::set<SymbolId>& symbols) {
  for (const ExprId id : nodes_below(tree, {root})) {
    const ExprNode& node = tree[id];
    const bool divides = node.op == Op::divide;
    if (!divides && node.op != Op::function && node.op != Op::absolute) continue;
    for (const SymbolId symbol : symbols_in(tree, tree.children(id)[divides ? 1 : 0])) symbols.erase(symbol);
  }
}

bool is_single_capital(const ExprTree& tree, const Names& names, SymbolId symbol) {
  const NameKey* key = key_of(names.symbols, symbol);
  return key != nullptr && key->rank == 0 && is_capital_letter(key->base) && !tree.symbols[symbol].derivation;
}

bool is_defined_by_numbers(const Question& question, const Names& names, SymbolId symbol) {
  return std::ranges::any_of(question.definitions, [&](const Definition& each) {
    if (each.symbol != symbol) return false;
    return std::ranges::none_of(symbols_in(*question.tree, each.body), [&](SymbolId inside) {
      return is_single_capital(*question.tree, names, inside);
    });
  });
}

}  // namespace

std::set<SymbolId> capitals_that_must_commute(const Question& question, const Names& names) {
  const ExprTree& tree = *question.tree;
  const auto [left, right] = std::pair(question.claim.left, question.claim.right);
  if (question.claim.relation != Relation::equal || names.symbols.evidence->speaks_of_numbers) return {};
  std::set<SymbolId> capitals;
  for (const ExprId side : {left, right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      if (!is_single_capital(tree, names, symbol) || tree.symbols[symbol].declared) continue;
      const std::string& letter = key_of(names.symbols, symbol)->base;
      const bool number = names.symbols.evidence->numbers.contains(letter) ||
                          names.symbols.evidence->real.contains(letter) ||
                          names.symbols.evidence->vectors.contains(letter);
      if (!number && !is_defined_by_numbers(question, names, symbol)) capitals.insert(symbol);
    }
  }
  for (const ExprId side : {left, right}) remove_numbers(tree, side, capitals);
  const auto equal = [&](ExprId one, ExprId other, const std::set<SymbolId>& ordered) {
    return equal_with_units(tree, one, other, ordered, {});
  };
  if (capitals.size() < 2 || !equal(left, right, {}) || equal(left, right, capitals)) return {};
  const bool read = equal(left, left, capitals) && equal(right, right, capitals);
  return read ? capitals : std::set<SymbolId>{};
}

}  // namespace rigor
