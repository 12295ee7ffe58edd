// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/scope.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/among.h"

namespace rigor {
namespace {

/// What was said further out stays said.
void say_of(SaidOfSymbols& said, SymbolId symbol, int depth) {
  if (!said.contains(symbol)) said.put({symbol, depth});
}

/// What held before, but for what equations define since the last frame began.
void restore(NameScope& scope, Held held) {
  for (const NamedDefinition& later : scope.definitions) {
    if (is_made_in_frame(scope, later)) held.definitions.put(later);
  }
  replace(scope, std::move(held));
}

}  // namespace

std::vector<SymbolId> symbols_of(const std::vector<NamedDefinition>& definitions) {
  std::vector<SymbolId> symbols;
  for (const NamedDefinition& each : definitions) symbols.push_back(each.definition.symbol);
  return symbols;
}

void define(NameScope& scope, NamedDefinition definition) {
  definition.depth = definition.origin.directive ? scope.depth : 0;
  scope.last_body = std::max(scope.last_body, definition.definition.body);
  scope.definitions.put(std::move(definition));
}

const NamedDefinition* definition_of(const NameScope& scope, SymbolId symbol) {
  return scope.definitions.find(symbol);
}

std::optional<ExprId> body_of_definition(const NameScope& scope, SymbolId symbol) {
  const NamedDefinition* named = definition_of(scope, symbol);
  return named == nullptr ? std::nullopt : std::optional(named->definition.body);
}

std::vector<SymbolId> symbols_reached(const ExprTree& tree, const NameScope& scope,
                                      std::vector<ExprId> roots) {
  const auto below = [&](std::vector<ExprId> from) {
    return symbols_reached(tree, std::move(from), [&](SymbolId symbol) {
      return body_of_definition(scope, base_of(tree.symbols, symbol));
    });
  };
  std::vector<SymbolId> reached = below(std::move(roots));
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const auto& integral = tree.symbols[base_of(tree.symbols, reached[k])].integral;
    if (!integral) continue;
    for (const SymbolId inside : below(parts_of(*integral))) {
      if (!is_one_of(inside, reached)) reached.push_back(inside);
    }
  }
  return reached;
}

void forget_definition(NameScope& scope, SymbolId symbol) { scope.definitions.erase(symbol); }

void forget_definitions(NameScope& scope, const std::vector<SymbolId>& symbols) {
  const std::set<SymbolId> forgotten(symbols.begin(), symbols.end());
  scope.definitions.erase_if(
      [&](const NamedDefinition& each) { return forgotten.contains(each.definition.symbol); });
}

void assume(NameScope& scope, NamedAssumption assumption) {
  assumption.depth = scope.depth;
  scope.assumptions.push_back(std::move(assumption));
}

void doubt_last_assumption(NameScope& scope) {
  scope.assumptions.write(scope.assumptions.size() - 1).without_sample = true;
}

void note_unread(NameScope& scope, UnreadAssumption unread) {
  unread.depth = scope.depth;
  scope.unread.push_back(std::move(unread));
}

void replace(NameScope& scope, Held held) {
  scope.definitions = std::move(held.definitions);
  for (const NamedDefinition& each : scope.definitions)
    scope.last_body = std::max(scope.last_body, each.definition.body);
  scope.assumptions = std::move(held.assumptions);
}

void declare_constant(NameScope& scope, SymbolId symbol, std::optional<std::size_t> directive) {
  scope.constants.push_back({symbol, directive, scope.depth, scope.frames->size()});
}

bool is_declared_constant(const NameScope& scope, SymbolId symbol) {
  return std::ranges::any_of(scope.constants,
                             [&](const DeclaredConstant& each) { return each.symbol == symbol; });
}

Directives withdraw_constant(NameScope& scope, SymbolId symbol) {
  Directives withdrawn;
  for (const DeclaredConstant& each : scope.constants) {
    if (each.symbol == symbol && each.directive) withdrawn.insert(*each.directive);
  }
  scope.constants.erase_if([&](const DeclaredConstant& each) { return each.symbol == symbol; });
  return withdrawn;
}

void declare_variable(NameScope& scope, SymbolId symbol) { say_of(scope.variables, symbol, scope.depth); }

void end_family(NameScope& scope, SymbolId general) {
  scope.families.erase_if([&](const Family& each) { return each.general == general; });
}

void set_apart(NameScope& scope, SymbolId symbol) { say_of(scope.apart, symbol, scope.depth); }

void declare_small(NameScope& scope, SmallQuantity small) {
  small.depth = scope.depth;
  scope.small.push_back(std::move(small));
}

void note_other_order(NameScope& scope, SymbolId small) { say_of(scope.of_other_order, small, scope.depth); }

void mean_for_all(NameScope& scope, SymbolId symbol) { say_of(scope.for_all, symbol, scope.depth); }

void enter_frame(NameScope& scope, Frame frame) {
  frame.depth = scope.depth;
  scope.frames.write().push_back(std::move(frame));
}

void withdraw_frame(NameScope& scope) { scope.frames.write().pop_back(); }

bool is_made_in_frame(const NameScope& scope, const NamedDefinition& definition) {
  if (scope.frames->empty() || definition.origin.directive) return false;
  return std::ranges::none_of(scope.frames->back().before.definitions, [&](const NamedDefinition& old) {
    return old.definition.symbol == definition.definition.symbol && old.origin.text == definition.origin.text;
  });
}

void mark_seen(NameScope& scope, SymbolId symbol) {
  if (seen_in_equation(scope, symbol)) return;
  say_of(scope.seen, symbol, scope.depth);
  if (!scope.seen_anywhere.contains(symbol)) scope.seen_anywhere.put(symbol);
}

void open_section(NameScope& scope, int level) {
  const auto closed = [&](const auto& entry) { return entry.depth >= level; };
  const auto said_inside = [&](const auto& entry) { return entry.second >= level; };
  while (!scope.frames->empty() && closed(scope.frames->back())) {
    restore(scope, scope.frames->back().before);
    scope.frames.write().pop_back();
  }
  scope.definitions.erase_if(
      [&](const NamedDefinition& entry) { return entry.origin.directive && closed(entry); });
  scope.assumptions.erase_if(closed);
  scope.unread.erase_if(closed);
  scope.constants.erase_if(closed);
  scope.small.erase_if(closed);
  scope.families.erase_if(closed);
  for (auto* said : {&scope.variables, &scope.for_all, &scope.of_other_order, &scope.apart, &scope.seen})
    said->erase_if(said_inside);
  scope.depth = level;
}

}  // namespace rigor
