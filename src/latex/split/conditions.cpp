// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/conditions.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "base/ascii.h"
#include "latex/split/beside.h"
#include "latex/split/blocks.h"
#include "latex/token/differential.h"
#include "latex/token/remarks.h"

namespace rigor {
namespace {

/// A word, or a token of mathematics.
struct SentenceItem {
  std::string word;
  Token token{};
};

class ItemReader {
 public:
  explicit ItemReader(bool text) : text_(text) {}

  void read(TokenView tokens) {
    for (std::size_t at = 0; at < tokens.size();) {
      const Token& token = tokens[at];
      const bool math = !text_ || in_dollars_;
      if (math && !in_dollars_ && is_words(token)) {
        const Argument words = argument_at(tokens, at + 1);
        text_ = true;
        read(words.content);
        end_word();
        text_ = in_dollars_ = false;
        at = words.next;
        continue;
      }
      ++at;
      if (is_sign(token, "$")) {
        end_word();
        in_dollars_ = !in_dollars_;
      } else if (math) {
        if (!is_blank(token)) items_.push_back({{}, token});
      } else if (token.kind == TokenKind::letter || token.kind == TokenKind::digit || is_sign(token, "-")) {
        word_ += token.text;
      } else {
        end_word();
        const bool blank = is_blank(token) || is_spacing(token) || is_wide_space(token) ||
                           is_sign(token, "~") || token.kind == TokenKind::begin_group ||
                           token.kind == TokenKind::end_group;
        if (!blank) items_.push_back({{}, token});
      }
    }
  }

  std::vector<SentenceItem> take() {
    end_word();
    return std::move(items_);
  }

 private:
  void end_word() {
    if (word_.empty()) return;
    items_.push_back({lowered(word_), {}});
    word_.clear();
  }

  bool text_;
  bool in_dollars_ = false;
  std::string word_;
  std::vector<SentenceItem> items_;
};

std::vector<SentenceItem> items_of(TokenView tokens, bool text) {
  ItemReader reader(text);
  reader.read(tokens);
  return reader.take();
}

using SentenceItems = std::span<const SentenceItem>;

bool is_space(const Token& token) {
  return is_blank(token) || is_spacing(token) || is_wide_space(token) || is_sign(token, "~") ||
         is_control(token, " ") || is_control(token, "enspace");
}

/// How many of the first items are the words of a phrase that brings a condition in; 0 for none.
std::size_t condition_words(SentenceItems items, bool& orders_only) {
  static constexpr std::array<std::string_view, 25> phrases{
      "if",         "for",       "for all",       "for any",  "for every",     "for each", "when",
      "whenever",   "assuming",  "assuming that", "provided", "provided that", "given",    "given that",
      "as long as", "valid for", "valid if",      "at",       "since",         "because",  "in case",
      "only if",    "only for",  "where",         "with"};
  std::size_t most = 0;
  for (const std::string_view phrase : phrases) {
    const std::vector<std::string_view> words = words_in(phrase);
    const bool stands =
        words.size() <= items.size() &&
        std::equal(words.begin(), words.end(), items.begin(),
                   [](std::string_view word, const SentenceItem& item) { return item.word == word; });
    if (!stands || words.size() <= most) continue;
    most = words.size();
    orders_only = phrase == "where" || phrase == "with";
  }
  return most;
}

bool may_be_assumed(RelationKind kind) {
  switch (kind) {
    case RelationKind::equal:
    case RelationKind::less:
    case RelationKind::less_or_equal:
    case RelationKind::greater:
    case RelationKind::greater_or_equal:
    case RelationKind::unequal:
      return true;
    default:
      return false;
  }
}

/// `i \ne j`, `i = 1`: which components are meant.
bool relates_indices(TokenView piece) {
  if (!relates_index_letters(piece)) return false;
  bool digit = false;
  bool order = false;
  bool only_indices = true;
  for (const Token& token : piece) {
    digit = digit || token.kind == TokenKind::digit;
    const auto kind = relation_kind(token);
    order = order || (kind && kind != RelationKind::equal);
    if (token.kind == TokenKind::letter)
      only_indices = only_indices && token.text.size() == 1 && token.text[0] >= 'i' && token.text[0] <= 'n';
  }
  return only_indices && (!digit || !order);
}

/// Two sides at least, and no relation that cannot be taken for granted.
bool is_condition(TokenView piece) {
  Nesting nesting(false);
  std::size_t relations = 0;
  bool empty = true;
  for (std::size_t at = 0; at < piece.size(); ++at) {
    const bool outside = nesting.enter(piece[at]) == 0;
    if (is_words(piece[at])) return false;
    const auto kind = relation_kind(piece[at]);
    if (!kind) {
      empty = empty && (is_space(piece[at]) || is_control(piece[at], "not"));
      continue;
    }
    if (!outside || empty || !may_be_assumed(*kind) || is_stacked_relation(piece, at)) return false;
    empty = true;
    ++relations;
  }
  return relations > 0 && !empty && !relates_indices(piece);
}

/// Commas and "and" between relations; letters before the first one share its relation.
std::optional<std::vector<Tokens>> pieces_of(SentenceItems items, bool orders_only) {
  std::vector<Tokens> pieces(1);
  Nesting nesting(false);
  for (const SentenceItem& item : items) {
    const bool joins = item.word.empty() && nesting.enter(item.token) == 0 && (is_sign_of(item.token, ",;"));
    if (joins || item.word == "and") {
      pieces.emplace_back();
    } else if (!item.word.empty()) {
      return std::nullopt;
    } else {
      pieces.back().push_back(item.token);
    }
  }
  std::vector<Tokens> conditions;
  std::vector<Tokens> letters;
  for (Tokens& piece : pieces) {
    while (!piece.empty() && (is_space(piece.back()) || is_sign_of(piece.back(), ".:"))) piece.pop_back();
    while (!piece.empty() && is_space(piece.front())) piece.erase(piece.begin());
    if (piece.empty()) continue;
    if (!has_relation(piece)) {
      if (symbol_end(piece, 0) != piece.size()) return std::nullopt;
      letters.push_back(std::move(piece));
      continue;
    }
    if (!is_condition(piece)) return std::nullopt;
    const bool equates = std::ranges::any_of(
        piece, [](const Token& token) { return relation_kind(token) == RelationKind::equal; });
    const bool unequal =
        std::ranges::any_of(piece, [](const Token& token) { return is_control(token, "not"); });
    if (orders_only && equates && !unequal) return std::nullopt;
    const auto relation = std::ranges::find_if(
        piece, [](const Token& token) { return relation_kind(token) || is_control(token, "not"); });
    for (Tokens& letter : letters) {
      letter.insert(letter.end(), relation, piece.end());
      conditions.push_back(std::move(letter));
    }
    letters.clear();
    conditions.push_back(std::move(piece));
  }
  if (!letters.empty() || conditions.empty()) return std::nullopt;
  return conditions;
}

/// Bare zeros, also `\mathbf 0` and `\vec{0}`.
bool is_zero(TokenView label) {
  std::size_t zeros = 0;
  for (const Token& token : label) {
    const bool dress = is_space(token) || style_of(token) || token.kind == TokenKind::begin_group ||
                       token.kind == TokenKind::end_group;
    if (dress) continue;
    if (token.kind != TokenKind::digit || token.text != "0") return false;
    ++zeros;
  }
  return zeros == 1;
}

}  // namespace

std::optional<std::vector<Tokens>> conditions_in(TokenView tokens) {
  tokens = trim(tokens);
  if (!tokens.empty() && is_sign(tokens.front(), "(") && bracket_end(tokens, 0) == tokens.size())
    tokens = tokens.subspan(1, tokens.size() - 2);
  const std::vector<SentenceItem> items = items_of(tokens, false);
  bool orders_only = false;
  const std::size_t words = condition_words(items, orders_only);
  return pieces_of(SentenceItems(items).subspan(words), orders_only);
}

std::optional<std::vector<Tokens>> conditions_behind_words(TokenView tokens) {
  const std::vector<SentenceItem> items = items_of(tokens, false);
  bool orders_only = false;
  const std::size_t words = condition_words(items, orders_only);
  if (words == 0) return std::nullopt;
  return pieces_of(SentenceItems(items).subspan(words), orders_only);
}

std::optional<std::vector<Tokens>> conditions_in_tag(TokenView tokens) {
  if (std::ranges::none_of(tokens, [](const Token& token) { return is_sign(token, "$"); }))
    return std::nullopt;
  const std::vector<SentenceItem> items = items_of(tokens, true);
  SentenceItems rest(items);
  const auto is_number = [](const SentenceItem& item) {
    return item.word.empty() ? is_sign_of(item.token, ",.:;") : is_digit(item.word[0]);
  };
  while (!rest.empty() && is_number(rest.front())) rest = rest.subspan(1);
  bool orders_only = true;  // a mere equation in a tag may be a name
  const std::size_t words = condition_words(rest, orders_only);
  return pieces_of(rest.subspan(words), orders_only);
}

std::vector<Tokens> listed_letters(TokenView tokens) {
  std::vector<Tokens> letters;
  std::size_t begin = 0;
  Nesting nesting(false);
  for (std::size_t at = 0; at <= tokens.size(); ++at) {
    const bool end = at == tokens.size() || (nesting.enter(tokens[at]) == 0 && is_sign(tokens[at], ","));
    if (!end) continue;
    const TokenView letter = trim(tokens.subspan(begin, at - begin));
    if (letter.empty() || symbol_end(letter, 0) != letter.size()) return {};
    letters.emplace_back(letter.begin(), letter.end());
    begin = at + 1;
  }
  return letters;
}

std::optional<Tokens> said_at_brace(TokenView part, TokenView label) {
  part = trim(part);
  label = trim(label);
  for (std::size_t at = 0; at < label.size(); ++at) {
    if (!is_words(label[at])) continue;
    if (remark_of(spoken(label.subspan(at))) != Remark::remark) return std::nullopt;
    label = trim(label.first(at));
    break;
  }
  if (part.empty() || label.empty() || has_relation(part)) return std::nullopt;
  Tokens all(part.begin(), part.end());
  if (is_zero(label)) {
    all.push_back({TokenKind::other, "=", label.front().span});
  } else if (!relation_kind(label[first_significant(label, 0)]) && !is_control(label.front(), "not")) {
    return std::nullopt;
  }
  all.insert(all.end(), label.begin(), label.end());
  if (!is_condition(all)) return std::nullopt;
  return all;
}

std::vector<Tokens> said_at_braces(TokenView side) {
  std::vector<Tokens> said;
  for (std::size_t at = 0; at < side.size(); ++at) {
    if (!is_control(side[at], "underbrace") && !is_control(side[at], "overbrace")) continue;
    const Argument part = argument_at(side, at + 1);
    const std::size_t script = skip_blank(side, part.next);
    if (script >= side.size()) continue;
    if (side[script].kind != TokenKind::subscript && side[script].kind != TokenKind::superscript) continue;
    auto condition = said_at_brace(part.content, script_argument_at(side, script + 1).content);
    if (condition) said.push_back(std::move(*condition));
  }
  return said;
}

}  // namespace rigor
