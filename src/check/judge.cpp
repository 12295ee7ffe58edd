// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "algebra/decide.h"
#include "check/identity_reading.h"
#include "source/suggest.h"

namespace rigor {
namespace {

/// The question, and which of the names' definitions and assumptions went into it.
struct Prepared {
  Question question;
  std::vector<const NamedDefinition*> definitions;
  std::vector<const NamedAssumption*> assumptions;
};

/// Everything that the claim can depend on: definitions of its symbols, and assumptions that share a symbol
/// with it, until nothing is added.
Prepared prepare(const ExprTree& tree, const Names& names, const Equation& claim) {
  Prepared prepared;
  prepared.question.tree = &tree;
  prepared.question.claim = claim;
  std::set<SymbolId> reached;
  std::vector<ExprId> pending{claim.left, claim.right};
  std::set<const NamedAssumption*> taken;
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    for (const SymbolId symbol : symbols_in(tree, id)) {
      if (!reached.insert(symbol).second) continue;
      if (const NamedDefinition* definition = names.definition_of(symbol)) {
        prepared.definitions.push_back(definition);
        prepared.question.definitions.push_back(definition->definition);
        pending.push_back(definition->definition.body);
      }
    }
    if (!pending.empty()) continue;
    for (const NamedAssumption& assumption : names.assumptions()) {
      if (taken.contains(&assumption)) continue;
      std::vector<SymbolId> own = symbols_in(tree, assumption.equation.left);
      const std::vector<SymbolId> right = symbols_in(tree, assumption.equation.right);
      own.insert(own.end(), right.begin(), right.end());
      if (std::none_of(own.begin(), own.end(), [&](SymbolId symbol) { return reached.contains(symbol); }))
        continue;
      taken.insert(&assumption);
      prepared.assumptions.push_back(&assumption);
      prepared.question.assumptions.push_back(assumption.equation);
      pending.push_back(assumption.equation.left);
      pending.push_back(assumption.equation.right);
    }
  }
  return prepared;
}

void mark_used(Names& names, const Origin& origin) {
  if (origin.directive) names.mark_used(*origin.directive);
}

Counterexample describe(const ExprTree& tree, const Equation& equation, const Sample& sample) {
  Counterexample example;
  example.particles = sample.particles;
  for (const SampleValue& value : sample.values) {
    const Symbol& symbol = tree.symbols[value.symbol];
    example.values.push_back({symbol.name, value.particle, symbol.rank, value.components});
  }
  for (std::size_t k = 0; k < sample.axes.size(); ++k) {
    const std::string index = k < equation.indices.size() ? tree.name(equation.indices[k]) : "";
    example.component.push_back({index, sample.axes[k]});
  }
  for (std::size_t k = 0; k < sample.free_particles.size() && k < equation.particles.size(); ++k) {
    example.component.push_back(
        {tree.name(equation.particles[k]), static_cast<int>(sample.free_particles[k])});
  }
  example.left = sample.left;
  example.right = sample.right;
  return example;
}

std::string quoted_names(const ExprTree& tree, const std::vector<SymbolId>& symbols) {
  std::string text;
  std::vector<std::string> names;
  for (const SymbolId symbol : symbols) {
    const std::string& name = tree.symbols[symbol].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) text += k + 1 == names.size() ? " and " : ", ";
    text += "`" + names[k] + "`";
  }
  return text;
}

/// A symbol's name without face and braces: `\\boldsymbol{\\omega}` is `\\omega`.
std::string bare_name(std::string name) {
  for (const char* mark : {"\\mathbf", "\\boldsymbol", "\\text", "\\hat", "\\mathrm", "{", "}", "'"}) {
    for (std::size_t at = name.find(mark); at != std::string::npos; at = name.find(mark))
      name.erase(at, std::string(mark).size());
  }
  return name;
}

/// A known name that differs in face, primes or one letter of a long name.
std::optional<std::string> likely_meant(const std::string& name, const std::vector<std::string>& known) {
  const std::string bare = bare_name(name);
  for (const std::string& other : known) {
    if (other == name) continue;
    const std::string candidate = bare_name(other);
    const bool long_enough = bare.size() > 4 && candidate.size() > 4;
    if (candidate == bare || (long_enough && edit_distance(candidate, bare, 1) == 1)) return other;
  }
  return std::nullopt;
}

Diagnostic law_diagnostic(const ExprTree& tree, const Names& names, const Claim& claim,
                          const std::vector<SymbolId>& symbols) {
  Diagnostic diagnostic{
      DiagnosticKind::undeclared_symbol, claim.relation,
      fmt::format(
          "{} {} neither declared nor defined, so this reads as a law or a condition, not as an identity",
          quoted_names(tree, symbols), symbols.size() == 1 ? "is" : "are")};
  const std::vector<std::string> known = names.known_names(tree);
  for (const SymbolId symbol : symbols) {
    const std::string& name = tree.symbols[symbol].name;
    if (const auto near = likely_meant(name, known))
      diagnostic.help.push_back(fmt::format("is `{}` meant for `{}`?", *near, name));
  }
  diagnostic.help.push_back(
      "`rigor: given` makes it an assumption, `rigor: let` a definition; declared symbols are meant for all "
      "values");
  return diagnostic;
}

/// `-3/2` as an expression.
ExprId add_rational(ExprTree& tree, Span span, const std::string& value) {
  const bool negative = value.starts_with('-');
  const std::string digits = negative ? value.substr(1) : value;
  const auto slash = digits.find('/');
  ExprId number = tree.add_number(span, digits.substr(0, slash));
  if (slash != std::string::npos) {
    const ExprId parts[] = {number, tree.add_number(span, digits.substr(slash + 1))};
    number = tree.add({.op = Op::divide, .span = span}, parts);
  }
  return negative ? tree.add({.op = Op::negate, .span = span}, std::span(&number, 1)) : number;
}

class Judging {
 public:
  Judging(ExprTree& tree, Names& names, const Claim& claim)
      : tree_(tree), names_(names), claim_(claim), prepared_(prepare(tree, names, claim.equation)) {}

  Judgement judge() {
    for (const NamedDefinition* definition : prepared_.definitions) mark_used(names_, definition->origin);
    const Decision decision = decide(prepared_.question);
    for (const std::size_t which : decision.assumptions)
      mark_used(names_, prepared_.assumptions[which]->origin);
    judgement_.route = decision.route;
    switch (decision.outcome) {
      case Outcome::proved:
        proved(decision);
        break;
      case Outcome::refuted:
        refuted(decision);
        break;
      case Outcome::undecided:
        judgement_.verdict = Verdict::undecided;
        for (const NamedAssumption* assumption : prepared_.assumptions) mark_used(names_, assumption->origin);
        add(DiagnosticKind::undecided,
            decision.reason.empty() ? "no proof and no counterexample was found" : decision.reason);
        break;
    }
    note_uses(decision);
    return std::move(judgement_);
  }

 private:
  void add(DiagnosticKind kind, std::string message, std::vector<std::string> help = {}) {
    judgement_.diagnostics.push_back({kind, claim_.relation, std::move(message), {}, std::move(help)});
  }

  void note_uses(const Decision& decision) {
    for (const NamedDefinition* definition : prepared_.definitions) {
      const auto& unfolded = decision.unfolded;
      const bool used =
          std::find(unfolded.begin(), unfolded.end(), definition->definition.symbol) != unfolded.end();
      if (used) judgement_.uses.push_back(definition->origin.text);
    }
    for (const std::size_t which : decision.assumptions)
      judgement_.uses.push_back(prepared_.assumptions[which]->origin.text);
    for (const std::string& convention : claim_.reading->conventions())
      judgement_.uses.push_back("convention: " + convention);
  }

  void proved(const Decision& decision) {
    for (const std::size_t which : decision.assumptions) {
      if (!prepared_.assumptions[which]->without_sample) continue;
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided,
          "it follows from assumptions that no sample was found to satisfy, and from the impossible anything "
          "follows");
      return;
    }
    judgement_.verdict = Verdict::proved;
    const bool zero_written =
        tree_.is_zero_literal(claim_.equation.left) || tree_.is_zero_literal(claim_.equation.right);
    if (!decision.vanishes || zero_written) return;
    judgement_.route += ", 0 = 0";
    add(DiagnosticKind::zero_equals_zero,
        "both sides are zero for all values, so the step says less than it seems to");
  }

  /// `A·(A×B) = 1`: where neither side depends on anything, no law can make it true.
  bool both_constant(const Sample& sample) {
    if (!sample.axes.empty() || !sample.free_particles.empty()) return false;
    const auto is_constant = [&](ExprId side, const std::string& value) {
      Question question = prepared_.question;
      question.claim.left = side;
      question.claim.right = add_rational(tree_, claim_.relation, value);
      return decide(question).outcome == Outcome::proved;
    };
    return is_constant(claim_.equation.left, sample.left) && is_constant(claim_.equation.right, sample.right);
  }

  /// The left side is a defined symbol alone, so that the step says again what it is.
  bool restates_definition() const {
    const ExprNode& left = tree_[claim_.equation.left];
    return left.op == Op::symbol && names_.definition_of(left.symbol) != nullptr;
  }

  /// `|m\mathbf v| = mv` fails for negative m, and a mass is none. Samples prefer positive scalars, so that a
  /// negative one was needed.
  std::optional<std::string> undeclared_negative(const Sample& sample) const {
    const auto has_root = [&](ExprId root) {
      std::vector<ExprId> pending{root};
      for (const NamedDefinition* definition : prepared_.definitions)
        pending.push_back(definition->definition.body);
      while (!pending.empty()) {
        const ExprId id = pending.back();
        pending.pop_back();
        const Op op = tree_[id].op;
        if (op == Op::root || op == Op::length || op == Op::absolute) return true;
        for (const ExprId child : tree_.children(id)) pending.push_back(child);
      }
      return false;
    };
    if (!has_root(claim_.equation.left) && !has_root(claim_.equation.right)) return std::nullopt;
    for (const SampleValue& value : sample.values) {
      const Symbol& symbol = tree_.symbols[value.symbol];
      if (symbol.rank == 0 && !symbol.declared && value.components[0].starts_with('-')) return symbol.name;
    }
    return std::nullopt;
  }

  void refuted(const Decision& decision) {
    for (const NamedAssumption* assumption : prepared_.assumptions) mark_used(names_, assumption->origin);
    if (claim_.reading->guess() || claim_.doubt != nullptr) {
      const Obstacle& guess = claim_.reading->guess() ? *claim_.reading->guess() : *claim_.doubt;
      judgement_.verdict = Verdict::not_understood;
      add(guess.kind, guess.message + "; the equation does not hold in the reading that was tried",
          guess.help);
      return;
    }
    const std::vector<SymbolId> law = law_symbols(prepared_.question, restates_definition());
    if (!law.empty() && !both_constant(*decision.sample)) {
      judgement_.verdict = Verdict::not_understood;
      judgement_.diagnostics.push_back(law_diagnostic(tree_, names_, claim_, law));
      return;
    }
    if (const auto negative = undeclared_negative(*decision.sample)) {
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided,
          fmt::format("it was found to fail only where `{}` is negative, and nothing says whether it can be",
                      *negative),
          {fmt::format("`rigor: scalar {}` means it for all values", *negative)});
      return;
    }
    judgement_.verdict = Verdict::refuted;
    judgement_.counterexample = describe(tree_, claim_.equation, *decision.sample);
    judgement_.diagnostics.push_back({DiagnosticKind::refuted,
                                      claim_.relation,
                                      fmt::format("the sides differ: left is {}, right is {}",
                                                  decision.sample->left, decision.sample->right),
                                      {{claim_.left, ""}, {claim_.right, ""}}});
  }

  ExprTree& tree_;
  Names& names_;
  const Claim& claim_;
  Prepared prepared_;
  Judgement judgement_;
};

}  // namespace

Judgement judge(ExprTree& tree, Names& names, const Claim& claim) {
  return Judging(tree, names, claim).judge();
}

bool assumptions_have_a_sample(const ExprTree& tree, const Names& names) {
  Question question;
  question.tree = &tree;
  for (const NamedDefinition& definition : names.definitions())
    question.definitions.push_back(definition.definition);
  for (const NamedAssumption& assumption : names.assumptions())
    question.assumptions.push_back(assumption.equation);
  if (question.assumptions.empty()) return true;
  question.claim = question.assumptions.back();
  return satisfiable(question);
}

}  // namespace rigor
