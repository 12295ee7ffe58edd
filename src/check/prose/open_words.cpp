// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/open_words.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "base/ascii.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// Sorted. Words of argument and of mathematics in general, none names a case.
constexpr std::array<std::string_view, 184> neutral{
    "a",           "above",      "add",      "adding",    "again",      "algebra",    "all",
    "also",        "an",         "and",      "another",   "any",        "are",        "arrive",
    "as",          "at",         "be",       "because",   "becomes",    "been",       "below",
    "both",        "bracket",    "brackets", "but",       "by",         "calculate",  "calculation",
    "can",         "check",      "claim",    "component", "components", "compute",    "consider",
    "could",       "definition", "derive",   "derived",   "did",        "do",         "does",
    "dot",         "each",       "easily",   "easy",      "equal",      "equals",     "equation",
    "equations",   "equivalent", "every",    "exercise",  "expand",     "expanding",  "expression",
    "expressions", "factor",     "finally",  "find",      "first",      "follow",     "following",
    "follows",     "for",        "form",     "formula",   "formulas",   "found",      "fourth",
    "from",        "get",        "give",     "given",     "gives",      "hand",       "has",
    "have",        "hence",      "here",     "hold",      "holds",      "identities", "identity",
    "implies",     "in",         "indeed",   "insert",    "into",       "is",         "it",
    "its",         "know",       "known",    "later",     "lead",       "leads",      "left",
    "lemma",       "let",        "line",     "may",       "means",      "multiply",   "multiplying",
    "must",        "namely",     "need",     "next",      "note",       "notice",     "now",
    "number",      "numbers",    "obtain",   "obtained",  "of",         "on",         "one",
    "or",          "our",        "out",      "product",   "products",   "proof",      "prove",
    "reads",       "recall",     "relation", "relations", "remember",   "result",     "results",
    "right",       "rule",       "same",     "scalar",    "scalars",    "second",     "see",
    "show",        "shown",      "shows",    "side",      "sides",      "since",      "so",
    "some",        "square",     "squares",  "step",      "sum",        "tensor",     "term",
    "terms",       "that",       "the",      "then",      "there",      "therefore",  "these",
    "third",       "this",       "three",    "thus",      "to",         "two",        "us",
    "use",         "using",      "vector",   "vectors",   "verify",     "way",        "ways",
    "we",          "where",      "which",    "with",      "write",      "written",    "yield",
    "yields",      "you"};
static_assert(std::ranges::is_sorted(neutral));

/// Of several, one that names no quantity: "the force" says less than "slowly".
std::optional<std::string> open_word_in(std::string_view text) {
  std::optional<std::string> quantity;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_small_letter(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    at = std::max(end, at + 1);
    if (word.size() < 2 || std::ranges::binary_search(neutral, word)) continue;
    if (!is_quantity(word)) return std::string(word);
    if (!quantity) quantity = word;
  }
  return quantity;
}

std::optional<std::string> dropping_word_in(std::string_view text) {
  static constexpr std::array<std::string_view, 18> stems{
      "averag",      "incoherent",  "random",   "uncorrelated", "independent", "cancel",
      "cross",       "drop",        "fluctuat", "washes",       "mean",        "integrates",
      "statistical", "expectation", "noise",    "interference", "oscillat",    "ensemble"};
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_small_letter(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    const bool drops = word != "means" && word != "meaning" &&
                       std::ranges::any_of(stems, [&](auto stem) { return word.starts_with(stem); });
    if (drops && (word != "cross" || text.substr(end).starts_with(" term"))) return std::string(word);
    at = std::max(end, at + 1);
  }
  return std::nullopt;
}

/// The last one before the display, in its section; behind "hence" the one before its premise.
const ProseSentence* sentence_above(const Prose& prose, const ProseBeside& beside) {
  const auto end = std::ranges::lower_bound(prose.sentences, beside.sentence, {}, &ProseSentence::number);
  const bool concludes = says_that_it_follows(beside.lead);
  for (auto at = end; at != prose.sentences.begin() && std::prev(at)->place == beside.place; --at) {
    const ProseSentence& sentence = *std::prev(at);
    const bool premise = sentence.has_display && concludes && says_that_it_follows(sentence.text);
    if (!premise) return &sentence;
  }
  return nullptr;
}

}  // namespace

std::optional<std::string> word_of_dropped_terms(const Prose& prose, std::size_t event) {
  const ProseBeside& beside = prose.beside[event];
  if (auto word = dropping_word_in(beside.lead)) return word;
  if (auto word = dropping_word_in(beside.tail)) return word;
  const ProseSentence* above = sentence_above(prose, beside);
  return above == nullptr ? std::nullopt : dropping_word_in(above->text);
}

std::optional<std::string> open_word(const Prose& prose, std::size_t event) {
  const ProseBeside& beside = prose.beside[event];
  if (auto word = open_word_in(beside.lead)) return word;
  if (auto word = open_word_in(beside.tail)) return word;
  const ProseSentence* above = sentence_above(prose, beside);
  return above == nullptr ? std::nullopt : open_word_in(above->text);
}

}  // namespace rigor
