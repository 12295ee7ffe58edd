// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/word_sum.h"

#include <span>
#include <utility>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

constexpr std::size_t most_words = 4'000;
constexpr std::size_t longest_word = 32;

void add_word(WordSum& into, Word word, const Coefficient& coefficient) {
  if (coefficient.empty()) return;
  Coefficient& total = into[word];
  add_to(total, coefficient);
  if (total.empty()) into.erase(word);
  if (into.size() > most_words) throw Undecidable("it has too many products of operators");
}

/// A letter beside its inverse is 1.
void append(Word& word, std::span<const Letter> more) {
  for (Letter letter : more) {
    letter.inverse = !letter.inverse;
    const bool cancels = !word.empty() && word.back() == letter;
    letter.inverse = !letter.inverse;
    if (cancels) {
      word.pop_back();
    } else {
      word.push_back(letter);
    }
  }
  if (word.size() > longest_word) throw Undecidable("it has too long products of operators");
}

}  // namespace

WordSum scalar(Coefficient value) {
  WordSum sum;
  if (!value.empty()) sum.emplace(Word{}, std::move(value));
  return sum;
}

void add_to(WordSum& into, const WordSum& more) {
  for (const auto& [word, coefficient] : more) add_word(into, word, coefficient);
}

WordSum times(const WordSum& a, const WordSum& b) {
  WordSum result;
  for (const auto& [first, coefficient] : a) {
    for (const auto& [second, other] : b) {
      Word word = first;
      append(word, second);
      add_word(result, std::move(word), times(coefficient, other));
    }
  }
  return result;
}

WordSum opposite(const WordSum& a) { return times(scalar(rational({-1, 1})), a); }

WordSum adjoint(const WordSum& a, CommutingParts& parts) {
  WordSum result;
  for (const auto& [word, coefficient] : a) {
    Word turned(word.rbegin(), word.rend());
    for (Letter& letter : turned) letter.adjoint = !letter.adjoint;
    add_word(result, std::move(turned), conjugate(coefficient, parts));
  }
  return result;
}

Word transpose(const Word& word) {
  Word turned(word.rbegin(), word.rend());
  for (Letter& letter : turned) letter.transpose = !letter.transpose;
  return turned;
}

WordSum transpose(const WordSum& a) {
  WordSum result;
  for (const auto& [word, coefficient] : a) add_word(result, transpose(word), coefficient);
  return result;
}

WordSum between(const Word& u, const WordSum& a, const Word& v) {
  WordSum result;
  for (const auto& [word, coefficient] : a) {
    Word whole = u;
    append(whole, word);
    append(whole, v);
    add_word(result, std::move(whole), coefficient);
  }
  return result;
}

}  // namespace rigor
