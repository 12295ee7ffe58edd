// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/canonical.h"

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

using Text = CanonicalMonomial;

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
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<std::string> ranks;
    for (const std::string& color : colors) {
      const auto place = std::ranges::lower_bound(sorted, color) - sorted.begin();
      std::string rank = std::to_string(place);
      rank.insert(0, 4 - std::min<std::size_t>(rank.size(), 4), '0');
      ranks.push_back("?" + rank);
    }
    return ranks;
  }

  /// All factors that a letter is in, with the letter itself marked.
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
    std::ranges::sort(texts);
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
    std::ranges::sort(texts);
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
        std::ranges::sort(slots);
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
      if (slots[k] <= slots[k + 1]) continue;
      std::swap(slots[k], slots[k + 1]);
      sign = -sign;
    }
    return slots[0] == slots[1] || slots[1] == slots[2] ? 0 : sign;
  }

  /// Symmetric tensors; repeated derivatives by space, whose axes come last.
  static void sort_symmetric(const Symbol& symbol, std::vector<std::string>& slots) {
    const std::ptrdiff_t space = symbol.order(By::space);
    if (space > 1 && static_cast<std::ptrdiff_t>(slots.size()) >= space)
      std::sort(slots.end() - space, slots.end());
    if (symbol.symmetric && slots.size() >= 2 && std::ptrdiff_t(slots.size()) - space >= 2)
      std::sort(slots.begin(), slots.begin() + 2);
  }

  const SymbolTable& symbols_;
};

}  // namespace

CanonicalMonomial canonical_monomial(const SymbolTable& symbols, const IndexMonomial& term) {
  return Canonical(symbols).monomial(term, {}, 0);
}

std::string canonical_text(const SymbolTable& symbols, const IndexPolynomial& polynomial) {
  return Canonical(symbols).polynomial(polynomial, {}, 0);
}

}  // namespace rigor
