// SPDX-License-Identifier: GPL-3.0-or-later
// What the words say of changes: "a variable mass", "$U$ depends on $T$". Where they do not name a letter,
// any letter of the section may be meant.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

/// Their subject is what changes.
constexpr auto verbs = std::to_array<std::string_view>({"varies",
                                                        "grows",
                                                        "increases",
                                                        "decreases",
                                                        "shrinks",
                                                        "depends on",
                                                        "depends only on",
                                                        "leaves",
                                                        "leave the",
                                                        "loses",
                                                        "accretes",
                                                        "evaporates",
                                                        "leaks",
                                                        "vary",
                                                        "depend on",
                                                        "depend only on",
                                                        "changes with",
                                                        "change with",
                                                        "ejects",
                                                        "drifts",
                                                        "evolves",
                                                        "melts",
                                                        "shortened",
                                                        "lengthened",
                                                        "is a function of",
                                                        "itself a function of",
                                                        "be a function of",
                                                        "be any function of",
                                                        "different at each",
                                                        "different for each"});

/// "We let $A$ and $B$ depend on $x$", "the spring constant is not constant": no letter of a function is
/// held.
constexpr auto words_of_dependence = std::to_array<std::string_view>(
    {"depend on", "depends on", "depend only on", "depends only on", "depending on", "dependent on", "vary",
     "varies", "varying", "function of", "functions of", "not constant", "not really constant", "dependent",
     "proportional", "\\propto"});

/// Of a letter they say that it changes, of a thing mostly that it moves: "so that $T$ rises", "$k$ does not
/// depend on $x$, but $c$ does".
constexpr auto verbs_of_letters = std::to_array<std::string_view>(
    {"rises", "falls", "drops", "changes", "decays", "does", "differs", "is different"});

/// "The density falls with height": with what does it change? "A body falls with constant speed" moves.
constexpr auto verbs_with = std::to_array<std::string_view>({"falls with", "rises with", "drops with"});
constexpr auto manners = std::to_array<std::string_view>(
    {"a", "an", "air", "no", "constant", "uniform", "drag", "friction", "resistance", "velocity", "speed",
     "acceleration", "linear", "quadratic", "viscous", "initial", "terminal", "zero"});

constexpr auto adjectives = std::to_array<std::string_view>(
    {"variable", "varying", "growing", "increasing", "decreasing", "modulated", "inhomogeneous",
     "depending on", "time-dependent", "position-dependent", "nonuniform", "non-uniform", "not constant",
     "not really constant", "time dependent", "dependent on", "function of time"});

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '~'; }

/// The word after a place; none at the end, or where no word is there.
std::string_view word_behind(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  const std::size_t begin = at;
  while (at < text.size() && (is_letter(text[at]) || text[at] == '-')) ++at;
  return text.substr(begin, at - begin);
}

std::string_view without_last(std::string_view text, std::string_view word) {
  return text.ends_with(word) ? text.substr(0, text.size() - word.size()) : text;
}

std::string_view trimmed_behind(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// "the variable $x$", "new variables", "a variable of integration": a name for a letter, as nouns are.
bool is_noun(std::string_view text, std::size_t at, std::size_t behind) {
  static constexpr auto no_things = std::to_array<std::string_view>(
      {"",   "of",   "is", "for",  "by",  "to", "that",  "which", "on",  "it",
       "as", "from", "we", "then", "but", "or", "whose", "can",   "may", "must"});
  const std::string_view before = trimmed_behind(text.substr(0, at));
  for (const std::string_view verb : {" is", " are", " be", " becomes", " not"}) {
    if (before.ends_with(verb)) return false;  // "the mass is variable"
  }
  return (behind < text.size() && is_letter(text[behind])) || is_one_of(word_behind(text, behind), no_things);
}

/// "does not depend on", "is not variable", "nor varies".
bool is_denied(std::string_view before) {
  before = trimmed_behind(before);
  return before.ends_with(" not") || before.ends_with(" never") || before.ends_with(" nor") ||
         before.ends_with(" neither") || before.ends_with(" cannot");
}

/// The letter of "$U$ depends on"; nothing where no mathematics stands there.
std::optional<std::string> subject(std::string_view before) {
  for (const std::string_view filler : {" also", " only", " then", " still", " thus", " itself"})
    before = without_last(trimmed_behind(before), filler);
  before = trimmed_behind(before);
  std::string_view open = "$";
  if (before.ends_with("\\)")) {
    open = "\\(";
    before.remove_suffix(2);
  } else if (before.ends_with('$')) {
    before.remove_suffix(1);
  } else {
    return std::nullopt;
  }
  const std::size_t begin = before.rfind(open);
  if (begin == std::string_view::npos) return std::nullopt;
  std::string_view maths = before.substr(begin + open.size());
  while (!maths.empty() && is_blank(maths.front())) maths.remove_prefix(1);
  std::size_t end = maths.starts_with('\\') ? 1 : 0;
  while (end < maths.size() && is_letter(maths[end]) && (maths[0] == '\\' || end == 0)) ++end;
  const std::string letter(maths.substr(0, end));
  const std::string_view rest = maths.substr(end);
  // "$m$ and $k$ vary", "both $m$, $v$ depend on": of all of them.
  const std::string_view beside = trimmed_behind(before.substr(0, begin));
  if (beside.ends_with(" and") || beside.ends_with(" or") || beside.ends_with(',')) return std::nullopt;
  const bool alone = rest.empty() || rest.starts_with('(') || rest.starts_with('_');
  return alone && !letter.empty() && letter != "\\" ? std::optional(letter) : std::nullopt;
}

template <class Visit>
void for_each_place(std::string_view text, std::string_view word, const Visit& visit) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
    visit(at);
}

}  // namespace

void see_said_changes(std::string_view text, Evidence& evidence) {
  evidence.d_is_a_letter = evidence.d_is_a_letter || text.find("$d$") != std::string_view::npos ||
                           text.find("\\(d\\)") != std::string_view::npos;
  const std::string small = lowered(text);
  for (const std::string_view adjective : adjectives) {
    for_each_place(small, adjective, [&](std::size_t at) {
      const bool noun = adjective == "variable" && is_noun(small, at, at + adjective.size());
      if (!noun && !is_denied(std::string_view(small).substr(0, at))) evidence.speaks_of_change = true;
    });
  }
  for (const std::string_view verb : verbs_of_letters) {
    for_each_place(small, verb, [&](std::size_t at) {
      const std::size_t behind = at + verb.size();
      const bool whole = behind >= small.size() || !is_letter(small[behind]);
      const auto letter =
          whole && word_behind(small, behind) != "not" ? subject(text.substr(0, at)) : std::nullopt;
      if (letter) evidence.said_to_change.insert(*letter);
    });
  }
  const auto says_a_change_at = [&](std::size_t at) {
    const std::string_view before = text.substr(0, at);  // letters are capital or not
    if (is_denied(before)) return;
    if (const auto letter = subject(before)) {
      evidence.said_to_change.insert(*letter);
    } else {
      evidence.speaks_of_change = true;
    }
  };
  for (const std::string_view verb : verbs) for_each_place(small, verb, says_a_change_at);
  for (const std::string_view word : {"conserved", "conservation", "constant", "fixed", "given"}) {
    for_each_place(small, word, [&](std::size_t at) {
      if (!is_denied(std::string_view(small).substr(0, at))) evidence.speaks_of_conservation = true;
    });
  }
  for (const std::string_view word : {"negative", "opposite", "opposed", "backwards", "downwards"}) {
    for_each_place(small, word, [&](std::size_t at) {
      const std::string_view before = std::string_view(small).substr(0, at);
      const bool denied = before.ends_with("not ") || before.ends_with("never ") || before.ends_with("non");
      evidence.speaks_of_signs = evidence.speaks_of_signs || !denied;
    });
  }
  for (const std::string_view word : words_of_dependence) {
    for_each_place(small, word, [&](std::size_t at) {
      const std::string_view before = std::string_view(text).substr(0, at);
      if (!is_denied(before) && !subject(before)) evidence.speaks_of_dependence = true;
    });
  }
  for (const std::string_view verb : verbs_with) {
    for_each_place(small, verb, [&](std::size_t at) {
      if (!is_one_of(word_behind(small, at + verb.size()), manners)) says_a_change_at(at);
    });
  }
}

}  // namespace rigor
