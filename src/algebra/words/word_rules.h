// SPDX-License-Identifier: GPL-3.0-or-later
// What laws say of operators, as rules that replace a word by smaller ones: `[x, p] = iħ` is px → xp − iħ.
// Applied as long as one fits, they lead to a normal form. Where two rules fit and lead to different ends,
// the difference is a further rule. When no such pair is left, normal forms do not depend on the order in
// which rules are applied (G. Bergman, The diamond lemma for ring theory, 1978): then the words to which no
// rule fits are linearly independent, so the laws do not contradict each other, and a sum of words is 0 by
// the laws alone exactly if its normal form is 0.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "algebra/engine/budget.h"
#include "algebra/words/word_sum.h"

namespace rigor {

using Positions = std::set<std::size_t>;  // in Question::assumptions

struct WordRule {
  Word from;
  WordSum to;
  Positions by;
};

class WordRules {
 public:
  explicit WordRules(Budget& budget) : budget_(budget) {}
  /// Laws of states lead to `\sqrt n\sqrt n - n`: what seems to vanish is no rule, and no contradiction.
  void see_numbers(const CommutingParts& parts) { parts_ = &parts; }

  /// `zero` is 0 by these assumptions. Throws Undecidable where it says something of numbers only, or where
  /// its greatest word has a coefficient that may be 0.
  void add(WordSum zero, Positions by);
  /// Adds what follows from pairs of rules. Throws Undecidable if that does not end soon, or contradicts.
  void complete();
  /// If each rule says that a commutator of two letters is a number: lets all other letters of these commute.
  /// Such a set always has operators that satisfy it (sums of positions and momenta), whatever the numbers.
  [[nodiscard]] bool commute_the_rest();
  /// The normal form; `used` gets what was needed.
  [[nodiscard]] WordSum reduce(WordSum sum, Positions& used) const;
  /// The sum with a rotation of one of its words brought into normal form, as a trace allows; nothing where
  /// no rule fits to one.
  [[nodiscard]] std::optional<WordSum> reduce_rotations(const WordSum& sum, Positions& used) const;
  [[nodiscard]] const std::vector<WordRule>& rules() const { return rules_; }

 private:
  void add_cancelling(const Letter& letter);
  [[nodiscard]] const WordRule* fitting(const Word& word, std::size_t& at) const;
  void add_ends_of(const WordRule& first, const WordRule& second);

  Budget& budget_;
  const CommutingParts* parts_ = nullptr;
  std::vector<WordRule> rules_;
};

}  // namespace rigor
