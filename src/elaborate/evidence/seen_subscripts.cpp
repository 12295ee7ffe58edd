// SPDX-License-Identifier: GPL-3.0-or-later
// Letters that count the members of a sequence in a subscript: n of `x_{n+1}`, of `E_n = n^2E_1` and of "for
// $n = 1, 2, \dots$"; and s of `\sum_s p_s\ln p_s`, which names what is summed over.
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

[[nodiscard]] bool is_latin_letter(const WrittenIndex& index) {
  return index.form == IndexForm::letter && index.primes == 0 && index.text.size() == 1;
}

/// `\exp`, `\ln`, `\sin`: of a component of a vector nobody takes one.
[[nodiscard]] bool is_function_of_numbers(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::function &&
         is_one_of(syntax.text(id), {"exp", "ln", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh"});
}

/// The letters in the subscripts of one side: those that a sum binds are all right, those that are free are
/// collected. Recursion: as deep as the tree.
class LettersBelow {
 public:
  LettersBelow(const SyntaxTree& syntax, SummedMembers& members) : syntax_(syntax), members_(members) {}

  void look(SyntaxId id, bool in_function) {
    switch (syntax_[id].kind) {
      case SyntaxKind::symbol:
        return look_at(syntax_.symbol(id), in_function);
      case SyntaxKind::component:
        for (const WrittenIndex& index : syntax_.indices(id)) members_.otherwise.insert(index.text);
        break;
      case SyntaxKind::derivative:
        for (const WrittenVariable& by : syntax_.derivative(id).by) look_at(by.symbol, in_function);
        break;
      case SyntaxKind::big_sum: {
        const WrittenSum& sum = syntax_.big_sum(id);
        const bool plain = sum.from.empty() && sum.to.empty();
        for (const WrittenIndex& index : sum.indices)
          (plain && is_latin_letter(index) ? members_.summed : members_.otherwise).insert(index.text);
        const std::vector<WrittenIndex> before = bound_;
        bound_.insert(bound_.end(), sum.indices.begin(), sum.indices.end());
        for (const SyntaxChild& child : syntax_.children(id)) look(child.id, in_function);
        bound_ = before;
        return;
      }
      case SyntaxKind::power:
        look(syntax_.child(id, 0), in_function);
        return look(syntax_.child(id, 1), true);
      default:
        break;
    }
    const bool inside = in_function || is_function_of_numbers(syntax_, id);
    for (const SyntaxChild& child : syntax_.children(id)) look(child.id, inside);
  }

  [[nodiscard]] const std::set<std::string>& free() const { return free_; }

 private:
  void look_at(const WrittenSymbol& symbol, bool in_function) {
    if (symbol.face != Face::plain) members_.vectors.insert(symbol.letter);
    if (symbol.lower.empty()) {
      members_.otherwise.insert(symbol.letter);
      return;
    }
    const bool alone = symbol.lower.size() == 1 && symbol.face == Face::plain;
    for (const WrittenIndex& index : symbol.lower) {
      if (!is_latin_letter(index)) {
        for (const std::string& each : counters_in(index)) members_.otherwise.insert(each);
        continue;
      }
      if (!alone) members_.otherwise.insert(index.text);
      members_.on[index.text].insert(symbol.letter);
      if (alone && in_function) members_.in_functions.insert(index.text);
      const bool bound =
          std::ranges::any_of(bound_, [&](const WrittenIndex& each) { return each.text == index.text; });
      if (!bound) free_.insert(index.text);
    }
  }

  const SyntaxTree& syntax_;
  SummedMembers& members_;
  std::vector<WrittenIndex> bound_;
  std::set<std::string> free_;
};

}  // namespace

bool SummedMembers::has(const std::string& letter) const {
  if (!in_functions.contains(letter) || !summed.contains(letter) || otherwise.contains(letter)) return false;
  const auto carriers = on.find(letter);
  return carriers != on.end() && std::ranges::none_of(carriers->second, [&](const std::string& each) {
           return vectors.contains(each);
         });
}

void see_summed_members(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides,
                        SummedMembers& members) {
  std::vector<std::set<std::string>> free;
  for (const SyntaxId side : sides) {
    LettersBelow letters(syntax, members);
    letters.look(side, false);
    free.push_back(letters.free());
  }
  // i of `Q = T_i\Delta S` is a label, s of `p_s = 1/\Omega` is none.
  const bool says_of_each = !sides.empty() && syntax[sides[0]].kind == SyntaxKind::symbol;
  for (std::size_t k = says_of_each ? 1 : 0; k < free.size(); ++k) {
    for (const std::string& letter : free[k]) {
      if (std::ranges::any_of(free, [&](const auto& other) { return !other.contains(letter); }))
        members.otherwise.insert(letter);
    }
  }
}

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
