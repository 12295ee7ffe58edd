// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/line_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/split/beside.h"
#include "latex/split/blocks.h"
#include "latex/split/chain.h"
#include "latex/split/conditions.h"
#include "latex/token/differential.h"
#include "latex/token/remarks.h"

namespace rigor {
namespace {

/// "or", "or else".
bool says_or(const std::string& words) {
  std::string letters = " ";
  for (const char c : words + " ") letters += is_letter(c) ? c : ' ';
  return letters.find(" or ") != std::string::npos;
}

}  // namespace

bool knows(const std::set<std::string>& symbols, TokenView tokens) {
  return std::ranges::includes(symbols_in(tokens), symbols);
}

bool is_detail(const std::string& words) {
  std::string letters = lowered(words);
  for (char& c : letters) c = is_letter(c) ? c : ' ';
  const auto first = letters.find_first_not_of(' ');
  if (first == std::string::npos) return false;
  const auto last = letters.find_last_not_of(' ');
  return is_one_of(letters.substr(first, last - first + 1), {"where", "with", "and where", "in which"});
}

void LineNotes::set_condition(TokenView tokens, std::string message) {
  uses_.mark(tokens, TokenUse::condition);
  set_condition(span_of(tokens), {DiagnosticKind::unsupported, std::move(message), {}});
}

void LineNotes::set_condition(Span span, Obstacle obstacle) {
  if (condition_) return;
  condition_ = std::move(obstacle);
  condition_span_ = span;
}

void LineNotes::set_doubt(TokenView tokens, bool counts) {
  uses_.mark(tokens, TokenUse::condition);
  only_counts_ = counts && (!doubt_ || only_counts_);
  if (doubt_) return;
  std::string words = spoken(without_stop(tokens));
  while (!words.empty() && words.back() == ' ') words.pop_back();
  doubt_ = Obstacle{
      DiagnosticKind::restricted, fmt::format("`{}` next to it is not read, and may restrict it", words), {}};
}

void LineNotes::note_remark(TokenView tokens, bool after_equation) {
  const std::string words = spoken(tokens);
  Remark kind = remark_of(words);
  if (!knows(symbols_in_words(words), line_) || (kind == Remark::cyclic && !after_equation))
    kind = Remark::unread;
  alternatives_ = alternatives_ || (kind == Remark::connective && after_equation && says_or(words));
  no_sum_ = no_sum_ || kind == Remark::no_sum;
  cyclic_ = cyclic_ || kind == Remark::cyclic;
  if (kind != Remark::unread) return uses_.mark(tokens, TokenUse::remark);
  set_condition(tokens, fmt::format("the words `{}` next to the equation are not read", words));
}

void LineNotes::note_restriction(TokenView tokens) {
  const std::string words = spoken(tokens);
  if (can_only_restrict(words)) return set_doubt(tokens);
  set_condition(tokens, fmt::format("the words `{}` next to the equation are not read", words));
}

void LineNotes::note_aside(TokenView tokens) {
  const Remark whole = remark_of(spoken(tokens));
  if (whole == Remark::no_sum || whole == Remark::cyclic) return note_remark(tokens, true);
  std::string words;
  bool only_words = true;
  bool relates = false;
  for (std::size_t at = 0; at < tokens.size();) {
    if (is_words(tokens[at]) || is_control(tokens[at], "mathrm")) {
      const Argument argument = argument_at(tokens, at + 1);
      words += text_of(argument.content) + " ";
      at = argument.next;
      continue;
    }
    relates = relates || relation_kind(tokens[at]).has_value();
    only_words = only_words && (is_sign_of(tokens[at], "()[]") || is_ornament(tokens.subspan(at, 1)));
    ++at;
  }
  if (only_words && remark_of(words) != Remark::unread && knows(symbols_in_words(words), line_))
    return uses_.mark(tokens, TokenUse::remark);
  const bool bracketed = is_sign_of(tokens.front(), "([");
  if (bracketed && assume(tokens, conditions_in)) return;
  const bool restricts = words.empty() ? bracketed && relates : can_only_restrict(words);
  if (restricts && !(bracketed && bracket_end(tokens, 0) != tokens.size()))
    return set_doubt(tokens, bracketed && lists_values(tokens.subspan(1, tokens.size() - 2)));
  set_condition(tokens, fmt::format("`{}` next to the equation is not read, and may change what it says",
                                    text_of(tokens)));
}

bool LineNotes::assume(TokenView tokens, std::optional<std::vector<Tokens>> (*read)(TokenView)) {
  const auto conditions = read(tokens);
  if (!conditions) return false;
  uses_.mark(tokens, TokenUse::remark);
  for (const Tokens& condition : *conditions) assumed_.push_back(chain_of(condition, uses_));
  return true;
}

bool LineNotes::ranges_over_known(TokenView range) const {
  const auto relation = std::ranges::find_if(
      range, [](const Token& token) { return relation_kind(token) || is_control(token, "in"); });
  return std::ranges::all_of(symbols_in({range.begin(), relation}), [&](const std::string& letter) {
    const auto same = [&](const Token& token) { return token.text == letter; };
    return std::ranges::count_if(line_, same) > std::ranges::count_if(range, same);
  });
}

void LineNotes::apply(WrittenChain& chain) const {
  chain.no_sum = no_sum_;
  chain.cyclic = cyclic_;
  chain.assumed.insert(chain.assumed.begin(), assumed_.begin(), assumed_.end());
  chain.alternative = alternatives_;
  chain.doubt = doubt_;
  chain.only_counts = only_counts_ && !alternatives_;
  if (alternatives_)
    chain.doubt = Obstacle{DiagnosticKind::restricted, "it is one of several alternatives", {}};
  if (!condition_) return;
  chain.condition = condition_;
  chain.condition_span = condition_span_;
}

}  // namespace rigor
