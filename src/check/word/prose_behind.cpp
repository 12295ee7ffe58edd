// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/prose_behind.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/words_behind.h"

namespace rigor {

using Parts = std::vector<std::string_view>;

Parts parts_of_sentence(std::string_view sentence) {
  Parts parts;
  const auto in_word = [](char c) { return is_letter_or_digit(c) || c == '-' || c == '\''; };
  for (std::size_t at = 0; at < sentence.size();) {
    std::size_t end = at;
    while (end < sentence.size() && in_word(sentence[end])) ++end;
    if (end == at) ++end;
    if (sentence[at] != ' ') parts.push_back(sentence.substr(at, end - at));
    at = end;
  }
  return parts;
}

namespace {

bool is_punctuation(std::string_view part) { return part == "," || part == ";" || part == ":"; }
bool is_number(std::string_view part) { return !part.empty() && is_digit(part[0]); }

/// The letters of indices, `i` to `n` and Greek ones, in `text`.
std::vector<std::string> index_letters(std::string_view text) {
  std::vector<std::string> letters;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\') {
      std::size_t end = at + 1;
      while (end < text.size() && is_letter(text[end])) ++end;
      letters.emplace_back(text.substr(at, end - at));
      at = std::max(end, at + 2) - 1;
    } else if (is_letter(text[at])) {
      letters.emplace_back(text.substr(at, 1));
    }
  }
  return letters;
}

/// What is in the subscripts.
std::string subscripts_of(std::string_view text) {
  std::string all;
  for (std::size_t at = text.find('_'); at != std::string_view::npos; at = text.find('_', at + 1)) {
    std::size_t begin = at + 1;
    while (begin < text.size() && text[begin] == ' ') ++begin;
    if (begin >= text.size()) break;
    std::size_t end = begin + 1;
    if (text[begin] == '{') {
      end = std::min(text.find('}', begin), text.size());
    } else if (text[begin] == '\\') {
      while (end < text.size() && is_letter(text[end])) ++end;
    }
    all += text.substr(begin, end - begin);
    all += ' ';
  }
  return all;
}

/// `i \ne j`, `\alpha = 1` next to `A_{ij} = 0`, `q_\alpha = q`.
bool speaks_of_indices(std::string_view condition, std::string_view relation) {
  const std::vector<std::string> there = index_letters(subscripts_of(relation));
  if (there.empty() || condition.find('_') != std::string_view::npos) return false;
  return std::ranges::any_of(index_letters(condition),
                             [&](const std::string& letter) { return is_one_of(letter, there); });
}

/// `k > 0`: "where $k > 0$ is the stiffness" gives no name to a value.
bool is_order(std::string_view text) {
  if (text.find('=') != std::string_view::npos) return false;
  if (text.find_first_of("<>") != std::string_view::npos) return true;
  for (const std::string_view sign : {"\\le", "\\ge", "\\ne"}) {
    for (std::size_t at = text.find(sign); at != std::string_view::npos; at = text.find(sign, at + 1)) {
      const std::string_view behind = text.substr(at + sign.size());
      if (behind.empty() || behind[0] == 'q' || !is_letter(behind[0])) return true;
    }
  }
  return false;
}

/// Reads on after one `$` of a sentence.
class Behind {
 public:
  explicit Behind(const Parts& parts) : parts_(parts) {}

  enum class Found { free, restricted, list, named };  // list: another piece of mathematics is said with it

  Found read(std::size_t at) {
    at_ = at + 1;
    for (;;) {
      while (is_filler_behind(here())) ++at_;
      if (ends()) return Found::free;
      if (is_punctuation(here())) return behind_comma();
      if (here() == ")") {
        ++at_;
        continue;
      }
      if (here() == "(") {
        if (!pass_over_bracket()) return Found::restricted;
        continue;
      }
      if (here() == "and") return behind_and();
      if (here() == "$") return Found::list;
      if (pass_over_place_in_text() || pass_over_remark()) continue;
      if (is_named()) return Found::named;
      return main_clause() ? Found::free : Found::restricted;
    }
  }

  /// Where it ended; of a list, at the next `$`.
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  [[nodiscard]] std::string_view part(std::size_t at) const {
    return at < parts_.size() ? parts_[at] : std::string_view("\n");
  }
  [[nodiscard]] std::string_view here() const { return part(at_); }
  [[nodiscard]] bool ends() const { return here() == "\n"; }

  Found behind_comma() {
    while (is_punctuation(here()) || here() == "and" || is_filler_behind(here())) ++at_;
    if (here() == "$") return Found::list;
    if (here() == "for") return is_remark_of_all() ? Found::free : Found::restricted;
    if (here() == "in") return is_remark_in() ? Found::free : Found::restricted;
    return restricts_behind_comma(here()) ? Found::restricted : Found::free;
  }

  Found behind_and() {
    while (here() == "and" || is_filler_behind(here())) ++at_;
    static constexpr std::array<std::string_view, 8> cues{"with", "for",   "if",      "where",
                                                          "when", "since", "because", "setting"};
    if (is_one_of(here(), cues) && part(at_ + 1) == "$") ++at_;
    if (here() == "$") return Found::list;
    return restricts_behind_comma(here()) ? Found::restricted : Found::free;
  }

  /// "for all $x$", "for simplicity".
  [[nodiscard]] bool is_remark_of_all() const {
    static constexpr std::array<std::string_view, 9> remarks{
        "all", "any", "every", "each", "example", "instance", "simplicity", "convenience", "brevity"};
    return is_one_of(part(at_ + 1), remarks);
  }

  /// "in terms of", "in general".
  [[nodiscard]] bool is_remark_in() const {
    static constexpr std::array<std::string_view, 7> remarks{"terms", "general",    "fact", "short",
                                                             "other", "particular", "turn"};
    return is_one_of(part(at_ + 1), remarks);
  }

  /// "(1)", "(see above)"; not "(in air)".
  bool pass_over_bracket() {
    static constexpr std::array<std::string_view, 6> remarks{"see", "eq", "eqs", "cf", "why", "by"};
    const std::string_view first = part(at_ + 1);
    if (first == "$") {
      ++at_;
      return false;
    }
    if (!is_number(first) && !is_one_of(first, remarks)) return false;
    while (!ends() && here() != ")") ++at_;
    return true;
  }

  /// "in (3)", "into this equation", "by assumption", "from (2)".
  bool pass_over_place_in_text() {
    static constexpr std::array<std::string_view, 4> prepositions{"in", "into", "by", "from"};
    static constexpr std::array<std::string_view, 6> grounds{"assumption", "definition",   "hypothesis",
                                                             "symmetry",   "construction", "eq"};
    if (!is_one_of(here(), prepositions)) return false;
    std::size_t next = at_ + 1;
    if (here() == "by" && is_one_of(part(next), grounds)) {
      at_ = next + 1;
      return true;
    }
    while (points_into_text(part(next))) ++next;
    const bool number = part(next) == "(" && is_number(part(next + 1)) && part(next + 2) == ")";
    const bool named = is_place_in_text(part(next));
    if (!number && !named) return false;
    at_ = number ? next + 3 : next + 1;
    return true;
  }

  /// "for all times", "at all times", "for all $t$", "for simplicity".
  bool pass_over_remark() {
    static constexpr std::array<std::string_view, 5> reasons{"simplicity", "convenience", "brevity",
                                                             "example", "instance"};
    if (here() == "for" && is_one_of(part(at_ + 1), reasons)) {
      at_ += 2;
      return true;
    }
    if ((here() != "for" && here() != "at") || part(at_ + 1) != "all") return false;
    static constexpr std::array<std::string_view, 5> nouns{"times", "time", "$", "points", "places"};
    if (!is_one_of(part(at_ + 2), nouns) || part(at_ + 3) == "but") return false;
    at_ += 3;
    return true;
  }

  /// "is the frequency", "denotes the reduced mass of the pair", "is conserved"; not "is the wall", "is the
  /// speed at the top".
  [[nodiscard]] bool is_named() const {
    static constexpr std::array<std::string_view, 8> naming{"is",    "are",   "be",      "denotes",
                                                            "being", "means", "remains", "stays"};
    static constexpr std::array<std::string_view, 3> kept{"conserved", "constant", "fixed"};
    if (!is_one_of(here(), naming)) return false;
    bool named = false;
    bool behind_of = false;
    for (std::size_t k = at_ + 1; k < parts_.size(); ++k) {
      const std::string_view word = parts_[k];
      if (word == "\n" || word == ")" || is_punctuation(word)) break;
      if (!behind_of && (word == "of" || word == "and")) {
        behind_of = true;
      } else if (restricts_behind_comma(word) || word == "for" || word == "in") {
        return false;
      } else if (!behind_of) {
        named = is_named_quantity(word) || is_one_of(word, kept);
      }
    }
    return named;
  }

  [[nodiscard]] bool main_clause() const {
    if (opens_main_clause(here()) || is_consequence(here())) return true;
    // "A boost with $\beta = v/c$ has"
    static constexpr std::array<std::string_view, 9> of_a_subject{
        "has", "have", "reads", "becomes", "become", "takes", "satisfies", "satisfy", "obeys"};
    if (is_one_of(here(), of_a_subject)) return true;
    if (here() == "which") return is_consequence(part(at_ + 1));
    if (!opens_noun_phrase(here())) return false;
    for (std::size_t k = at_ + 1; k < parts_.size(); ++k) {
      if (parts_[k] == "\n" || is_punctuation(parts_[k])) return false;
      if (is_main_verb(parts_[k])) return true;
    }
    return false;
  }

  const Parts& parts_;
  std::size_t at_ = 0;
};

class Restrictions {
 public:
  Restrictions(std::string_view sentence, const std::vector<MathsInLine>& maths)
      : parts_(parts_of_sentence(sentence)), maths_(maths), said_of_(maths.size(), SaidOf::the_row) {
    for (std::size_t at = 0; at < parts_.size(); ++at) {
      if (parts_[at] == "$" && places_.size() < maths.size()) places_.push_back(at);
    }
  }

  std::vector<SaidOf> read() {
    for (std::size_t k = places_.size(); k-- > 0;) {
      if (maths_[k].relates) read(k);
    }
    restrict_doubted();
    return std::move(said_of_);
  }

 private:
  void read(std::size_t k) {
    const std::size_t place = places_[k];
    if (is_bounded_from_before(k)) said_of_[k] = SaidOf::something;
    Behind behind(parts_);
    const Behind::Found found = behind.read(place);
    if (found == Behind::Found::free) return;
    if (found == Behind::Found::named) {
      if (!is_order(maths_[k].text)) said_of_[k] = std::max(said_of_[k], SaidOf::a_name);
      return;
    }
    const std::size_t next = maths_from(behind.at());
    const bool is_next = next < places_.size() && maths_[next].relates;
    if (found == Behind::Found::list) {
      // "$x = a$ and $x = -a$ are the walls"
      if (is_next) said_of_[k] = std::max(said_of_[k], said_of_[next]);
      if (is_next && speaks_of_indices(maths_[next].text, maths_[k].text)) said_of_[k] = SaidOf::something;
      return;
    }
    said_of_[k] = SaidOf::something;
    // "$v = 0$ at $t = 0$": neither of them restricts what follows.
    if (is_next && !has_sign_between(place, places_[next])) said_of_[next] = SaidOf::something;
  }

  [[nodiscard]] std::size_t maths_from(std::size_t at) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(places_, at) - places_.begin());
  }

  [[nodiscard]] bool has_sign_between(std::size_t begin, std::size_t end) const {
    return std::any_of(parts_.begin() + static_cast<std::ptrdiff_t>(begin),
                       parts_.begin() + static_cast<std::ptrdiff_t>(end),
                       [](std::string_view part) { return is_punctuation(part) || part == "\n"; });
  }

  /// "to introduce $u = 1/r$"
  static bool brings_in(std::string_view verb) {
    static constexpr std::array<std::string_view, 6> verbs{"introduce", "define", "set",
                                                           "put",       "write",  "abbreviate"};
    return is_one_of(verb, verbs);
  }

  /// "from $x = 0$", "starting at $t = 0$", "since $t = 0$".
  [[nodiscard]] bool is_bounded_from_before(std::size_t k) const {
    const std::size_t place = places_[k];
    if (place > 0 && restricts_from_before(parts_[place - 1])) return true;
    const bool is_purpose = place > 1 && parts_[place - 2] == "to" && brings_in(parts_[place - 1]);
    if (place > 1 && restricts_from_before(parts_[place - 2]) && !is_purpose) return true;
    const std::string& text = maths_[k].text;
    const std::size_t first = text.find_first_not_of(' ');
    const bool time = first != std::string::npos && text[first] == 't' &&
                      text.find_first_not_of(' ', first + 1) == text.find('=');
    return time && place > 0 && parts_[place - 1] == "since";
  }

  /// From each display to the next.
  void restrict_doubted() {
    for (std::size_t k = 0; k < places_.size(); ++k) {
      std::size_t begin = places_[k];
      while (begin > 0 && parts_[begin - 1] != "\n") --begin;
      if (maths_[k].relates && has_doubt(parts_, begin)) said_of_[k] = SaidOf::something;
    }
  }

  Parts parts_;
  const std::vector<MathsInLine>& maths_;
  std::vector<std::size_t> places_;
  std::vector<SaidOf> said_of_;
};

}  // namespace

bool has_doubt(const Parts& parts, std::size_t begin) {
  for (std::size_t at = begin; at < parts.size() && parts[at] != "\n"; ++at) {
    if (is_doubt(parts[at])) return true;
  }
  return false;
}

bool stands_free(const Parts& parts, std::size_t at) {
  return Behind(parts).read(at) != Behind::Found::restricted;
}

std::vector<SaidOf> said_of(std::string_view sentence, const std::vector<MathsInLine>& maths) {
  return Restrictions(sentence, maths).read();
}

}  // namespace rigor
