// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/said_kinds.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "check/word/prose_behind.h"
#include "check/word/words_behind.h"

namespace rigor {
namespace {

using Words = std::vector<std::string_view>;

/// What an adjective says about a letter; nothing for other words.
std::vector<std::string_view> relations_of(std::string_view word) {
  if (word == "positive") return {"$ > 0"};
  if (word == "negative") return {"$ < 0"};
  if (word == "non-negative" || word == "nonnegative") return {"$ \\ge 0"};
  if (word == "non-positive" || word == "nonpositive") return {"$ \\le 0"};
  if (word == "non-zero" || word == "nonzero" || word == "non-vanishing" || word == "nonvanishing")
    return {"$ \\ne 0"};
  if (word == "acute") return {"\\cos $ > 0", "\\sin $ > 0"};
  if (word == "hermitian" || word == "self-adjoint" || word == "selfadjoint") return {self_adjoint};
  if (word == "obtuse") return {"\\cos $ < 0", "\\sin $ > 0"};
  return {};
}

/// Next to the adjective, they do not change what it says.
bool is_filler(std::string_view word) {
  static constexpr std::array<std::string_view, 16> fillers{
      "a",      "an",       "the",  "real", "given", "fixed", "arbitrary", "constant",
      "finite", "strictly", "both", "all",  "some",  "any",   "every",     "two"};
  return is_one_of(word, fillers);
}

/// What a letter can be that is positive or acute.
bool is_noun(std::string_view word) {
  static constexpr std::array<std::string_view, 44> nouns{
      "operator", "operators",   "matrix",       "matrices",  "observable",  "observables", "number",
      "numbers",  "constant",    "constants",    "integer",   "integers",    "real",        "reals",
      "quantity", "quantities",  "value",        "values",    "parameter",   "parameters",  "angle",
      "angles",   "mass",        "masses",       "scalar",    "scalars",     "length",      "lengths",
      "time",     "times",       "charge",       "charges",   "energy",      "energies",    "speed",
      "speeds",   "coefficient", "coefficients", "frequency", "frequencies", "temperature", "pressure",
      "radius",   "volume"};
  return is_one_of(word, nouns);
}

/// About one letter: "positive mass $m$ and $q$" says nothing about q.
bool is_of_one(std::string_view word) {
  static constexpr std::array<std::string_view, 23> singular{
      "operator", "matrix", "observable", "a",      "an",     "number",   "constant",   "integer",
      "quantity", "value",  "parameter",  "angle",  "mass",   "scalar",   "length",     "time",
      "charge",   "energy", "speed",      "radius", "volume", "pressure", "temperature"};
  return is_one_of(word, singular);
}

/// A sentence with one of them may say the opposite, or something else.
bool is_doubtful(std::string_view word) {
  static constexpr std::array<std::string_view, 22> doubts{
      "not",    "no",     "non",     "never",  "nor",       "neither", "either", "or",
      "unless", "except", "whether", "cannot", "without",   "nearly",  "almost", "may",
      "might",  "can",    "could",   "would",  "otherwise", "than"};
  return is_one_of(word, doubts);
}

bool ends(Words words, std::size_t at) {
  static constexpr std::array<std::string_view, 6> ends{"\n", ",", ";", ":", ")", "("};
  return at >= words.size() || is_one_of(words[at], ends);
}

class KindReader {
 public:
  explicit KindReader(const Words& words) : words_(words) {}

  std::vector<SaidKind> read() {
    for (std::size_t at = 0; at < words_.size(); ++at) {
      if (words_[at] == "$") ++maths_;
      if (relations_of(words_[at]).empty()) continue;
      if (!of_those_behind(at)) of_those_before(at);
    }
    return std::move(said_);
  }

 private:
  /// "positive constants $m$, $k$ and $l$": the place after a noun, if one is there.
  [[nodiscard]] std::size_t behind_nouns(std::size_t at) const {
    while (at < words_.size() && (is_filler(words_[at]) || is_noun(words_[at]))) ++at;
    return at;
  }

  bool of_those_behind(std::size_t adjective) {
    std::size_t at = behind_nouns(adjective + 1);
    if (at >= words_.size() || words_[at] != "$") return false;
    const bool noun = is_noun(words_[at - 1]);
    const bool one = (adjective > 0 && is_of_one(words_[adjective - 1])) ||
                     std::any_of(words_.begin() + static_cast<std::ptrdiff_t>(adjective),
                                 words_.begin() + static_cast<std::ptrdiff_t>(at), is_of_one);
    std::size_t count = 0;
    std::size_t last = at;
    while (at < words_.size() && words_[at] == "$") {
      ++count;
      last = at;
      std::size_t next = at + 1;
      while (next < words_.size() && (words_[next] == "," || words_[next] == "and")) ++next;
      at = next > at + 1 && next < words_.size() && words_[next] == "$" && !is_spoken_of(next)
               ? next
               : words_.size();
    }
    // "the positive $x$ axis", "positive $m$, $q$ arbitrary": the last one is said to be something else, and
    // who knows about those between.
    const bool of_the_thing = count == 1 && noun && !is_case(last + 1);
    if ((!stands_free(words_, last) && !of_the_thing) || (count > 1 && one)) {
      if (count == 1) return true;
      count = 1;
    }
    for (std::size_t k = 0; k < count; ++k) say(maths_ + k, adjective);
    return true;
  }

  /// "a positive charge $q$ for protons"; not "a positive charge $q$ at the origin".
  [[nodiscard]] bool is_case(std::size_t at) const {
    static constexpr std::array<std::string_view, 7> cases{"for",   "when", "whenever", "if",
                                                           "while", "to",   "initially"};
    while (at < words_.size() && (words_[at] == "," || is_filler_behind(words_[at]))) ++at;
    return at < words_.size() && is_one_of(words_[at], cases);
  }

  /// "$a > 0$ and $b$ is negative": is there a verb after this one?
  [[nodiscard]] bool is_spoken_of(std::size_t maths) const {
    return maths + 1 < words_.size() && is_verb(words_[maths + 1]);
  }

  static bool is_verb(std::string_view word) { return word == "is" || word == "are" || word == "be"; }

  /// "$m$, $k$ are positive constants", "for $a$ positive,".
  void of_those_before(std::size_t adjective) {
    const std::size_t behind = behind_nouns(adjective + 1);
    const bool goes_on = behind + 1 < words_.size() && words_[behind] == "and" && words_[behind + 1] == "$";
    if ((!ends(words_, behind) || !stands_free(words_, behind - 1)) && !goes_on) return;
    std::size_t at = adjective;
    bool verb = false;
    while (at > 0 && (is_filler(words_[at - 1]) || (is_verb(words_[at - 1]) && !verb))) {
      --at;
      verb = verb || is_verb(words_[at]);
    }
    if (at == 0 || words_[at - 1] != "$") return;
    std::size_t count = 1;
    --at;
    while (at >= 2 && (words_[at - 1] == "," || words_[at - 1] == "and")) {
      std::size_t before = at - 1;
      if (before > 0 && words_[before] == "and" && words_[before - 1] == ",") --before;
      if (before == 0 || words_[before - 1] != "$") break;
      at = before - 1;
      ++count;
    }
    static constexpr std::array<std::string_view, 7> openings{"for",   "with", "where", "let",
                                                              "since", "and",  "here"};
    const bool opened = at > 0 && is_one_of(words_[at - 1], openings);
    if (!verb && !opened) return;
    for (std::size_t k = 1; k <= count && k <= maths_; ++k) say(maths_ - k, adjective);
  }

  void say(std::size_t maths, std::size_t adjective) {
    said_.push_back({maths, relations_of(words_[adjective])});
  }

  const Words& words_;
  std::size_t maths_ = 0;  // that are before the word at hand
  std::vector<SaidKind> said_;
};

}  // namespace

std::vector<SaidKind> said_kinds(std::string_view sentence) {
  const Words words = parts_of_sentence(sentence);
  if (std::ranges::any_of(words, [](auto word) { return is_doubtful(word) || is_doubt(word); })) return {};
  return KindReader(words).read();
}

}  // namespace rigor
