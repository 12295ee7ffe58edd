// SPDX-License-Identifier: GPL-3.0-or-later
// Lists and tables of words, written as text: `WordSet("quad qquad")`. All keep views into the text, which is
// a literal as a rule.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "base/check.h"

namespace rigor {

/// What is between blanks and line breaks.
[[nodiscard]] inline std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && !is_white(text[end])) ++end;
    if (end > at) words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

/// `name value name value`: two words a pair.
[[nodiscard]] inline std::vector<std::pair<std::string_view, std::string_view>> word_pairs(
    std::string_view text) {
  const std::vector<std::string_view> words = words_in(text);
  RIGOR_CHECK(words.size() % 2 == 0, words.size());
  std::vector<std::pair<std::string_view, std::string_view>> pairs;
  for (std::size_t k = 0; k < words.size(); k += 2) pairs.emplace_back(words[k], words[k + 1]);
  return pairs;
}

class WordSet {
 public:
  explicit WordSet(std::string_view text) {
    for (const std::string_view word : words_in(text)) words_.insert(word);
  }
  [[nodiscard]] bool contains(std::string_view word) const { return words_.contains(word); }

 private:
  std::unordered_set<std::string_view> words_;
};

/// Every word of a row has the value of the row; of two rows with the same word the first counts.
template <class Value>
class WordMap {
 public:
  using Row = std::pair<std::string_view, Value>;
  WordMap(std::initializer_list<Row> rows) {
    for (const auto& [words, value] : rows) {
      for (const std::string_view word : words_in(words)) values_.emplace(word, value);
    }
  }
  [[nodiscard]] std::optional<Value> find(std::string_view word) const {
    const auto found = values_.find(word);
    return found == values_.end() ? std::nullopt : std::optional<Value>(found->second);
  }

 private:
  std::unordered_map<std::string_view, Value> values_;
};

/// From words to words, written as pairs.
class WordTable {
 public:
  explicit WordTable(std::string_view text) {
    for (const auto& [word, value] : word_pairs(text)) values_.emplace(word, value);
  }
  /// Empty for a word that is not in the table.
  [[nodiscard]] std::string_view find(std::string_view word) const {
    const auto found = values_.find(word);
    return found == values_.end() ? std::string_view{} : found->second;
  }

 private:
  std::unordered_map<std::string_view, std::string_view> values_;
};

}  // namespace rigor
