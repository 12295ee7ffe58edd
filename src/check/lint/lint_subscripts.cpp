// SPDX-License-Identifier: GPL-3.0-or-later
// An index at the end of a subscript that is read as a word: `r_{CMi}`, `T_{\text{rot i}}`, next to a
// component with that index. What is a word and what is an index can then be told by neither reader nor
// program.
#include <fmt/format.h>

#include <algorithm>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// The letters at the end of a subscript that stand together, or the word there.
std::string last_run(const std::vector<WrittenIndex>& lower) {
  if (lower.empty()) return {};
  std::string run;
  if (lower.back().form == IndexForm::word) {
    run = lower.back().text;
    std::erase(run, ' ');
    return run;
  }
  for (auto index = lower.rbegin(); index != lower.rend(); ++index) {
    if (index->form != IndexForm::letter || index->primes > 0) break;
    run.insert(0, index->text);
  }
  return run;
}

/// The index after a known word, as `i` in `CMi`.
std::string hidden_in(const std::vector<WrittenIndex>& lower) {
  const std::string run = last_run(lower);
  const bool ends_in_index = run.size() > 2 && run.back() >= 'i' && run.back() <= 'n';
  if (!ends_in_index || is_subscript_word(run)) return {};
  return is_subscript_word(run.substr(0, run.size() - 1)) ? run.substr(run.size() - 1) : std::string{};
}

/// Is the letter an index somewhere else in the statement?
bool is_index_of(const SyntaxTree& syntax, SyntaxId id, const std::string& letter) {
  const std::vector<WrittenIndex>* indices = nullptr;
  if (syntax[id].kind == SyntaxKind::symbol) indices = &syntax.symbol(id).lower;
  if (syntax[id].kind == SyntaxKind::component) indices = &syntax.indices(id);
  if (syntax[id].kind == SyntaxKind::big_sum) indices = &syntax.big_sum(id).indices;
  if (indices == nullptr || !hidden_in(*indices).empty()) return false;
  return std::ranges::any_of(*indices, [&](const WrittenIndex& index) {
    return index.form == IndexForm::letter && index.text == letter;
  });
}

}  // namespace

Findings lint_subscripts(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  Findings findings;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    const std::vector<SyntaxId> nodes = nodes_below(syntax, statement.chain->sides);
    for (const SyntaxId id : nodes) {
      if (syntax[id].kind != SyntaxKind::symbol) continue;
      const std::string letter = hidden_in(syntax.symbol(id).lower);
      const bool index = !letter.empty() && std::ranges::any_of(nodes, [&](SyntaxId other) {
        return is_index_of(syntax, other, letter);
      });
      if (!index) continue;
      const std::string run = last_run(syntax.symbol(id).lower);
      const std::string word = run.substr(0, run.size() - 1);
      findings.push_back(
          {{DiagnosticKind::hidden_index,
            syntax[id].span,
            fmt::format(
                "the subscript is read as the name `{}`, and `{}` is an index elsewhere in the equation", run,
                letter),
            {},
            {fmt::format("set the word upright and the index apart: `_{{\\text{{{}}}{}}}`", word, letter)}}});
    }
  }
  return findings;
}

}  // namespace rigor
