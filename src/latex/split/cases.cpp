// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/split/beside.h"
#include "latex/split/blocks.h"
#include "latex/split/case_conditions.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// `x^2 & x > 0`
struct CaseRow {
  TokenView value;
  TokenView condition;
};

/// `\begin{cases} … \end{cases}`
struct CaseBlock {
  std::size_t begin = 0;
  std::size_t end = 0;    // the place behind it
  bool in_words = false;  // the conditions are words with mathematics between dollar signs
  std::vector<CaseRow> rows = {};
};

/// Where what is opened at `open` is closed; the size where it is not.
std::size_t closing_end(TokenView tokens, std::size_t open) {
  Nesting nesting(true);
  for (std::size_t at = open; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) == 0 && at > open && is_control(tokens[at], "end")) return at;
  }
  return tokens.size();
}

/// Without blanks and punctuation at its end.
TokenView bare_value(TokenView tokens) {
  tokens = trim(tokens);
  while (!tokens.empty() &&
         (is_sign_of(tokens.back(), ",;.") || is_spacing(tokens.back()) || is_wide_space(tokens.back())))
    tokens = trim(tokens.first(tokens.size() - 1));
  return tokens;
}

/// `x^2, \quad x > 0` without a column between.
std::optional<CaseRow> row_without_column(TokenView cell) {
  Nesting nesting(false);
  for (std::size_t at = 0; at < cell.size(); ++at) {
    if (nesting.enter(cell[at]) != 0 || (!is_wide_space(cell[at]) && !is_words(cell[at]))) continue;
    if (bare_value(cell.first(at)).empty()) return std::nullopt;
    return CaseRow{cell.first(at), cell.subspan(at)};
  }
  return std::nullopt;
}

/// The rows of what is between `\begin{…}` and `\end{…}`; nothing where one is no value with a condition.
std::optional<std::vector<CaseRow>> rows_of(TokenView body) {
  std::vector<CaseRow> rows;
  std::vector<TokenView> cells;
  Nesting nesting(false);
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= body.size(); ++at) {
    const bool ends = at == body.size();
    const bool outside = ends || nesting.enter(body[at]) == 0;
    const bool ends_row = ends || (outside && is_control_of(body[at], {"\\", "cr", "newline"}));
    if (!ends_row && !(outside && body[at].kind == TokenKind::align)) continue;
    cells.push_back(trim(body.subspan(begin, at - begin)));
    begin = at + 1;
    if (!ends_row) continue;
    if (!ends) {
      const Argument length = optional_argument_at(body, begin);
      if (is_length(length.content)) begin = length.next;
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    auto row = cells.size() == 2   ? std::optional(CaseRow{cells[0], cells[1]})
               : cells.size() == 1 ? row_without_column(cells[0])
                                   : std::nullopt;
    const bool blank = cells.empty();
    cells.clear();
    if (blank && ends) continue;
    if (!row || bare_value(row->value).empty() || has_relation(row->value)) return std::nullopt;
    rows.push_back(*row);
  }
  return rows;
}

std::optional<CaseBlock> block_at(TokenView tokens, std::size_t at) {
  if (!is_control_at(tokens, at, "begin")) return std::nullopt;
  const Argument argument = argument_at(tokens, at + 1);
  std::string name = text_of(argument.content);
  const bool in_words = name.ends_with("cases*");
  if (in_words) name.pop_back();
  if (!is_one_of(name, {"cases", "dcases", "rcases", "drcases", "array"})) return std::nullopt;
  const std::size_t close = closing_end(tokens, at);
  if (close >= tokens.size()) return std::nullopt;
  TokenView body = tokens.subspan(argument.next, close - argument.next);
  if (name == "array") {
    const TokenView columns = body.first(argument_at(body, optional_argument_at(body, 0).next).next);
    if (!are_columns(columns)) return std::nullopt;
    body = body.subspan(columns.size());
  }
  auto rows = rows_of(body);
  if (!rows || rows->size() < 2) return std::nullopt;
  return CaseBlock{at, argument_at(tokens, close + 1).next, in_words, *std::move(rows)};
}

/// The first of them outside of all brackets.
std::optional<CaseBlock> first_block(TokenView tokens) {
  Nesting nesting(false);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) != 0) continue;
    if (auto block = block_at(tokens, at)) return block;
  }
  return std::nullopt;
}

bool is_relation_at(TokenView tokens, std::size_t at) {
  return at < tokens.size() && (relation_kind(tokens[at]).has_value() || is_stacked_relation(tokens, at));
}

/// All blocks, each behind the relation that follows the one before it: `f = CASES = CASES`.
std::vector<CaseBlock> blocks_of(TokenView statement) {
  std::vector<CaseBlock> blocks;
  const auto first = first_block(statement);
  if (!first) return blocks;
  blocks.push_back(*first);
  while (true) {
    const std::size_t relation = first_significant(statement, blocks.back().end);
    if (!is_relation_at(statement, relation)) return blocks;
    auto next = block_at(statement, first_significant(statement, relation + 1));
    if (!next) return blocks;
    blocks.push_back(*std::move(next));
  }
}

/// Is each block a whole side?
bool are_whole_sides(TokenView statement, const std::vector<CaseBlock>& blocks) {
  const TokenView before = trim(statement.first(blocks.front().begin));
  const bool begins = before.empty() || relation_kind(before.back()).has_value();
  std::size_t at = first_significant(statement, blocks.back().end);
  while (at < statement.size() && is_sign_of(statement[at], ",;.")) at = first_significant(statement, at + 1);
  const bool ends = at == statement.size() || is_relation_at(statement, at) || is_wide_space(statement[at]) ||
                    is_words(statement[at]);
  return begins && ends && !(before.empty() && !is_relation_at(statement, at)) &&
         !first_block(statement.subspan(blocks.back().end));
}

/// Where the last equation of `a = b, \quad f(x) =` begins.
std::size_t last_equation(TokenView before) {
  std::size_t begin = 0;
  std::size_t last = 0;
  bool related = false;
  Nesting nesting(false);
  for (std::size_t at = 0; at < before.size(); ++at) {
    if (nesting.enter(before[at]) != 0) continue;
    if (is_relation_at(before, at)) {
      if (related) begin = last;
      related = true;
      last = at + 1;
    } else if (related && (is_wide_space(before[at]) || is_words(before[at]))) {
      begin = last = at;
      related = false;
    }
  }
  return begin;
}

/// Where it is, outside of all brackets.
std::size_t last_relation(TokenView tokens) {
  std::size_t last = 0;
  Nesting nesting(false);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) == 0 && is_relation_at(tokens, at)) last = at;
  }
  return last;
}

Tokens put_in(TokenView statement, std::size_t begin, const std::vector<CaseBlock>& blocks,
              std::size_t which) {
  Tokens tokens;
  const auto add = [&](TokenView part) { tokens.insert(tokens.end(), part.begin(), part.end()); };
  for (const CaseBlock& block : blocks) {
    add(statement.subspan(begin, block.begin - begin));
    add(bare_value(block.rows[which].value));
    begin = block.end;
  }
  add(statement.subspan(begin));
  return tokens;
}

Obstacle unread_words(TokenView condition, bool in_words) {
  const TokenView bare = bare_value(condition);
  const std::string words = in_words ? text_of(bare) : spoken(bare);
  return {DiagnosticKind::restricted,
          fmt::format("it is said for the case `{}`, which is not read", words),
          {"write the condition as a relation, such as `x > 0`"}};
}

/// What only sets the cases, and what says when they hold.
void mark_block(const CaseBlock& block, TokenView statement, TokenUses& uses) {
  const TokenView whole = statement.subspan(block.begin, block.end - block.begin);
  std::vector<TokenView> values;
  for (const CaseRow& row : block.rows) {
    uses.mark(row.condition, TokenUse::condition);
    values.push_back(bare_value(row.value));
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    const Token* token = &whole[at];
    const bool of_value = std::ranges::any_of(values, [&](TokenView value) {
      return token >= value.data() && token < value.data() + value.size();
    });
    if (!of_value && uses.of(*token) == TokenUse::none) uses.mark(whole.subspan(at, 1), TokenUse::layout);
  }
}

/// Where nothing is written, before `next`.
void add_written(Tokens& tokens, std::string_view control, const Token& next) {
  const Span place{next.span.file, next.span.begin, next.span.begin};
  tokens.push_back({TokenKind::control, control, place});
  tokens.push_back({TokenKind::begin_group, "{", place});
  for (const std::string_view letter : {"c", "a", "s", "e", "s"})
    tokens.push_back({TokenKind::letter, letter, place});
  tokens.push_back({TokenKind::other, "*", place});
  tokens.push_back({TokenKind::end_group, "}", place});
}

}  // namespace

Tokens numbered_cases(TokenView body) {
  const std::size_t open = skip_blank(body, 0);
  if (!is_kind_at(body, open, TokenKind::begin_group)) return {body.begin(), body.end()};
  const Argument left = argument_at(body, open);
  if (trim(left.content).empty()) return {body.begin() + static_cast<std::ptrdiff_t>(left.next), body.end()};
  Tokens tokens(left.content.begin(), left.content.end());
  add_written(tokens, "begin", body[open]);
  tokens.insert(tokens.end(), body.begin() + static_cast<std::ptrdiff_t>(left.next), body.end());
  add_written(tokens, "end", body.back());
  return tokens;
}

std::optional<WrittenCases> cases_of(TokenView statement, TokenUses& uses) {
  const std::vector<CaseBlock> blocks = blocks_of(statement);
  if (blocks.empty() || !are_whole_sides(statement, blocks)) return std::nullopt;
  const CaseBlock& first = blocks.front();
  std::vector<TokenView> written;
  for (const CaseRow& row : first.rows) written.push_back(row.condition);
  for (const CaseBlock& other : blocks) {
    if (other.rows.size() != first.rows.size()) return std::nullopt;
    for (std::size_t k = 0; k < other.rows.size(); ++k) {
      if (text_of(bare_value(other.rows[k].condition)) != text_of(bare_value(written[k])))
        return std::nullopt;
    }
  }
  const std::vector<CaseConditions> conditions = conditions_of_cases(written, first.in_words);
  if (conditions.empty()) return std::nullopt;
  const std::size_t begin = last_equation(statement.first(first.begin));
  WrittenCases found;
  if (begin > 0) {
    // The last side of `a = b = CASES` is a side of both.
    const TokenView before = statement.first(first.begin);
    const bool chained = is_relation_at(before, begin - 1);
    const TokenView plain = chained ? before.first(last_relation(before)) : before.first(begin);
    found.before.assign(plain.begin(), plain.end());
  }
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    const Tokens tokens = put_in(statement, begin, blocks, k);
    if (conditions[k].alternatives.empty())
      found.cases.push_back({tokens, {}, unread_words(written[k], first.in_words)});
    for (const std::vector<Tokens>& each : conditions[k].alternatives)
      found.cases.push_back({tokens, each, std::nullopt});
  }
  for (const CaseBlock& block : blocks) mark_block(block, statement, uses);
  return found;
}

}  // namespace rigor
