// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/inference.h"

#include "latex/split/beside.h"
#include "latex/split/blocks.h"
#include "latex/split/line_notes.h"
#include "latex/token/differential.h"
#include "latex/token/remarks.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

Link link_of(const Token& token) {
  if (is_control_of(token, {"Leftarrow", "Longleftarrow", "impliedby"})) return Link::ground;
  const bool both =
      is_control_of(token, {"iff", "Leftrightarrow", "Longleftrightarrow"}) || token.text == "⇔";
  return both ? Link::equivalence : Link::conclusion;
}

bool is_wide_before(TokenView tokens, std::size_t at) {
  while (at > 0 && is_blank(tokens[at - 1])) --at;
  return at > 0 && is_wide_space(tokens[at - 1]);
}

bool is_wide_behind(TokenView tokens, std::size_t at) {
  while (at < tokens.size() && is_blank(tokens[at])) ++at;
  return at < tokens.size() && is_wide_space(tokens[at]);
}

bool is_any_space(const Token& token) { return is_blank(token) || is_wide_space(token) || is_spacing(token); }

}  // namespace

std::optional<LinkAt> link_at(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (is_control(token, "therefore")) return LinkAt{Link::conclusion, at + 1};
  if (is_control(token, "because")) return LinkAt{Link::ground, at + 1};
  if (is_control_of(token, {"xRightarrow", "xLeftrightarrow"})) {
    const Argument below = optional_argument_at(tokens, at + 1);
    const std::size_t above = below.content.empty() ? at + 1 : below.next;
    const Link link = is_control(token, "xRightarrow") ? Link::conclusion : Link::equivalence;
    return LinkAt{link, argument_at(tokens, above).next, true};
  }
  if (is_stacked_relation(tokens, at)) {
    const Argument above = argument_at(tokens, at + 1);
    const Argument arrow = argument_at(tokens, above.next);
    const Token& sign = trim(arrow.content).front();
    if (relation_kind(sign) != RelationKind::implies) return std::nullopt;
    return LinkAt{link_of(sign), arrow.next, true};
  }
  if (is_control_of(token, {"to", "rightarrow", "longrightarrow"})) {
    if (!is_wide_before(tokens, at) || !is_wide_behind(tokens, at + 1)) return std::nullopt;
    return LinkAt{Link::conclusion, at + 1};
  }
  if (relation_kind(token) != RelationKind::implies) return std::nullopt;
  return LinkAt{link_of(token), at + 1};
}

std::size_t condition_end(TokenView tokens, std::size_t begin) {
  Nesting nesting(false);
  std::size_t end = begin;
  for (; end < tokens.size(); ++end) {
    if (nesting.enter(tokens[end]) != 0) continue;
    const bool concluded = is_words(tokens[end]) && concludes(text_of(argument_at(tokens, end + 1).content));
    if (concluded || link_at(tokens, end)) break;
    if (is_wide_space(tokens[end]) && !trim(tokens.subspan(begin, end - begin)).empty()) break;
  }
  return end;
}

bool opens_equation(TokenView tokens, std::size_t at) {
  while (at < tokens.size() && is_any_space(tokens[at])) ++at;
  const std::size_t end = symbol_end(tokens, at);
  const std::size_t relation = first_significant(tokens, end);
  if (end == at || relation >= tokens.size()) return false;
  const auto kind = relation_kind(tokens[relation]);
  return kind && is_equality(*kind) && !lists_values(tokens.subspan(at, condition_end(tokens, at) - at));
}

bool leads(TokenView line, const std::string& said, std::size_t next) {
  if (!has_relation(line.subspan(next))) return false;
  if (is_detail(said)) return opens_equation(line, next);
  if (!can_only_restrict(said)) return false;
  if (opens_a_condition(said)) return has_relation(line.subspan(condition_end(line, next)));
  if (said.substr(0, said.find_last_not_of(' ') + 1).ends_with(":")) return true;
  return is_wide_behind(line, next);
}

}  // namespace rigor
