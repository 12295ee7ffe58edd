// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/prose.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/ascii.h"
#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::size_t shortest_word = 3;  // `dx`, `mg`, `ma` are products

bool is_letter_of_word(char c) { return is_letter(c) || static_cast<unsigned char>(c) >= 0x80U; }

/// Reads the words outside of braces; controls are none.
class WordSearch {
 public:
  explicit WordSearch(std::string_view text) : text_(without_blanks_around(text)) {}

  bool finds_prose() {
    for (at_ = 0; at_ < text_.size();) {
      if (is_mark_of_prose()) return true;
      if (text_[at_] == '\\') {
        skip_control();
      } else if (is_letter_of_word(text_[at_])) {
        if (read_word()) return true;
      } else {
        read_sign(text_[at_]);
        ++at_;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool has(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  [[nodiscard]] bool is_mark_of_prose() const {
    if (depth_ > 0) return false;
    static constexpr auto marks = std::to_array<std::string_view>({"](", "![", "<!--", "**", "__", "`"});
    return std::ranges::any_of(marks, [this](std::string_view mark) { return has(mark); }) || has("$");
  }

  void skip_control() {
    last_word_ = 0;
    ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    if (at_ == begin && at_ < text_.size()) ++at_;
  }

  /// Two words side by side, one of them not short; a single word that is all there is.
  bool read_word() {
    const std::size_t begin = at_;
    std::size_t length = 0;
    for (; at_ < text_.size() && is_letter_of_word(text_[at_]); ++at_)
      length += is_continuation(text_[at_]) ? 0 : 1;
    if (depth_ > 0) return false;
    const bool pair = last_word_ > 1 && length > 1 && std::max(last_word_, length) >= shortest_word &&
                      last_word_ + length > shortest_word + 2;
    const std::string_view rest = text_.substr(at_);
    const bool alone =
        begin == 0 && length >= shortest_word && rest.find_first_not_of(",.:;") == std::string_view::npos;
    const bool first = begin == 0 && length > shortest_word && is_followed_by_letter(rest);
    last_word_ = length;
    return pair || alone || first;
  }

  /// `where a` and `hence, \alpha`: after a first word that is no name, as in `Kraft = \dots`.
  static bool is_followed_by_letter(std::string_view rest) {
    const std::size_t next = rest.find_first_not_of(" \t\n,");
    return next != std::string_view::npos && next > 0 && is_letter_of_word(rest[next]);
  }

  void read_sign(char c) {
    if (c == '{') ++depth_;
    if (c == '}') --depth_;
    if (!is_white(c) && c != ',' && c != '\'' && c != '-') last_word_ = 0;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::size_t last_word_ = 0;  // the length of the word directly before
};

}  // namespace

bool has_mathematics(std::string_view text) {
  return text.find_first_of("\\=^_<+") != std::string_view::npos;
}

bool reads_as_prose(std::string_view text) { return WordSearch(text).finds_prose(); }

}  // namespace rigor
