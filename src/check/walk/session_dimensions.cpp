// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk through the notes tells the dimensions of, and when they are solved.
#include <algorithm>
#include <span>
#include <vector>

#include "base/among.h"
#include "check/dimension/dimensions.h"
#include "check/walk/session.h"

namespace rigor {
namespace {

/// Relations between quantities of one dimension.
bool compares(RelationKind kind) {
  return kind != RelationKind::other && kind != RelationKind::implies && kind != RelationKind::demanded;
}

/// `x(\SI{7.6}{s})`: a value at that time, or a product.
bool takes_measured_argument(const SyntaxTree& syntax, std::span<const SyntaxChild> factors) {
  for (std::size_t k = 1; k < factors.size(); ++k) {
    const bool beside = factors[k].joint == Joint::juxtaposed &&
                        syntax[factors[k - 1].id].kind == SyntaxKind::symbol &&
                        syntax[factors[k].id].kind == SyntaxKind::group;
    // `\SI{2}{s}` is a group by itself.
    if (!beside || syntax[syntax.child(factors[k].id, 0)].kind != SyntaxKind::group) continue;
    bool unit = false;
    bool other = false;
    std::vector<SyntaxId> pending(1, factors[k].id);
    while (!pending.empty()) {
      const SyntaxId id = pending.back();
      pending.pop_back();
      unit = unit || syntax[id].kind == SyntaxKind::unit;
      other = other || syntax[id].kind == SyntaxKind::symbol || syntax[id].kind == SyntaxKind::sum;
      for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
    }
    if (unit && !other) return true;
  }
  return false;
}

bool has_measured_argument(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::vector<SyntaxId> pending = sides;
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    if (syntax[id].kind == SyntaxKind::term && takes_measured_argument(syntax, syntax.children(id)))
      return true;
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
  }
  return false;
}

}  // namespace

void Session::declare_units(const Directive& directive) {
  for (std::size_t k = 0; k < directive.symbols.size(); ++k) {
    const std::optional<Typed> typed = read_declared(directive.symbols[k]);
    if (typed && options_.forms != nullptr)
      options_.forms->declare_unit(tree_[typed->id].symbol, directive.dimensions[k]);
    if (typed)
      dimensions_.declare(typed->id, directive.dimensions[k], notes_.syntax[directive.symbols[k]].span,
                          directive.number);
  }
}

/// A reading that was only a guess says nothing of dimensions.
void Session::record_dimensions(const ParsedChain& parsed, ChainReading& reading, const Context& context,
                                std::size_t first_step) {
  const auto guess = reading.elaborator().guess();
  if (guess && guess->kind == DiagnosticKind::ambiguous_reading) return;
  if (has_measured_argument(notes_.syntax, parsed.sides)) return;
  const bool where = context.role == Role::given && is_one_of(context.directive, wheres_);
  const bool local = where || context.role == Role::claim;
  bool read_before = false;
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) {
    const Side& left = reading.sides[k];
    const Side& right = reading.sides[k + 1];
    if (!left.typed || !right.typed || first_step + k >= report_.steps.size()) {
      read_before = false;
      continue;
    }
    const Step& step = report_.steps[first_step + k];
    const bool redefined =
        step.verdict == Verdict::definition &&
        std::any_of(step.diagnostics.begin(), step.diagnostics.end(),
                    [](const Diagnostic& each) { return each.kind == DiagnosticKind::redefinition; });
    if (redefined && tree_[left.typed->id].op == Op::symbol) dimensions_.renew(tree_[left.typed->id].symbol);
    dimensions_.add({.step = first_step + k,
                     .left = left.typed->id,
                     .right = right.typed->id,
                     .left_span = parsed.written.sides[k].span,
                     .right_span = parsed.written.sides[k + 1].span,
                     .compared = compares(parsed.written.relations[k].kind),
                     .inner_left = !read_before,
                     .source = local ? DimensionSource::local : DimensionSource::law});
    read_before = true;
    if (where) dimensions_.assume_last();
  }
}

void Session::finish_dimensions() {
  solve_dimensions(dimensions_.record(), sources_, report_);
  for (const DeclaredUnit& unit : dimensions_.record().units) {
    if (dimensions_.is_used(unit)) names_.mark_used(unit.directive);
  }
}

}  // namespace rigor
