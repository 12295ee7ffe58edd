// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/split.h"

#include <fmt/format.h>

#include <algorithm>

#include "latex/split/blocks.h"
#include "latex/split/cases.h"
#include "latex/split/chain.h"
#include "latex/split/conditions.h"

namespace rigor {
namespace {

/// The tokens of one statement with the tag and label of its rows.
struct Statement {
  Tokens tokens;
  int open_brackets = 0;  // how many brackets more open than close
  std::string tag;
  Tokens in_tag;
  std::string label;
  std::optional<Obstacle> condition;
  Span condition_span;
  std::optional<Obstacle> doubt;
};

/// The first place that is no kind of space.
std::size_t first_sign(TokenView tokens) {
  std::size_t at = first_significant(tokens, 0);
  while (at < tokens.size() && is_wide_space(tokens[at])) at = first_significant(tokens, at + 1);
  return at;
}

bool is_empty(TokenView tokens) { return first_sign(tokens) == tokens.size(); }

bool starts_with_relation(TokenView tokens) {
  const std::size_t at = first_sign(tokens);
  return at < tokens.size() &&
         (relation_kind(tokens[at]).has_value() || is_stacked_relation(tokens, at) ||
          is_control(tokens[at], "mathrel") ||
          (is_sign(tokens[at], ":") && at + 1 < tokens.size() && is_sign(tokens[at + 1], "=")));
}

bool starts_with_operator(TokenView tokens) {
  const std::size_t at = first_sign(tokens);
  if (at >= tokens.size()) return false;
  return is_sign_of(tokens[at], "+-") || (tokens[at].kind == TokenKind::letter && tokens[at].text == "−") ||
         factor_joint(tokens[at]) != Joint::none;
}

/// `\theta > 0`, `0 < x \le 1`: a condition, and no equation.
bool orders_only(TokenView tokens) {
  return conditions_in(tokens) && std::ranges::none_of(tokens, [](const Token& token) {
           return relation_kind(token) == RelationKind::equal || is_words(token);
         });
}

int count_open_brackets(TokenView tokens) {
  int depth = 0;
  for (const Token& token : tokens) {
    if (is_sign_of(token, "([")) ++depth;
    if (is_sign_of(token, ")]")) --depth;
  }
  return depth;
}

std::size_t last_sign(TokenView tokens) {
  const TokenView signs = trim(tokens);
  return signs.empty() ? 0 : static_cast<std::size_t>(&signs.back() - tokens.data());
}

/// `a =` above `= b`: one relation, written at the end of a line and again at the beginning of the next.
bool repeats_relation(TokenView above, TokenView row) {
  if (trim(above).empty() || trim(row).empty()) return false;
  const Token& last = trim(above).back();
  const Token& first = row[first_sign(row)];
  const auto kind = relation_kind(last);
  return kind && relation_kind(first) == kind && last.text == first.text;
}

bool has_ended(const Statement& statement) {
  const TokenView tokens = trim(statement.tokens);
  return !tokens.empty() && is_sign_of(tokens.back(), ".,;");
}

/// `+ b = c`: an equation of its own begins with no `+` and no sign of a product, unless what stands above
/// has ended.
bool goes_on(const Statement& above, TokenView row) {
  const Token& first = row[first_sign(row)];
  return !has_ended(above) && (is_sign(first, "+") || factor_joint(first) != Joint::none);
}

/// Does the row go on with the statement above it?
bool continues(const Statement& above, TokenView row, bool first_cell_empty, bool continuation_by_layout,
               bool only_cell) {
  if (above.tokens.empty()) return false;
  if (starts_with_relation(row) || above.open_brackets > 0 || ends_open(above.tokens)) return true;
  if (continuation_by_layout) return true;
  if (starts_with_operator(row))
    return first_cell_empty || !has_relation(row) || (only_cell && goes_on(above, row));
  return false;
}

std::size_t cells_per_equation(std::string_view environment, const std::vector<Row>& rows) {
  if (environment.starts_with("eqnarray") || environment == "IEEEeqnarray") return 3;
  const bool pairs = std::ranges::any_of(rows, [](const Row& row) { return row.cells.size() > 2; });
  const bool middle_relation =
      pairs && std::ranges::all_of(rows, [](const Row& row) {
        return row.cells.size() == 3 && starts_with_relation(row.cells[1]) && trim(row.cells[1]).size() == 1;
      });
  if (middle_relation) return 3;  // `a &=& b` written in align
  return pairs ? 2 : 1000;
}

/// `a = b \qquad c = d`: where a wide space parts two statements; the end where none does.
std::size_t second_statement(TokenView tokens) {
  Nesting nesting(false);
  bool related = false;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) != 0) continue;
    const auto kind = relation_kind(tokens[at]);
    if (kind && kind != RelationKind::implies) related = true;
    const bool parts = related && is_wide_space(tokens[at]);
    if (parts && has_relation(tokens.subspan(at + 1))) return at;
  }
  return tokens.size();
}

/// `= b \qquad = d` below two statements goes on with both.
bool continues_several(TokenView above, TokenView row) {
  if (!starts_with_relation(row) || second_statement(above) == above.size()) return false;
  const std::size_t wide = second_statement(row);
  return wide < row.size() && starts_with_relation(row.subspan(wide));
}

/// Puts the rows of a display together: a row goes on with the statement above it, or begins the next.
class RowJoiner {
 public:
  RowJoiner(const std::vector<Row>& rows, std::string_view environment, TokenUses& uses)
      : rows_(rows),
        uses_(uses),
        width_(cells_per_equation(environment, rows)),
        by_layout_(environment.starts_with("multline")) {}

  std::vector<Statement> join() {
    for (const Row& row : rows_) {
      if (row.after_text) close_all();
      for (std::size_t begin = 0, column = 0; begin < row.cells.size(); begin += width_, ++column)
        add(row, begin, column);
    }
    close_all();
    std::ranges::stable_sort(done_, [](const Statement& a, const Statement& b) {
      return span_of(a.tokens).begin < span_of(b.tokens).begin;
    });
    return std::move(done_);
  }

 private:
  void close_all() {
    for (Statement& statement : open_) close(statement);
    open_.clear();
  }

  void close(Statement& statement) {
    if (!is_empty(statement.tokens)) done_.push_back(std::move(statement));
    statement = Statement{};
  }

  void add(const Row& row, std::size_t begin, std::size_t column) {
    Tokens tokens;
    for (std::size_t cell = begin; cell < std::min(begin + width_, row.cells.size()); ++cell) {
      tokens.insert(tokens.end(), row.cells[cell].begin(), row.cells[cell].end());
    }
    if (is_empty(tokens)) return;
    tokens.erase(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(first_sign(tokens)));
    const bool first_cell_empty = row.cells.size() > 1 && is_empty(row.cells[begin]);
    const bool column_is_new = column >= open_.size() || is_empty(open_[column].tokens);
    if (column > 0 && column <= open_.size() && column_is_new &&
        starts_with_relation(tokens)) {  // `a &= b &= c`
      Statement& before = open_[column - 1];
      before.tokens.insert(before.tokens.end(), tokens.begin(), tokens.end());
      before.open_brackets += count_open_brackets(tokens);
      return;
    }
    // `a &= b & \text{if } i \ne j`: what is next to an equation belongs to it.
    const bool beside = column > 0 && column <= open_.size() && !starts_with_relation(tokens) &&
                        (!has_relation(tokens) || relates_index_letters(tokens) || is_words(tokens.front()) ||
                         orders_only(tokens));
    if (beside) {
      Token space = tokens.front();
      space.kind = TokenKind::control;
      space.text = "quad";
      space.place = 0;
      tokens.insert(tokens.begin(), space);
      column = column - 1;
    } else {
      if (column >= open_.size()) open_.resize(column + 1);
      if (!continues(open_[column], tokens, first_cell_empty, by_layout_, row.cells.size() == 1)) {
        auto of_row = doubt(open_[column], tokens);
        close(open_[column]);
        open_[column].doubt = std::move(of_row);
      }
    }
    Statement& current = open_[column];
    if (continues_several(current.tokens, tokens)) {
      current.condition = Obstacle{DiagnosticKind::ambiguous_reading,
                                   "the next row goes on with several equations of this one",
                                   {"columns of `align` say which of them goes on with which"}};
      current.condition_span = span_of(tokens);
    }
    const bool one = second_statement(current.tokens) == current.tokens.size();
    if (starts_with_relation(tokens) && one && !trim(current.tokens).empty() &&
        is_sign(trim(current.tokens).back(), ",")) {  // `a &= b, \\ &= c`
      const std::size_t last = last_sign(current.tokens);
      uses_.mark(TokenView(current.tokens).subspan(last), TokenUse::layout);
      current.tokens.resize(last);
    }
    if (repeats_relation(current.tokens, tokens)) {
      const std::size_t last = last_sign(current.tokens);
      uses_.mark(TokenView(current.tokens).subspan(last), TokenUse::relation);
      current.tokens.resize(last);
    }
    current.tokens.insert(current.tokens.end(), tokens.begin(), tokens.end());
    current.open_brackets += count_open_brackets(tokens);
    if (!row.tag.empty()) {
      current.tag = row.tag;
      current.in_tag = row.in_tag;
    }
    if (!row.label.empty()) current.label = row.label;
  }

  /// Where a row could belong to the statement above it or not, that statement is not judged; nor is the row
  /// refuted, since its own left side may be only the end of one.
  static std::optional<Obstacle> doubt(Statement& above, TokenView row) {
    const bool open_end = !has_relation(row) || starts_with_operator(row);
    if (!open_end || is_empty(above.tokens)) return std::nullopt;
    above.condition = Obstacle{DiagnosticKind::ambiguous_reading,
                               "the next row can continue this equation, or be an equation of its own",
                               {"begin the row with `&` and a sign if it continues"}};
    above.condition_span = span_of(row);
    if (!has_relation(row) || has_ended(above)) return std::nullopt;
    return Obstacle{DiagnosticKind::ambiguous_reading, "it can continue the equation above it", {}};
  }

  const std::vector<Row>& rows_;
  TokenUses& uses_;
  std::size_t width_;
  bool by_layout_;
  std::vector<Statement> done_;
  std::vector<Statement> open_;  // one for each column of equations
};

/// One tag in a whole display numbers all of it.
void share_single_tag(std::vector<WrittenChain>& chains) {
  const auto share = [&](std::string WrittenChain::*field) {
    std::string only;
    for (const WrittenChain& chain : chains) {
      if ((chain.*field).empty()) continue;
      if (!only.empty() && only != chain.*field) return;
      only = chain.*field;
    }
    for (WrittenChain& chain : chains) chain.*field = only;
  };
  share(&WrittenChain::tag);
  share(&WrittenChain::label);
}

/// `\tag{for $x > 0$}`, and conditions at the braces of the chain.
void add_conditions(WrittenChain& chain, const std::vector<Tokens>& in_tag) {
  const std::size_t before = chain.assumed.size();
  TokenUses own(0);
  for (const Tokens& condition : in_tag) chain.assumed.push_back(chain_of(condition, own));
  for (const WrittenSide& side : chain.sides) {
    for (const Tokens& condition : said_at_braces(side.tokens))
      chain.assumed.push_back(chain_of(condition, own));
  }
  if (chain.assumed.empty() || chain.doubt || (chain.of_cases && chain.assumed.size() == before)) return;
  chain.only_said_for = true;
  chain.doubt = Obstacle{
      DiagnosticKind::restricted, fmt::format("it is said for `{}`", text_of(chain.assumed.front())), {}};
}

/// Around signs that nobody read, nothing is judged.
void refuse(std::vector<WrittenChain>& chains, const Token& left_over) {
  for (WrittenChain& chain : chains) {
    if (chain.condition) continue;
    chain.condition = Obstacle{DiagnosticKind::passed_over,
                               fmt::format("`{}` is not part of what was read", text_of({&left_over, 1})),
                               {}};
    chain.condition_span = left_over.span;
  }
}

/// The chains of a statement; of `f(x) = \begin{cases} … \end{cases}`, those of each case.
std::vector<WrittenChain> chains_of(TokenView statement, TokenUses& uses) {
  const auto cases = cases_of(statement, uses);
  if (!cases) return split_statement(statement, uses);
  std::vector<WrittenChain> chains = split_statement(cases->before, uses);
  for (const WrittenCase& each : cases->cases) {
    TokenUses own(0);
    for (WrittenChain& chain : split_statement(each.statement, uses)) {
      chain.of_cases = !chain.relations.empty();
      for (const Tokens& condition : each.conditions) chain.assumed.push_back(chain_of(condition, own));
      if (each.unread && !chain.doubt) chain.doubt = each.unread;
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

}  // namespace

std::string text_of(const WrittenChain& chain) {
  std::string text = text_of(chain.sides.front().tokens);
  for (std::size_t k = 0; k < chain.relations.size(); ++k)
    text += fmt::format(" {} {}", chain.relations[k].text, text_of(chain.sides[k + 1].tokens));
  return text;
}

std::vector<WrittenChain> split_display(TokenView tokens, std::string_view environment,
                                        Diagnostics& diagnostics) {
  return split_and_count(tokens, environment, diagnostics).chains;
}

SplitDisplay split_and_count(TokenView tokens, std::string_view environment, Diagnostics& diagnostics) {
  std::string name(environment);
  if (!name.empty() && name.back() == '*') name.pop_back();
  const bool cases = name == "numcases" || name == "subnumcases";
  SplitDisplay split{
      {}, counted(cases ? numbered_cases(tokens) : Tokens(tokens.begin(), tokens.end())), TokenUses(0)};
  split.uses = TokenUses(split.tokens.size());
  std::vector<WrittenChain>& chains = split.chains;
  const std::vector<Row> rows = read_rows(split.tokens, diagnostics, split.uses);
  std::size_t number = 0;
  for (Statement& statement : RowJoiner(rows, name, split.uses).join()) {
    ++number;
    std::vector<WrittenChain> own = chains_of(statement.tokens, split.uses);
    if (const Token* left_over = split.uses.left_over(statement.tokens)) {
      if (own.empty()) own.push_back(chain_of(statement.tokens, split.uses));
      refuse(own, *left_over);
    }
    const auto in_tag = conditions_in_tag(statement.in_tag);
    for (WrittenChain& chain : own) {
      add_conditions(chain, in_tag.value_or(std::vector<Tokens>{}));
      if (chain.tag.empty()) chain.tag = statement.tag;
      chain.label = statement.label;
      chain.statement = number;
      if (statement.doubt && !chain.doubt) chain.doubt = statement.doubt;
      if (statement.condition && !chain.condition) {
        chain.condition = statement.condition;
        chain.condition_span = statement.condition_span;
      }
      chains.push_back(std::move(chain));
    }
  }
  share_single_tag(chains);
  if (const Token* left_over = split.uses.left_over(split.tokens)) refuse(chains, *left_over);
  return split;
}

}  // namespace rigor
