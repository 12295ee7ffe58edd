// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/state_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "algebra/engine/undecidable.h"
#include "base/ascii.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

constexpr std::size_t most_instances = 24;

[[nodiscard]] bool is_ket_letter(const Letter& letter, const ExprTree& tree) {
  return tree.symbols[letter.symbol].ket;
}

[[nodiscard]] std::string text_of_bracket(const Word& word) {
  std::string text = "#<";
  for (const Letter& letter : word)
    text += fmt::format("{}{}{}{}{} ", static_cast<std::uint32_t>(letter.symbol),
                        letter.component == 0 ? "" : fmt::format("[{}]", letter.component),
                        letter.inverse ? "-" : "", letter.transpose ? "T" : "", letter.adjoint ? "*" : "");
  return text;
}

/// (⟨a|X|b⟩)* as a word in the same form.
[[nodiscard]] Word conjugate_bracket(const Word& word, CommutingParts& parts, const WordRules* rules,
                                     Positions& used) {
  const WordSum turned = adjoint(WordSum{{word, rational({1, 1})}}, parts);
  const Word plain = turned.begin()->first;
  if (rules == nullptr) return plain;
  const WordSum reduced = rules->reduce(turned, used);
  const bool one = reduced.size() == 1 && reduced.begin()->second == rational({1, 1}) &&
                   reduced.begin()->first.size() == word.size();
  return one ? reduced.begin()->first : plain;
}

[[nodiscard]] Coefficient number_of_bracket(const Word& word, CommutingParts& parts, const WordRules* rules,
                                            Positions& used) {
  const std::string own = text_of_bracket(word);
  const std::string other = text_of_bracket(conjugate_bracket(word, parts, rules, used));
  if (own == other) return power_of_part(parts.number_named(own), 1);
  const std::uint32_t number = parts.number_named(std::min(own, other), true);
  return power_of_part(own < other ? number : parts.conjugate_of(number), 1);
}

// --- a law for any n

/// n, and what stands for it.
using Numbers = std::map<std::string, LabelPart>;
using Label = std::vector<LabelPart>;

[[nodiscard]] LabelPart put_in(const LabelPart& part, const Numbers& numbers) {
  const auto found = numbers.find(part.letter);
  if (found == numbers.end()) return part;
  const bool above = part.mark.starts_with('^') && found->second.letter.empty();
  return {found->second.letter, above ? "" : part.mark, found->second.number + part.number};
}

[[nodiscard]] bool may_stand_for_a_number(const LabelPart& part, bool alone) {
  return part.letter.empty() ? !alone || part.number >= 0 : numbers_states(part);
}

/// Does `label` become `other` with these numbers and further ones?
[[nodiscard]] std::optional<Numbers> unified(const Label& label, const Label& other, Numbers numbers) {
  if (label.size() != other.size()) return std::nullopt;
  for (std::size_t k = 0; k < label.size(); ++k) {
    if (!numbers_states(label[k]) || numbers.contains(label[k].letter)) {
      if (put_in(label[k], numbers) != other[k]) return std::nullopt;
      continue;
    }
    const bool same_mark =
        label[k].mark == other[k].mark || (other[k].letter.empty() && label[k].mark.empty());
    if (!same_mark || !may_stand_for_a_number(other[k], label.size() == 1)) return std::nullopt;
    numbers[label[k].letter] = {other[k].letter, "", other[k].number - label[k].number};
  }
  return numbers;
}

void collect_labels(const WordSum& sum, const ExprTree& tree, std::set<Label>& into) {
  for (const auto& [word, coefficient] : sum) {
    for (const Letter& letter : word) {
      if (is_ket_letter(letter, tree) && !tree.symbols[letter.symbol].label.empty())
        into.insert(tree.symbols[letter.symbol].label);
    }
  }
}

[[nodiscard]] bool has_free_number(const Label& label, const Numbers& numbers) {
  return std::ranges::any_of(
      label, [&](const LabelPart& part) { return numbers_states(part) && !numbers.contains(part.letter); });
}

/// Puts numbers in for those of a law. Throws Undecidable where a letter may depend on them.
class Instance {
 public:
  Instance(const Numbers& numbers, CommutingParts& parts, const std::function<WordSum(ExprId)>& read)
      : numbers_(numbers), parts_(parts), read_(read) {}

  [[nodiscard]] WordSum of(const WordSum& law) {
    WordSum result;
    for (const auto& [word, coefficient] : law) {
      Word own = word;
      for (Letter& letter : own) letter.symbol = of_letter(letter.symbol);
      const WordSum number = read_(expression(as_expression(coefficient, parts_, {})));
      add_to(result, times(number, WordSum{{own, rational({1, 1})}}));
    }
    // `H|n\rangle = E|n\rangle`: E may be another one for another n. In `S|i\rangle = |f\rangle` nothing says
    // that i is any number.
    if ((fixed_letters_ || operators_) && !numbered_letters_)
      throw Undecidable("a letter of a law may depend on the number of its state");
    return result;
  }

 private:
  [[nodiscard]] ExprTree& tree() { return parts_.tree(); }

  [[nodiscard]] SymbolId of_letter(SymbolId id) {
    const Symbol& symbol = tree().symbols[id];
    if (!symbol.ket) {
      if (depends(symbol)) throw Undecidable("an operator of a law has the number of a state");
      operators_ = true;
      return id;
    }
    if (symbol.derivation) throw Undecidable("a rate of a state is not that of another one");
    Label label = symbol.label;
    for (LabelPart& part : label) part = put_in(part, numbers_);
    return symbol_of_ket(tree(), label, symbol.first_seen);
  }

  /// `E_{n}`: does a number stand below it?
  [[nodiscard]] bool depends(const Symbol& symbol) const {
    if (symbol.integral) return true;
    const std::size_t script = symbol.name.find('_');
    if (script == std::string::npos) return false;
    return std::ranges::any_of(numbers_, [&](const auto& each) {
      return position_of(symbol.name, each.first, script) != std::string::npos;
    });
  }

  /// Of a letter by itself, not of one in `\text` or `\nu`.
  [[nodiscard]] static std::size_t position_of(const std::string& name, const std::string& letter,
                                               std::size_t from) {
    for (std::size_t at = name.find(letter, from); at != std::string::npos; at = name.find(letter, at + 1)) {
      const bool before = at > 0 && (is_letter(name[at - 1]) || name[at - 1] == '\\');
      const std::size_t end = at + letter.size();
      const bool behind = end < name.size() && is_letter(name[end]) && is_letter(letter.back());
      if (!before && !behind) return at;
    }
    return std::string::npos;
  }

  [[nodiscard]] std::optional<SymbolId> symbol_named(const std::string& name) {
    for (std::uint32_t k = 0; k < tree().symbols.size(); ++k) {
      const Symbol& known = tree().symbols[SymbolId{k}];
      if (known.name == name && known.rank == 0 && !known.noncommuting) return SymbolId{k};
    }
    return std::nullopt;
  }

  [[nodiscard]] ExprId number(const LabelPart& part) {
    const auto digits = [&](int value) {
      const ExprId size = tree().add_number({}, std::to_string(std::abs(value)));
      return value < 0 ? tree().add({.op = Op::negate}, std::span(&size, 1)) : size;
    };
    if (part.letter.empty()) return digits(part.number);
    std::optional<SymbolId> letter = symbol_named(part.letter);
    if (!letter) {
      Symbol made;
      made.name = part.letter;
      made.made_at = tree().size();
      letter = tree().symbols.add(std::move(made));
    }
    const ExprId symbol = tree().add({.op = Op::symbol, .symbol = *letter});
    if (part.number == 0) return symbol;
    const ExprId both[] = {symbol, digits(part.number)};
    return tree().add({.op = Op::add}, both);
  }

  [[nodiscard]] ExprId of_symbol(ExprId id) {
    const SymbolId own = tree()[id].symbol;
    const Symbol symbol = tree().symbols[own];
    const bool numbered = is_kronecker_of_states(symbol) || numbers_.contains(symbol.name) || depends(symbol);
    (numbered ? numbered_letters_ : fixed_letters_) = true;
    if (is_kronecker_of_states(symbol))
      return kronecker_of_states(tree(), put_in(symbol.label[0], numbers_), put_in(symbol.label[1], numbers_),
                                 {});
    if (const auto found = numbers_.find(symbol.name); found != numbers_.end()) return number(found->second);
    if (!depends(symbol)) return id;
    std::string name = symbol.name;
    for (const auto& [letter, part] : numbers_) {
      const std::size_t at = position_of(name, letter, name.find('_'));
      if (at == std::string::npos) continue;
      std::string text = text_of_label({part});
      std::erase(text, ' ');
      name.replace(at, letter.size(), text);
    }
    if (name == symbol.name) return id;
    const auto other = symbol_named(name);
    if (symbol.integral || !other) throw Undecidable("a letter of a law has the number of a state");
    return tree().add({.op = Op::symbol, .symbol = *other});
  }

  /// n + 1 − 1 under a root is n.
  [[nodiscard]] ExprId simplified(ExprId id) {
    const WordSum value = read_(id);
    if (value.empty()) return tree().add_number({}, "0");
    if (value.size() != 1 || !value.begin()->first.empty()) return id;
    const Coefficient& terms = value.begin()->second;
    std::optional<ExprId> letter;
    WordFraction rest{0, 1};
    for (const auto& [monomial, factor] : terms) {
      if (monomial.empty()) {
        rest = factor;
      } else if (letter || monomial.size() != 1 || monomial[0].second != 1 || factor != WordFraction{1, 1}) {
        return id;
      } else {
        letter = parts_.part(monomial[0].first);
      }
    }
    if (rest.below != 1 || (!letter && rest.above < 0)) return id;
    const ExprId size = tree().add_number({}, std::to_string(std::abs(rest.above)));
    if (!letter) return size;
    if (rest.above == 0) return *letter;
    const ExprId both[] = {*letter,
                           rest.above < 0 ? tree().add({.op = Op::negate}, std::span(&size, 1)) : size};
    return tree().add({.op = Op::add}, both);
  }

  [[nodiscard]] ExprId expression(ExprId id) {
    const ExprNode node = tree()[id];
    if (node.op == Op::symbol) return of_symbol(id);
    const std::vector<ExprId> before(tree().children(id).begin(), tree().children(id).end());
    if (before.empty()) return id;
    std::vector<ExprId> children;
    for (const ExprId child : before) children.push_back(expression(child));
    if (children == before) return id;
    if (node.op == Op::root) {
      children[0] = simplified(children[0]);
      if (tree()[children[0]].op == Op::number) {
        const std::string& digits = tree().digits(children[0]);
        if (digits == "0" || digits == "1") return children[0];
      }
    }
    const std::vector<Slot> slots(tree().slots(id).begin(), tree().slots(id).end());
    if (node.op == Op::table) throw Undecidable("cases beside states are not decided");
    return tree().add(node, children, slots);
  }

  const Numbers& numbers_;
  CommutingParts& parts_;
  bool fixed_letters_ = false;
  bool operators_ = false;
  bool numbered_letters_ = false;
  const std::function<WordSum(ExprId)>& read_;
};

/// Kets of one name stay apart where a law says different things of them: ⟨m|n⟩ = 0.
[[nodiscard]] bool joins_states(const std::set<Label>& patterns, const Numbers& numbers, bool has_delta) {
  if (has_delta) return false;
  std::set<Label> images;
  for (Label label : patterns) {
    for (LabelPart& part : label) part = put_in(part, numbers);
    images.insert(std::move(label));
  }
  return images.size() < patterns.size();
}

[[nodiscard]] bool has_delta(const WordSum& law, const CommutingParts& parts) {
  for (const auto& [word, coefficient] : law) {
    for (const auto& [monomial, factor] : coefficient) {
      for (const auto& [part, exponent] : monomial) {
        const ExprNode& node = parts.tree()[parts.part(part)];
        if (node.op == Op::symbol && is_kronecker_of_states(parts.tree().symbols[node.symbol])) return true;
      }
    }
  }
  return false;
}

/// Such that `first` becomes one of the kets that are asked about, and others where that leaves something
/// free.
[[nodiscard]] std::vector<Numbers> numbers_for(const Label& first, const std::set<Label>& patterns,
                                               const std::set<Label>& wanted) {
  std::vector<Numbers> all{{}};
  std::vector<Label> order{first};
  order.insert(order.end(), patterns.begin(), patterns.end());
  for (const Label& pattern : order) {
    std::vector<Numbers> more;
    for (const Numbers& numbers : all) {
      if (!has_free_number(pattern, numbers)) {
        more.push_back(numbers);
        continue;
      }
      for (const Label& label : wanted) {
        if (auto extended = unified(pattern, label, numbers)) more.push_back(*std::move(extended));
      }
    }
    all = std::move(more);
    if (all.size() > most_instances) all.resize(most_instances);
  }
  return all;
}

}  // namespace

bool holds_kets(const WordSum& sum, const ExprTree& tree) {
  return std::ranges::any_of(sum, [&](const auto& each) {
    return std::ranges::any_of(each.first, [&](const Letter& letter) { return is_ket_letter(letter, tree); });
  });
}

WordSum with_brackets_out(const WordSum& sum, CommutingParts& parts, const WordRules* rules,
                          Positions& used) {
  WordSum result;
  for (const auto& [whole, coefficient] : sum) {
    Word word;
    Coefficient factor = coefficient;
    std::optional<std::size_t> bra;
    for (const Letter& letter : whole) {
      word.push_back(letter);
      if (!is_ket_letter(letter, parts.tree())) continue;
      if (letter.adjoint) {
        bra = word.size() - 1;
      } else if (bra) {
        const auto begin = word.begin() + static_cast<std::ptrdiff_t>(*bra);
        factor = times(factor, number_of_bracket(Word(begin, word.end()), parts, rules, used));
        word.erase(begin, word.end());
        bra.reset();
      }
    }
    add_to(result, WordSum{{std::move(word), std::move(factor)}});
  }
  return result;
}

LawsOfStates laws_of_other_states(const LawsOfStates& laws, const std::vector<ExprId>& roots,
                                  CommutingParts& parts, const std::function<WordSum(ExprId)>& read) {
  constexpr int rounds = 2;
  std::set<Label> wanted;
  for (const ExprId id : nodes_below(parts.tree(), roots)) {
    const ExprNode& node = parts.tree()[id];
    if (node.op == Op::symbol && parts.tree().symbols[node.symbol].ket &&
        !parts.tree().symbols[node.symbol].label.empty())
      wanted.insert(parts.tree().symbols[node.symbol].label);
  }
  LawsOfStates found;
  std::set<std::pair<std::size_t, Numbers>> done;
  for (int round = 0; round < rounds; ++round) {
    std::set<Label> next = wanted;
    for (std::size_t k = 0; k < laws.size(); ++k) {
      std::set<Label> patterns;
      collect_labels(laws[k].first, parts.tree(), patterns);
      const bool delta = has_delta(laws[k].first, parts);
      std::set<Numbers> all;
      for (const Label& first : patterns) {
        for (Numbers& numbers : numbers_for(first, patterns, wanted)) all.insert(std::move(numbers));
      }
      for (const Numbers& numbers : all) {
        if (numbers.empty() || joins_states(patterns, numbers, delta) || !done.emplace(k, numbers).second)
          continue;
        try {
          WordSum law = Instance(numbers, parts, read).of(laws[k].first);
          collect_labels(law, parts.tree(), next);
          if (!law.empty()) found.emplace_back(std::move(law), laws[k].second);
        } catch (const Undecidable&) {
          // a letter of the law has another value there
        }
        if (found.size() >= 2 * most_instances) return found;
      }
    }
    wanted = std::move(next);
  }
  return found;
}

}  // namespace rigor
