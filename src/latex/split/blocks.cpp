// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/ascii.h"
#include "latex/split/acting.h"
#include "latex/split/beside.h"
#include "latex/split/chain.h"
#include "latex/split/conditions.h"
#include "latex/split/inference.h"
#include "latex/split/line_notes.h"
#include "latex/token/differential.h"
#include "latex/token/remarks.h"
#include "latex/unit/units.h"

namespace rigor {
namespace {

struct Block {
  Tokens tokens;
  bool related = false;  // a relation is outside all brackets
  Link link = Link::none;
  bool before_link = false;  // something is inferred from it directly
  Span span() const { return span_of(trim(tokens)); }
};

class StatementSplitter {
 public:
  StatementSplitter(TokenView tokens, TokenUses& uses) : tokens_(tokens), uses_(uses), notes_(tokens, uses) {}

  std::vector<WrittenChain> split() {
    cut_into_blocks();
    for (const Block& block : blocks_) add_linked(block);
    for (WrittenChain& chain : chains_) {
      chain.tag = tag_;
      notes_.apply(chain);
    }
    return std::move(chains_);
  }

 private:
  /// Boundaries: wide space, words, implications; each only where an equation stands complete before it.
  void cut_into_blocks() {
    Nesting nesting(false);
    Block block;
    const auto cut = [&] {
      if (!trim(block.tokens).empty()) {
        block.link = std::exchange(link_, Link::none);
        blocks_.push_back(std::move(block));
      }
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
        const std::size_t end = note_words(block, at, words);
        cut();
        link_behind(at);
        at = end;
        continue;
      }
      const bool may_close = depth == 0 && !ends_open(block.tokens);
      if (const std::size_t end = may_close ? bracketed_remark_end(tokens_, at) : at; end != at) {
        notes_.note_remark(tokens_.subspan(at, end - at), block.related || !blocks_.empty());
        cut();
        while (++at < end) nesting.enter(tokens_[at]);
        continue;
      }
      if (depth == 0 && block.related) note_beside(block, at, cut);
      if (const auto link = depth == 0 ? link_at(tokens_, at) : std::nullopt;
          link && may_link(block, token)) {
        const TokenView arrow = tokens_.subspan(at, link->next - at);
        uses_.mark(arrow, TokenUse::relation);
        if (link->marked) notes_.set_doubt(arrow);
        if (link->link == Link::ground)
          notes_.set_condition(arrow, "what is inferred from what comes behind it is not decided yet");
        cut();
        infer(link->link);
        while (++at < link->next) nesting.enter(tokens_[at]);
        continue;
      }
      if (depth == 0 && is_control(token, "forall")) {
        cut();
        const TokenView rest = tokens_.subspan(at);
        const bool names_only =
            lists_symbols(rest.subspan(1)) && knows(symbols_in(rest.subspan(1)), tokens_.first(at));
        if (!blocks_.empty() && names_only) {
          uses_.mark(rest, TokenUse::remark);
          return;  // what follows only names the symbols
        }
        if (blocks_.empty()) {
          notes_.set_condition(rest, "what `\\forall` says about the equation is not read");
          ++at;
        } else {
          const std::size_t end = next_wide_space(at);
          notes_.set_doubt(tokens_.subspan(at, end - at));
          at = end;
        }
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

  /// `x \quad\to\quad y` relates two expressions; only behind an equation it is an arrow between two.
  static bool may_link(const Block& block, const Token& arrow) {
    return block.related || relation_kind(arrow) != RelationKind::other;
  }

  /// What stands before is assumed for what comes, or the other way round.
  void infer(Link link) {
    const auto last =
        std::find_if(blocks_.rbegin(), blocks_.rend(), [](const Block& each) { return each.related; });
    if (last != blocks_.rend() && link != Link::ground) last->before_link = true;
    link_ = link;
  }

  /// "hence", "where" at `at` after an equation, or at the beginning of the line.
  void link_behind(std::size_t at) {
    const std::string words = text_of(argument_at(tokens_, at + 1).content);
    if (is_detail(words)) return infer(Link::detail);
    if (remark_of(words) == Remark::connective && concludes(words)) infer(Link::conclusion);
  }

  template <class Cut>
  void note_beside(const Block& block, std::size_t at, const Cut& cut) {
    switch (behind_space(block.tokens, tokens_, at)) {
      case Beside::goes_on:
        return;
      case Beside::begins:
        return cut();
      case Beside::unclear:
        notes_.set_condition(tokens_[at].span,
                             {DiagnosticKind::ambiguous_reading,
                              "what follows the space can be a factor, or begin the next equation",
                              {"write `\\,` before a factor, `\\quad` before an equation"}});
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
      const bool labels = kind == Remark::remark && said.ends_with(":");
      return !(opens && (joins || labels || leads(tokens_, said, words.next)));
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
    const std::size_t end = condition_end(tokens_, words.next);
    if (!block.related && blocks_.empty() && !has_relation(tokens_.subspan(end))) return at;
    return notes_.assume(tokens_.subspan(at, end - at), conditions_behind_words) ? end : at;
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

  /// The place after words and what belongs to them.
  std::size_t note_words(const Block& block, std::size_t at, const Argument& words) {
    const std::string said = text_of(words.content);
    const bool after_equation = block.related || !blocks_.empty() || leads(tokens_, said, words.next);
    if (after_equation && is_detail(said) && opens_equation(tokens_, words.next)) {
      uses_.mark(tokens_.subspan(at, words.next - at), TokenUse::remark);
      return words.next;
    }
    std::size_t end = remark_end(tokens_, words);
    const TokenView before = trim(block.tokens);
    const bool opens = opens_a_condition(said);
    const bool apart = opens || before.empty() || is_wide_space(before.back()) ||
                       is_sign_of(before.back(), ",;.") || stands_apart(said);
    if (!after_equation || !apart || remark_of(said) != Remark::unread) {
      notes_.note_remark(tokens_.subspan(at, end - at), after_equation);
      return end;
    }
    // "unless $x > 0$": what stands behind words that are not read belongs to them.
    if (opens || !begins_apart(end)) end = condition_end(tokens_, end);
    notes_.note_restriction(tokens_.subspan(at, end - at));
    return end;
  }

  /// Does a wide space or a comma set apart what stands there, if anything does?
  [[nodiscard]] bool begins_apart(std::size_t at) const {
    while (at < tokens_.size() && is_blank(tokens_[at])) ++at;
    return at >= tokens_.size() || is_wide_space(tokens_[at]) || is_sign_of(tokens_[at], ",;");
  }

  /// Its equations hang on those before it as its arrow says; an arrow after it makes a premise of it.
  void add_linked(const Block& block) {
    const std::size_t first = chains_.size();
    add_block(block);
    if (block.link != Link::none) {
      inherited_ = block.link;
    } else if (block.before_link) {
      inherited_ = Link::none;
    }
    for (std::size_t k = first; k < chains_.size(); ++k) {
      WrittenChain& chain = chains_[k];
      if (inherited_ == Link::conclusion) chain.inference = Inference::conclusion;
      if (inherited_ == Link::equivalence) chain.inference = Inference::equivalence;
      chain.explains = inherited_ == Link::detail;
      chain.premise = block.before_link;
      if (block.link != Link::ground) continue;
      for (std::size_t earlier = 0; earlier < first; ++earlier) chains_[earlier].assumed.push_back(chain);
    }
  }

  void add_block(const Block& block) {
    TokenView tokens = trim(block.tokens);
    if (tokens.empty()) return;
    if (is_ornament(tokens)) return uses_.mark(tokens, TokenUse::layout);
    if (is_index_range(tokens) && notes_.ranges_over_known(tokens))
      return uses_.mark(tokens, TokenUse::remark);
    if (is_equation_number(tokens)) {
      tag_ = text_of(tokens);
      return uses_.mark(tokens, TokenUse::name);
    }
    const bool concluded = block.link == Link::conclusion || block.link == Link::equivalence;
    if (!chains_.empty() && !concluded) {  // an order behind an arrow is a claim, and no condition
      const TokenView said = without_stop(tokens);
      uses_.mark(tokens.subspan(said.size()), TokenUse::layout);
      tokens = said;
      if (relates_index_letters(tokens)) {
        if (!notes_.assume(tokens, conditions_in)) notes_.set_doubt(tokens);
        return;
      }
      if (lists_values(tokens) && notes_.ranges_over_known(tokens)) return notes_.set_doubt(tokens, true);
    }
    if (!has_relation(tokens) && !chains_.empty()) {
      return notes_.note_aside(tokens);
    }
    add_equations(tokens, concluded);
  }

  /// Commas separate equations where every piece is one; `a = b, i = 1, 2, 3` keeps its range out.
  void add_equations(TokenView tokens, bool concluded) {
    std::vector<TokenView> pieces;
    Nesting nesting(false);
    std::size_t begin = 0;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (nesting.enter(tokens[at]) != 0) continue;
      if (!is_sign_of(tokens[at], ",;")) continue;
      const TokenView rest = tokens.subspan(at + 1);
      const TokenView piece = trim(tokens.subspan(begin, at - begin));
      const bool after_equation = !piece.empty() && has_relation(piece);
      if (after_equation && rest.size() <= 24 && is_index_range(rest) && notes_.ranges_over_known(rest)) {
        uses_.mark(tokens.subspan(at), TokenUse::remark);
        tokens = tokens.first(at);
        break;
      }
      if (after_equation && lists_values(rest) && notes_.ranges_over_known(rest)) {
        notes_.set_doubt(tokens.subspan(at + 1), true);
        uses_.mark(tokens.subspan(at, 1), TokenUse::layout);
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
      if (!chains_.empty() && !concluded && relates_index_letters(piece)) {
        if (!notes_.assume(piece, conditions_in)) notes_.set_doubt(piece);
      } else {
        chains_.push_back(chain_of(piece, uses_));
      }
    }
  }

  TokenView tokens_;
  TokenUses& uses_;
  std::vector<Block> blocks_;
  std::vector<WrittenChain> chains_;
  LineNotes notes_;
  std::string tag_;
  Link link_ = Link::none;       // before the block that comes next
  Link inherited_ = Link::none;  // of the equation added last
};

}  // namespace

std::vector<WrittenChain> split_statement(TokenView tokens, TokenUses& uses) {
  return StatementSplitter(tokens, uses).split();
}

}  // namespace rigor
