// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.h"
#include "latex/split/blocks.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/state_places.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// Controls that vanish together with one argument; of `\textcolor`, what is coloured stays.
bool vanishes_with_argument(const Token& token) {
  return is_control_of(token, {"phantom", "vphantom", "vspace", "color", "footnote", "hypertarget", "index",
                               "setcounter", "footnotemark", "textcolor"});
}

/// `\hskip 2pt`, `\kern-3mu`: the length stands without braces.
bool takes_bare_length(const Token& token) {
  return is_control_of(token, {"hskip", "vskip", "mskip", "kern", "mkern", "hglue"});
}

/// The place after `2pt`, `-.5em`, `\smallskipamount`; `at` where no length stands.
std::size_t behind_length(TokenView tokens, std::size_t at) {
  std::size_t end = skip_blank(tokens, at);
  if (is_kind_at(tokens, end, TokenKind::control)) {
    return is_length(tokens.subspan(end, 1)) ? end + 1 : at;
  }
  while (end < tokens.size() && (tokens[end].kind == TokenKind::digit || is_sign_of(tokens[end], ".-+")))
    ++end;
  end = skip_blank(tokens, end);
  if (end + 2 > tokens.size() || !is_length(tokens.subspan(at, end + 2 - at))) return at;
  return end + 2;
}

/// As it would be printed, at \tag.
std::string tag_at(TokenView tokens, std::size_t at) {
  const bool starred = at + 1 < tokens.size() && is_sign(tokens[at + 1], "*");
  const std::string text = text_of(argument_at(tokens, at + (starred ? 2 : 1)).content);
  return starred ? text : fmt::format("({})", text);
}

class RowReader {
 public:
  RowReader(TokenView tokens, Diagnostics& diagnostics, TokenUses& uses)
      : tokens_(tokens), diagnostics_(diagnostics), uses_(uses) {}

  std::vector<Row> read() {
    while (at_ < tokens_.size()) step();
    for (const Open& open : open_) {
      diagnostics_.push_back({DiagnosticKind::unbalanced, open.span,
                              fmt::format("`\\begin{{{}}}` is not closed in this display", open.name)});
    }
    finish_row();
    if (rows_.empty()) rows_.emplace_back();
    return std::move(rows_);
  }

 private:
  struct Open {
    std::string name;
    bool transparent;
    Span span;
  };

  Tokens& cell() { return row_.cells.back(); }

  /// To the place after what means nothing more than `use`.
  void leave(std::size_t next, TokenUse use = TokenUse::layout) {
    uses_.mark(tokens_.subspan(at_, std::min(next, tokens_.size()) - at_), use);
    at_ = next;
  }

  /// Nested in braces or in an environment that is one piece of an expression (a matrix, cases).
  bool inside() const {
    return braces_ > 0 || std::ranges::any_of(open_, [](const Open& open) { return !open.transparent; });
  }

  void finish_row() {
    lefts_.clear();
    const bool empty =
        std::ranges::all_of(row_.cells, [](const Tokens& tokens) { return trim(tokens).empty(); });
    if (empty && !rows_.empty() && rows_.back().tag.empty()) rows_.back().tag = row_.tag;
    if (empty && !rows_.empty() && rows_.back().label.empty()) rows_.back().label = row_.label;
    const bool after_text = empty && row_.after_text;
    if (!empty) rows_.push_back(std::move(row_));
    row_ = Row{};
    row_.after_text = after_text;
  }

  void step() {
    const Token& token = tokens_[at_];
    if (vanishes_with_argument(token))
      return leave(argument_at(tokens_, skip_star(at_ + 1)).next, TokenUse::aside);
    if (takes_bare_length(token)) return leave(behind_length(tokens_, at_ + 1), TokenUse::aside);
    if (token.kind == TokenKind::control && control(token)) return;
    if (token.kind == TokenKind::align && !inside()) {
      const bool in_system = !open_.empty() && open_.back().name.ends_with("cases");
      if (in_system && std::ranges::any_of(row_.cells, has_relation)) {
        Token space = token;  // `x = r & r > 0`: a condition next to its equation
        space.kind = TokenKind::control;
        space.text = "quad";
        cell().push_back(space);
      } else {
        row_.cells.emplace_back();
      }
      ++at_;
      return;
    }
    if (token.kind == TokenKind::begin_group) ++braces_;
    if (token.kind == TokenKind::end_group) braces_ = std::max(0, braces_ - 1);
    cell().push_back(token);
    if (is_control_of(token, {"lvert", "rvert"}) && is_bar_of_one_state(tokens_, at_))
      cell().back().text = "vert";
    ++at_;
  }

  /// True if the control was dealt with here.
  bool control(const Token& token) {
    if (token.text == "label" || token.text == "tag") return tag_or_label(token.text == "tag");
    if (token.text == "begin" || token.text == "end") return environment(token);
    if (is_bracket_size(token)) return sized_bracket(token);
    if (is_transparent(token)) {
      const Argument argument = argument_at(tokens_, at_ + 1);
      if (!has_relation(argument.content)) return false;
      uses_.mark(tokens_.subspan(at_, 1), TokenUse::layout);
      cell().insert(cell().end(), argument.content.begin(), argument.content.end());  // \\boxed{a = b}
      at_ = argument.next;
      return true;
    }
    if (token.text == "intertext" || token.text == "shortintertext") {
      leave(argument_at(tokens_, at_ + 1).next, TokenUse::aside);
      finish_row();
      row_.after_text = true;
      return true;
    }
    if (token.text == "hspace" || token.text == "hphantom") {
      leave(argument_at(tokens_, skip_star(at_ + 1)).next, TokenUse::aside);
      Token space = token;
      space.text = "quad";
      cell().push_back(space);
      return true;
    }
    if ((token.text == "\\" || token.text == "cr" || token.text == "newline") && !inside()) {
      const std::size_t next = skip_star(at_ + 1);
      const Argument length = optional_argument_at(tokens_, next);
      leave(is_length(length.content) ? length.next : next);
      finish_row();
      return true;
    }
    return false;
  }

  std::size_t skip_star(std::size_t at) const { return is_sign_at(tokens_, at, "*") ? at + 1 : at; }

  bool tag_or_label(bool tag) {
    const Argument argument = argument_at(tokens_, skip_star(at_ + 1));
    if (tag) {
      row_.tag = tag_at(tokens_, at_);
      row_.in_tag.assign(argument.content.begin(), argument.content.end());
    } else {
      row_.label = text_of(argument.content);
    }
    leave(argument.next, TokenUse::name);
    return true;
  }

  bool sized_bracket(const Token& token) {
    const bool opens = token.text == "left" || token.text.back() == 'l';
    const bool closes = token.text == "right" || token.text.back() == 'r';
    std::size_t at = skip_blank(tokens_, at_ + 1);
    uses_.mark(tokens_.subspan(at_, 1), TokenUse::layout);
    if (at >= tokens_.size()) {
      at_ = at;
      return true;
    }
    Token bracket = tokens_[at];
    bracket.span = cover(token.span, bracket.span);
    const bool of_state = is_bar_of_one_state(tokens_, at);  // `\\left|n\\right\\rangle`
    const bool plain_bar = !of_state && (is_sign(bracket, "|") || is_control(bracket, "vert"));
    const bool double_bar = is_control(bracket, "|") || is_control(bracket, "Vert");
    const bool brace = is_control(bracket, "{") || is_control(bracket, "lbrace");
    const std::size_t behind = skip_blank(tokens_, at + 1);
    if (is_sign_of(bracket, "<>")) {  // `\left<x\right>`
      bracket.text = is_sign(bracket, "<") ? "langle" : "rangle";
      bracket.kind = TokenKind::control;
    }
    if (opens && brace && is_control_at(tokens_, behind, "begin")) {
      leave(behind);  // the brace of a system of equations, which `\\right.` ends
      behind_brace_ = behind;
      return true;
    }
    // `\biggl|_{x=0}`: a bar with a subscript opens nothing.
    const bool at_a_place = opens && plain_bar && is_kind_at(tokens_, behind, TokenKind::subscript);
    if ((plain_bar || double_bar) && (opens || closes) && !at_a_place) {
      bracket.kind = TokenKind::control;
      bracket.text = plain_bar ? (opens ? "lvert" : "rvert") : (opens ? "lVert" : "rVert");
    }
    if (token.text == "left") lefts_.push_back({row_.cells.size(), cell().size(), is_sign(bracket, ".")});
    if (token.text == "right" && !lefts_.empty()) {
      const bool script = is_kind_at(tokens_, behind, TokenKind::subscript);
      if (plain_bar && script && lefts_.back().invisible) bracket.text = "vert";  // it closes no bracket
      if (plain_bar && script) hold_together(lefts_.back(), bracket);
      lefts_.pop_back();
    }
    if (is_sign(bracket, ".")) {
      uses_.mark(tokens_.subspan(at, 1), TokenUse::layout);
    } else {
      cell().push_back(bracket);
    }
    at_ = at + 1;
    return true;
  }

  struct Left {
    std::size_t cells;  // of the row, and tokens of the last of them, when it came
    std::size_t size;
    bool invisible;
  };

  /// `\left. a + b \right|_{…}`: the bar is about all of it, so it comes as `{a + b}`.
  void hold_together(const Left& left, const Token& bar) {
    constexpr std::size_t longest = 1000;  // what is inserted moves the tokens after it
    if (!left.invisible || left.cells != row_.cells.size() || left.size > cell().size() ||
        cell().size() - left.size > longest)
      return;
    const auto at = cell().begin() + static_cast<std::ptrdiff_t>(left.size);
    const Span begin = at == cell().end() ? bar.span : at->span;
    cell().insert(at, Token{TokenKind::begin_group, "{", {begin.file, begin.begin, begin.begin}});
    const Span end{bar.span.file, bar.span.begin, bar.span.begin};
    cell().push_back(Token{TokenKind::end_group, "}", end});
  }

  bool environment(const Token& token) {
    const Argument argument = argument_at(tokens_, at_ + 1);
    const std::string name = text_of(argument.content);
    std::size_t next = argument.next;
    if (token.text == "begin") {
      const bool row_is_empty = row_.cells.size() == 1 && trim(row_.cells[0]).empty();
      const bool system =
          (name == "cases" || name == "dcases" || (name == "array" && at_ == behind_brace_)) &&
          row_is_empty && !inside() && is_whole_row(next, name);
      const bool transparent = !inside() && (is_transparent_environment(name) || system);
      open_.push_back({name, transparent, cover(token.span, argument.content)});
      if (transparent) {
        next = behind_position(next);
        if (name.starts_with("alignat") || name == "alignedat" || name == "array")
          next = argument_at(tokens_, next).next;
      }
    } else if (!open_.empty() && open_.back().name == name) {
      const bool transparent = open_.back().transparent;
      open_.pop_back();
      if (transparent) {
        leave(next);
        return true;
      }
      copy_until(next);
      return true;
    } else {
      diagnostics_.push_back(
          {DiagnosticKind::unbalanced, token.span, fmt::format("`\\end{{{}}}` closes nothing here", name)});
    }
    if (!open_.empty() && token.text == "begin" && open_.back().transparent) {
      leave(next);
    } else {
      copy_until(next);
    }
    return true;
  }

  /// `\begin{aligned}[t]`: nothing but a letter of position, so that `[A, B]` stays.
  std::size_t behind_position(std::size_t at) const {
    const Argument position = optional_argument_at(tokens_, at);
    const std::string text = text_of(position.content);
    return text == "t" || text == "b" || text == "c" ? position.next : at;
  }

  void copy_until(std::size_t next) {
    cell().insert(cell().end(), tokens_.begin() + static_cast<std::ptrdiff_t>(at_),
                  tokens_.begin() + static_cast<std::ptrdiff_t>(next));
    at_ = next;
  }

  /// A `cases` with nothing but punctuation after its end is a system of equations, not a value.
  bool is_whole_row(std::size_t at, std::string_view name) const {
    for (std::size_t i = at; i < tokens_.size(); ++i) {
      if (!is_control(tokens_[i], "end")) continue;
      const Argument argument = argument_at(tokens_, i + 1);
      if (text_of(argument.content) != name) continue;
      std::size_t behind = skip_blank(tokens_, argument.next);
      if (is_control_at(tokens_, behind, "right") &&
          is_sign_at(tokens_, skip_blank(tokens_, behind + 1), "."))
        behind = skip_blank(tokens_, skip_blank(tokens_, behind + 1) + 1);
      while (behind < tokens_.size() && (is_sign_of(tokens_[behind], ".,") || is_blank(tokens_[behind]))) {
        ++behind;
      }
      return behind >= tokens_.size() || is_control(tokens_[behind], "\\") ||
             is_wide_space(tokens_[behind]) || is_control_of(tokens_[behind], {"tag", "label", "end"});
    }
    return false;
  }

  TokenView tokens_;
  Diagnostics& diagnostics_;
  TokenUses& uses_;
  std::size_t at_ = 0;
  std::size_t behind_brace_ = 0;  // the place behind the last `\\left\\{` of a system
  int braces_ = 0;
  std::vector<Open> open_;
  std::vector<Left> lefts_;
  std::vector<Row> rows_;
  Row row_;
};

}  // namespace

std::vector<Row> read_rows(TokenView tokens, Diagnostics& diagnostics, TokenUses& uses) {
  return RowReader(tokens, diagnostics, uses).read();
}

std::vector<std::string> tags_in(TokenView tokens) {
  std::vector<std::string> tags;
  for (std::size_t at = 0; at < tokens.size(); ++at)
    if (is_control(tokens[at], "tag")) tags.push_back(tag_at(tokens, at));
  return tags;
}

}  // namespace rigor
