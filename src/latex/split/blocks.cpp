// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/blocks.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/split/acting.h"
#include "latex/split/beside.h"
#include "latex/split/chain.h"
#include "latex/split/conditions.h"
#include "latex/token/remarks.h"
#include "latex/unit/units.h"

namespace rigor {
namespace {

struct Block {
  Tokens tokens;
  bool related = false;  // a relation is outside all brackets
  Span span() const { return span_of(trim(tokens)); }
};

/// A block in brackets that is an equation number: `(6)`, `(2.3a)`, `(A1')`.
bool is_tag(TokenView block) {
  block = trim(block);
  if (block.size() < 3 || block.size() > 10 || !is_sign(block.front(), "(") || !is_sign(block.back(), ")"))
    return false;
  bool digit = false;
  for (const Token& token : block.subspan(1, block.size() - 2)) {
    digit = digit || token.kind == TokenKind::digit;
    const bool fits = token.kind == TokenKind::digit || is_sign_of(token, ".'-*") ||
                      (token.kind == TokenKind::letter && token.text.size() == 1);
    if (!fits) return false;
  }
  return digit;
}

/// `i, j = 1, 2, 3`: says only what every index does.
bool is_index_range(TokenView block) {
  std::string text;
  for (const Token& token : block) {
    if (!is_blank(token) && !is_spacing(token)) text += text_of({&token, 1});
  }
  if (!text.empty() && text.front() == '(' && text.back() == ')') text = text.substr(1, text.size() - 2);
  const auto equal = text.find('=');
  if (equal == std::string::npos || equal == 0) return false;
  for (std::size_t i = 0; i < equal; ++i) {
    if (i % 2 == 0 ? !is_small_letter(text[i]) : text[i] != ',') return false;
  }
  const std::string range = text.substr(equal + 1);
  return range == "1,2,3" ||
         is_one_of(range, {"1,2,3.", "1\\ldots3", "1,\\ldots,3", "1,\\dots,3", "x,y,z", "x,y,z."});
}

bool is_ornament(TokenView block) {
  return std::ranges::all_of(block, [](const Token& token) {
    return is_blank(token) || is_spacing(token) || is_sign_of(token, ".,;:") ||
           is_control_of(token, {"checkmark", "blacksquare", "qed", "Box", "square", "therefore", "because"});
  });
}

/// "or", "or else".
bool says_or(const std::string& words) {
  std::string letters = " ";
  for (const char c : words + " ") letters += is_letter(c) ? c : ' ';
  return letters.find(" or ") != std::string::npos;
}

class StatementSplitter {
 public:
  StatementSplitter(TokenView tokens, TokenUses& uses) : tokens_(tokens), uses_(uses) {}

  std::vector<WrittenChain> split() {
    cut_into_blocks();
    for (const Block& block : blocks_) add_block(block);
    for (WrittenChain& chain : chains_) {
      chain.tag = tag_;
      chain.no_sum = no_sum_;
      chain.cyclic = cyclic_;
      chain.assumed = assumed_;
      chain.alternative = alternatives_;
      if (alternatives_)
        chain.doubt = Obstacle{DiagnosticKind::restricted, "it is one of several alternatives", {}};
      if (condition_) {
        chain.condition = condition_;
        chain.condition_span = condition_span_;
      }
    }
    return std::move(chains_);
  }

 private:
  void set_condition(TokenView tokens, std::string message) {
    uses_.mark(tokens, TokenUse::condition);
    const Span span = span_of(tokens);
    if (condition_) return;
    condition_ = Obstacle{DiagnosticKind::unsupported, std::move(message), {}};
    condition_span_ = span;
  }

  /// Boundaries: wide space, words, implications; each only where an equation stands complete before it.
  void cut_into_blocks() {
    Nesting nesting(false);
    Block block;
    const auto cut = [&] {
      if (!trim(block.tokens).empty()) blocks_.push_back(std::move(block));
      block = Block{};
    };
    for (std::size_t at = 0; at < tokens_.size();) {
      const Token& token = tokens_[at];
      const int depth = nesting.enter(token);
      if (depth == 0 && is_wide_space(token)) {
        if (may_end(block, at + 1) || is_remark_end(block, at + 1)) cut();
        ++at;
        continue;
      }
      if (depth == 0 && is_words(token) && !is_script_argument(tokens_, at) && !wants_operand(block.tokens)) {
        const Argument words = argument_at(tokens_, at + 1);
        if (is_inside(block, at, words)) {
          block.tokens.insert(block.tokens.end(), tokens_.begin() + static_cast<std::ptrdiff_t>(at),
                              tokens_.begin() + static_cast<std::ptrdiff_t>(words.next));
          at = words.next;
          continue;
        }
        if (quantifies(at)) {
          uses_.mark(tokens_.subspan(at), TokenUse::remark);
          cut();
          return;  // what follows only names the symbols
        }
        const bool complete = block.related ? !ends_open(block.tokens) : trim(block.tokens).empty();
        if (const std::size_t end = complete ? note_condition(block, at, words) : at; end != at) {
          cut();
          at = end;
          continue;
        }
        const std::size_t end = remark_end(tokens_, words);
        note_words(tokens_.subspan(at, end - at), block.related || !blocks_.empty());
        cut();
        at = end;
        continue;
      }
      const bool may_close = depth == 0 && !ends_open(block.tokens);
      if (const std::size_t end = may_close ? bracketed_remark_end(tokens_, at) : at; end != at) {
        note_words(tokens_.subspan(at, end - at), block.related || !blocks_.empty());
        cut();
        while (++at < end) nesting.enter(tokens_[at]);
        continue;
      }
      if (depth == 0 && block.related) note_beside(block, at, cut);
      if (depth == 0 && relation_kind(token) == RelationKind::implies) {
        set_condition(tokens_.subspan(at, 1),
                      fmt::format("`{}` between equations is not decided yet", text_of({&token, 1})));
        cut();
        ++at;
        continue;
      }
      if (depth == 0 && (is_control(token, "therefore") || is_control(token, "forall"))) {
        cut();
        if (is_control(token, "forall")) {
          const TokenView rest = tokens_.subspan(at);
          const bool names_only =
              lists_symbols(rest.subspan(1)) && knows(symbols_in(rest.subspan(1)), tokens_.first(at));
          if (!blocks_.empty() && names_only) {
            uses_.mark(rest, TokenUse::remark);
            return;  // what follows only names the symbols
          }
          set_condition(rest, "what `\\forall` says about the equation is not read");
          at = blocks_.empty() ? at + 1 : next_wide_space(at);
          continue;
        }
        uses_.mark(tokens_.subspan(at, 1), TokenUse::remark);
        ++at;
        continue;
      }
      block.related =
          block.related || (depth == 0 && !is_script_argument(tokens_, at) &&
                            (relation_kind(token).has_value() || is_stacked_relation(tokens_, at)));
      block.tokens.push_back(token);
      ++at;
    }
    cut();
  }

  template <class Cut>
  void note_beside(const Block& block, std::size_t at, const Cut& cut) {
    switch (behind_space(block.tokens, tokens_, at)) {
      case Beside::goes_on:
        return;
      case Beside::begins:
        return cut();
      case Beside::unclear:
        if (condition_) return;
        condition_ = Obstacle{DiagnosticKind::ambiguous_reading,
                              "what follows the space can be a factor, or begin the next equation",
                              {"write `\\,` before a factor, `\\quad` before an equation"}};
        condition_span_ = tokens_[at].span;
        return;
    }
  }

  std::size_t next_wide_space(std::size_t at) const {
    while (at < tokens_.size() && !is_wide_space(tokens_[at])) ++at;
    return at;
  }

  /// `3\,\text{kg}`: a unit is no remark.
  static bool is_unit_behind(TokenView block, TokenView words) {
    const TokenView before = trim(block);
    std::size_t end = before.size();
    while (end > 0 && (is_blank(before[end - 1]) || is_spacing(before[end - 1]))) --end;
    const bool number =
        end > 0 && (before[end - 1].kind == TokenKind::digit || before[end - 1].kind == TokenKind::end_group);
    return number && is_unit_word(text_of(words), true);
  }

  /// `\text{…}` where an operand is due is part of the expression: `\text{torque} = …`, `m = \text{const}`.
  static bool wants_operand(TokenView block) { return ends_open(block) && !trim(block).empty(); }

  /// After an equation, a remark in brackets ends at a wide space as well: `(\text{Kronecker}) \quad (17)`.
  bool is_remark_end(const Block& block, std::size_t next) const {
    return !blocks_.empty() && !block.related && !ends_open(block.tokens) && !trim(block.tokens).empty() &&
           goes_on_elsewhere(next);
  }

  bool may_end(const Block& block, std::size_t next) const {
    return block.related && !ends_open(block.tokens) && goes_on_elsewhere(next);
  }

  /// Does what stands next begin anew, rather than go on with a sign?
  bool goes_on_elsewhere(std::size_t next) const {
    const std::size_t at = first_significant(tokens_, next);
    if (at >= tokens_.size()) return true;
    const Token& token = tokens_[at];
    return !relation_kind(token).has_value() && !is_sign(token, "+") && factor_joint(token) == Joint::none &&
           !is_stacked_relation(tokens_, at);
  }

  /// Do the words belong to the expression that they occur in? At the left end and within a side, what is no
  /// remark does; so does what could be a factor after the equation: `E = 2\,\text{energy}`.
  bool is_inside(const Block& block, std::size_t at, const Argument& words) const {
    if (writes_mathematics(tokens_, at) || is_unit_behind(block.tokens, words.content)) return true;
    const std::string said = text_of(words.content);
    const Remark kind = remark_of(said);
    const TokenView before = trim(block.tokens);
    const std::size_t behind = first_significant(tokens_, words.next);
    if (kind == Remark::no_sum || kind == Remark::cyclic || kind == Remark::quantifier) return false;
    const bool joins = kind == Remark::connective;
    if (!block.related && (!before.empty() || blocks_.empty())) {
      const bool opens = before.empty() && behind < tokens_.size() && !is_operator(tokens_[behind]);
      return !(opens && (joins || (kind == Remark::remark && said.ends_with(":"))));
    }
    const bool apart = before.empty() || is_wide_space(before.back()) || is_sign_of(before.back(), ",;.") ||
                       stands_apart(said);
    return kind == Remark::remark && !apart;
  }

  static bool is_operator(const Token& token) {
    return is_sign_of(token, "+-") || factor_joint(token) != Joint::none || relation_kind(token).has_value();
  }

  /// `\text{for } x > 0` after an equation: the place after it; `at` if it is not read to its end.
  std::size_t note_condition(const Block& block, std::size_t at, const Argument& words) {
    if (!block.related && blocks_.empty()) return at;
    Nesting nesting(false);
    std::size_t end = words.next;
    for (; end < tokens_.size(); ++end) {
      if (nesting.enter(tokens_[end]) != 0) continue;
      if (relation_kind(tokens_[end]) == RelationKind::implies) break;
      if (is_wide_space(tokens_[end]) && !trim(tokens_.subspan(words.next, end - words.next)).empty()) break;
    }
    return assume(tokens_.subspan(at, end - at), conditions_behind_words) ? end : at;
  }

  template <class Read>
  bool assume(TokenView tokens, Read read) {
    const auto conditions = read(tokens);
    if (!conditions) return false;
    uses_.mark(tokens, TokenUse::remark);
    for (const Tokens& condition : *conditions) assumed_.push_back(chain_of(condition, uses_));
    return true;
  }

  /// Are all of these symbols of the statement?
  static bool knows(const std::set<std::string>& symbols, TokenView statement) {
    return std::ranges::includes(symbols_in(statement), symbols);
  }

  /// `\text{for all } a, b` to the end of the statement, with symbols that are before it.
  bool quantifies(std::size_t at) const {
    const Argument words = argument_at(tokens_, at + 1);
    const TokenView rest = tokens_.subspan(words.next);
    const std::string said = text_of(words.content);
    const bool named = remark_of(said) == Remark::quantifier ||
                       (!trim(rest).empty() && remark_of(said + " x") == Remark::quantifier);
    return named && lists_symbols(rest) && knows(symbols_in(rest), tokens_.first(at)) &&
           knows(symbols_in_words(said), tokens_.first(at));
  }

  void note_words(TokenView tokens, bool after_equation) {
    const std::string words = spoken(tokens);
    Remark kind = remark_of(words);
    if (!knows(symbols_in_words(words), tokens_) || (kind == Remark::cyclic && !after_equation))
      kind = Remark::unread;
    alternatives_ = alternatives_ || (kind == Remark::connective && after_equation && says_or(words));
    no_sum_ = no_sum_ || kind == Remark::no_sum;
    cyclic_ = cyclic_ || kind == Remark::cyclic;
    if (kind != Remark::unread) return uses_.mark(tokens, TokenUse::remark);
    set_condition(tokens, fmt::format("the words `{}` next to the equation are not read", words));
  }

  void add_block(const Block& block) {
    const TokenView tokens = trim(block.tokens);
    if (tokens.empty()) return;
    if (is_ornament(tokens)) return uses_.mark(tokens, TokenUse::layout);
    if (is_index_range(tokens) && ranges_over_known(tokens)) return uses_.mark(tokens, TokenUse::remark);
    if (is_tag(tokens)) {
      tag_ = text_of(tokens);
      return uses_.mark(tokens, TokenUse::name);
    }
    if (!chains_.empty() && relates_index_letters(tokens)) {
      if (assume(tokens, conditions_in)) return;
      set_condition(tokens,
                    fmt::format("the condition `{}` next to the equation is not read yet", text_of(tokens)));
      return;
    }
    if (!has_relation(tokens) && !chains_.empty()) {
      add_remark(tokens);
      return;
    }
    add_equations(tokens);
  }

  /// `(\text{no sum})`, `(a, b constant)`: signs next to an equation that are no equation.
  void add_remark(TokenView tokens) {
    const Remark whole = remark_of(spoken(tokens));
    if (whole == Remark::no_sum || whole == Remark::cyclic) return note_words(tokens, true);
    std::string words;
    bool only_words = true;
    for (std::size_t at = 0; at < tokens.size();) {
      if (is_words(tokens[at]) || is_control(tokens[at], "mathrm")) {
        const Argument argument = argument_at(tokens, at + 1);
        words += text_of(argument.content) + " ";
        at = argument.next;
        continue;
      }
      only_words = only_words && (is_sign_of(tokens[at], "()[]") || is_ornament(tokens.subspan(at, 1)));
      ++at;
    }
    if (only_words && remark_of(words) != Remark::unread && knows(symbols_in_words(words), tokens_))
      return uses_.mark(tokens, TokenUse::remark);
    if (is_sign(tokens.front(), "(") && assume(tokens, conditions_in)) return;
    set_condition(tokens, fmt::format("`{}` next to the equation is not read, and may change what it says",
                                      text_of(tokens)));
  }

  /// Of `i, j = 1, 2, 3`: do the letters occur in the statement elsewhere, too?
  bool ranges_over_known(TokenView range) const {
    const auto equal = std::ranges::find_if(range, [](const Token& token) { return is_sign(token, "="); });
    std::size_t known = 0;
    for (const std::string& letter : symbols_in({range.begin(), equal})) {
      const auto same = [&](const Token& token) { return token.text == letter; };
      known += std::ranges::count_if(tokens_, same) > std::ranges::count_if(range, same) ? 1 : 0;
    }
    return known == symbols_in({range.begin(), equal}).size();
  }

  /// Commas separate equations where every piece is one; `a = b, i = 1, 2, 3` keeps its range out.
  void add_equations(TokenView tokens) {
    std::vector<TokenView> pieces;
    Nesting nesting(false);
    std::size_t begin = 0;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (nesting.enter(tokens[at]) != 0) continue;
      if (!is_sign_of(tokens[at], ",;")) continue;
      const TokenView rest = tokens.subspan(at + 1);
      const TokenView piece = trim(tokens.subspan(begin, at - begin));
      if (!piece.empty() && has_relation(piece) && rest.size() <= 24 && is_index_range(rest) &&
          ranges_over_known(rest)) {
        uses_.mark(tokens.subspan(at), TokenUse::remark);
        tokens = tokens.first(at);
        break;
      }
      pieces.push_back(piece);
      begin = at + 1;
    }
    pieces.push_back(trim(tokens.subspan(begin)));
    std::erase_if(pieces, [](TokenView piece) { return is_ornament(piece); });
    const bool separate = std::ranges::all_of(pieces, has_relation);
    if (!separate) pieces = {tokens};
    uses_.mark(tokens, TokenUse::layout);  // commas between; what is between them follows
    for (const TokenView piece : pieces) {
      if (!chains_.empty() && relates_index_letters(piece)) {
        if (assume(piece, conditions_in)) continue;
        set_condition(piece,
                      fmt::format("the condition `{}` next to the equation is not read yet", text_of(piece)));
      } else {
        chains_.push_back(chain_of(piece, uses_));
      }
    }
  }

  TokenView tokens_;
  TokenUses& uses_;
  std::vector<Block> blocks_;
  std::vector<WrittenChain> chains_;
  std::vector<WrittenChain> assumed_;
  std::string tag_;
  std::optional<Obstacle> condition_;
  Span condition_span_;
  bool no_sum_ = false;
  bool cyclic_ = false;
  bool alternatives_ = false;
};

}  // namespace

std::vector<WrittenChain> split_statement(TokenView tokens, TokenUses& uses) {
  return StatementSplitter(tokens, uses).split();
}

}  // namespace rigor
