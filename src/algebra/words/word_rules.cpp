// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/word_rules.h"

#include <algorithm>
#include <utility>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

constexpr std::size_t most_rules = 80;
constexpr std::size_t most_steps = 20'000;

[[nodiscard]] Word part_of(const Word& word, std::size_t begin, std::size_t end) {
  return {word.begin() + static_cast<std::ptrdiff_t>(begin), word.begin() + static_cast<std::ptrdiff_t>(end)};
}

[[nodiscard]] WordSum difference(WordSum a, const WordSum& b) {
  add_to(a, opposite(b));
  return a;
}

[[nodiscard]] bool stands_at(const Word& part, const Word& word, std::size_t at) {
  return at + part.size() <= word.size() &&
         std::equal(part.begin(), part.end(), word.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace

const WordRule* WordRules::fitting(const Word& word, std::size_t& at) const {
  for (const WordRule& rule : rules_) {
    for (at = 0; at + rule.from.size() <= word.size(); ++at) {
      if (stands_at(rule.from, word, at)) return &rule;
    }
  }
  return nullptr;
}

WordSum WordRules::reduce(WordSum sum, Positions& used) const {
  WordSum normal;
  for (std::size_t step = 0; !sum.empty(); ++step) {
    if (step > most_steps) throw Undecidable("bringing products of operators into one order takes too long");
    budget_.count(5 + rules_.size());
    auto last = sum.extract(std::prev(sum.end()));
    const Word& word = last.key();
    std::size_t at = 0;
    const WordRule* rule = fitting(word, at);
    if (rule == nullptr) {
      normal.insert(std::move(last));
      continue;
    }
    used.insert(rule->by.begin(), rule->by.end());
    const WordSum replaced =
        between(part_of(word, 0, at), rule->to, part_of(word, at + rule->from.size(), word.size()));
    add_to(sum, times(scalar(last.mapped()), replaced));
  }
  return normal;
}

std::optional<WordSum> WordRules::reduce_rotations(const WordSum& sum, Positions& used) const {
  for (const auto& [word, coefficient] : sum) {
    Word turned = word;
    for (std::size_t k = 1; k < word.size(); ++k) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      std::size_t at = 0;
      if (fitting(turned, at) == nullptr) continue;
      WordSum rest = sum;
      rest.erase(word);
      add_to(rest, reduce({{turned, coefficient}}, used));
      return rest;
    }
  }
  return std::nullopt;
}

/// What `append` does of its own is a rule where other rules meet it.
void WordRules::add_cancelling(const Letter& letter) {
  Letter other = letter;
  other.inverse = !other.inverse;
  for (Word from : {Word{letter, other}, Word{other, letter}}) {
    const bool known = std::ranges::any_of(rules_, [&](const WordRule& rule) { return rule.from == from; });
    if (!known) rules_.push_back({std::move(from), scalar(rational({1, 1})), {}});
  }
}

void WordRules::add(WordSum zero, Positions by) {
  zero = reduce(std::move(zero), by);
  if (zero.empty()) return;
  const auto vanishes = [&](const auto& each) { return is_nearly_zero(each.second, *parts_); };
  if (parts_ != nullptr && std::ranges::all_of(zero, vanishes)) return;
  const auto greatest = std::prev(zero.end());
  if (greatest->first.empty()) throw Contradiction();  // or they hold for some numbers only
  const Coefficient reciprocal = inverse(greatest->second, true);
  if (reciprocal.empty()) throw Undecidable("a law for its operators has a factor that may be zero");
  for (const auto& [word, coefficient] : zero) {
    for (const Letter& letter : word) {
      if (letter.inverse) add_cancelling(letter);
    }
  }
  if (rules_.size() >= most_rules) throw Undecidable("the laws for its operators lead to too many others");
  Word from = greatest->first;
  zero.erase(greatest);
  WordSum to = times(scalar(reciprocal), opposite(zero));
  // Rules that the new one fits to are added anew, so that none is left that another makes needless.
  std::vector<WordRule> again;
  std::erase_if(rules_, [&](const WordRule& rule) {
    for (std::size_t at = 0; at + from.size() <= rule.from.size(); ++at) {
      if (!stands_at(from, rule.from, at)) continue;
      again.push_back(rule);
      return true;
    }
    return false;
  });
  rules_.push_back({std::move(from), std::move(to), std::move(by)});
  for (WordRule& rule : again) add(difference({{rule.from, rational({1, 1})}}, rule.to), std::move(rule.by));
}

/// Where the end of one word is the beginning of the other, both rules fit to the whole.
void WordRules::add_ends_of(const WordRule& first, const WordRule& second) {
  const WordRule one = first;  // the list may move
  const WordRule other = second;
  const std::size_t most = std::min(one.from.size(), other.from.size());
  for (std::size_t common = 1; common < std::max<std::size_t>(most, 1); ++common) {
    if (!std::equal(other.from.begin(), other.from.begin() + static_cast<std::ptrdiff_t>(common),
                    one.from.end() - static_cast<std::ptrdiff_t>(common)))
      continue;
    const Word before = part_of(one.from, 0, one.from.size() - common);
    const Word behind = part_of(other.from, common, other.from.size());
    Positions by = one.by;
    by.insert(other.by.begin(), other.by.end());
    add(difference(between({}, one.to, behind), between(before, other.to, {})), std::move(by));
  }
}

void WordRules::complete() {
  constexpr int most_rounds = 6;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<WordRule> before = rules_;
    for (const WordRule& first : before) {
      for (const WordRule& second : before) {
        budget_.count(5);
        add_ends_of(first, second);
      }
    }
    const bool same = before.size() == rules_.size() &&
                      std::equal(before.begin(), before.end(), rules_.begin(),
                                 [](const WordRule& a, const WordRule& b) { return a.from == b.from; });
    if (same) return;
  }
  throw Undecidable("the laws for its operators lead to ever more of them");
}

bool WordRules::commute_the_rest() {
  std::set<Letter> letters;
  std::set<Word> known;
  for (const WordRule& rule : rules_) {
    const Word exchanged(rule.from.rbegin(), rule.from.rend());
    const auto fits = [&](const auto& each) {
      return each.first.empty() || (each.first == exchanged && each.second == rational({1, 1}));
    };
    const bool exchanges =
        rule.from.size() == 2 && rule.from[0] != rule.from[1] && rule.to.contains(exchanged);
    if (!exchanges || !std::ranges::all_of(rule.to, fits)) return false;
    letters.insert(rule.from.begin(), rule.from.end());
    known.insert(rule.from);
  }
  for (const Letter& smaller : letters) {
    for (const Letter& greater : letters) {
      if (!(smaller < greater) || known.contains({greater, smaller})) continue;
      WordSum zero{{Word{greater, smaller}, rational({1, 1})}};
      add_to(zero, {{Word{smaller, greater}, rational({-1, 1})}});
      add(std::move(zero), {});
    }
  }
  return true;
}

}  // namespace rigor
