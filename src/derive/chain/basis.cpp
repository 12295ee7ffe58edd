// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/basis.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/among.h"
#include "derive/notation/letter_choice.h"
#include "derive/notation/unfold.h"

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

/// Takes out of a part of the list what is not needed, the last first; large parts at once. `list` is one of
/// the basis's own.
template <class Entry>
void drop_needless(SmallProofs& proofs, const Question& question, Basis& basis, std::vector<Entry>& list,
                   std::size_t from, std::size_t to) {
  if (from == to) return;
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(from);
  const std::vector<Entry> part(begin, list.begin() + static_cast<std::ptrdiff_t>(to));
  list.erase(begin, list.begin() + static_cast<std::ptrdiff_t>(to));
  if (is_proved(proofs, question, basis)) return;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(from), part.begin(), part.end());
  if (to - from == 1) return;
  const std::size_t middle = from + (to - from) / 2;
  drop_needless(proofs, question, basis, list, middle, to);
  drop_needless(proofs, question, basis, list, from, middle);
}

/// What an equation says about the symbol alone on its left: for all its components.
std::optional<Definition> as_definition(const ExprTree& tree, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  if (left.op != Op::symbol || equation.relation != Relation::equal) return std::nullopt;
  Definition definition{.symbol = left.symbol, .particle = left.particle, .body = equation.right};
  for (const Slot& slot : tree.slots(equation.left)) {
    const bool free = slot.axis == 0 && is_one_of(slot.variable, equation.indices);
    const bool repeated = is_one_of(slot.variable, definition.indices);
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
  drop_needless(proofs, question, basis, basis.assumptions, 0, basis.assumptions.size());
  drop_needless(proofs, question, basis, basis.definitions, 0, basis.definitions.size());
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
      const bool taken = std::ranges::any_of(rules, same);
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

Question widened(const ExprTree& tree, Question question, std::span<const KnownEquation> known) {
  std::vector<NamedRule> own;
  for (const Definition& definition : question.definitions) own.push_back({definition, ""});
  std::vector<ExprId> sides{question.claim.left, question.claim.right};
  for (const Equation& assumption : question.assumptions) {
    sides.push_back(assumption.left);
    sides.push_back(assumption.right);
  }
  std::set<SymbolId> spoken_of = reached_from(tree, sides, own);
  for (const NamedRule& rule : own) spoken_of.insert(rule.definition.symbol);
  for (auto each = known.rbegin(); each != known.rend(); ++each) {
    for (const Definition& definition : each->definitions) {
      if (spoken_of.insert(definition.symbol).second) question.definitions.push_back(definition);
    }
  }
  return question;
}

DescentRules rules_of(ExprTree& tree, const Question& question, const Basis& basis, Orientation orientation) {
  DescentRules rules;
  rules.definitions = basis.definitions;
  rules.frames = turning_frames(tree, question);
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
