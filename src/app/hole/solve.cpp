// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algebra/form/rational_form.h"
#include "app/hole/hole_text.h"
#include "app/hole/write_back.h"
#include "base/among.h"
#include "check/entry/read_forms.h"
#include "derive/answer/isolate.h"
#include "derive/answer/propose.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

class StatementSolver {
 public:
  StatementSolver(const HoleNotes& notes, std::string symbol) : notes_(notes), symbol_(std::move(symbol)) {}

  SolvedStatement run() {
    const FormRequest request{
        .asked = {symbol_}, .at = notes_.at, .sidecar = notes_.sidecar, .statement = notes_.statement};
    reading_ = read_forms_of_text(result_.sources, notes_.path, notes_.text, request);
    const WrittenFormChain* chain = own_chain();
    if (reading_.forms.asked.empty() || chain == nullptr) return unread();
    if (chain->forms.size() != 2 || chain->steps[0].kind != "=") return refuse("it is not one equation");
    if (!chain->forms[0].expr || !chain->forms[1].expr) return unread();
    if (!sides_fit(*chain)) return unread();
    unknown_ = reading_.forms.asked[0].expr;
    find_places(*chain);
    if (places_.empty()) return refuse("it does not occur");
    std::vector<ExprId> values = values_of(*chain);
    for (const ExprId value : values) try_value(value);
    if (result_.roots.empty() && result_.obstacle.empty())
      result_.obstacle = "what was found could not be proved";
    return std::move(result_);
  }

 private:
  const WrittenFormChain* own_chain() const {
    for (const WrittenFormChain& chain : reading_.forms.chains) {
      if (chain.span.file == *reading_.statement) return &chain;
    }
    return nullptr;
  }

  /// Each side can be readable, and the two not be an equation: ranks or indices differ.
  bool sides_fit(const WrittenFormChain& chain) const {
    const ExprTree& tree = reading_.forms.tree;
    if (tree[*chain.forms[0].expr].rank != tree[*chain.forms[1].expr].rank) return false;
    return std::ranges::none_of(reading_.report.steps, [&](const Step& step) {
      if (step.relation_span.file != *reading_.statement) return false;
      return std::ranges::any_of(step.diagnostics,
                                 [](const Diagnostic& each) { return each.severity() == Severity::error; });
    });
  }

  SolvedStatement unread() {
    result_.malformed = true;
    const auto take = [&](const Diagnostics& diagnostics) {
      for (const Diagnostic& each : diagnostics) {
        if (each.severity() != Severity::warning && each.kind != DiagnosticKind::unused_directive)
          result_.diagnostics.push_back(each);
      }
    };
    take(reading_.report.diagnostics);
    for (const Step& step : reading_.report.steps) {
      if (step.relation_span.file == *reading_.statement) take(step.diagnostics);
    }
    if (result_.diagnostics.empty()) result_.obstacle = "the statement is not one equation";
    return std::move(result_);
  }

  SolvedStatement refuse(std::string obstacle) {
    result_.obstacle = std::move(obstacle);
    return std::move(result_);
  }

  /// Where the unknown is in the statement.
  void find_places(const WrittenFormChain& chain) {
    const ExprTree& tree = reading_.forms.tree;
    const std::string text = dump(tree, unknown_);
    std::vector<ExprId> pending{*chain.forms[0].expr, *chain.forms[1].expr};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      const ExprNode& node = tree[id];
      if (node.op == tree[unknown_].op && dump(tree, id) == text) {
        if (node.span.file == *reading_.statement && !is_one_of(node.span, places_))
          places_.push_back(node.span);
        continue;
      }
      for (const ExprId child : tree.children(id)) pending.push_back(child);
    }
  }

  std::vector<ExprId> values_of(const WrittenFormChain& chain) {
    ExprTree& tree = reading_.forms.tree;
    ExprId left = *chain.forms[0].expr;
    ExprId right = *chain.forms[1].expr;
    if (tree[unknown_].rank == 0 && tree[left].rank == 0) {
      const ExprId negative = tree.add({.op = Op::negate}, std::span(&right, 1));
      const ExprId terms[] = {left, negative};
      Roots roots = solved_for(tree, tree.add({.op = Op::add}, terms), unknown_);
      result_.obstacle = std::move(roots.obstacle);
      return std::move(roots.values);
    }
    const SymbolId symbol = tree[unknown_].symbol;
    if (tree[unknown_].op != Op::symbol) return {};
    if (occurrences_of(tree, right, symbol) == 0) std::swap(left, right);
    if (occurrences_of(tree, left, symbol) > 0) {
      result_.obstacle = "it occurs on both sides";
      return {};
    }
    const Equation equation{
        .left = left, .right = right, .indices = chain.indices, .particles = chain.particles};
    const Isolation isolation = isolated(tree, equation, symbol);
    result_.obstacle = isolation.obstacle;
    if (!isolation.value) return {};
    const std::vector<ExprId> forms = in_form(tree, *isolation.value, {});
    return {forms[0]};
  }

  void try_value(ExprId value) {
    const std::string latex = print_latex(reading_.forms.tree, value, reading_.forms.notation);
    std::vector<PlacedText> replacements;
    for (const Span place : places_)
      replacements.push_back({place, placed(latex, place_of(result_.sources, place, false))});
    FormRequest request{.at = notes_.at, .sidecar = notes_.sidecar};
    request.statement = with_replacements(*notes_.statement, std::move(replacements));
    SourceMap sources;
    const FormsReading again = read_forms_of_text(sources, notes_.path, notes_.text, request);
    for (const WrittenFormChain& chain : again.forms.chains) {
      if (chain.span.file != *again.statement || chain.steps.empty()) continue;
      const bool known = is_one_of(latex, result_.roots);
      if (chain.steps[0].outcome == Outcome::proved && !known) result_.roots.push_back(latex);
      if (chain.steps[0].outcome != Outcome::proved)
        result_.obstacle = fmt::format("`{}` was found, but it could not be proved that it fits", latex);
      return;
    }
  }

  const HoleNotes& notes_;
  std::string symbol_;
  SolvedStatement result_;
  FormsReading reading_;
  ExprId unknown_{};
  std::vector<Span> places_;
};

}  // namespace

SolvedStatement solve_statement(const HoleNotes& notes, const std::string& symbol) {
  return StatementSolver(notes, symbol).run();
}

}  // namespace rigor
