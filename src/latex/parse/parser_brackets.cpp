// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets, bars and the environments that are one piece of an expression.
#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/parse/parser.h"
#include "latex/token/differential.h"
#include "latex/token/state_places.h"

namespace rigor {
namespace {

/// The place of the bracket that closes the one at `open`, or the size.
std::size_t closing_bracket(TokenView tokens, std::size_t open) {
  Nesting nesting(false);
  for (std::size_t at = open; at < tokens.size(); ++at) {
    const int depth = nesting.enter(tokens[at]);
    if (at > open && depth == 0) return at;
  }
  return tokens.size();
}

bool are_a_pair(const Token& open, const Token& closing) {
  if (is_sign(open, "(")) return is_sign(closing, ")");
  if (is_sign(open, "[")) return is_sign(closing, "]");
  return is_control(closing, "}") || is_control(closing, "rbrace");
}

/// `[0, 1)`: two ends with a comma between, each with a bracket of its own kind.
bool is_interval(const Token& open, const Token& closing, TokenView content) {
  const bool round = is_sign(open, "(") != is_sign(closing, ")");
  if (!round || !is_sign_of(open, "([")) return false;
  Nesting nesting(false);
  return 1 == std::ranges::count_if(content, [&](const Token& token) {
           return nesting.enter(token) == 0 && is_sign_of(token, ",;");
         });
}

/// `[A, B\}`: a commutator, or an anticommutator where both are odd.
bool is_graded(const Token& open, const Token& closing, TokenView content) {
  Nesting nesting(false);
  return is_sign(open, "[") && is_control(closing, "}") &&
         std::ranges::any_of(
             content, [&](const Token& token) { return nesting.enter(token) == 0 && is_sign(token, ","); });
}

bool is_bar(const Token& token) { return is_sign(token, "|") || is_control(token, "vert"); }
bool is_double_bar(const Token& token) { return is_control(token, "|") || is_control(token, "Vert"); }

/// Does an operand end with this token? Then a bar after it closes.
bool ends_operand(const Token& token) {
  if (factor_joint(token) != Joint::none || relation_kind(token)) return false;
  switch (token.kind) {
    case TokenKind::letter:
      return token.text != "−";
    case TokenKind::digit:
    case TokenKind::end_group:
      return true;
    case TokenKind::control:
      return !letter_of(token).empty() || is_one_of(token.text, {"rvert", "rVert", "}", "rangle"});
    case TokenKind::other:
      return token.text == ")" || token.text == "]" || token.text == "'";
    default:
      return false;
  }
}

bool is_product_sign(const Token& token) { return factor_joint(token) != Joint::none; }

/// `+`, `\cdot`: a sign of a sum or a product, and nothing else.
bool is_lone_sign(TokenView tokens) {
  tokens = trim(tokens);
  return tokens.size() == 1 && (is_sum_sign(tokens[0]) || is_product_sign(tokens[0]));
}

/// `|…|` has one sign for both ends: a bar after an operand closes, any other opens. `|\cdot|` closes, too.
std::size_t closing_bar(TokenView tokens, std::size_t open) {
  const bool twofold = is_double_bar(tokens[open]);
  Nesting nesting(false);
  int bars = 1;
  bool operand = false;
  for (std::size_t at = open + 1; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    if (is_blank(token) || is_spacing(token)) continue;
    const int depth = nesting.enter(token);
    if (const std::size_t behind = depth == 0 ? behind_states(tokens, at) : at; behind > at) {
      at = behind - 1;
      operand = true;
      continue;
    }
    if (depth == 0 && (twofold ? is_double_bar(token) : is_bar(token))) {
      const TokenView inside = trim(tokens.subspan(open + 1, at - open - 1));
      const bool placeholder = inside.size() == 1 && is_product_sign(inside[0]);
      bars += operand || placeholder ? -1 : 1;
      if (bars == 0) return at;
      continue;  // after a closed bar an operand has ended, after an opened one it has not
    }
    operand = ends_operand(token) || is_script_argument(tokens, at);
  }
  return tokens.size();
}

bool is_angle(const Token& token) { return is_control_of(token, {"rangle", "langle", "ket", "bra"}); }

/// Does an operand begin with this token? A sign does not count.
bool begins_operand(const Token& token) {
  if (token.kind == TokenKind::control)
    return !letter_of(token).empty() || style_of(token).has_value() || is_fraction(token) ||
           dots_of(token) > 0 || !function_name(token.text).empty() || token.text == "sqrt" ||
           token.text == "nabla";
  return token.kind == TokenKind::letter || token.kind == TokenKind::digit || is_sign_of(token, "([") ||
         token.kind == TokenKind::begin_group;
}

/// Does an operand end right before this place, and another one begin right after it?
bool stands_between(TokenView tokens, std::size_t at) {
  const auto means_nothing = [](const Token& token) { return is_blank(token) || is_spacing(token); };
  std::size_t before = at;
  while (before > 0 && means_nothing(tokens[before - 1])) --before;
  std::size_t behind = at + 1;
  while (behind < tokens.size() && means_nothing(tokens[behind])) ++behind;
  if (before == 0 || behind >= tokens.size()) return false;
  // `P(+|D)`, `P(D|-)`: a sign alone is a name.
  const bool named_before = is_lone_sign(tokens.first(at));
  const bool named_behind = is_lone_sign(tokens.subspan(at + 1));
  const bool ended =
      named_before || ends_operand(tokens[before - 1]) || is_script_argument(tokens, before - 1);
  return ended && (named_behind || begins_operand(tokens[behind]));
}

struct Cell {
  TokenView tokens;
  bool ends_row;
};

std::vector<Cell> cells_of(TokenView body) {
  std::vector<Cell> cells;
  Nesting nesting(true);
  std::size_t begin = 0;
  for (std::size_t at = 0; at < body.size(); ++at) {
    if (nesting.enter(body[at]) != 0) continue;
    const bool row = is_control(body[at], "\\") || is_control(body[at], "cr");
    if (!row && body[at].kind != TokenKind::align) continue;
    cells.push_back({body.subspan(begin, at - begin), row});
    begin = at + 1;
    if (row && is_length(optional_argument_at(body, begin).content))
      begin = optional_argument_at(body, begin).next;
  }
  if (!trim(body.subspan(begin)).empty()) cells.push_back({body.subspan(begin), true});
  if (!cells.empty()) cells.back().ends_row = true;
  return cells;
}

std::vector<TokenView> views_of(const std::vector<Cell>& cells) {
  std::vector<TokenView> views;
  for (const Cell& cell : cells) views.push_back(cell.tokens);
  return views;
}

/// `\exp[x]`, `\frac{d}{dx}[f]`: is there a function or a derivative before the bracket in its term?
bool is_acted_on(TokenView tokens, std::size_t open) {
  while (open > 0) {
    const Token& token = tokens[--open];
    if (is_sign_of(token, "+-")) return false;
    const bool derivative = is_partial(token) || is_control(token, "nabla") ||
                            (token.kind == TokenKind::letter && token.text == "d");
    if (derivative || (token.kind == TokenKind::control && !function_name(token.text).empty())) return true;
  }
  return false;
}

}  // namespace

/// Signs between the cells of a matrix.
void Parser::read_between(TokenView body, std::span<const TokenView> cells) {
  const Token* from = body.data();
  for (const TokenView cell : cells) {
    read({from, cell.data()});
    from = cell.data() + cell.size();
  }
  read({from, body.data() + body.size()});
}

SyntaxId Parser::bracketed(Cursor& cursor) {
  const Token open = cursor.token();
  const std::size_t close = closing_bracket(cursor.tokens, cursor.at);
  if (close >= cursor.tokens.size()) {
    cursor.at = cursor.tokens.size();
    return opaque(open.span, fmt::format("`{}` is not closed", open.text), DiagnosticKind::unbalanced);
  }
  const TokenView content = cursor.tokens.subspan(cursor.at + 1, close - cursor.at - 1);
  const Token closing = cursor.tokens[close];
  const Span span = cover(open.span, closing.span);
  read_sign(cursor);
  read(cursor.tokens.subspan(close, 1));
  cursor.at = close + 1;
  if (auto derivative = operator_in(content)) return bracketed_operator(cursor, std::move(*derivative), span);
  const bool interval = is_interval(open, closing, content);
  if (interval) return opaque(span, "a half-open interval is not read");
  if (is_graded(open, closing, content)) return opaque(span, "a graded commutator is not read");
  if (!are_a_pair(open, closing)) {
    return opaque(closing.span, fmt::format("`{}` does not close `{}`", closing.text, open.text),
                  DiagnosticKind::unbalanced);
  }
  const std::size_t begin = static_cast<std::size_t>(content.data() - cursor.tokens.data()) - 1;
  const std::uint32_t pair = is_sign(open, "(") ? 0 : is_sign(open, "[") ? in_square_brackets : in_braces;
  const SyntaxId group = bracket_contents(content, span, pair);
  if (is_sign(open, "(") || !holds_one_letter(group) || is_acted_on(cursor.tokens, begin)) return group;
  const bool component = close + 1 < cursor.tokens.size() && is_bold_letter(group) &&
                         cursor.tokens[close + 1].kind == TokenKind::subscript;
  if (component) return group;
  return opaque(
      span,
      fmt::format(
          "brackets around `{0}` alone group nothing: this can be its matrix, its unit or its integer part",
          text_of(content)),
      DiagnosticKind::ambiguous_reading, {"without brackets, or in round ones, it is the letter itself"});
}

/// What brackets hold. `P(+)` names a result, `E(\cdot)` keeps a place for an argument: a sign alone is no
/// slip there.
SyntaxId Parser::in_brackets(TokenView content, Span span) {
  if (is_lone_sign(content))
    return opaque(
        span_of(trim(content)),
        fmt::format("`{0}` alone in brackets, for a name or an argument, is not read", text_of(content)));
  return inner(content, span);
}

/// One expression in brackets, or several with commas between: the components of a vector. `pair`: the
/// payload if there are two.
SyntaxId Parser::bracket_contents(TokenView content, Span span, std::uint32_t pair) {
  std::vector<SyntaxChild> entries;
  Nesting nesting(false);
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= content.size(); ++at) {
    const bool end = at == content.size();
    if (!end && (nesting.enter(content[at]) != 0 || !is_sign(content[at], ","))) continue;
    entries.push_back({in_brackets(content.subspan(begin, at - begin), span), Joint::comma, span});
    if (!end) read(content.subspan(at, 1));
    begin = at + 1;
  }
  if (entries.size() == 1) entries[0].joint = Joint::none;
  return tree_.add(entries.size() == 1 ? SyntaxKind::group : SyntaxKind::tuple, span, entries,
                   entries.size() == 2 ? pair : 0);
}

/// `\boldsymbol\omega\times` is the matrix that takes the cross product.
SyntaxId Parser::missing_operand(Joint joint, Span place, std::span<const SyntaxChild> before) {
  const bool matrix = joint == Joint::cross && !before.empty() &&
                      tree_[before.back().id].kind == SyntaxKind::symbol &&
                      tree_.symbol(before.back().id).face == Face::vector;
  if (matrix) return opaque(place, "the matrix of a cross product is not read");
  return opaque(place, "an operand is missing after this sign", DiagnosticKind::bad_syntax);
}

SyntaxId Parser::bars(Cursor& cursor) {
  if (const auto state = ket(cursor)) return *state;
  const Token open = cursor.token();
  const bool sized = is_control(open, "lvert") || is_control(open, "lVert");
  const bool norm = is_control(open, "lVert") || is_double_bar(open);
  std::size_t close =
      sized ? closing_bracket(cursor.tokens, cursor.at) : closing_bar(cursor.tokens, cursor.at);
  if (close >= cursor.tokens.size()) {
    const bool divides = stands_between(cursor.tokens, cursor.at);
    const bool ket = std::ranges::any_of(cursor.tokens, is_angle);
    cursor.at = cursor.tokens.size();
    if (ket) return opaque(open.span, "a bra or ket is not read");
    if (divides) return opaque(open.span, "a bar between two quantities is not read");
    return opaque(open.span, "this bar is not closed", DiagnosticKind::unbalanced);
  }
  if (!sized) close = outer_bar(cursor, close);
  const TokenView content = cursor.tokens.subspan(cursor.at + 1, close - cursor.at - 1);
  const Token closing = cursor.tokens[close];
  const Span span = cover(open.span, closing.span);
  read_sign(cursor);
  read(cursor.tokens.subspan(close, 1));
  cursor.at = close + 1;
  if (sized && !is_control(closing, norm ? "rVert" : "rvert")) {
    return opaque(closing.span, "this does not close the bar before it", DiagnosticKind::unbalanced);
  }
  const SyntaxChild child{in_brackets(content, span)};
  return tree_.add(norm ? SyntaxKind::norm : SyntaxKind::bars, span, {&child, 1});
}

/// `|a|b|c|`: the first bar is closed at `close`, or around the bars that follow. The latter needs two more
/// bars between operands on both sides, and a fourth.
std::size_t Parser::outer_bar(const Cursor& cursor, std::size_t close) {
  const TokenView tokens = cursor.tokens;
  const bool twofold = is_double_bar(tokens[cursor.at]);
  std::vector<std::size_t> behind;
  Nesting nesting(false);
  for (std::size_t at = cursor.at + 1; at < tokens.size() && behind.size() < 3; ++at) {
    if (const std::size_t next = behind_states(tokens, at); next > at) {
      at = next - 1;
      continue;
    }
    const bool bar = twofold ? is_double_bar(tokens[at]) : is_bar(tokens[at]);
    if (nesting.enter(tokens[at]) == 0 && bar) behind.push_back(at);
  }
  const bool nests = behind.size() == 3 && behind[0] == close && stands_between(tokens, behind[0]) &&
                     stands_between(tokens, behind[1]);
  if (!nests) return close;
  const auto written = [&](std::size_t from, std::size_t to) {
    return text_of(tokens.subspan(from, to - from));
  };
  const Span span = cover(tokens[cursor.at].span, tokens[behind[2]].span);
  const std::string first = fmt::format("({})({})({})", written(cursor.at, behind[0] + 1),
                                        written(behind[0] + 1, behind[1]), written(behind[1], behind[2] + 1));
  const std::string second =
      fmt::format("{}({}){}", written(cursor.at, behind[0]), written(behind[0], behind[1] + 1),
                  written(behind[1] + 1, behind[2] + 1));
  return takes_second({span, first, second}) ? behind[2] : close;
}

/// `]0, 1[` and `]0, 1]`.
std::optional<SyntaxId> Parser::reversed_interval(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  if (!is_sign(tokens[cursor.at], "]")) return std::nullopt;
  std::size_t end = cursor.at + 1;
  while (end < tokens.size() && !is_sign_of(tokens[end], "[]")) ++end;
  const TokenView content = tokens.subspan(cursor.at + 1, std::min(end, tokens.size()) - cursor.at - 1);
  const bool two = std::ranges::any_of(content, [](const Token& token) { return is_sign_of(token, ",;"); });
  if (end >= tokens.size() || !two) return std::nullopt;
  const Span span = cover(tokens[cursor.at].span, tokens[end].span);
  cursor.at = end + 1;
  return opaque(span, "an interval is not read");
}

SyntaxId Parser::environment(Cursor& cursor) {
  const Token begin = cursor.token();
  const Argument name_argument = argument_at(cursor.tokens, cursor.at + 1);
  std::string name = text_of(name_argument.content);
  const std::size_t end = closing_bracket(cursor.tokens, cursor.at);
  if (end >= cursor.tokens.size() || end < name_argument.next) {
    cursor.at = cursor.tokens.size();
    return opaque(begin.span, fmt::format("`\\begin{{{}}}` is not closed", name), DiagnosticKind::unbalanced);
  }
  TokenView body = cursor.tokens.subspan(name_argument.next, end - name_argument.next);
  const Span span = cover(begin.span, cursor.tokens[end].span);
  read_since({cursor.tokens, name_argument.next}, cursor.at);
  cursor.at = argument_at(cursor.tokens, end + 1).next;
  read_since(cursor, end);
  if (name.ends_with("matrix*")) {  // of mathtools: `[r]` says how columns are set
    name.pop_back();
    const TokenView columns = body.first(optional_argument_at(body, 0).next);
    if (!are_columns(columns)) return opaque(span, "the columns of this matrix are not read");
    read(columns);
    body = body.subspan(columns.size());
  }
  if (name == "cases" || name == "dcases" || name == "rcases") return cases(body, span);
  if (name == "array") {
    const TokenView columns = body.first(argument_at(body, optional_argument_at(body, 0).next).next);
    if (!are_columns(columns)) return opaque(span, "the columns of this array are not read");
    read(columns);
    body = body.subspan(columns.size());
  }
  const bool brackets = is_one_of(name, {"pmatrix", "bmatrix", "matrix", "smallmatrix", "array", "Bmatrix",
                                         "psmallmatrix", "bsmallmatrix"});
  if (brackets) return matrix(body, span, false);
  if (name == "vmatrix") return matrix(body, span, true);
  return opaque(span, fmt::format("the environment `{}` is not read inside an expression", name));
}

SyntaxId Parser::cases(TokenView body, Span span) {
  std::vector<SyntaxChild> children;
  bool value_next = true;
  const std::vector<Cell> cells = cells_of(body);
  read_between(body, views_of(cells));
  for (const Cell& cell : cells) {
    TokenView tokens = trim(cell.tokens);
    if (value_next) {
      if (tokens.empty() && cell.ends_row) continue;
      while (!tokens.empty() && is_sign(tokens.back(), ",")) {
        read(tokens.last(1));
        tokens = trim(tokens.first(tokens.size() - 1));
      }
      children.push_back({inner(tokens, span)});
    } else {
      read(tokens);
      children.push_back(
          {tree_.add_text(SyntaxKind::text, tokens.empty() ? span : span_of(tokens), text_of(tokens))});
    }
    if (value_next && cell.ends_row)
      children.push_back({tree_.add_text(SyntaxKind::text, span, "otherwise")});
    value_next = cell.ends_row;
  }
  return tree_.add(SyntaxKind::cases, span, children);
}

SyntaxId Parser::matrix(TokenView body, Span span, bool determinant) {
  std::vector<SyntaxChild> entries;
  std::uint32_t columns = 0;
  std::uint32_t in_row = 0;
  bool ragged = false;
  const std::vector<Cell> cells = cells_of(body);
  read_between(body, views_of(cells));
  for (const Cell& cell : cells) {
    const bool empty = trim(cell.tokens).empty();
    entries.push_back(
        {empty ? opaque(span, "an empty cell can be a 0")
         : is_lone_sign(cell.tokens)
             ? opaque(span_of(trim(cell.tokens)), "a cell with a sign alone can be a 0 or any entry")
             : inner(cell.tokens, span),
         Joint::comma, span});
    ++in_row;
    if (!cell.ends_row) continue;
    ragged = ragged || (columns != 0 && columns != in_row);
    columns = in_row;
    in_row = 0;
  }
  const bool dots = std::ranges::any_of(body, [](const Token& token) {
    return token.kind == TokenKind::control && token.text.ends_with("dots");
  });
  if (ragged && dots) return opaque(span, "a matrix with dots is not read");
  if (ragged || entries.empty())
    return opaque(span, "the rows of this matrix have different lengths", DiagnosticKind::bad_syntax);
  if (determinant) return tree_.add(SyntaxKind::determinant, span, entries, columns);
  const bool vector = columns == 1 || columns == entries.size();
  return tree_.add(vector ? SyntaxKind::tuple : SyntaxKind::matrix, span, entries, columns);
}

}  // namespace rigor
