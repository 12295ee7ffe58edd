// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/explanation.h"

#include <algorithm>
#include <utility>

#include "derive/descent.h"
#include "derive/line.h"
#include "derive/small_proofs.h"
#include "expr/differentiate.h"

namespace rigor {
namespace {

std::vector<std::size_t> without(std::vector<std::size_t> positions, std::size_t at) {
  positions.erase(positions.begin() + static_cast<std::ptrdiff_t>(at));
  return positions;
}

/// A chain that was glued of two descents, and how good it is.
struct Chain {
  ExprId start{};
  std::vector<SmallStep> steps;
  std::size_t cost = 0;
};

class Explaining {
 public:
  Explaining(ExprTree& tree, const Question& question, const QuestionNames& names)
      : tree_(tree), question_(question), names_(names), proofs_(tree, question_) {}

  Explanation explain() {
    Explanation result;
    result.start = question_.claim.left;
    if (question_.claim.relation != Relation::equal) {
      result.gap = "an order is not turned from one side into the other";
      return result;
    }
    if (!find_what_is_needed()) {
      result.gap = "the exact side does not prove it";
      return result;
    }
    if (auto chain = best_chain()) {
      result.start = chain->start;
      result.steps = std::move(chain->steps);
    } else {
      result.gap = "no chain of small steps was found";
    }
    return result;
  }

 private:
  /// The definitions and assumptions without which the claim is not proved.
  bool find_what_is_needed() {
    const auto [left, right] = std::pair(question_.claim.left, question_.claim.right);
    if (proofs_.decide_with(left, right, {}, {}).outcome == Outcome::proved) return true;
    for (std::size_t k = 0; k < question_.definitions.size(); ++k) definitions_.push_back(k);
    for (std::size_t k = 0; k < question_.assumptions.size(); ++k) assumptions_.push_back(k);
    const Decision first = proofs_.decide_with(left, right, definitions_, assumptions_);
    if (first.outcome != Outcome::proved) return false;
    assumptions_ = first.assumptions;
    std::erase_if(definitions_, [&](std::size_t k) {
      const SymbolId symbol = question_.definitions[k].symbol;
      return std::find(first.unfolded.begin(), first.unfolded.end(), symbol) == first.unfolded.end();
    });
    const auto proved = [&](const auto& definitions, const auto& assumptions) {
      return proofs_.decide_with(left, right, definitions, assumptions).outcome == Outcome::proved;
    };
    for (std::size_t k = assumptions_.size(); k-- > 0;) {
      if (auto fewer = without(assumptions_, k); proved(definitions_, fewer)) assumptions_ = std::move(fewer);
    }
    for (std::size_t k = definitions_.size(); k-- > 0;) {
      if (auto fewer = without(definitions_, k); proved(fewer, assumptions_)) definitions_ = std::move(fewer);
    }
    return true;
  }

  DescentRules rules() {
    DescentRules rules;
    for (const std::size_t k : definitions_)
      rules.definitions.push_back({question_.definitions[k], name_of(names_.definitions, k)});
    for (const std::size_t k : assumptions_) {
      if (auto replacement = replacement_of(tree_, question_.assumptions[k]))
        rules.replacements.push_back({*std::move(replacement), name_of(names_.assumptions, k)});
    }
    for (const ExprId side : {question_.claim.left, question_.claim.right})
      note_letters(tree_, side, rules.letters);
    for (const IndexId index : question_.claim.indices) rules.letters.taken.insert(tree_.name(index));
    for (const ParticleId particle : question_.claim.particles)
      rules.letters.taken.insert(tree_.name(particle));
    rules.free = question_.claim.indices;
    return rules;
  }

  static std::string name_of(const std::vector<std::string>& names, std::size_t k) {
    return k < names.size() && !names[k].empty() ? names[k] : "as given";
  }

  /// In index notation, and along the axes where that does not do.
  std::optional<Chain> best_chain() {
    DescentRules of_components = rules();
    const int rank = tree_[question_.claim.left].rank;
    std::vector<Slot> slots;
    for (int axis = 0; axis < rank; ++axis) {
      slots.push_back({0, free_letter(of_components.letters)});
      of_components.free.push_back(slots.back().variable);
    }
    if (auto chain = chain_by(of_components, component_of(tree_, question_.claim.left, slots),
                              component_of(tree_, question_.claim.right, slots)))
      return chain;
    DescentRules along = rules();
    along.axes = true;
    if (along.free.size() + static_cast<std::size_t>(rank) > 2) return std::nullopt;
    return chain_by(along, question_.claim.left, question_.claim.right);
  }

  IndexId free_letter(LetterChoice& letters) {
    for (const char* name : {"i", "j", "k", "l", "m", "n", "p", "q", "r", "s"}) {
      if (letters.taken.insert(name).second) return tree_.add_index(name);
    }
    return tree_.add_index("u");
  }

  std::optional<Chain> chain_by(const DescentRules& rules, ExprId left, ExprId right) {
    Descent down = descend(tree_, left, rules);
    Descent up = descend(tree_, right, rules);
    append_common_denominator(tree_, rules, down, up);
    for (const auto& [i, j] : meetings(down, up)) {
      Chain chain = glued(down, i, up, j, rules);
      if (holds(chain, rules)) return chain;
    }
    return std::nullopt;
  }

  /// Where the descents meet, the shortest chain first.
  static std::vector<std::pair<std::size_t, std::size_t>> meetings(const Descent& down, const Descent& up) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t i = 0; i < down.lines.size(); ++i) {
      for (std::size_t j = 0; j < up.lines.size(); ++j) {
        if (meets(down.lines[i], up.lines[j])) found.emplace_back(i, j);
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first + a.second, a.second) < std::pair(b.first + b.second, b.second);
    });
    return found;
  }

  /// Down to line i of the left side, which is line j of the right side, and up from there.
  Chain glued(const Descent& down, std::size_t i, const Descent& up, std::size_t j, const DescentRules& rules) {
    const auto expression = [&](const Line& line) { return as_expression(tree_, line, rules.free); };
    Chain chain;
    chain.start = expression(down.lines[0]);
    for (std::size_t k = 1; k <= i; ++k) {
      const Line& line = k == i ? up.lines[j] : down.lines[k];
      chain.steps.push_back({expression(line), down.lines[k].down});
    }
    for (std::size_t k = j; k-- > 0;) chain.steps.push_back({expression(up.lines[k]), up.lines[k + 1].up});
    if (chain.steps.empty()) chain.steps.push_back({expression(up.lines[0]), "other letters, other order"});
    return chain;
  }

  bool holds(const Chain& chain, const DescentRules& rules) {
    const Equation asked = question_.claim;
    question_.claim.indices = rules.free;
    ExprId before = chain.start;
    bool all = true;
    for (const SmallStep& step : chain.steps) {
      all = all && proofs_.equal(before, step.expr);
      before = step.expr;
    }
    question_.claim = asked;
    return all;
  }

  ExprTree& tree_;
  Question question_;
  const QuestionNames& names_;
  SmallProofs proofs_;
  std::vector<std::size_t> definitions_;  // positions of those needed
  std::vector<std::size_t> assumptions_;
};

}  // namespace

Explanation explain(ExprTree& tree, const Question& question, const QuestionNames& names) {
  return Explaining(tree, question, names).explain();
}

}  // namespace rigor
