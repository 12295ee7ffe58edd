// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/basis.h"

#include <algorithm>
#include <set>
#include <utility>

#include "derive/letter_choice.h"
#include "derive/unfold.h"

namespace rigor {
namespace {

constexpr int most_unfoldings = 12;

std::string name_of(const std::vector<std::string>& names, std::size_t k) {
  return k < names.size() && !names[k].empty() ? names[k] : "as given";
}

bool is_proved(SmallProofs& proofs, const Question& question, const Basis& basis) {
  std::vector<Definition> definitions;
  for (const NamedRule& rule : basis.definitions) definitions.push_back(rule.definition);
  std::vector<Equation> assumptions;
  for (const KnownEquation& each : basis.assumptions) assumptions.push_back(each.equation);
  return proofs
             .decide_from(question.claim.left, question.claim.right, std::move(definitions),
                          std::move(assumptions))
             .outcome == Outcome::proved;
}

/// What an equation says of the symbol alone on its left: for all its components.
std::optional<Definition> as_definition(const ExprTree& tree, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  if (left.op != Op::symbol || equation.relation != Relation::equal) return std::nullopt;
  Definition definition{.symbol = left.symbol, .particle = left.particle, .body = equation.right};
  for (const Slot& slot : tree.slots(equation.left)) {
    const bool free = slot.axis == 0 && std::find(equation.indices.begin(), equation.indices.end(),
                                                  slot.variable) != equation.indices.end();
    const bool repeated = std::find(definition.indices.begin(), definition.indices.end(), slot.variable) !=
                          definition.indices.end();
    if (!free || repeated) return std::nullopt;
    definition.indices.push_back(slot.variable);
  }
  return definition;
}

/// All symbols that an expression leads to.
std::set<SymbolId> reached_from(const ExprTree& tree, std::vector<ExprId> open,
                                const std::vector<NamedRule>& definitions) {
  std::set<SymbolId> reached;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    for (const SymbolId symbol : symbols_in(tree, id)) {
      if (!reached.insert(symbol).second) continue;
      for (const NamedRule& rule : definitions) {
        if (rule.definition.symbol == symbol) open.push_back(rule.definition.body);
      }
    }
  }
  return reached;
}

}  // namespace

Basis whole_basis(const Question& question, const QuestionNames& names) {
  Basis basis;
  for (std::size_t k = 0; k < question.definitions.size(); ++k)
    basis.definitions.push_back({question.definitions[k], name_of(names.definitions, k)});
  for (std::size_t k = 0; k < question.assumptions.size(); ++k)
    basis.assumptions.push_back({question.assumptions[k], name_of(names.assumptions, k)});
  return basis;
}

std::optional<Basis> needed_of(SmallProofs& proofs, const Question& question, Basis basis) {
  Basis nothing;
  if (is_proved(proofs, question, nothing)) return nothing;
  if (!is_proved(proofs, question, basis)) return std::nullopt;
  const auto drop = [&](auto& list) {
    for (std::size_t k = list.size(); k-- > 0;) {
      const auto dropped = list[k];
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
      if (!is_proved(proofs, question, basis))
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(k), dropped);
    }
  };
  drop(basis.assumptions);
  drop(basis.definitions);
  return basis;
}

std::optional<Basis> with_known(const ExprTree& tree, const Question& question, Basis basis,
                                std::span<const KnownEquation> known, bool latest) {
  bool any = false;
  const std::vector<ExprId> sides{question.claim.left, question.claim.right};
  const std::set<SymbolId> reached = reached_from(tree, sides, basis.definitions);
  std::vector<NamedRule> rules;
  std::vector<KnownEquation> equations;
  for (const KnownEquation& each : known) {
    const ExprNode& left = tree[each.equation.left];
    if (left.op != Op::symbol || !reached.contains(left.symbol)) continue;
    if (const auto definition = as_definition(tree, each.equation)) {
      const auto same = [&](const NamedRule& rule) { return rule.definition.symbol == definition->symbol; };
      const bool taken = std::any_of(rules.begin(), rules.end(), same);
      if (taken && !latest) continue;
      std::vector<NamedRule> all = basis.definitions;
      std::erase_if(all, same);
      for (const NamedRule& rule : rules) {
        std::erase_if(
            all, [&](const NamedRule& other) { return other.definition.symbol == rule.definition.symbol; });
      }
      std::erase_if(rules, same);
      all.insert(all.end(), rules.begin(), rules.end());
      if (reached_from(tree, {definition->body}, all).contains(definition->symbol)) continue;
      rules.push_back({*definition, each.name});
      any = true;
    } else {
      equations.push_back({each.equation, each.name});
      any = true;
    }
  }
  if (!any) return std::nullopt;
  for (const NamedRule& rule : rules) {
    std::erase_if(basis.definitions,
                  [&](const NamedRule& other) { return other.definition.symbol == rule.definition.symbol; });
  }
  basis.definitions.insert(basis.definitions.begin(), rules.begin(), rules.end());
  basis.assumptions.insert(basis.assumptions.begin(), equations.begin(), equations.end());
  return basis;
}

DescentRules rules_of(ExprTree& tree, const Question& question, const Basis& basis, Orientation orientation) {
  DescentRules rules;
  rules.definitions = basis.definitions;
  const auto add = [&](const Equation& equation, const std::string& name) {
    if (auto replacement = replacement_of(tree, equation, orientation))
      rules.replacements.push_back({*std::move(replacement), name});
  };
  for (const KnownEquation& each : basis.assumptions) {
    add(each.equation, each.name);
    Equation inner = each.equation;
    for (int round = 0; round < most_unfoldings; ++round) {
      const Equation before = inner;
      for (const NamedRule& rule : basis.definitions) {
        inner.left = unfolded(tree, inner.left, rule.definition);
        inner.right = unfolded(tree, inner.right, rule.definition);
      }
      if (inner.left == before.left && inner.right == before.right) break;
    }
    if (inner.left != each.equation.left || inner.right != each.equation.right) add(inner, each.name);
  }
  for (const ExprId side : {question.claim.left, question.claim.right})
    note_letters(tree, side, rules.letters);
  for (const IndexId index : question.claim.indices) rules.letters.taken.insert(tree.name(index));
  for (const ParticleId particle : question.claim.particles) rules.letters.taken.insert(tree.name(particle));
  rules.free = question.claim.indices;
  return rules;
}

}  // namespace rigor
