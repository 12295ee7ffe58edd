// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/index_condition.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {
namespace {

using Axes = std::vector<int>;  // one axis 1..3 for each letter, in the letters' own order

/// Without LaTeX, blanks and capitals: `\text{if } i = j` is `ifi=j`.
std::string bare(const std::string& words) {
  std::string text = words;
  for (const char* mark : {"\\text", "\\mbox", "\\mathrm", "\\textrm", "\\quad", "\\qquad", "\\left",
                           "\\right", "\\ ", "\\,", "\\;", "~"}) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark))
      text.replace(at, std::string(mark).size(), " ");
  }
  for (const char* sign : {"\\neq", "\\ne", "\\not="}) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign))
      text.replace(at, std::string(sign).size(), "#");
  }
  std::string result;
  for (const char c : text) {
    if (c == '{' || c == '}' || c == '$' || c == '.' || is_white(c)) continue;
    result += lowered(c);
  }
  return result;
}

bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// Tuples such as `123`, `(2,3,1)` or `xyz` in the text, each of exactly `count` axes.
std::vector<Axes> tuples_in(const std::string& text, std::size_t count) {
  std::vector<Axes> tuples;
  Axes run;
  const auto finish = [&] {
    if (run.size() == count) tuples.push_back(run);
    run.clear();
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c >= '1' && c <= '3') {
      run.push_back(c - '0');
      if (run.size() == count) finish();
    } else if (count == 3 && text.compare(at, 3, "xyz") == 0) {
      finish();
      tuples.push_back({1, 2, 3});
      at += 2;
    } else if (count == 3 && (text.compare(at, 3, "xzy") == 0)) {
      finish();
      tuples.push_back({1, 3, 2});
      at += 2;
    } else if (c != ',') {
      finish();
    }
  }
  finish();
  return tuples;
}

std::vector<Axes> cyclic(const std::vector<Axes>& tuples) {
  std::vector<Axes> all;
  for (Axes tuple : tuples) {
    for (std::size_t turn = 0; turn < tuple.size(); ++turn) {
      all.push_back(tuple);
      std::rotate(tuple.begin(), tuple.begin() + 1, tuple.end());
    }
  }
  return all;
}

/// The letters before the first `=` or `is`, in the order written; empty if they are not all of `letters`.
std::vector<std::size_t> order_of(const std::string& head, const std::vector<std::string>& letters) {
  std::vector<std::size_t> order;
  for (const char c : head) {
    if (c == ',' || c == '(' || c == ')') continue;
    const auto found = std::ranges::find(letters, std::string(1, c));
    if (found == letters.end()) return {};
    order.push_back(static_cast<std::size_t>(found - letters.begin()));
  }
  std::vector<std::size_t> sorted = order;
  std::ranges::sort(sorted);
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (sorted[k] != k) return {};
  }
  return order.size() == letters.size() ? order : std::vector<std::size_t>{};
}

Axes axes_of(std::size_t position, std::size_t count) {
  Axes axes(count);
  for (std::size_t k = count; k-- > 0; position /= 3) axes[k] = static_cast<int>(position % 3) + 1;
  return axes;
}

template <class Predicate>
std::vector<bool> select(std::size_t count, Predicate predicate) {
  std::size_t all = 1;
  for (std::size_t k = 0; k < count; ++k) all *= 3;
  std::vector<bool> selected(all);
  for (std::size_t position = 0; position < all; ++position)
    selected[position] = predicate(axes_of(position, count));
  return selected;
}

/// "any two indices are equal", "if any index is repeated": whole phrases, since a word before them can turn
/// them round.
bool says_repeated(const std::string& text, const std::vector<std::string>& letters) {
  std::string list;
  for (const std::string& letter : letters) list += letter + ",";
  if (!list.empty()) list.pop_back();
  std::string bare_text = text;
  const auto at = bare_text.find(list);
  if (at != std::string::npos) bare_text.replace(at, list.size(), "indices");
  static constexpr std::array phrases{"anytwoindicesareequal",
                                      "twoindicesareequal",
                                      "anytwoindicesarethesame",
                                      "twoindicesarethesame",
                                      "anytwoofindicesareequal",
                                      "twoofindicesareequal",
                                      "anytwoareequal",
                                      "anyindexisrepeated",
                                      "anindexisrepeated",
                                      "anyindicesareequal",
                                      "anyindicesarerepeated",
                                      "twoormoreindicesareequal",
                                      "twoormoreindicesarethesame",
                                      "anytwooftheindicesareequal",
                                      "twooftheindicesareequal",
                                      "atleasttwoindicesareequal",
                                      "anyofindicesareequal",
                                      "indicesarerepeated",
                                      "therearerepeatedindices"};
  return is_one_of(bare_text, phrases);
}

std::optional<std::vector<bool>> pair_condition(const std::string& text,
                                                const std::vector<std::string>& letters) {
  const auto sign = text.find_first_of("=#");
  if (sign != 1 || text.size() != 3) return std::nullopt;
  const auto place = [&](char c) { return std::ranges::find(letters, std::string(1, c)) - letters.begin(); };
  const auto first = static_cast<std::size_t>(place(text[0]));
  const auto second = static_cast<std::size_t>(place(text[2]));
  if (first >= letters.size() || second >= letters.size()) return std::nullopt;
  const bool equal = text[1] == '=';
  return select(letters.size(), [&](const Axes& axes) { return (axes[first] == axes[second]) == equal; });
}

}  // namespace

std::optional<std::vector<bool>> read_index_condition(const std::string& words,
                                                      const std::vector<std::string>& letters) {
  std::string text = bare(words);
  while (!text.empty() && (text.back() == ',' || text.back() == ';')) text.pop_back();
  const std::size_t count = letters.size();
  if (text.empty() || holds(text, "otherwise") || text == "else" || text == "inallothercases") {
    return select(count, [](const Axes&) { return true; });
  }
  for (const char* opening : {"if", "for", "when", "where"}) {
    if (text.starts_with(opening)) text = text.substr(std::string(opening).size());
  }
  if (auto pair = pair_condition(text, letters)) return pair;
  const bool permutation = holds(text, "permutation") || holds(text, "cyclic");
  if (!permutation && says_repeated(text, letters)) {
    return select(count, [](Axes axes) {
      std::ranges::sort(axes);
      return std::ranges::adjacent_find(axes) != axes.end();
    });
  }
  for (const char* negation :
       {"not", "non", "anti", "unequal", "unless", "except", "all", "distinct", "different"}) {
    if (holds(text, negation) || text.starts_with("no")) return std::nullopt;
  }
  if (holds(text, "#")) return std::nullopt;
  const std::size_t split = std::min(text.find('='), text.find("is"));
  if (split == std::string::npos) return std::nullopt;
  const std::string head = text.substr(0, split);
  std::vector<std::size_t> order = order_of(head, letters);
  if (order.empty() && permutation && (head == "it" || head.empty())) {  // "if it is an odd permutation"
    for (std::size_t k = 0; k < count; ++k) order.push_back(k);
  }
  if (order.empty()) return std::nullopt;
  std::vector<Axes> tuples = tuples_in(text.substr(split), count);
  const bool even = holds(text, "even");
  const bool odd = holds(text, "odd");
  if (even || odd) {
    if (count != 3 || (even && odd) || (tuples.size() > 1) || (!tuples.empty() && tuples[0] != Axes{1, 2, 3}))
      return std::nullopt;
    tuples = cyclic({even ? Axes{1, 2, 3} : Axes{1, 3, 2}});
  } else if (permutation) {
    if (!holds(text, "cyclic")) return std::nullopt;
    tuples = cyclic(tuples);
  }
  if (tuples.empty()) return std::nullopt;
  return select(count, [&](const Axes& axes) {
    Axes written(count);
    for (std::size_t k = 0; k < count; ++k) written[k] = axes[order[k]];
    return is_one_of(written, tuples);
  });
}

}  // namespace rigor
