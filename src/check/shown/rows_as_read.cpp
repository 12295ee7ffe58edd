// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/shown/rows_as_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/among.h"
#include "check/form/notation_of_notes.h"
#include "check/meaning/identity_reading.h"
#include "check/meaning/ordered_product.h"
#include "check/prose/denial.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/row/row.h"
#include "check/shown/grounds.h"
#include "check/shown/read_letters.h"
#include "check/word/prose_words.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

/// What a statement of the ledger is a step of.
struct StatementOfStep {
  const LedgerEntry* entry = nullptr;
  const Statement* statement = nullptr;
  std::size_t which = 0;  // of its relations
};

std::vector<StatementOfStep> statements_of_steps(const Ledger& ledger, std::size_t steps) {
  std::vector<StatementOfStep> found(steps);
  for (const LedgerEntry& entry : ledger.entries) {
    const auto* statement = std::get_if<Statement>(&entry.what);
    if (statement == nullptr) continue;
    for (std::size_t k = 0; k < statement->step_count; ++k)
      found[statement->first_step + k] = {&entry, statement, k};
  }
  return found;
}

/// Is there anything that keeps it from being read?
bool is_read_whole(const Step& step) {
  return std::ranges::none_of(step.diagnostics, [](const Diagnostic& each) {
    return each.severity() == Severity::error || each.severity() == Severity::not_understood;
  });
}

class RowReader {
 public:
  RowReader(Ledger& ledger, const Notes& notes, const SourceMap& sources, const FileReport& report,
            const CheckOptions& options)
      : tree_(ledger.tree),
        notes_(notes),
        sources_(sources),
        report_(report),
        options_(options),
        known_(letters_of_notes(notes, *ledger.end)),
        notation_(notation_of_notes(notes, *ledger.end, ledger.tree)) {
    notation_.every_sum = true;
  }

  ReadRow read(std::size_t which_step, const StatementOfStep& from) {
    const Step& step = report_.steps[which_step];
    ReadRow row{.step = which_step};
    if (step.verdict == Verdict::skipped) row.role = RowRole::skipped;
    if (from.statement == nullptr) return row;
    const Statement& statement = *from.statement;
    row.headings = headings_at(notes_, statement.event);
    row.link = from.which + 1;
    row.links = statement.step_count;
    row.cyclic = statement.chain->written.cyclic;
    row.open = statement.how.open;
    RowPlace place{sources_,           notes_,       options_,       above_, tree_,
                   *from.entry->scope, step.section, statement.event};
    Notation plain = notation_in(place.names.scope);
    plain.every_sum = false;
    describe(place, from, row);
    const auto& equation = statement.how.equations[from.which];
    if (!equation || !is_read_whole(step)) return row;
    row.role = role_of(place, from, *equation, row);
    const bool is_claim = row.role == RowRole::identity || row.role == RowRole::law ||
                          row.role == RowRole::conclusion || row.role == RowRole::approximation;
    if (is_claim) row.grounds = grounds_of(place, *statement.chain, *equation, plain);
    const bool leaves = row.role == RowRole::law || row.role == RowRole::conclusion;
    if (leaves && statement.role == Role::display)
      leave_to_rows_below(place, *statement.chain, *equation,
                          statement.chain->written.relations[from.which].span,
                          row.role == RowRole::law ? Standing::law : Standing::conclusion);
    std::move(place.found.stated.begin(), place.found.stated.end(), std::back_inserter(above_.stated));
    return row;
  }

 private:
  [[nodiscard]] Notation notation_in(const NameScope& scope) const {
    Notation notation = notation_;
    if (!scope.frames->empty()) {
      const Frame& frame = scope.frames->back();
      notation.frame = FrameNames{frame.rotation, frame.rotating, frame.fixed};
    }
    return notation;
  }

  /// What was read of its sides, also if they do not fit.
  void describe(RowPlace& place, const StatementOfStep& from, ReadRow& row) {
    const Statement& statement = *from.statement;
    const auto& left = statement.sides[from.which];
    const auto& right = statement.sides[from.which + 1];
    std::set<SymbolId> ordered;
    if (left && right) {
      const Notation notation = notation_in(place.names.scope);
      row.statement = fmt::format("{} {} {}", print_latex(tree_, left->id, notation),
                                  statement.chain->written.relations[from.which].text,
                                  print_latex(tree_, right->id, notation));
      Question question{.tree = &tree_, .claim = {.left = left->id, .right = right->id}};
      ordered = ordered_symbols(tree_, place.names, question);
    }
    row.letters = letters_of_row(tree_, place.names, known_, statement, from.which, ordered);
    row.conventions = statement.how.conventions;
    restrict(place, statement, row);
  }

  /// Words and conditions that bear on it.
  void restrict(RowPlace& place, const Statement& statement, ReadRow& row) {
    if (statement.role != Role::display) return;
    const WrittenChain& written = statement.chain->written;
    if (written.doubt) row.restricted.push_back(written.doubt->message);
    for (const ParsedChain& condition : statement.chain->assumed)
      row.restricted.push_back(fmt::format("it holds where `{}`", text_of(condition.written)));
    if (const auto denied = denial_of(notes_.prose, statement.event))
      row.restricted.push_back(fmt::format("`{}` next to it may say that it does not hold", *denied));
    if (const auto word = word_that_demands(beside(place).lead))
      row.restricted.push_back(fmt::format("behind `{}` it may be no claim", *word));
    if (const auto around = said_around(notes_.prose, statement.event, sources_, written.span, written.tag))
      row.restricted.push_back(fmt::format("`{}` in {} may restrict it", around->word, around->where));
    const Standpoint at = standpoint(place, *statement.chain);
    if (!at.unread.empty())
      row.restricted.push_back(fmt::format("`{}` shares a letter with it and is not read", at.unread));
  }

  RowRole role_of(RowPlace& place, const StatementOfStep& from, const Equation& equation, ReadRow& row) {
    const Statement& statement = *from.statement;
    const ParsedChain& parsed = *statement.chain;
    const Verdict verdict = report_.steps[row.step].verdict;
    row.inferred = parsed.written.inference != Inference::none;
    if (statement.role == Role::display) row.announced = word_that_concludes(beside(place).lead).value_or("");
    if (verdict == Verdict::definition || statement.role == Role::let) return RowRole::definition;
    if (statement.role == Role::given) return RowRole::given;
    if (verdict == Verdict::given || (statement.role == Role::display && is_condition_beside(place, parsed)))
      return RowRole::condition;
    if (statement.role == Role::claim) return RowRole::identity;
    const RelationKind kind = parsed.written.relations[from.which].kind;
    if (kind == RelationKind::nearly || statement.first_order) return RowRole::approximation;
    for (const SymbolId symbol : not_meant_for_all(place, equation)) {
      const std::string& name = tree_.symbols[base_of(tree_.symbols, symbol)].name;
      if (!is_one_of(name, row.for_some)) row.for_some.push_back(name);
    }
    if (row.for_some.empty()) return RowRole::identity;
    const bool announced = from.which > 0 || row.inferred || !row.announced.empty();
    return announced && !statement.how.is_stated ? RowRole::conclusion : RowRole::law;
  }

  std::vector<SymbolId> not_meant_for_all(RowPlace& place, const Equation& equation) {
    options_.cache->begin(options_.effort);
    Prepared prepared = prepare(tree_, place.names, equation);
    prepared.question.tree = &tree_;
    const ExprNode& left = tree_[equation.left];
    const bool restates = left.op == Op::symbol && definition_of(place.names.scope, left.symbol) != nullptr;
    return law_symbols(prepared.question, place.names.scope, restates, options_.cache);
  }

  ExprTree& tree_;
  const Notes& notes_;
  const SourceMap& sources_;
  const FileReport& report_;
  const CheckOptions& options_;
  LettersOfNotes known_;
  Notation notation_;
  SaidAbove above_;  // by the rows so far
};

}  // namespace

std::vector<ReadRow> rows_as_read(Ledger& ledger, const Notes& notes, const SourceMap& sources,
                                  const FileReport& report, const CheckOptions& options) {
  RowReader reader(ledger, notes, sources, report, options);
  const std::vector<StatementOfStep> from = statements_of_steps(ledger, report.steps.size());
  std::vector<ReadRow> rows;
  for (std::size_t k = 0; k < report.steps.size(); ++k) {
    const bool image = from[k].statement != nullptr && from[k].statement->chain->image > 0;
    if (!image) rows.push_back(reader.read(k, from[k]));
  }
  return rows;
}

}  // namespace rigor
