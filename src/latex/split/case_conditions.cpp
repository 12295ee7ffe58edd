// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/case_conditions.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/ascii.h"
#include "latex/split/beside.h"
#include "latex/split/blocks.h"
#include "latex/split/chain.h"
#include "latex/split/conditions.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

using Together = std::vector<Tokens>;  // relations that hold together

constexpr std::size_t most_alternatives = 4;

/// "otherwise", "elsewhere": what the other cases leave.
bool means_otherwise(TokenView condition, bool in_words) {
  std::string words;
  for (const char c : lowered(in_words ? text_of(condition) : spoken(condition))) {
    if (is_letter(c)) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  while (!words.empty() && words.back() == ' ') words.pop_back();
  static constexpr std::array<std::string_view, 9> known{
      "otherwise",          "else",           "elsewhere",         "else where", "everywhere else",
      "in all other cases", "in other cases", "in any other case", "if not"};
  return is_one_of(words, known);
}

Token made(TokenKind kind, std::string_view text, const Token& where) { return {kind, text, where.span}; }

Tokens related(TokenView left, Token relation, TokenView right) {
  Tokens tokens(left.begin(), left.end());
  tokens.push_back(std::move(relation));
  tokens.insert(tokens.end(), right.begin(), right.end());
  return tokens;
}

/// `x \in (0, L]` as `0 < x` and `x \le L`.
std::optional<Together> bounds_of_interval(TokenView condition) {
  condition = trim(condition);
  while (!condition.empty() && is_sign_of(condition.back(), ",;."))
    condition = trim(condition.first(condition.size() - 1));
  const auto in = std::ranges::find_if(condition, [](const Token& token) { return is_control(token, "in"); });
  if (in == condition.end() || condition.size() < 5) return std::nullopt;
  const auto at = static_cast<std::size_t>(in - condition.begin());
  const TokenView letter = trim(condition.first(at));
  const TokenView interval = trim(condition.subspan(at + 1));
  if (letter.empty() || interval.size() < 5) return std::nullopt;
  const Token& open = interval.front();
  const Token& close = interval.back();
  if (!is_sign_of(open, "([") || !is_sign_of(close, ")]")) return std::nullopt;
  const TokenView inside = interval.subspan(1, interval.size() - 2);
  std::optional<std::size_t> comma;
  Nesting nesting(false);
  for (std::size_t k = 0; k < inside.size(); ++k) {
    const int depth = nesting.enter(inside[k]);
    if (depth < 0) return std::nullopt;
    if (depth != 0 || !is_sign_of(inside[k], ",;")) continue;
    if (comma) return std::nullopt;
    comma = k;
  }
  if (!comma) return std::nullopt;
  const TokenView lower = trim(inside.first(*comma));
  const TokenView upper = trim(inside.subspan(*comma + 1));
  if (lower.empty() || upper.empty()) return std::nullopt;
  const auto below = [&](bool closed) {
    return closed ? made(TokenKind::control, "le", open) : made(TokenKind::other, "<", open);
  };
  Together bounds;
  const auto is_infinite = [](TokenView bound) {
    return std::ranges::any_of(bound, [](const Token& token) { return is_control(token, "infty"); });
  };
  if (!is_infinite(lower)) bounds.push_back(related(lower, below(is_sign(open, "[")), letter));
  if (!is_infinite(upper)) bounds.push_back(related(letter, below(is_sign(close, "]")), upper));
  if (bounds.empty()) return std::nullopt;
  return bounds;
}

std::optional<Together> together(TokenView condition, bool in_words) {
  if (auto bounds = in_words ? std::nullopt : bounds_of_interval(condition)) return bounds;
  return in_words ? conditions_in_tag(condition) : conditions_in(condition);
}

/// What "or" is between.
std::vector<TokenView> between_or(TokenView condition) {
  std::vector<TokenView> parts;
  std::size_t begin = 0;
  Nesting nesting(false);
  for (std::size_t at = 0; at < condition.size(); ++at) {
    if (nesting.enter(condition[at]) != 0) continue;
    const bool sign = is_control_of(condition[at], {"lor", "vee"});
    const Argument words = is_words(condition[at]) ? argument_at(condition, at + 1) : Argument{{}, at + 1};
    std::string said = text_of(words.content);
    std::erase(said, ' ');
    if (!sign && !(is_words(condition[at]) && lowered(said) == "or")) continue;
    parts.push_back(condition.subspan(begin, at - begin));
    begin = words.next;
  }
  parts.push_back(condition.subspan(begin));
  return parts;
}

std::vector<Together> alternatives_in(TokenView condition, bool in_words) {
  std::vector<Together> alternatives;
  for (const TokenView part : between_or(condition)) {
    auto relations = together(part, in_words);
    if (!relations) return {};
    alternatives.push_back(*std::move(relations));
  }
  return alternatives;
}

/// One relation between two sides.
struct Single {
  Tokens left;
  RelationKind kind = RelationKind::equal;
  Tokens right;
};

std::optional<RelationKind> negation_of(RelationKind kind) {
  switch (kind) {
    case RelationKind::less:
      return RelationKind::greater_or_equal;
    case RelationKind::less_or_equal:
      return RelationKind::greater;
    case RelationKind::greater:
      return RelationKind::less_or_equal;
    case RelationKind::greater_or_equal:
      return RelationKind::less;
    case RelationKind::equal:
      return RelationKind::unequal;
    case RelationKind::unequal:
      return RelationKind::equal;
    default:
      return std::nullopt;
  }
}

RelationKind turned_round(RelationKind kind) {
  switch (kind) {
    case RelationKind::less:
      return RelationKind::greater;
    case RelationKind::less_or_equal:
      return RelationKind::greater_or_equal;
    case RelationKind::greater:
      return RelationKind::less;
    case RelationKind::greater_or_equal:
      return RelationKind::less_or_equal;
    default:
      return kind;
  }
}

bool is_number(TokenView tokens) {
  return !tokens.empty() && std::ranges::all_of(tokens, [](const Token& token) {
    return token.kind == TokenKind::digit || is_sign_of(token, "-.") || is_blank(token);
  });
}

/// The relations of `0 \le x < L`, numbers on the right where there are some.
std::vector<Single> singles_of(const Together& relations) {
  std::vector<Single> singles;
  for (const Tokens& relation : relations) {
    TokenUses own(0);
    const WrittenChain chain = chain_of(relation, own);
    for (std::size_t k = 0; k < chain.relations.size(); ++k) {
      Single single{chain.sides[k].tokens, chain.relations[k].kind, chain.sides[k + 1].tokens};
      if (is_number(single.left) && !is_number(single.right)) {
        std::swap(single.left, single.right);
        single.kind = turned_round(single.kind);
      }
      singles.push_back(std::move(single));
    }
  }
  return singles;
}

Tokens written(const Single& single) {
  const Token& where = single.left.front();
  const Token relation = [&] {
    switch (single.kind) {
      case RelationKind::less:
        return made(TokenKind::other, "<", where);
      case RelationKind::greater:
        return made(TokenKind::other, ">", where);
      case RelationKind::less_or_equal:
        return made(TokenKind::control, "le", where);
      case RelationKind::greater_or_equal:
        return made(TokenKind::control, "ge", where);
      case RelationKind::unequal:
        return made(TokenKind::control, "ne", where);
      default:
        return made(TokenKind::other, "=", where);
    }
  }();
  return related(single.left, relation, single.right);
}

/// Does it hold for what is below, at and above the other side?
std::array<bool, 3> allowed(RelationKind kind) {
  switch (kind) {
    case RelationKind::less:
      return {true, false, false};
    case RelationKind::less_or_equal:
      return {true, true, false};
    case RelationKind::greater:
      return {false, false, true};
    case RelationKind::greater_or_equal:
      return {false, true, true};
    case RelationKind::equal:
      return {false, true, false};
    default:
      return {true, false, true};
  }
}

/// `x < 0` and `x \ge 0`, `x < 0` and `x > 2`: as far as it is seen without computing.
bool exclude(const Single& a, const Single& b) {
  if (text_of(a.left) != text_of(b.left)) return false;
  const std::array<bool, 3> first = allowed(a.kind);
  const std::array<bool, 3> second = allowed(b.kind);
  if (text_of(a.right) == text_of(b.right)) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (first[k] && second[k]) return false;
    }
    return true;
  }
  if (!is_number(a.right) || !is_number(b.right)) return false;
  const double at = std::strtod(text_of(a.right).c_str(), nullptr);
  const double other = std::strtod(text_of(b.right).c_str(), nullptr);
  if (at == other) return false;
  const bool upwards = at < other;  // what is above `at` and below `other` fits both sides of the gap
  return upwards ? !first[2] && !second[0] : !first[0] && !second[2];
}

/// That none of the alternatives holds; nothing where that is too much, or a relation has no contrary.
std::optional<std::vector<std::vector<Single>>> none_of(const std::vector<Together>& alternatives) {
  std::vector<std::vector<Single>> none{{}};
  for (const Together& alternative : alternatives) {
    std::vector<std::vector<Single>> finer;
    for (const std::vector<Single>& so_far : none) {
      for (Single single : singles_of(alternative)) {
        const auto contrary = negation_of(single.kind);
        if (!contrary) return std::nullopt;
        single.kind = *contrary;
        const bool impossible =
            std::ranges::any_of(so_far, [&](const Single& each) { return exclude(each, single); });
        if (impossible) continue;
        finer.push_back(so_far);
        const bool known = std::ranges::any_of(
            so_far, [&](const Single& each) { return text_of(written(each)) == text_of(written(single)); });
        if (!known) finer.back().push_back(std::move(single));
      }
    }
    if (finer.size() > most_alternatives) return std::nullopt;
    none = std::move(finer);
  }
  return none;
}

}  // namespace

std::vector<CaseConditions> conditions_of_cases(const std::vector<TokenView>& written_beside, bool in_words) {
  std::vector<CaseConditions> cases;
  std::vector<Together> said;
  bool all_read = true;
  for (const TokenView condition : written_beside) {
    CaseConditions& own = cases.emplace_back();
    if (means_otherwise(condition, in_words)) continue;
    own.alternatives = alternatives_in(condition, in_words);
    said.insert(said.end(), own.alternatives.begin(), own.alternatives.end());
    all_read = all_read && !own.alternatives.empty();
  }
  if (said.empty()) return {};
  const auto rest = all_read ? none_of(said) : std::nullopt;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!rest || !means_otherwise(written_beside[k], in_words)) continue;
    for (const std::vector<Single>& each : *rest) {
      Together relations;
      for (const Single& single : each) relations.push_back(written(single));
      cases[k].alternatives.push_back(std::move(relations));
    }
  }
  return cases;
}

}  // namespace rigor
