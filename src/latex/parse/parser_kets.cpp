// SPDX-License-Identifier: GPL-3.0-or-later
// Kets and bras: `|n\rangle`, `\langle a|H|b\rangle`, `\ket{n}`, `\mel{a}{H}{b}`, `\ketbra{a}{b}`. What is in
// a ket is its name, a text in one spelling. A bracket of two states is the product of a bra and a ket.
#include <algorithm>
#include <string>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/state_places.h"

namespace rigor {
namespace {

/// In tokens. What follows goes as deep as a name does.
constexpr std::size_t longest_name = 100;

/// The name in one spelling: scripts in braces, no blanks, no braces around a whole.
std::string spelled_label(TokenView tokens) {
  tokens = trim(tokens);
  std::string text;
  bool behind_word = false;     // a letter would run on
  bool behind_control = false;  // a group is its argument
  for (std::size_t at = 0; at < tokens.size();) {
    const Token& token = tokens[at];
    if (is_blank(token) || is_spacing(token)) {
      ++at;
      continue;
    }
    if (is_sign(token, "'") || token.text == "prime") {
      text += '\'';
      ++at;
    } else if (is_script(token)) {
      const Argument script = script_argument_at(tokens, at + 1);
      const std::string inside = spelled_label(script.content);
      text += inside == "'" || inside == "''" ? inside : std::string(token.text) + "{" + inside + "}";
      at = script.next;
    } else if (token.kind == TokenKind::begin_group) {
      const Argument group = argument_at(tokens, at);
      const std::string inside = spelled_label(group.content);
      text += behind_control ? "{" + inside + "}" : inside;
      at = group.next;
      behind_word = false;
      continue;
    } else if (token.kind == TokenKind::control) {
      const bool fraction = is_control_of(token, {"tfrac", "dfrac", "frac", "nicefrac", "sfrac"});
      const std::string_view name = fraction                     ? "frac"
                                    : token.text == "varepsilon" ? "epsilon"
                                                                 : std::string_view(token.text);
      text += '\\' + std::string(name);
      behind_control = true;
      behind_word = is_letter(name.back());
      ++at;
      for (int k = 0; fraction && k < 2; ++k) {
        const Argument part = argument_at(tokens, at);
        text += "{" + spelled_label(part.content) + "}";
        at = part.next;
        behind_word = false;
      }
      continue;
    } else {
      if (behind_word && token.kind == TokenKind::letter && !token.text.empty() &&
          is_letter(token.text.front()))
        text += ' ';
      text += token.kind == TokenKind::letter && token.text == "−" ? std::string_view("-")
                                                                   : std::string_view(token.text);
      ++at;
    }
    behind_word = false;
    behind_control = false;
  }
  return text;
}

/// The parts of a name, `j` and `m` of `|j, m\rangle`.
std::vector<TokenView> parts_of_label(TokenView content) {
  std::vector<TokenView> parts;
  Nesting nesting(false);
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= content.size(); ++at) {
    const bool end = at == content.size();
    if (!end && (nesting.enter(content[at]) != 0 || !is_sign_of(content[at], ",;"))) continue;
    parts.push_back(trim(content.subspan(begin, at - begin)));
    begin = at + 1;
  }
  return parts;
}

bool is_digits(TokenView tokens) {
  tokens = trim(tokens);
  return !tokens.empty() && std::ranges::all_of(tokens, [](const Token& token) {
    return token.kind == TokenKind::digit || is_blank(token);
  });
}

/// `A\psi`: the state of this name, or A acting on another one. `\psi + \phi` the same.
const char* why_no_name(TokenView part) {
  std::size_t letters = 0;
  bool capital = false;
  bool marked = false;
  bool wave = false;
  Nesting nesting(true);
  for (std::size_t at = 0; at < part.size(); ++at) {
    const Token& token = part[at];
    if (is_control_of(token, {"dagger", "dag"})) return "a dagger inside a ket is not read";
    const bool script = is_script_argument(part, at);
    if (nesting.enter(token) != 0 || script) continue;
    if (is_sum_sign(token) && at > 0 && !is_digits(part.subspan(at + 1)) && at + 1 < part.size() &&
        letters > 0)
      return "a sum inside a ket can be a name, or a sum of states";
    if (is_control_of(token, {"hat", "widehat"})) marked = true;
    const bool letter =
        token.kind == TokenKind::letter || (token.kind == TokenKind::control && !letter_of(token).empty());
    if (!letter) continue;
    if (letters == 0) capital = token.text.size() == 1 && is_capital_letter(token.text[0]);
    if (letters > 0 && is_one_of(token.text, {"psi", "phi", "varphi", "chi", "Psi", "Phi", "u", "v"}))
      wave = true;
    ++letters;
  }
  if (wave && (capital || marked))
    return "letters side by side in a ket can be a name, or an operator that acts on a state";
  return nullptr;
}

bool is_whole_group(TokenView tokens, std::size_t at) {
  return is_kind_at(tokens, at, TokenKind::begin_group);
}

}  // namespace

/// A ket or a bra by its name.
SyntaxId Parser::state_named(const char* kind, TokenView content, Span span) {
  content = trim(content);
  if (content.empty()) return opaque(span, "a ket or bra without a name is not read");
  if (content.size() > longest_name) return opaque(span, "so long a name of a ket or bra is not read");
  std::string name;
  for (const TokenView part : parts_of_label(content)) {
    if (const char* reason = why_no_name(part))
      return opaque(span, reason, DiagnosticKind::ambiguous_reading);
    const std::string text = spelled_label(part);
    if (text.empty()) return opaque(span, "a ket or bra with an empty part in its name is not read");
    name += (name.empty() ? "" : ", ") + text;
  }
  read(content);
  return tree_.add_named(SyntaxKind::function, span, kind,
                         tree_.add_text(SyntaxKind::text, span_of(content), name));
}

/// `\langle a|H|b\rangle`; `between` is nothing in `\langle a|b\rangle`.
SyntaxId Parser::bracket_of_states(TokenView bra, const std::optional<TokenView>& between, TokenView ket,
                                   Span span) {
  std::vector<SyntaxChild> factors{{state_named("bra", bra, span), Joint::none, span}};
  if (between) {
    const SyntaxId middle = inner(*between, span);
    const auto inside = tree_.children(middle);
    const bool product = tree_[middle].kind == SyntaxKind::term &&
                         std::ranges::all_of(inside.subspan(1), [](const SyntaxChild& each) {
                           return each.joint == Joint::juxtaposed;
                         });
    if (product) {
      const std::vector<SyntaxChild> own(inside.begin(), inside.end());
      for (const SyntaxChild& each : own) factors.push_back({each.id, Joint::juxtaposed, span});
    } else if (tree_[middle].kind == SyntaxKind::sum || tree_[middle].kind == SyntaxKind::term) {
      const SyntaxChild child{middle};
      factors.push_back({tree_.add(SyntaxKind::group, span, {&child, 1}), Joint::juxtaposed, span});
    } else {
      factors.push_back({middle, Joint::juxtaposed, span});
    }
  }
  factors.push_back({state_named("ket", ket, span), Joint::juxtaposed, span});
  const SyntaxChild product{tree_.add(SyntaxKind::term, span, factors)};
  return tree_.add(SyntaxKind::group, span, {&product, 1});
}

/// `|a\rangle`
std::optional<SyntaxId> Parser::ket(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  const std::size_t end = behind_ket(tokens, begin);
  if (end == begin) return std::nullopt;
  cursor.at = end;
  read(tokens.subspan(begin, 1));
  read(tokens.subspan(end - 1, 1));
  const Span span = cover(tokens[begin].span, tokens[end - 1].span);
  return state_named("ket", tokens.subspan(begin + 1, end - begin - 2), span);
}

/// `\langle a|`, `\langle a|b\rangle`, `\langle a|H|b\rangle`; nothing for an average.
std::optional<SyntaxId> Parser::angles_of_states(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  const StateAngles angles = state_angles(tokens, begin);
  const std::vector<std::size_t>& bars = angles.bars;
  if (bars.empty()) return std::nullopt;
  const auto between = [&](std::size_t from, std::size_t to) {
    return tokens.subspan(from + 1, to - from - 1);
  };
  read(tokens.subspan(begin, 1));
  read(tokens.subspan(bars[0], 1));
  if (angles.close >= tokens.size()) {
    cursor.at = bars[0] + 1;
    return state_named("bra", between(begin, bars[0]), cover(tokens[begin].span, tokens[bars[0]].span));
  }
  cursor.at = angles.close + 1;
  const Span span = cover(tokens[begin].span, tokens[angles.close].span);
  read(tokens.subspan(angles.close, 1));
  if (bars.size() == 1)
    return bracket_of_states(between(begin, bars[0]), std::nullopt, between(bars[0], angles.close), span);
  const TokenView middle = between(bars[0], bars.back());
  if (bars.size() > 2 || trim(middle).empty()) return opaque(span, "this bracket of states is not read");
  read(tokens.subspan(bars.back(), 1));
  return bracket_of_states(between(begin, bars[0]), middle, between(bars.back(), angles.close), span);
}

/// `\ket{a}`, `\braket{a|b}`, `\braket{a}{b}`, `\mel{a}{H}{b}`, `\ev{H}{a}`, `\ketbra{a}{b}`.
std::optional<SyntaxId> Parser::named_states(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  std::size_t at = begin + 1;
  while (is_sign_at(tokens, at, "*")) ++at;
  std::vector<TokenView> arguments;
  std::size_t end = at;
  const std::size_t most = is_control_of(tokens[begin], {"ket", "bra", "Ket", "Bra"})           ? 1
                           : is_control_of(tokens[begin], {"mel", "matrixel", "matrixelement"}) ? 3
                                                                                                : 2;
  for (at = skip_blank(tokens, at); arguments.size() < most && is_whole_group(tokens, at);
       at = skip_blank(tokens, end)) {
    const Argument argument = argument_at(tokens, at);
    arguments.push_back(argument.content);
    end = argument.next;
  }
  const bool single = most == 1 && arguments.empty() && at < tokens.size();  // `\ket n`
  if (single) {
    const Argument argument = argument_at(tokens, at);
    arguments.push_back(argument.content);
    end = argument.next;
  }
  if (arguments.empty()) return std::nullopt;
  const auto finish = [&](std::optional<std::size_t> inside) {
    cursor.at = end;
    std::size_t from = begin;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
      const auto first = static_cast<std::size_t>(arguments[k].data() - tokens.data());
      read(tokens.subspan(from, first - from));
      from = first + (inside == k || !arguments[k].empty() ? arguments[k].size() : 0);
    }
    read(tokens.subspan(from, end - from));
    return cover(tokens[begin].span, tokens.subspan(begin, end - begin));
  };
  if (most == 1) {
    const bool is_ket = is_control_of(tokens[begin], {"ket", "Ket"});
    return state_named(is_ket ? "ket" : "bra", arguments[0], finish({}));
  }
  if (most == 3) {
    if (arguments.size() != 3) return std::nullopt;
    const Span span = finish(1);
    return bracket_of_states(arguments[0], arguments[1], arguments[2], span);
  }
  if (is_control_of(tokens[begin], {"ev", "expval", "expectationvalue"})) {
    if (arguments.size() != 2) return std::nullopt;
    const Span span = finish(0);
    return bracket_of_states(arguments[1], arguments[0], arguments[1], span);
  }
  if (is_control_of(tokens[begin], {"ketbra", "dyad", "op", "outerproduct"})) {
    if (arguments.size() != 2) return std::nullopt;
    const Span span = finish({});
    const SyntaxChild factors[] = {{state_named("ket", arguments[0], span), Joint::none, span},
                                   {state_named("bra", arguments[1], span), Joint::juxtaposed, span}};
    const SyntaxChild product{tree_.add(SyntaxKind::term, span, factors)};
    return tree_.add(SyntaxKind::group, span, {&product, 1});
  }
  const std::vector<std::size_t> bars = bars_of_states(arguments[0]);
  if (arguments.size() == 2 && bars.empty()) {
    const Span span = finish({});
    return bracket_of_states(arguments[0], std::nullopt, arguments[1], span);
  }
  if (bars.empty() || bars.size() > 2) return std::nullopt;
  arguments.resize(1);
  end = argument_at(tokens, static_cast<std::size_t>(arguments[0].data() - tokens.data()) - 1).next;
  const TokenView whole = arguments[0];
  const Span span = finish(0);
  for (const std::size_t bar : bars) read(whole.subspan(bar, 1));
  const TokenView bra = whole.first(bars[0]);
  const TokenView ket = whole.subspan(bars.back() + 1);
  if (bars.size() == 1) return bracket_of_states(bra, std::nullopt, ket, span);
  return bracket_of_states(bra, whole.subspan(bars[0] + 1, bars[1] - bars[0] - 1), ket, span);
}

}  // namespace rigor
