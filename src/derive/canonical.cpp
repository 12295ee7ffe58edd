// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/canonical.h"

#include <algorithm>
#include <map>
#include <utility>

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

/// How letters are called in a text: those that are summed over by what was tried for them.
struct Calling {
  std::map<IndexId, std::string> indices = {};
  std::map<ParticleId, std::string> particles = {};
};

struct Text {
  std::string text;
  int sign = 1;  // 0: vanishes by a symmetry
};

class Canonical {
 public:
  explicit Canonical(const SymbolTable& symbols) : symbols_(symbols) {}

  std::string polynomial(const IndexPolynomial& polynomial, const Calling& calling, int depth) {
    std::map<std::string, SmallRational> terms;
    for (const IndexMonomial& term : polynomial.terms) {
      const Text text = monomial(term, calling, depth);
      if (text.sign == 0) continue;
      SmallRational& total = terms.try_emplace(text.text, 0).first->second;
      total = total + term.coefficient * SmallRational(text.sign);
    }
    std::string all;
    for (const auto& [text, coefficient] : terms) {
      if (!coefficient.is_zero()) all += coefficient.text() + '*' + text + '+';
    }
    return all;
  }

  /// The least text over the names of its sums that could matter.
  Text monomial(const IndexMonomial& term, const Calling& outer, int depth) {
    const std::vector<std::vector<std::size_t>> classes = classes_of(term, outer, depth);
    std::vector<std::size_t> order;
    for (const auto& same : classes) order.insert(order.end(), same.begin(), same.end());
    std::size_t renamings = 1;
    for (const auto& same : classes) {
      for (std::size_t k = 2; k <= same.size(); ++k) renamings *= k;
      if (renamings > most_renamings) break;
    }
    Text best = text_of(term, called(term, outer, order, depth), depth);
    if (renamings > most_renamings) return best;
    std::vector<std::vector<std::size_t>> permuted = classes;
    while (next(permuted)) {
      order.clear();
      for (const auto& same : permuted) order.insert(order.end(), same.begin(), same.end());
      const Text text = text_of(term, called(term, outer, order, depth), depth);
      if (text.text < best.text) {
        best = text;
      } else if (text.text == best.text && text.sign != best.sign) {
        best.sign = 0;
      }
    }
    return best;
  }

 private:
  /// Names for what is summed over, by position in `order`: indices and particles count together.
  static Calling called(const IndexMonomial& term, const Calling& outer,
                        const std::vector<std::size_t>& order, int depth) {
    Calling calling = outer;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::string name = "d" + std::to_string(depth) + "_" + std::to_string(k);
      if (order[k] < term.indices.size()) {
        calling.indices[term.indices[order[k]]] = name;
      } else {
        calling.particles[term.particles[order[k] - term.indices.size()]] = name;
      }
    }
    return calling;
  }

  /// The next combination of permutations within the classes; false after the last.
  static bool next(std::vector<std::vector<std::size_t>>& classes) {
    for (auto& same : classes) {
      if (std::next_permutation(same.begin(), same.end())) return true;
    }
    return false;
  }

  /// Summed letters that cannot be told apart by where they stand, refined until nothing changes.
  std::vector<std::vector<std::size_t>> classes_of(const IndexMonomial& term, const Calling& outer,
                                                   int depth) {
    const std::size_t count = term.indices.size() + term.particles.size();
    std::vector<std::string> color(count);
    for (std::size_t k = 0; k < count; ++k) color[k] = k < term.indices.size() ? "?i" : "?p";
    for (std::size_t round = 0; round < count; ++round) {
      std::vector<std::string> refined(count);
      for (std::size_t k = 0; k < count; ++k) refined[k] = color_of(term, outer, color, k, depth);
      refined = ranked(refined);
      if (refined == color) break;
      color = refined;
    }
    std::map<std::string, std::vector<std::size_t>> classes;
    for (std::size_t k = 0; k < count; ++k) classes[color[k]].push_back(k);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [name, members] : classes) result.push_back(std::move(members));
    return result;
  }

  /// Long texts become their place among the others.
  static std::vector<std::string> ranked(const std::vector<std::string>& colors) {
    std::vector<std::string> sorted = colors;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<std::string> ranks;
    for (const std::string& color : colors) {
      const auto place = std::lower_bound(sorted.begin(), sorted.end(), color) - sorted.begin();
      std::string rank = std::to_string(place);
      rank.insert(0, 4 - std::min<std::size_t>(rank.size(), 4), '0');
      ranks.push_back("?" + rank);
    }
    return ranks;
  }

  /// All factors that a letter stands in, with the letter itself marked.
  std::string color_of(const IndexMonomial& term, const Calling& outer, const std::vector<std::string>& color,
                       std::size_t which, int depth) {
    Calling calling = outer;
    for (std::size_t k = 0; k < term.indices.size(); ++k) calling.indices[term.indices[k]] = color[k];
    for (std::size_t k = 0; k < term.particles.size(); ++k)
      calling.particles[term.particles[k]] = color[term.indices.size() + k];
    const bool is_index = which < term.indices.size();
    if (is_index) {
      calling.indices[term.indices[which]] = "!";
    } else {
      calling.particles[term.particles[which - term.indices.size()]] = "!";
    }
    std::vector<std::string> texts;
    for (const IndexFactor& each : term.factors) {
      const bool stands = is_index ? speaks_of(each, term.indices[which])
                                   : speaks_of(each, term.particles[which - term.indices.size()]);
      if (stands) texts.push_back(factor(each, calling, depth).text);
    }
    std::sort(texts.begin(), texts.end());
    std::string all = color[which];
    for (const std::string& text : texts) all += text + '.';
    return all;
  }

  Text text_of(const IndexMonomial& term, const Calling& calling, int depth) {
    std::vector<std::string> texts;
    Text result;
    for (const IndexFactor& each : term.factors) {
      const Text text = factor(each, calling, depth);
      result.sign *= text.sign;
      texts.push_back(text.text);
    }
    std::sort(texts.begin(), texts.end());
    for (std::size_t k = 0; k < term.indices.size(); ++k) result.text += "i";
    for (std::size_t k = 0; k < term.particles.size(); ++k) result.text += "p";
    for (const std::string& text : texts) result.text += text + '.';
    return result;
  }

  static std::string name_of(const Slot& slot, const Calling& calling) {
    if (slot.axis != 0) return std::to_string(slot.axis);
    const auto known = calling.indices.find(slot.variable);
    if (known != calling.indices.end()) return known->second;
    return "f" + std::to_string(static_cast<std::uint32_t>(slot.variable));
  }

  static std::string name_of(ParticleId particle, const Calling& calling) {
    if (particle == no_particle) return {};
    const auto known = calling.particles.find(particle);
    if (known != calling.particles.end()) return '{' + known->second + '}';
    return "{f" + std::to_string(static_cast<std::uint32_t>(particle)) + '}';
  }

  Text factor(const IndexFactor& factor, const Calling& calling, int depth) {
    std::vector<std::string> slots;
    for (const Slot& slot : factor.slots) slots.push_back(name_of(slot, calling));
    Text result;
    switch (factor.kind) {
      case Kind::delta:
        result.text = "delta";
        std::sort(slots.begin(), slots.end());
        break;
      case Kind::epsilon:
        result.text = "epsilon";
        result.sign = sort_with_sign(slots);
        break;
      case Kind::component:
        result.text = "s" + std::to_string(static_cast<std::uint32_t>(factor.symbol)) +
                      name_of(factor.particle, calling);
        sort_symmetric(symbols_[factor.symbol], slots);
        break;
      case Kind::root:
        result.text = "root(" + polynomial(*factor.argument, calling, depth + 1) + ')';
        break;
      case Kind::sum:
        result.text = "sum(" + polynomial(*factor.argument, calling, depth + 1) + ')';
        break;
      case Kind::function:
        result.text = "function" + std::to_string(static_cast<int>(factor.function)) + '(' +
                      polynomial(*factor.argument, calling, depth + 1) + ')';
        break;
      case Kind::table:
        result.text = "table" + std::to_string(static_cast<std::uint32_t>(factor.table));
        break;
    }
    for (const std::string& slot : slots) result.text += '[' + slot + ']';
    if (factor.exponent != 1) result.text += '^' + std::to_string(factor.exponent);
    return result;
  }

  static int sort_with_sign(std::vector<std::string>& slots) {
    int sign = 1;
    for (const std::size_t k : {0u, 1u, 0u}) {
      if (slots[k] == slots[k + 1]) return 0;
      if (slots[k] < slots[k + 1]) continue;
      std::swap(slots[k], slots[k + 1]);
      sign = -sign;
    }
    return slots[0] == slots[1] || slots[1] == slots[2] ? 0 : sign;
  }

  /// Symmetric tensors; repeated derivatives by space, whose axes come last.
  static void sort_symmetric(const Symbol& symbol, std::vector<std::string>& slots) {
    const std::ptrdiff_t space = symbol.derivation ? symbol.derivation->space : 0;
    if (space > 1 && static_cast<std::ptrdiff_t>(slots.size()) >= space)
      std::sort(slots.end() - space, slots.end());
    if (symbol.symmetric && slots.size() >= 2 && std::ptrdiff_t(slots.size()) - space >= 2)
      std::sort(slots.begin(), slots.begin() + 2);
  }

  const SymbolTable& symbols_;
};

bool is_closed(const IndexMonomial& term, const IndexFactor& factor) {
  return std::none_of(term.indices.begin(), term.indices.end(),
                      [&](IndexId index) { return speaks_of(factor, index); });
}

/// Powers of equal factors that no sum over components reaches are one factor.
void join_equal_factors(Canonical& canonical, IndexMonomial& term) {
  std::map<std::string, std::size_t> known;
  std::vector<IndexFactor> factors;
  for (const IndexFactor& factor : term.factors) {
    if (!is_closed(term, factor) || factor.kind == Kind::delta || factor.kind == Kind::epsilon) {
      factors.push_back(factor);
      continue;
    }
    IndexMonomial alone{.factors = {factor}};
    alone.factors[0].exponent = 1;
    const auto [entry, fresh] = known.try_emplace(canonical.monomial(alone, {}, 0).text, factors.size());
    if (fresh) {
      factors.push_back(factor);
    } else {
      factors[entry->second].exponent += factor.exponent;
    }
  }
  std::erase_if(factors, [](const IndexFactor& factor) { return factor.exponent == 0; });
  term.factors = std::move(factors);
}

/// √x^n with x = a_i a_i beside a_i a_i: √x^(n+2).
bool join_square_with_root(Canonical& canonical, IndexMonomial& term) {
  for (IndexFactor& root : term.factors) {
    if (root.kind != Kind::root || root.exponent >= 0 || root.argument->terms.size() != 1) continue;
    const IndexMonomial& square = root.argument->terms[0];
    if (square.indices.size() != 1 || square.factors.size() != 2 || square.coefficient != SmallRational(1))
      continue;
    const std::string wanted = canonical.monomial(square, {}, 0).text;
    for (const IndexId index : term.indices) {
      IndexMonomial pair{.indices = {index}};
      for (const IndexFactor& factor : term.factors) {
        if (speaks_of(factor, index)) pair.factors.push_back(factor);
      }
      if (pair.factors.size() != 2 || canonical.monomial(pair, {}, 0).text != wanted) continue;
      root.exponent += 2;
      const IndexId joined = index;
      std::erase_if(term.factors, [&](const IndexFactor& factor) { return speaks_of(factor, joined); });
      std::erase(term.indices, joined);
      std::erase_if(term.factors, [](const IndexFactor& factor) { return factor.exponent == 0; });
      return true;
    }
  }
  return false;
}

/// √x² = x, where x can be multiplied in.
bool open_root(ExprTree& tree, IndexMonomial& term, IndexPolynomial& opened) {
  for (std::size_t k = 0; k < term.factors.size(); ++k) {
    IndexFactor& root = term.factors[k];
    if (root.kind != Kind::root || root.exponent < 2) continue;
    IndexPolynomial argument = *root.argument;
    for (IndexMonomial& inner : argument.terms) inner = with_new_sums(tree, inner);
    root.exponent -= 2;
    if (root.exponent == 0) term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(k));
    const auto product = product_of({{term}}, argument);
    if (!product) return false;
    opened = *product;
    return true;
  }
  return false;
}

/// 1/2 of a denominator that is the number 2, and 1 of √1.
bool take_out_numbers(IndexMonomial& term) {
  for (std::size_t k = 0; k < term.factors.size(); ++k) {
    const IndexFactor factor = term.factors[k];
    if (factor.kind != Kind::root && factor.kind != Kind::sum) continue;
    const auto& terms = factor.argument->terms;
    if (terms.size() != 1 || !terms[0].factors.empty() || !terms[0].indices.empty() ||
        !terms[0].particles.empty())
      continue;
    const SmallRational value = terms[0].coefficient;
    if (factor.kind == Kind::root && value != SmallRational(1)) continue;
    term.factors.erase(term.factors.begin() + static_cast<std::ptrdiff_t>(k));
    for (int n = factor.exponent; n < 0; ++n) term.coefficient = term.coefficient / value;
    for (int n = factor.exponent; n > 0; --n) term.coefficient = term.coefficient * value;
    return true;
  }
  return false;
}

/// A sum over what does not speak of its index.
void count_idle_sums(IndexMonomial& term) {
  for (std::size_t k = term.indices.size(); k-- > 0;) {
    if (occurrences(term, term.indices[k]) > 0) continue;
    term.coefficient = term.coefficient * SmallRational(3);
    term.indices.erase(term.indices.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

}  // namespace

std::string canonical_text(const SymbolTable& symbols, const IndexPolynomial& polynomial) {
  return Canonical(symbols).polynomial(polynomial, {}, 0);
}

std::string text_of_terms(const SymbolTable& symbols, const IndexPolynomial& polynomial) {
  Canonical canonical(symbols);
  std::vector<std::string> texts;
  for (const IndexMonomial& term : polynomial.terms) {
    IndexMonomial joined = term;
    join_equal_factors(canonical, joined);
    const Text text = canonical.monomial(joined, {}, 0);
    texts.push_back((term.coefficient * SmallRational(text.sign == 0 ? 1 : text.sign)).text() + '*' +
                    text.text);
  }
  std::sort(texts.begin(), texts.end());
  std::string all;
  for (const std::string& text : texts) all += text + '+';
  return all;
}

bool join_powers(ExprTree& tree, IndexPolynomial& polynomial) {
  Canonical canonical(tree.symbols);
  bool changed = false;
  IndexPolynomial result;
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  while (!open.empty()) {
    IndexMonomial term = std::move(open.back());
    open.pop_back();
    const std::size_t before = term.factors.size();
    join_equal_factors(canonical, term);
    while (join_square_with_root(canonical, term)) {
    }
    while (take_out_numbers(term)) {
    }
    changed = changed || term.factors.size() != before;
    IndexPolynomial opened;
    if (!open_root(tree, term, opened)) {
      result.terms.push_back(std::move(term));
      continue;
    }
    changed = true;
    open.insert(open.end(), opened.terms.rbegin(), opened.terms.rend());
    if (open.size() + result.terms.size() > most_monomials) return false;
  }
  if (changed) polynomial = std::move(result);
  return changed;
}

IndexPolynomial collected(ExprTree& tree, const IndexPolynomial& polynomial) {
  Canonical canonical(tree.symbols);
  std::map<std::string, std::size_t> known;
  std::vector<std::pair<IndexMonomial, int>> kept;  // with the sign of its text
  std::vector<IndexMonomial> open(polynomial.terms.rbegin(), polynomial.terms.rend());
  for (std::size_t budget = 4 * most_monomials; !open.empty() && budget > 0; --budget) {
    IndexMonomial term = std::move(open.back());
    open.pop_back();
    count_idle_sums(term);
    join_equal_factors(canonical, term);
    while (join_square_with_root(canonical, term) || take_out_numbers(term)) {
    }
    IndexPolynomial opened;
    if (open_root(tree, term, opened)) {
      open.insert(open.end(), opened.terms.rbegin(), opened.terms.rend());
      continue;
    }
    const Text text = canonical.monomial(term, {}, 0);
    if (text.sign == 0 || term.coefficient.is_zero()) continue;
    const auto [entry, fresh] = known.try_emplace(text.text, kept.size());
    if (fresh) {
      kept.emplace_back(std::move(term), text.sign);
    } else {
      auto& [first, sign] = kept[entry->second];
      first.coefficient = first.coefficient + term.coefficient * SmallRational(text.sign * sign);
    }
  }
  if (!open.empty()) return polynomial;
  IndexPolynomial result;
  for (auto& [term, sign] : kept) {
    if (!term.coefficient.is_valid()) return polynomial;
    if (!term.coefficient.is_zero()) result.terms.push_back(std::move(term));
  }
  return result;
}

}  // namespace rigor
