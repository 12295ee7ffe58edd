// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/explanation.h"

#include <algorithm>
#include <utility>

#include "base/among.h"
#include "derive/chain/line.h"
#include "derive/chain/rearrangement.h"
#include "derive/notation/unfold.h"
#include "derive/polynomial/nodes.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// A chain that was glued of two descents, what has to be proved of it, and how good it is.
struct GluedChain {
  ExprId start{};
  std::vector<SmallStep> steps = {};
  std::vector<Rules> rules = {};                       // one for each step
  std::vector<std::pair<ExprId, ExprId>> claims = {};  // one for each step
  std::vector<IndexId> free = {};
  std::vector<IndexId> letters = {};
  bool by_cases = false;

  /// Steps that only undo what another one did read badly; a rule alone that is the claim says nothing.
  [[nodiscard]] std::size_t cost() const {
    std::size_t total = 2 * steps.size();
    for (const Rules& each : rules) {
      if (has(each, RuleKind::terms_split) || has(each, RuleKind::delta_put_in)) total += 1;
    }
    const bool says_nothing = steps.size() == 1 && (has(rules[0], RuleKind::cross_of_cross) ||
                                                    has(rules[0], RuleKind::dot_of_crosses));
    return total + (says_nothing ? 100 : 0);
  }

  static bool has(const Rules& rules, RuleKind kind) { return is_one_of(Rule{kind}, rules); }
};

/// Is nothing written in index notation?
bool is_direct(const ExprTree& tree, ExprId root) {
  return std::ranges::none_of(nodes_below(tree, {root}), [&](ExprId id) {
    const Op op = tree[id].op;
    const bool index = op == Op::index_sum || op == Op::delta || op == Op::epsilon || op == Op::component ||
                       op == Op::table || op == Op::basis || op == Op::determinant || tree[id].slot_count > 0;
    return index || (op == Op::tuple && !tree.is_zero_literal(id));
  });
}

class Explaining {
 public:
  Explaining(ExprTree& tree, const Question& question)
      : tree_(tree), question_(question), proofs_(tree, question_) {}

  Explanation explain(const QuestionNames& names, std::span<const KnownEquation> known) {
    if (question_.claim.relation != Relation::equal)
      return gap("one side of an order is not turned into the other");
    const Basis whole = whole_basis(question_, names);
    const auto needed = needed_of(proofs_, question_, whole);
    if (!needed) return gap("it is not proved");
    std::vector<Basis> bases{*needed};
    question_ = widened(tree_, std::move(question_), known);
    const bool from_nothing = needed->definitions.empty() && needed->assumptions.empty();
    for (const bool latest : {true, false}) {
      if (from_nothing || known.empty()) break;
      auto wider = with_known(tree_, question_, whole, known, latest);
      if (!wider) continue;
      if (auto fewer = needed_of(proofs_, question_, *std::move(wider))) bases.push_back(*std::move(fewer));
    }
    return best_of(bases, {});
  }

  Explanation explain_nearly(const NearlyQuestion& nearly) {
    return best_of({whole_basis(question_, nearly.names)}, nearly.small);
  }

 private:
  Explanation gap(std::string why) const {
    Explanation result;
    result.start = question_.claim.left;
    result.gap = std::move(why);
    return result;
  }

  /// Vectors stay vectors, or index notation, whichever is shorter; along the axes where neither does.
  Explanation best_of(const std::vector<Basis>& bases, const std::vector<ExprId>& small) {
    using enum DescentNotation;
    std::optional<GluedChain> best;
    for (const bool axes : {false, true}) {
      for (const Orientation orientation : {Orientation::as_written, Orientation::leading}) {
        for (const Basis& basis : bases) {
          if (orientation == Orientation::leading && basis.assumptions.empty()) continue;
          for (const DescentNotation notation : {direct, components, DescentNotation::axes}) {
            if ((notation == DescentNotation::axes) != axes) continue;
            DescentRules rules = rules_of(tree_, question_, basis, orientation);
            rules.small = small;
            rules.notation = notation;
            auto chain = chain_in(std::move(rules));
            if (chain && (!best || chain->cost() < best->cost())) best = std::move(chain);
          }
        }
        if (best) return explanation_of(*std::move(best));
      }
    }
    return gap("no chain of small steps was found");
  }

  static Explanation explanation_of(GluedChain chain) {
    Explanation result;
    result.start = chain.start;
    result.steps = std::move(chain.steps);
    result.letters = std::move(chain.letters);
    result.by_cases = chain.by_cases;
    return result;
  }

  std::optional<GluedChain> chain_in(DescentRules rules) {
    const auto [left, right] = std::pair(question_.claim.left, question_.claim.right);
    const int rank = tree_[left].rank;
    switch (rules.notation) {
      case DescentNotation::direct: {
        if (!is_direct(tree_, left) || !is_direct(tree_, right) || rank > 1 || !rules.small.empty())
          return std::nullopt;
        for (int axis = 0; axis < rank; ++axis) {
          const auto letter = free_letter(rules.letters);
          if (!letter) return std::nullopt;
          rules.open.push_back(*letter);
        }
        return chain_by(rules, left, right);
      }
      case DescentNotation::components: {
        std::vector<Slot> slots;
        for (int axis = 0; axis < rank; ++axis) {
          const auto letter = free_letter(rules.letters);
          if (!letter) return std::nullopt;
          slots.push_back({0, *letter});
          rules.free.push_back(slots.back().variable);
        }
        auto chain =
            chain_by(rules, component_within(tree_, left, slots), component_within(tree_, right, slots));
        if (chain) chain->letters.assign(rules.free.end() - rank, rules.free.end());
        return chain;
      }
      case DescentNotation::axes: {
        if (rules.free.size() + static_cast<std::size_t>(rank) > 2) return std::nullopt;
        for (const ExprId side : {left, right}) {
          for (const SymbolId symbol : symbols_in(tree_, side)) {
            if (tree_.symbols[symbol].unit)
              rules.replacements.push_back(
                  {replacement_of_unit(tree_, symbol), words_of({{RuleKind::unit_vector}})});
          }
        }
        auto chain = chain_by(rules, left, right);
        if (chain) chain->by_cases = !rules.free.empty();
        return chain;
      }
    }
    return std::nullopt;
  }

  /// Nothing where all are taken.
  std::optional<IndexId> free_letter(LetterChoice& letters) {
    for (const char* name : {"i", "j", "k", "l", "m", "n", "p", "q", "r", "s"}) {
      if (letters.taken.insert(name).second) return tree_.add_index(name);
    }
    return std::nullopt;
  }

  std::optional<GluedChain> chain_by(const DescentRules& rules, ExprId left, ExprId right) {
    Descent down = descend(tree_, left, rules);
    Descent up = descend(tree_, right, rules);
    if (rules.notation != DescentNotation::direct) append_common_denominator(tree_, rules, down, up);
    int trials = 0;
    for (const auto& [i, j] : meetings(down, up)) {
      GluedChain chain = glued(down, i, up, j, rules);
      if (holds(chain)) return chain;
      if (++trials == most_trials) break;
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
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) {
      return std::pair(a.first + a.second, a.second) < std::pair(b.first + b.second, b.second);
    });
    return found;
  }

  /// Down to line i of the left side, which is line j of the right side, and up from there.
  GluedChain glued(const Descent& down, std::size_t i, const Descent& up, std::size_t j,
                   const DescentRules& rules) {
    const auto expression = [&](const Line& line) { return as_expression(tree_, line, rules.free); };
    GluedChain chain{.start = expression(down.lines[0]), .free = rules.free};
    ExprId before = chain.start;
    const auto add = [&](const Line& line, const Line& lower, const Rules& how, bool goes_down) {
      const ExprId after = expression(line);
      const bool nearly = !lower.left_out.empty();
      if (!nearly && same_expression(tree_, before, tree_, after)) return;
      const ExprId whole =
          nearly ? as_expression(tree_, with_left_out(lower, goes_down ? &line : nullptr), rules.free)
                 : (goes_down ? after : before);
      chain.claims.emplace_back(goes_down ? before : after, whole);
      chain.rules.push_back(described(tree_, how, before, after));
      chain.steps.push_back({after, words_of(chain.rules.back()), nearly});
      before = after;
    };
    for (std::size_t k = 1; k <= i; ++k)
      add(k == i ? up.lines[j] : down.lines[k], down.lines[k], down.lines[k].down, true);
    for (std::size_t k = j; k-- > 0;) add(up.lines[k], up.lines[k + 1], up.lines[k + 1].up, false);
    if (chain.steps.empty()) {
      const ExprId after = expression(up.lines[0]);
      chain.rules = {described(tree_, {}, before, after)};
      chain.steps = {{after, words_of(chain.rules[0])}};
      chain.claims = {{before, after}};
    }
    return chain;
  }

  /// A line and what it has left out; `instead`: the line that is in its place.
  Line with_left_out(const Line& line, const Line* instead) {
    Line whole = instead != nullptr ? *instead : line;
    for (std::size_t k = 0; k < whole.parts.size(); ++k)
      whole.parts[k] = sum_node(tree_, {whole.parts[k], line.left_out[k]});
    return whole;
  }

  bool holds(const GluedChain& chain) {
    return std::ranges::all_of(chain.claims, [&](const auto& claim) {
      return proofs_.equal(claim.first, claim.second, chain.free);
    });
  }

  static constexpr int most_trials = 6;

  ExprTree& tree_;
  Question question_;
  SmallProofs proofs_;
};

bool is_equation(const WrittenStep& step) {
  const bool equal = !step.question || step.question->claim.relation == Relation::equal;
  return equal && !step.nearly && (step.defines || step.outcome == Outcome::proved);
}

/// What the tagged chains before a step say of their first forms.
std::vector<KnownEquation> known_before(const WrittenForms& forms, std::size_t chain, std::size_t step) {
  std::vector<KnownEquation> known;
  for (std::size_t k = 0; k <= chain; ++k) {
    const WrittenFormChain& earlier = forms.chains[k];
    if (earlier.tag.empty() || earlier.assumed || earlier.forms.empty() || !earlier.forms[0].expr) continue;
    const std::size_t end = k < chain ? earlier.steps.size() : step;
    for (std::size_t s = 0; s < end && is_equation(earlier.steps[s]); ++s) {
      const auto& right = earlier.forms[s + 1].expr;
      if (!right || forms.tree[*right].rank != forms.tree[*earlier.forms[0].expr].rank) break;
      known.push_back({{.left = *earlier.forms[0].expr,
                        .right = *right,
                        .indices = earlier.indices,
                        .particles = earlier.particles},
                       "Eq. " + earlier.tag,
                       earlier.definitions});
    }
  }
  return known;
}

}  // namespace

Explanation explain(ExprTree& tree, const Question& question, const QuestionNames& names,
                    std::span<const KnownEquation> known) {
  return Explaining(tree, question).explain(names, known);
}

Explanation explain(ExprTree& tree, const NearlyQuestion& question) {
  return Explaining(tree, question.exact).explain_nearly(question);
}

Explanation explain_step(WrittenForms& forms, std::size_t chain, std::size_t step) {
  const WrittenStep written = forms.chains[chain].steps[step];
  Explanation open;
  if (const auto& left = forms.chains[chain].forms[step].expr) open.start = *left;
  open.gap = written.outcome == Outcome::refuted ? "it is refuted" : "it is not proved";
  if (written.outcome != Outcome::proved || !written.question) return open;
  if (written.nearly) {
    if (written.nearly_question) return explain(forms.tree, *written.nearly_question);
    open.gap = "nothing says what is small";
    return open;
  }
  return explain(forms.tree, *written.question, written.names, known_before(forms, chain, step));
}

}  // namespace rigor
