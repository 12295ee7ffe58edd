// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/beyond_reals.h"

#include <algorithm>
#include <array>
#include <complex>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/among.h"
#include "base/splitmix.h"
#include "check/question/unread.h"
#include "expr/tree/rough_value.h"

namespace rigor {
namespace {

using Complex = std::complex<double>;

/// The key of a symbol that need not be a real number; null for what is declared or has axes.
const NameKey* open_key(const ExprTree& tree, const Names& names, SymbolId symbol) {
  const Symbol& each = tree.symbols[symbol];
  const SymbolId base = each.derivation ? each.derivation->base : symbol;
  const Symbol& whole = tree.symbols[base];
  if (whole.declared || whole.is_fixed() || whole.rank != 0) return nullptr;
  return key_of(names.symbols, base);
}

std::string letter_before_label(const NameKey& key) { return without_labels(key.base); }

/// Where i is read, letters are real but for those that are shown to be complex and those that often are:
/// amplitudes, coefficients and functions, and not the time, frequencies and lengths.
bool is_usual_real(std::string_view letter) {
  static constexpr std::array<std::string_view, 18> usual{
      "t",      "x",       "y",       "r",       "m",          "M",        "N",    "l",     "L",
      "\\hbar", "\\omega", "\\Omega", "\\theta", "\\vartheta", "\\lambda", "\\nu", "\\tau", "\\rho"};
  return is_one_of(letter, usual);
}

bool may_be_complex(const Evidence& evidence, const std::string& letter) {
  if (evidence.real.contains(letter)) return false;
  const bool imaginary = evidence.letters.contains("i") || evidence.letters.contains("\\mathrm{i}");
  if (!evidence.imaginary_units.empty() && !evidence.complex.contains(letter) && is_usual_real(letter))
    return false;
  if (evidence.complex.contains(letter) || evidence.speaks_of_complex || imaginary) return true;
  static constexpr std::array<std::string_view, 7> usual{"z",        "w",     "\\psi", "\\Psi",
                                                         "\\varphi", "\\phi", "\\Phi"};
  if (!is_one_of(letter, usual)) return false;
  // Coordinates x, y, z, velocities u, v, w, and angles θ, φ.
  const auto beside = [&](const char* first, const char* second) {
    return evidence.letters.contains(first) && evidence.letters.contains(second);
  };
  if (letter == "z") return !beside("x", "y");
  if (letter == "w") return !evidence.letters.contains("u") && !evidence.letters.contains("v");
  return letter.ends_with("si") || !evidence.letters.contains("\\theta");
}

class ComplexValues {
 public:
  ComplexValues(const Question& question, const std::set<SymbolId>& complex)
      : question_(question), tree_(*question.tree), drawn_(complex), complex_(complex) {
    for (const SymbolId symbol : symbols_of(question)) {
      if (tree_.symbols[symbol].complex) drawn_.insert(symbol);
    }
    for (bool grew = true; grew;) {
      grew = false;
      for (const Definition& each : question.definitions) {
        if (!complex_.contains(each.symbol) && is_complex(each.body))
          grew = complex_.insert(each.symbol).second;
      }
    }
  }

  /// Is a modulus or a root taken of what is complex, definitions unfolded?
  bool tells_apart(ExprId root) const {
    std::set<SymbolId> seen;
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      const ExprNode& node = tree_[id];
      const bool of_reals = node.op == Op::absolute || node.op == Op::root || node.op == Op::conjugate ||
                            node.op == Op::real_part || node.op == Op::imaginary_part;
      if (of_reals && is_complex(id)) return true;
      const std::span<const ExprId> children = tree_.children(id);
      pending.insert(pending.end(), children.begin(), children.end());
      if (node.op != Op::symbol || !seen.insert(node.symbol).second) continue;
      if (const Definition* definition = definition_of(id)) pending.push_back(definition->body);
    }
    return false;
  }

  bool is_complex(ExprId id) const {
    return std::ranges::any_of(symbols_in(tree_, id),
                               [&](SymbolId symbol) { return complex_.contains(symbol); });
  }

  void draw(std::uint64_t seed) {
    random_ = SplitMix(seed);
    values_.clear();
    defined_.clear();
  }

  std::optional<Complex> value(ExprId id) {
    const ExprNode& node = tree_[id];
    const std::span<const ExprId> children = tree_.children(id);
    switch (node.op) {
      case Op::number:
        return Complex(std::stod(tree_.digits(id)));
      case Op::symbol:
        if (const Definition* definition = definition_of(id)) return value_of_defined(*definition);
        return node.rank == 0 ? std::optional(value_of(node.symbol)) : std::nullopt;
      case Op::add:
        return folded(children, Complex(0), [](Complex a, Complex b) { return a + b; });
      case Op::multiply:
        return folded(children, Complex(1), [](Complex a, Complex b) { return a * b; });
      case Op::negate:
        return mapped(children[0], [](Complex a) { return -a; });
      case Op::power:
        return mapped(children[0], [&](Complex a) { return std::pow(a, node.exponent); });
      case Op::real_power: {
        const auto base = value(children[0]);
        const auto exponent = value(children[1]);
        if (!base || !exponent || std::abs(*base) < 1e-9) return std::nullopt;
        return std::pow(*base, *exponent);
      }
      case Op::root:
        return mapped(children[0], [](Complex a) { return std::sqrt(a); });
      case Op::absolute:
        return mapped(children[0], [](Complex a) { return Complex(std::abs(a)); });
      case Op::imaginary_unit:
        return Complex(0, 1);
      case Op::conjugate:
        return mapped(children[0], [](Complex a) { return std::conj(a); });
      case Op::real_part:
        return mapped(children[0], [](Complex a) { return Complex(a.real()); });
      case Op::imaginary_part:
        return mapped(children[0], [](Complex a) { return Complex(a.imag()); });
      case Op::divide: {
        const auto above = value(children[0]);
        const auto below = value(children[1]);
        if (!above || !below || std::abs(*below) < 1e-9) return std::nullopt;
        return *above / *below;
      }
      case Op::function:
        return mapped(children[0], [&](Complex a) { return function_value(node.function, a); });
      default:
        return std::nullopt;
    }
  }

 private:
  template <typename Operation>
  std::optional<Complex> folded(std::span<const ExprId> children, Complex total, const Operation& operation) {
    for (const ExprId child : children) {
      const auto each = value(child);
      if (!each) return std::nullopt;
      total = operation(total, *each);
    }
    return total;
  }

  template <typename Operation>
  std::optional<Complex> mapped(ExprId child, const Operation& operation) {
    const auto inside = value(child);
    return inside ? std::optional<Complex>(operation(*inside)) : std::nullopt;
  }

  const Definition* definition_of(ExprId id) const {
    return tree_[id].op == Op::symbol ? definition_in(question_, tree_[id].symbol) : nullptr;
  }

  Complex value_of(SymbolId symbol) {
    const auto known = values_.find(symbol);
    if (known != values_.end()) return known->second;
    const double real = 0.3 + draw_unit();
    const Complex value = drawn_.contains(symbol) ? Complex(real - 0.8, 0.2 + draw_unit()) : Complex(real);
    values_.emplace(symbol, value);
    return value;
  }

  /// Once a draw, however often it stands.
  std::optional<Complex> value_of_defined(const Definition& definition) {
    const auto known = defined_.find(definition.symbol);
    if (known != defined_.end()) return known->second;
    const std::optional<Complex> found = value(definition.body);
    defined_.emplace(definition.symbol, found);
    return found;
  }

  double draw_unit() { return static_cast<double>(random_.next() >> 11) * 0x1p-53; }

  const Question& question_;
  const ExprTree& tree_;
  std::set<SymbolId> drawn_;    // complex by themselves, or perhaps
  std::set<SymbolId> complex_;  // that may be complex and were taken for real, and what is defined by them
  std::map<SymbolId, Complex> values_;
  std::map<SymbolId, std::optional<Complex>> defined_;
  SplitMix random_{0};
};

bool is_met(Relation relation, Complex left, Complex right) {
  const double scale = 1 + std::abs(left) + std::abs(right);
  constexpr double tolerance = 1e-9;
  if (relation == Relation::equal) return std::abs(left - right) < tolerance * scale;
  if (relation == Relation::unequal) return false;  // x^2 + 1 is 0 for no real number
  // An order is one of real numbers.
  return std::abs(left.imag()) < tolerance * scale && std::abs(right.imag()) < tolerance * scale &&
         left.real() < right.real() + tolerance * scale;
}

bool shares(const ExprTree& tree, ExprId side, const std::set<SymbolId>& symbols) {
  return std::ranges::any_of(symbols_in(tree, side),
                             [&](SymbolId symbol) { return symbols.contains(symbol); });
}

}  // namespace

std::set<SymbolId> complex_symbols(const Question& question, const Names& names) {
  std::set<SymbolId> found;
  for (const SymbolId symbol : symbols_of(question)) {
    const NameKey* key = open_key(*question.tree, names, symbol);
    if (key != nullptr && !question.tree->symbols[symbol].complex &&
        may_be_complex(*names.symbols.evidence, letter_before_label(*key)))
      found.insert(symbol);
  }
  return found;
}

bool holds_for_complex(const Question& question, const std::set<SymbolId>& symbols) {
  if (symbols.empty()) return true;
  ComplexValues values(question, symbols);
  const Equation& claim = question.claim;
  const auto is_of_complex = [&](const Equation& each) {
    return values.is_complex(each.left) || values.is_complex(each.right);
  };
  const auto tells_apart = [&](const Equation& each) {
    const bool order = each.relation != Relation::equal && each.relation != Relation::unequal;
    return (order && is_of_complex(each)) || values.tells_apart(each.left) || values.tells_apart(each.right);
  };
  const bool asked = (claim.relation == Relation::unequal && is_of_complex(claim)) || tells_apart(claim) ||
                     std::ranges::any_of(question.assumptions, tells_apart);
  if (!asked) return true;
  const ExprTree& tree = *question.tree;
  const bool assumed = std::ranges::any_of(question.assumptions, [&](const Equation& each) {
    return shares(tree, each.left, symbols) || shares(tree, each.right, symbols);
  });
  if (assumed) return false;
  constexpr std::uint64_t trials = 6;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    values.draw(seed);
    const auto left = values.value(claim.left);
    const auto right = values.value(claim.right);
    if (!left || !right || !is_met(claim.relation, *left, *right)) return false;
  }
  return true;
}

std::set<SymbolId> symbols_of_determinants(const Question& question, const Names& names) {
  const ExprTree& tree = *question.tree;
  const Evidence& evidence = *names.symbols.evidence;
  const auto can_be_matrix = [&](SymbolId symbol) {
    const NameKey* key = open_key(tree, names, symbol);
    if (key == nullptr || key->base.size() != 1 || key->base[0] < 'A' || key->base[0] > 'Z') return false;
    return !evidence.real.contains(key->base) && !evidence.numbers.contains(key->base) &&
           !evidence.vectors.contains(key->base) && !evidence.complex.contains(key->base);
  };
  std::set<SymbolId> inside;
  std::set<SymbolId> different;
  std::vector<ExprId> pending{question.claim.left, question.claim.right};
  std::vector<ExprId> outside;
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    const std::span<const ExprId> children = tree.children(id);
    if (tree[id].op == Op::symbol) outside.push_back(id);
    if (tree[id].op != Op::absolute) {
      pending.insert(pending.end(), children.begin(), children.end());
      continue;
    }
    // Products and powers of matrices have the products and powers of their determinants.
    bool only_products = true;
    std::vector<ExprId> factors{children[0]};
    while (!factors.empty() && only_products) {
      const ExprId factor = factors.back();
      factors.pop_back();
      const std::span<const ExprId> parts = tree.children(factor);
      const Op op = tree[factor].op;
      const bool product = op == Op::multiply || op == Op::power;
      only_products = product || (op == Op::symbol && can_be_matrix(tree[factor].symbol));
      factors.insert(factors.end(), parts.begin(), parts.end());
    }
    for (const SymbolId symbol : symbols_in(tree, children[0])) {
      if (!can_be_matrix(symbol)) continue;
      inside.insert(symbol);
      if (!only_products) different.insert(symbol);
    }
  }
  for (const ExprId id : outside) {
    if (inside.contains(tree[id].symbol)) different.insert(tree[id].symbol);
  }
  return different;
}

}  // namespace rigor
