// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that count the members of a sequence in a subscript: n of `x_{n+1}`, of `E_n = n^2E_1` and of "for
// $n = 1, 2, \dots$".
#include <algorithm>
#include <array>
#include <charconv>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

constexpr std::size_t near_words = 40;  // bytes: "where $n$ is a positive integer"

constexpr auto whole_words = std::to_array<std::string_view>(
    {"integer", "quantum number", "natural number", "whole number", "-th ", "th level", "th mode", "th term",
     "th harmonic", "th state", "th excited"});
constexpr auto words_of_levels = std::to_array<std::string_view>(
    {"levels", "quantum", "eigen", "harmonics", "harmonic oscillator", "standing wave", "normal mode",
     " modes", "ground state", "excited", "overtone", "orbits", "square well", "infinite well",
     "bound states", "sequence", "iterat", "recursion"});
constexpr auto words_of_members =
    std::to_array<std::string_view>({"ground", "level", "state", "lowest", "excited", "fundamental", "mode",
                                     "harmonic", "overtone", "between", "transition"});

[[nodiscard]] std::string_view behind_spacing(std::string_view text) {
  for (;;) {
    const std::size_t before = text.size();
    for (const std::string_view each :
         {" ", "\n", "~", "&", "{", "\\,", "\\;", "\\:", "\\ ", "\\!", "\\quad"}) {
      if (text.starts_with(each)) text.remove_prefix(each.size());
    }
    if (text.size() == before) return text;
  }
}

[[nodiscard]] bool takes(std::string_view& text, std::string_view word) {
  const std::string_view from = behind_spacing(text);
  if (!from.starts_with(word)) return false;
  text = from.substr(word.size());
  return true;
}

[[nodiscard]] std::optional<int> taken_number(std::string_view& text) {
  const std::string_view from = behind_spacing(text);
  int value = 0;
  const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text = from.substr(static_cast<std::size_t>(end - from.data()));
  return value;
}

[[nodiscard]] bool holds_any(std::string_view text, std::span<const std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != text.npos; });
}

void begin_with(CountingLetter& counting, int first) {
  counting.said = true;
  counting.first = std::max(counting.first.value_or(first), first);
}

/// `= 1, 2, \dots`, `\geq 1`, `\in\mathbb N` behind the letter.
void see_range(std::string_view behind, CountingLetter& counting) {
  if (takes(behind, "=")) {
    const auto first = taken_number(behind);
    if (!first) return;
    if (behind.size() > 1 && behind[0] == '.' && is_digit(behind[1])) counting.some_only = true;
    const bool more = takes(behind, ",");
    if (more && takes(behind, "\\pm")) counting.said = true;
    static_cast<void>(takes(behind, "\\"));
    if (takes(behind, "ldots") || takes(behind, "dots") || takes(behind, "...") || takes(behind, "cdots"))
      return begin_with(counting, *first);
    const auto second = more ? taken_number(behind) : std::nullopt;
    if (second && *second == *first + 1) return begin_with(counting, *first);
    counting.some_only = counting.some_only || second.has_value();
    return;
  }
  const bool at_least = takes(behind, "\\geqslant") || takes(behind, "\\geq") || takes(behind, "\\ge");
  if (at_least || takes(behind, ">")) {
    if (const auto first = taken_number(behind)) begin_with(counting, *first + (at_least ? 0 : 1));
    return;
  }
  if (!takes(behind, "\\in")) return;
  if (takes(behind, "\\{")) {
    if (const auto first = taken_number(behind)) begin_with(counting, *first);
    return;
  }
  static_cast<void>(takes(behind, "\\mathbb"));
  static_cast<void>(takes(behind, "\\mathbf"));
  if (takes(behind, "N") || takes(behind, "\\N")) begin_with(counting, 1);
  if (takes(behind, "Z") || takes(behind, "\\Z")) counting.said = true;
}

/// "for odd $n$", "a positive integer $n$": words around the letter.
void see_words_of_counting(std::string_view around, CountingLetter& counting) {
  const std::string words = lowered_line(around);
  if (words.find("odd") != words.npos || words.find("even ") != words.npos ||
      words.find("even}") != words.npos || words.find("multiple") != words.npos)
    counting.some_only = true;
  if (!holds_any(words, whole_words)) return;
  counting.said = true;
  const bool from_0 = words.find("negative") != words.npos;
  if (from_0 || words.find("positive") != words.npos) begin_with(counting, from_0 ? 0 : 1);
}

/// `$E_0$` of "the rest energy $E_0$", "two bodies with $E_1$ and $E_2$": not what the words call a level or
/// a state.
void see_quantity_apart(std::string_view text, std::size_t bar, Evidence& evidence) {
  std::size_t end = bar + 1;
  const bool braced = end < text.size() && text[end] == '{';
  end += braced ? 1 : 0;
  if (end >= text.size() || !is_digit(text[end])) return;
  const char digit = text[end++];
  if (braced && (end >= text.size() || text[end++] != '}')) return;
  std::size_t begin = bar;
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  if (begin > 0 && begin < bar && text[begin - 1] == '\\') --begin;
  const bool opens = begin > 0 && (text[begin - 1] == '$' || text.substr(0, begin).ends_with("\\("));
  const bool closes = end < text.size() && (text[end] == '$' || text.substr(end).starts_with("\\)"));
  const std::string name = std::string(text.substr(begin, bar - begin)) + "_{" + digit + "}";
  const bool has_value = opens && behind_spacing(text.substr(end)).starts_with('=');
  if (has_value) evidence.quantities_apart.insert(name);
  if (begin == bar || !opens || !closes) return;
  std::string_view before = text.substr(begin - std::min(begin, near_words), std::min(begin, near_words));
  std::string_view behind = text.substr(end, near_words);
  if (const auto stop = before.find_last_of(".;:"); stop != before.npos) before = before.substr(stop);
  behind = behind.substr(0, behind.find_first_of(".;:"));
  const std::string words = lowered_line(before) + " " + lowered_line(behind);
  if (holds_any(words, words_of_members)) return;  // "the ground state has $E_1$"
  evidence.quantities_apart.insert(name);
}

}  // namespace

bool may_count_members(std::string_view letter) {
  static constexpr std::array<std::string_view, 8> letters{"j", "k", "l", "m", "n", "N", "M", "\\ell"};
  return is_one_of(letter, letters);
}

std::vector<std::string> counters_in(const WrittenIndex& index) {
  std::vector<std::string> letters;
  if (index.form != IndexForm::word) return letters;
  if (index.text.find_first_of("+-/") == std::string::npos) return letters;
  for (std::size_t at = 0; at < index.text.size(); ++at) {
    if (index.text[at] == '\\') {
      while (at + 1 < index.text.size() && is_letter(index.text[at + 1])) ++at;
    } else if (is_letter(index.text[at])) {
      letters.emplace_back(1, index.text[at]);
    }
  }
  return letters;
}

void see_subscripts(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    for (const WrittenIndex& index : syntax.symbol(id).lower) {
      const std::vector<std::string> letters = counters_in(index);
      evidence.counters.insert(letters.begin(), letters.end());
      if (letters.size() == 1) evidence.counting[letters[0]].said = true;
    }
  }
}

void see_families(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  if (sides.size() < 2 || syntax[sides[0]].kind != SyntaxKind::symbol) return;
  const WrittenSymbol& left = syntax.symbol(sides[0]);
  if (left.lower.size() != 1 || left.face != Face::plain || left.lower[0].primes > 0) return;
  const std::string& letter = left.lower[0].text;
  if (!is_one_of(letter, {"l", "m", "n"})) return;
  const bool counts = std::ranges::any_of(nodes_below(syntax, sides), [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return false;
    const WrittenSymbol& symbol = syntax.symbol(id);
    return symbol.letter == letter && symbol.lower.empty() && symbol.face == Face::plain &&
           symbol.accent == Accent::none && symbol.primes == 0 && symbol.dots == 0;
  });
  // A counter above a letter may be no power: n of `2^n` stays as it is read without this row.
  const bool above = std::ranges::any_of(nodes_below(syntax, sides), [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::power) return false;
    return std::ranges::any_of(nodes_below(syntax, {syntax.child(id, 1)}), [&](SyntaxId each) {
      return syntax[each].kind == SyntaxKind::symbol && syntax.symbol(each).letter == letter;
    });
  });
  if (counts && !above) evidence.counters.insert(letter);
}

void see_counting(std::string_view text, bool prose, Evidence& evidence) {
  if (!evidence.speaks_of_levels) evidence.speaks_of_levels = holds_any(lowered_line(text), words_of_levels);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (prose && text[at] == '_') see_quantity_apart(text, at, evidence);
    if (!is_letter(text[at]) || (at > 0 && is_letter(text[at - 1]))) continue;
    std::size_t end = at + 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    const bool control = at > 0 && text[at - 1] == '\\';
    const std::string letter(text.substr(control ? at - 1 : at, end - at + (control ? 1 : 0)));
    if (!may_count_members(letter)) continue;
    std::string_view behind = text.substr(end);
    if (behind.starts_with('_')) {
      behind = behind.substr(behind.starts_with("_{") ? 2 : 1);
      if (!behind.empty() && is_digit(behind[0])) evidence.numbered.insert(letter);
      continue;
    }
    if (at > 0 && (text[at - 1] == '_' || text[at - 1] == '^')) continue;
    see_range(behind, evidence.counting[letter]);
    const std::size_t begin = at - std::min(at, near_words);
    see_words_of_counting(text.substr(begin, end + near_words - begin), evidence.counting[letter]);
  }
}

}  // namespace rigor
