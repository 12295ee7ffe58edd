// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/unseen_braces.h"

#include <algorithm>

#include "base/ascii.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool means_nothing(const Token& token) {
  return is_blank(token) || is_spacing(token) || is_wide_space(token) || token.kind == TokenKind::align;
}

/// `a \over b` is seen as what it is, and a switch such as `\rm` is about the look of what it holds.
bool is_seen(const Token& token) {
  static const WordSet controls(
      "over atop choose above brack brace rm bf it cal sf tt frak scr sc oldstyle sl");
  return is_control_of(token, controls) || relation_kind(token).has_value();
}

/// What acts on all that follows in its term, or may.
bool acts(const Token& token) {
  static const WordSet controls("nabla partial sum int oint prod iint iiint lim grad curl dd");
  return is_control_of(token, controls) ||
         (token.kind == TokenKind::control && !function_name(token.text).empty());
}

/// What is in a group, outside its own brackets and arguments.
struct Contents {
  int operands = 0;
  bool sum = false;     // several terms
  bool sign = false;    // one before the first
  bool joined = false;  // by `\cdot`, `\times`, `/`
  bool acting = false;
  bool power = false;  // the last operand has one
  bool seen = false;
};

/// After the bracket, environment or `\left…\right` that begins at `at`.
std::size_t behind_enclosed(TokenView tokens, std::size_t at) {
  Nesting nesting(false);
  static_cast<void>(nesting.enter(tokens[at]));
  for (std::size_t next = at + 1; next < tokens.size(); ++next) {
    if (nesting.enter(tokens[next]) == 0) return next + 1;
  }
  return tokens.size();
}

/// After a control with the arguments that are there: groups, or one token where it takes one.
std::size_t behind_control(TokenView tokens, std::size_t at) {
  const Token& control = tokens[at];
  std::size_t next = at + 1;
  if (!letter_of(control).empty()) return next;
  if (is_control(control, "sqrt")) next = optional_argument_at(tokens, next).next;
  const bool takes = style_of(control) || dots_of(control) > 0 || is_control(control, "sqrt");
  const int least = is_fraction(control) ? 2 : takes ? 1 : 0;
  for (int taken = 0;; ++taken) {
    const std::size_t open = skip_blank(tokens, next);
    const bool group = is_kind_at(tokens, open, TokenKind::begin_group);
    if (open >= tokens.size() || (!group && taken >= least)) return next;
    next = argument_at(tokens, open).next;
  }
}

std::size_t behind_operand(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (token.kind == TokenKind::begin_group) return argument_at(tokens, at).next;
  if (token.kind == TokenKind::digit || is_sign(token, ".")) {
    while (at < tokens.size() && (tokens[at].kind == TokenKind::digit || is_sign(tokens[at], "."))) ++at;
    return at;
  }
  const bool opens = is_sign_of(token, "([") || is_control_of(token, {"begin", "{", "lbrace"});
  if (opens) return behind_enclosed(tokens, at);
  if (is_sign(token, "|") || is_control(token, "vert")) {
    const auto rest = tokens.subspan(at + 1);
    const auto close = std::ranges::find_if(
        rest, [](const Token& other) { return is_sign(other, "|") || is_control(other, "vert"); });
    return std::min(at + 2 + static_cast<std::size_t>(close - rest.begin()), tokens.size());
  }
  return token.kind == TokenKind::control ? behind_control(tokens, at) : at + 1;
}

Contents contents_of(TokenView group) {
  Contents found;
  for (std::size_t at = 0; at < group.size();) {
    const Token& token = group[at];
    found.seen = found.seen || is_seen(token);
    if (means_nothing(token) || is_bracket_size(token)) {
      ++at;
    } else if (is_script(token)) {
      found.power = token.kind == TokenKind::superscript;
      at = is_sign(token, "'") ? at + 1 : script_argument_at(group, at + 1).next;
    } else if (is_sum_sign(token)) {
      (found.operands > 0 ? found.sum : found.sign) = true;
      ++at;
    } else if (factor_joint(token) != Joint::none) {
      found.joined = true;
      ++at;
    } else {
      ++found.operands;
      found.power = false;
      found.acting = found.acting || acts(token);
      at = behind_operand(group, at);
    }
  }
  return found;
}

/// `dx`, `\Delta x`, `\partial x`: `{\Delta x}^2` is seen as it is meant.
bool is_change(TokenView group) {
  group = trim(group);
  if (group.empty()) return false;
  const Token& first = group.front();
  const bool upright = is_control(first, "mathrm") && text_of(argument_at(group, 1).content) == "d";
  const bool marks = upright || is_control_of(first, {"Delta", "delta", "partial"}) ||
                     (first.kind == TokenKind::letter && first.text == "d");
  if (!marks) return false;
  const std::size_t next = upright ? argument_at(group, 1).next : 1;
  const Contents rest = contents_of(group.subspan(next));
  return rest.operands == 1 && !rest.sum && !rest.joined && !rest.power;
}

/// What is next to a group.
struct Sides {
  const Token* before = nullptr;
  const Token* behind = nullptr;
};

Sides sides_of(TokenView tokens, std::size_t at, std::size_t next) {
  Sides sides;
  while (at > 0 && means_nothing(tokens[at - 1])) --at;
  if (at > 0) sides.before = &tokens[at - 1];
  while (next < tokens.size() && means_nothing(tokens[next])) ++next;
  if (next < tokens.size()) sides.behind = &tokens[next];
  return sides;
}

/// Does something act in the term before `at`, or may it: the term is longer than anybody reads?
bool is_acted_on(TokenView tokens, std::size_t at) {
  constexpr std::size_t longest = 1000;
  for (std::size_t k = at; k > 0;) {
    const Token& token = tokens[--k];
    if (is_sum_sign(token)) return false;
    const bool differential = token.kind == TokenKind::letter && token.text == "d";
    if (acts(token) || differential || at - k == longest) return true;
  }
  return false;
}

bool ends_term(const Token* token) {
  return token == nullptr || is_sum_sign(*token) || is_sign(*token, ",") || is_sign(*token, ";");
}

}  // namespace

bool groups_unseen(TokenView tokens, std::size_t at) {
  if (!is_kind_at(tokens, at, TokenKind::begin_group) || tokens[at].span.empty()) return false;
  const Argument group = argument_at(tokens, at);
  const Contents inside = contents_of(group.content);
  if (inside.seen || inside.operands == 0) return false;
  const Sides sides = sides_of(tokens, at, group.next);
  const bool scripted = sides.behind != nullptr && is_script(*sides.behind);
  if (inside.sum) {
    const bool minus = sides.before != nullptr && is_sum_sign(*sides.before) && !is_sign(*sides.before, "+");
    return minus || !ends_term(sides.before) || !ends_term(sides.behind);
  }
  const bool several = inside.operands > 1 || inside.joined;
  if (scripted && (several || inside.sign)) return !is_change(group.content);
  const bool divides = sides.before != nullptr && factor_joint(*sides.before) == Joint::slash;
  if (inside.sign && !ends_term(sides.before) && factor_joint(*sides.before) == Joint::none) return true;
  if (inside.acting && !ends_term(sides.behind)) return true;
  if (!several) return false;
  if (divides || (inside.joined && (!ends_term(sides.before) || !ends_term(sides.behind)))) return true;
  return is_acted_on(tokens, at);
}

bool stacks_powers(TokenView tokens, std::size_t at) {
  const Argument group = argument_at(tokens, at);
  const Token* behind = sides_of(tokens, at, group.next).behind;
  if (behind == nullptr || behind->kind != TokenKind::superscript || tokens[at].span.empty()) return false;
  const Contents inside = contents_of(group.content);
  return inside.power && inside.operands == 1 && !inside.seen;
}

bool holds_unseen_sum(TokenView tokens, std::size_t at) {
  if (!is_kind_at(tokens, at, TokenKind::begin_group) || tokens[at].span.empty()) return false;
  const Contents inside = contents_of(argument_at(tokens, at).content);
  return inside.sum && !inside.seen;
}

namespace {

bool is_operator(const Token& token) {
  return is_sign_of(token, "+-*/") ||
         is_control_of(token, {"cdot", "times", "wedge", "pm", "mp", "ast", "star", "otimes"});
}

/// The last token before `at` that is no blank.
std::optional<std::size_t> before(const Tokens& tokens, std::size_t at) {
  while (at > 0) {
    if (tokens[--at].kind != TokenKind::space) return at;
  }
  return std::nullopt;
}

class IdleBraces {
 public:
  explicit IdleBraces(Tokens& tokens) : tokens_(tokens), opening_(tokens.size()) {}

  void lift() {
    std::vector<std::size_t> open;
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      if (tokens_[at].kind == TokenKind::begin_group) open.push_back(at);
      if (tokens_[at].kind != TokenKind::end_group || open.empty()) continue;
      opening_[at] = open.back();
      open.pop_back();
      close(*opening_[at], at);
    }
  }

 private:
  void close(std::size_t open, std::size_t end) {
    const auto inside = before(tokens_, end);
    if (!inside || *inside < open) return;
    const auto previous = before(tokens_, open);
    if (*inside == open) return empty(open, end, previous);
    const auto first = before(tokens_, *inside);
    const bool alone = first && *first == open;
    if (alone && is_operator(tokens_[*inside]) && previous && ends_an_operand(*previous)) blank({open, end});
  }

  void empty(std::size_t open, std::size_t end, std::optional<std::size_t> previous) {
    if (!previous) return;
    const Token& token = tokens_[*previous];
    if (token.kind == TokenKind::control && !function_name(token.text).empty()) blank({open, end});
    if (token.kind != TokenKind::subscript && token.kind != TokenKind::superscript) return;
    if (is_kind_at(tokens_, skip_blank(tokens_, end + 1), token.kind)) return;  // two of them on one base
    if (const auto base = before(tokens_, *previous); base && takes_scripts(*base))
      blank({*previous, open, end});
  }

  bool takes_scripts(std::size_t at) const {
    return ends_an_operand(at) || is_control_of(tokens_[at], {"sum", "int", "prod", "oint"});
  }

  /// A letter, a digit, a closing bracket or a group that is no argument still to be read: of `\overset{a}`
  /// the next group is one.
  bool ends_an_operand(std::size_t at) const {
    const Token& token = tokens_[at];
    if (token.kind == TokenKind::letter || token.kind == TokenKind::digit || is_sign_of(token, ")]'"))
      return !is_argument(at);
    if (token.kind == TokenKind::control) return !letter_of(token).empty() && !is_argument(at);
    if (token.kind != TokenKind::end_group || !opening_[at]) return false;
    const auto taker = before(tokens_, *opening_[at]);
    if (!taker) return true;
    const Token& control = tokens_[*taker];
    if (control.kind == TokenKind::end_group) {
      const auto first = opening_[*taker] ? before(tokens_, *opening_[*taker]) : std::nullopt;
      return first && is_fraction(tokens_[*first]);
    }
    if (control.kind != TokenKind::control) return true;
    return style_of(control).has_value() || dots_of(control) > 0 || control.text == "sqrt" ||
           !letter_of(control).empty();
  }

  /// `a` of `\frac a`, of which the next group is the second argument.
  bool is_argument(std::size_t at) const {
    const auto taker = before(tokens_, at);
    return taker && tokens_[*taker].kind == TokenKind::control && is_fraction(tokens_[*taker]);
  }

  void blank(std::initializer_list<std::size_t> places) {
    for (const std::size_t at : places) {
      Token& token = tokens_[at];
      token = {TokenKind::space, " ", token.span, token.place};
    }
  }

  Tokens& tokens_;
  std::vector<std::optional<std::size_t>> opening_;  // of each closing brace
};

}  // namespace

void lift_idle_braces(Tokens& tokens) { IdleBraces(tokens).lift(); }

}  // namespace rigor
