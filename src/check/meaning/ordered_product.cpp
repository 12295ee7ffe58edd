// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/ordered_product.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor {
namespace {

constexpr std::size_t most_words = 2'000;
constexpr std::size_t longest_word = 64;
constexpr std::string_view inverted = "1/";

/// Commuting factors, sorted, and factors in their order.
struct OrderedWord {
  std::vector<std::string> commuting;
  std::vector<std::string> ordered;
  friend auto operator<=>(const OrderedWord&, const OrderedWord&) = default;
};

/// Words with integer coefficients; no entry is 0.
using SumOfWords = std::map<OrderedWord, std::int64_t>;

class WordReader {
 public:
  /// `units`: 1 among `ordered`.
  WordReader(const ExprTree& tree, const std::set<SymbolId>& ordered, const std::set<SymbolId>& units = {})
      : tree_(tree), ordered_(ordered), units_(units) {}

  std::optional<SumOfWords> read(ExprId id) {
    const ExprNode& node = tree_[id];
    const std::span<const ExprId> children = tree_.children(id);
    switch (node.op) {
      case Op::number:
        return number(id);
      case Op::add:
        return sum(children);
      case Op::negate:
        return scaled(read(children[0]), -1);
      case Op::multiply:
        return product(children);
      case Op::power:
        return node.exponent > 0 ? power(id) : inverse(id);
      case Op::divide:
        return quotient(children);
      default:
        return atom(id);
    }
  }

 private:
  bool holds_ordered(ExprId id) const {
    return std::ranges::any_of(symbols_in(tree_, id),
                               [&](SymbolId symbol) { return ordered_.contains(symbol); });
  }

  /// What is not looked into: a symbol, or a whole without an ordered symbol in it.
  std::optional<SumOfWords> atom(ExprId id) const {
    const bool in_order = holds_ordered(id);
    if (in_order && tree_[id].op != Op::symbol) return std::nullopt;
    if (in_order && units_.contains(tree_[id].symbol)) return SumOfWords{{OrderedWord{}, 1}};
    OrderedWord word;
    (in_order || tree_[id].rank > 0 ? word.ordered : word.commuting).push_back(dump(tree_, id));
    return SumOfWords{{std::move(word), 1}};
  }

  std::optional<SumOfWords> number(ExprId id) const {
    const std::string& digits = tree_.digits(id);
    if (digits.size() > 9 || digits.find('.') != std::string::npos) return atom(id);
    const std::int64_t value = std::stoll(digits);
    return value == 0 ? SumOfWords{} : SumOfWords{{OrderedWord{}, value}};
  }

  static std::optional<SumOfWords> scaled(std::optional<SumOfWords> words, std::int64_t by) {
    if (words) {
      for (auto& [word, count] : *words) count *= by;
    }
    return words;
  }

  static bool add(SumOfWords& into, const OrderedWord& word, std::int64_t count) {
    constexpr std::int64_t limit = std::int64_t{1} << 40;
    auto& total = into[word];
    total += count;
    const bool small = total < limit && total > -limit;
    if (total == 0) into.erase(word);
    return small && into.size() <= most_words;
  }

  std::optional<SumOfWords> sum(std::span<const ExprId> children) {
    SumOfWords total;
    for (const ExprId child : children) {
      const auto words = read(child);
      if (!words) return words;
      for (const auto& [word, count] : *words) {
        if (!add(total, word, count)) return std::nullopt;
      }
    }
    return total;
  }

  static std::optional<SumOfWords> times(const SumOfWords& left, const SumOfWords& right) {
    SumOfWords result;
    for (const auto& [first, count] : left) {
      for (const auto& [second, other] : right) {
        OrderedWord word = first;
        word.commuting.insert(word.commuting.end(), second.commuting.begin(), second.commuting.end());
        std::ranges::sort(word.commuting);
        for (const std::string& factor : second.ordered) append(word.ordered, factor);
        const bool small = std::max(std::abs(count), std::abs(other)) < (1 << 20);
        const bool brief = word.ordered.size() + word.commuting.size() <= longest_word;
        if (!small || !brief || !add(result, word, count * other)) return std::nullopt;
      }
    }
    return result;
  }

  std::optional<SumOfWords> product(std::span<const ExprId> children) {
    SumOfWords whole{{OrderedWord{}, 1}};
    for (const ExprId child : children) {
      const auto words = read(child);
      if (!words) return words;
      auto next = times(whole, *words);
      if (!next) return next;
      whole = std::move(*next);
    }
    return whole;
  }

  std::optional<SumOfWords> power(ExprId id) {
    if (!holds_ordered(id)) return flat_power(id);
    const std::vector<ExprId> factors(static_cast<std::size_t>(tree_[id].exponent), tree_.children(id)[0]);
    return factors.size() <= 16 ? product(factors) : std::nullopt;
  }

  /// (xy)⁻¹ = y⁻¹x⁻¹, of one word without a coefficient.
  std::optional<SumOfWords> inverse(ExprId id) {
    if (!holds_ordered(id)) return atom(id);
    const auto base = read(tree_.children(id)[0]);
    const bool one_word = base && base->size() == 1 && base->begin()->second == 1;
    if (!one_word || !base->begin()->first.commuting.empty() || tree_[id].exponent < -16) return std::nullopt;
    const std::vector<std::string>& factors = base->begin()->first.ordered;
    OrderedWord word;
    for (int time = 0; time < -tree_[id].exponent; ++time) {
      for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor)
        append(word.ordered, inverse_of(*factor));
    }
    return SumOfWords{{std::move(word), 1}};
  }

  static std::string inverse_of(const std::string& factor) {
    return factor.starts_with(inverted) ? factor.substr(inverted.size()) : std::string(inverted) + factor;
  }

  /// A factor next to its inverse is 1.
  static void append(std::vector<std::string>& factors, const std::string& factor) {
    if (!factors.empty() && factors.back() == inverse_of(factor)) {
      factors.pop_back();
    } else {
      factors.push_back(factor);
    }
  }

  /// A power of what commutes is multiplied out, too, as far as it is short.
  std::optional<SumOfWords> flat_power(ExprId id) {
    if (tree_[id].exponent > 16) return atom(id);
    const std::vector<ExprId> factors(static_cast<std::size_t>(tree_[id].exponent), tree_.children(id)[0]);
    return product(factors);
  }

  /// A divisor is a commuting factor of its own, which nothing cancels.
  std::optional<SumOfWords> quotient(std::span<const ExprId> children) {
    const auto above = read(children[0]);
    if (!above || holds_ordered(children[1])) return std::nullopt;
    OrderedWord divisor;
    divisor.commuting.push_back("1/" + dump(tree_, children[1]));
    return times(*above, SumOfWords{{std::move(divisor), 1}});
  }

  const ExprTree& tree_;
  const std::set<SymbolId>& ordered_;
  const std::set<SymbolId> units_;
};

/// Is it made of sums, products, powers, multiples and power series alone?
bool is_series(const ExprTree& tree, ExprId id, const std::set<SymbolId>& ordered) {
  const ExprNode& node = tree[id];
  const std::span<const ExprId> children = tree.children(id);
  const auto inside = [&](ExprId child) { return is_series(tree, child, ordered); };
  switch (node.op) {
    case Op::number:
      return true;
    case Op::symbol:  // two components of a vector of matrices are two matrices
      return tree.symbols[node.symbol].rank == 0;
    case Op::add:
    case Op::negate:
    case Op::multiply:
    case Op::function:
      return std::ranges::all_of(children, inside);
    case Op::power:
      return node.exponent > 0 && inside(children[0]);
    case Op::divide: {
      const std::vector<SymbolId> below = symbols_in(tree, children[1]);
      const bool free =
          std::ranges::none_of(below, [&](SymbolId symbol) { return ordered.contains(symbol); });
      return free && inside(children[0]) && inside(children[1]);
    }
    default:
      return false;
  }
}

}  // namespace

bool equal_with_units(const ExprTree& tree, ExprId left, ExprId right, const std::set<SymbolId>& ordered,
                      const std::set<SymbolId>& units) {
  WordReader reader(tree, ordered, units);
  const auto first = reader.read(left);
  const auto second = reader.read(right);
  return first && second && *first == *second;
}

namespace {

/// A capital near matrices may be a matrix, but not if it is defined by numbers: `M = \sum_\alpha m_\alpha`.
void remove_defined_numbers(const ExprTree& tree, const Names& names, const Question& question,
                            std::set<SymbolId>& found) {
  const auto is_number = [&](const Definition& definition) {
    const NameKey* key = key_of(names.symbols, definition.symbol);
    if (key == nullptr || names.symbols.evidence->ordered.contains(without_labels(key->base))) return false;
    return std::ranges::none_of(symbols_in(tree, definition.body),
                                [&](SymbolId each) { return found.contains(each); });
  };
  for (bool shrunk = true; shrunk;) {
    shrunk = false;
    for (const Definition& definition : question.definitions) {
      if (found.contains(definition.symbol) && is_number(definition))
        shrunk = found.erase(definition.symbol) > 0 || shrunk;
    }
  }
}

}  // namespace

namespace {

/// The most factors of `ordered` in a term, 2 for two and more.
class FactorCount {
 public:
  FactorCount(const Question& question, const std::set<SymbolId>& ordered)
      : question_(question), ordered_(ordered) {}

  int of(ExprId id) {
    if (++steps_ > most_steps) return 2;
    const ExprTree& tree = *question_.tree;
    const ExprNode& node = tree[id];
    const std::span<const ExprId> children = tree.children(id);
    switch (node.op) {
      case Op::symbol:
        return of_symbol(node.symbol);
      case Op::add:
      case Op::negate:
      case Op::component:
      case Op::tuple:
      case Op::table:
      case Op::index_sum:
      case Op::particle_sum:
        return most(children);
      case Op::multiply:
      case Op::dot:
      case Op::cross:
        return product(children);
      case Op::divide:
        return of(children[1]) > 0 ? 2 : of(children[0]);
      case Op::power:
        return node.exponent == 1 ? of(children[0]) : 2 * of(children[0]);
      default:
        return 2 * most(children);
    }
  }

 private:
  static constexpr int most_steps = 20'000;

  int most(std::span<const ExprId> children) {
    int found = 0;
    for (const ExprId child : children) found = std::max(found, of(child));
    return found;
  }

  int product(std::span<const ExprId> children) {
    int found = 0;
    for (const ExprId child : children) found += of(child);
    return std::min(found, 2);
  }

  int of_symbol(SymbolId symbol) {
    const int own = ordered_.contains(symbol) ? 1 : 0;
    const Definition* definition = definition_in(question_, symbol);
    return definition == nullptr ? own : std::max(own, of(definition->body));
  }

  const Question& question_;
  const std::set<SymbolId>& ordered_;
  int steps_ = 0;
};

}  // namespace

namespace {

/// Does an assumption speak of one of them?
bool is_assumed(FactorCount& count, const Question& question) {
  return std::ranges::any_of(question.assumptions, [&](const Equation& each) {
    return count.of(each.left) > 0 || count.of(each.right) > 0;
  });
}

}  // namespace

bool equal_in_order(const Question& question, const std::set<SymbolId>& ordered) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  if (ordered.size() == 1 && is_series(tree, claim.left, ordered) && is_series(tree, claim.right, ordered)) {
    FactorCount count(question, ordered);
    if (!is_assumed(count, question)) return true;
  }
  return equal_with_units(tree, claim.left, claim.right, ordered, {});
}

bool is_linear_in(const Question& question, const std::set<SymbolId>& ordered) {
  FactorCount count(question, ordered);
  return !is_assumed(count, question) && count.of(question.claim.left) < 2 &&
         count.of(question.claim.right) < 2;
}

namespace {

/// The vector whose length is taken; a plain letter next to a bold one is read as its length.
std::set<SymbolId> with_length(const ExprTree& tree, ExprId root) {
  std::set<SymbolId> found;
  for (const ExprId id : nodes_below(tree, {root})) {
    if (tree[id].op != Op::length) continue;
    const ExprNode& inside = tree[tree.children(id)[0]];
    if (inside.op == Op::symbol) found.insert(inside.symbol);
  }
  return found;
}

}  // namespace

std::set<SymbolId> ordered_symbols(const ExprTree& tree, const Names& names, const Question& question) {
  std::set<SymbolId> found;
  const auto look = [&](ExprId side) {
    const std::set<SymbolId> lengths = with_length(tree, side);
    for (const SymbolId symbol : symbols_in(tree, side)) {
      const auto& derivation = tree.symbols[symbol].derivation;
      const SymbolId base = derivation ? derivation->base : symbol;
      const NameKey* key = key_of(names.symbols, base);
      const bool read = key != nullptr && key->shape.any();  // a column of numbers
      if (key == nullptr || key->rank > 1 || read || tree.symbols[base].declared) continue;
      const std::string letter = without_labels(key->base);
      // Of a vector of matrices, `\boldsymbol\sigma`, only what was shown counts, not that it is a capital.
      const bool labelled = letter.starts_with("\\") && key->base != letter;  // `\sigma_x`
      const bool beside_matrices = key->rank == 1 && names.symbols.evidence->real.contains(letter);
      if (beside_matrices) continue;  // `\mathbf n\cdot\boldsymbol\sigma`: its components are numbers
      const bool spoken =
          names.symbols.evidence->order_in_heading || (labelled && names.symbols.evidence->speaks_of_order);
      // A small letter inside a written matrix is a number; a capital there can be a block.
      const Evidence& here = *names.symbols.evidence;
      const bool small = here.entries.contains(key->base) && !is_capital_letter(letter);
      const bool of_column = small && key->base != letter && here.matrices.contains(letter);  // x_1 of x
      if (of_column || (here.entries.contains(key->base) && here.plain_numbers.contains(key->base))) continue;
      const bool weak = spoken && !small && !here.numbers.contains(letter);
      const bool plain = lengths.contains(symbol) && here.ordered.contains(letter);
      const bool shown = key->rank == 0 ? weak || names.symbols.evidence->is_ordered(letter)
                                        : plain || names.symbols.evidence->labelled.contains(letter);
      if (shown) found.insert(symbol);
    }
  };
  const auto look_at = [&](const Equation& equation) {
    look(equation.left);
    look(equation.right);
  };
  look_at(question.claim);
  for (const Definition& definition : question.definitions) look(definition.body);
  for (const Equation& assumption : question.assumptions) look_at(assumption);
  remove_defined_numbers(tree, names, question, found);
  return found;
}

std::set<SymbolId> unit_matrices(const Names& names, const Question& question,
                                 const std::set<SymbolId>& ordered) {
  std::set<SymbolId> units;
  for (const SymbolId symbol : ordered) {
    const NameKey* key = key_of(names.symbols, symbol);
    const bool defined = std::ranges::any_of(
        question.definitions, [&](const Definition& definition) { return definition.symbol == symbol; });
    if (key != nullptr && key->rank == 0 && !defined && names.symbols.evidence->units.contains(key->base))
      units.insert(symbol);
  }
  return units;
}

}  // namespace rigor
