// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/descent.h"

#include <algorithm>
#include <utility>

#include "derive/chain/line.h"
#include "derive/notation/along_axes.h"
#include "derive/notation/first_order.h"
#include "derive/notation/in_components.h"
#include "derive/notation/tidied.h"
#include "derive/notation/unfold.h"
#include "derive/polynomial/collected.h"
#include "derive/polynomial/contraction.h"
#include "derive/polynomial/fold.h"
#include "derive/polynomial/nodes.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

constexpr int most_lines = 40;
constexpr std::uint32_t most_weight = 20'000;
constexpr int most_depth = 6;  // of roots, quotients and functions within each other: texts of them double

/// All values of some free letters, the last one fastest.
std::vector<std::vector<std::uint8_t>> axes_of(std::size_t letters) {
  std::vector<std::vector<std::uint8_t>> all{{}};
  for (std::size_t k = 0; k < letters; ++k) {
    std::vector<std::vector<std::uint8_t>> longer;
    for (const auto& each : all) {
      for (std::uint8_t axis = 1; axis <= 3; ++axis) {
        longer.push_back(each);
        longer.back().push_back(axis);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// How deep roots, quotients and functions are within each other.
int depth_of(const IndexPolynomial& polynomial) {
  int depth = 0;
  for (const IndexMonomial& term : polynomial.terms) {
    for (const IndexFactor& factor : term.factors) {
      if (factor.argument != nullptr) depth = std::max(depth, 1 + depth_of(*factor.argument));
    }
  }
  return depth;
}

class Descending {
 public:
  Descending(ExprTree& tree, const DescentRules& rules) : tree_(tree), rules_(rules) {}

  Descent descend(ExprId side) {
    push({side}, {}, false);
    if (rules_.notation == DescentNotation::axes) {
      while (!stopped_ && tree_[parts()[0]].rank > 0 && unfold()) {
      }
      if (!stopped_) write_cases();
    }
    while (!stopped_ && (unfold() || write_out())) {
    }
    if (!stopped_ && multiply_out()) {
      do {
        if (!rules_.small.empty()) leave_out_second_order();
      } while (!stopped_ && contract());
      collect();
    }
    if (!has_polynomials_ || stopped_) polynomials_.clear();
    return {std::move(lines_), std::move(polynomials_)};
  }

 private:
  [[nodiscard]] const std::vector<ExprId>& parts() const { return lines_.back().parts; }

  /// Puts a line after the others, unless it says the same as the last one.
  bool push(std::vector<ExprId> parts, const Rules& rules, bool flat) {
    return push(std::move(parts), rules, rules, flat);
  }

  bool push(std::vector<ExprId> parts, Rules down, Rules up, bool flat) {
    Line line{.parts = {}, .down = std::move(down), .up = std::move(up), .flat = flat};
    for (const ExprId part : parts) {
      const ExprId plain = lines_.empty() ? part : tidied(tree_, part);  // the first one is as it is written
      line.parts.push_back(with_letters(tree_, plain, rules_.letters));
    }
    std::uint64_t weight = 0;
    for (const ExprId part : line.parts) weight += tree_[part].weight;
    if (lines_.size() >= most_lines || weight > most_weight) {
      stopped_ = true;
      return false;
    }
    describe(tree_, line, rules_.open);
    if (!lines_.empty() && line.shape == lines_.back().shape && line.terms == lines_.back().terms &&
        line.parts.size() == lines_.back().parts.size()) {
      lines_.back().flat = lines_.back().flat || flat;
      return false;
    }
    lines_.push_back(std::move(line));
    return true;
  }

  bool unfold() {
    for (const TurningFrame& frame : rules_.frames) {
      std::vector<ExprId> changed = parts();
      for (ExprId& part : changed) part = transported(tree_, part, frame);
      if (changed != parts() && push(std::move(changed), {{RuleKind::transport}}, false)) return true;
    }
    for (const NamedRule& rule : rules_.definitions) {
      std::vector<ExprId> changed = parts();
      for (ExprId& part : changed) part = unfolded_part(part, rule.definition);
      if (changed != parts() && push(std::move(changed), {{RuleKind::named, rule.name}}, false)) return true;
    }
    return false;
  }

  /// Along axes, what is unfolded is written along them at once: there zeros go.
  ExprId unfolded_part(ExprId part, const Definition& definition) {
    const ExprId changed = unfolded(tree_, part, definition);
    if (changed == part || rules_.notation != DescentNotation::axes || tree_[changed].rank > 0)
      return changed;
    return along_axes(tree_, changed, {}, {}).value_or(changed);
  }

  bool write_out() {
    switch (rules_.notation) {
      case DescentNotation::direct:
        return false;
      case DescentNotation::components:
        return write_components();
      case DescentNotation::axes:
        return write_along_axes();
    }
    return false;
  }

  bool write_components() {
    WrittenOut what;
    const ExprId before = parts()[0];
    const ExprId after = in_components(tree_, before, {}, what);
    if (after == before || what.empty()) return false;
    std::string rule;
    for (const std::string& each : what) rule += (rule.empty() ? "" : ", ") + each;
    return push({after}, {{RuleKind::named, rule}}, false);
  }

  void write_cases() {
    std::vector<ExprId> cases;
    for (const auto& axes : axes_of(rules_.free.size() + tree_[parts()[0]].rank)) {
      const auto written = along_axes(tree_, parts()[0], rules_.free, axes);
      if (!written) {
        stopped_ = true;
        return;
      }
      cases.push_back(*written);
    }
    push_along_axes(std::move(cases));
  }

  bool push_along_axes(std::vector<ExprId> written) {
    const RuleKind rule = rules_.free.empty() ? RuleKind::along_axes : RuleKind::by_axes;
    return push(std::move(written), {{rule}}, false);
  }

  bool write_along_axes() {
    std::vector<ExprId> written;
    for (const ExprId part : parts()) {
      const auto each = along_axes(tree_, part, {}, {});
      if (!each) {
        stopped_ = true;
        return false;
      }
      written.push_back(*each);
    }
    return written != parts() && push_along_axes(std::move(written));
  }

  bool multiply_out() {
    polynomials_.clear();
    std::vector<Slot> slots;
    for (const IndexId letter : rules_.open) slots.push_back({0, letter});
    for (const ExprId part : parts()) {
      auto polynomial = polynomial_of(tree_, part, slots);
      if (!polynomial) return false;
      polynomials_.push_back(*std::move(polynomial));
    }
    has_polynomials_ = true;
    push_polynomials({RuleKind::rearranged}, {RuleKind::rearranged});
    return true;
  }

  bool push_polynomials(const Rule& down, const Rule& up) {
    std::vector<ExprId> written;
    for (IndexPolynomial& polynomial : polynomials_) {
      if (depth_of(polynomial) > most_depth) {
        stopped_ = true;
        return false;
      }
      join_powers(tree_, polynomial);
      const bool direct = rules_.notation == DescentNotation::direct;
      const auto expr = direct ? folded(tree_, polynomial, rules_.open) : expression_of(tree_, polynomial);
      if (!expr) {  // between two lines that can be written
        add_pending(down, up);
        return false;
      }
      written.push_back(*expr);
    }
    add_pending(down, up);
    return push(std::move(written), std::exchange(pending_down_, {}), std::exchange(pending_up_, {}), true);
  }

  void add_pending(const Rule& down, const Rule& up) {
    if (pending_down_.empty() || pending_down_.back() != down) pending_down_.push_back(down);
    if (pending_up_.empty() || pending_up_.front() != up) pending_up_.insert(pending_up_.begin(), up);
  }

  /// A rule on all parts, and on what is opaque in them; true if anything changed.
  template <class Work>
  bool apply(const Rule& down, const Rule& up, const Work& work) {
    if (!has_polynomials_ || stopped_) return false;
    bool changed = false;
    for (IndexPolynomial& polynomial : polynomials_) changed = apply_within(polynomial, work) || changed;
    if (changed) push_polynomials(down, up);
    return changed;
  }
  template <class Work>
  bool apply(const Rule& rule, const Work& work) {
    return apply(rule, rule, work);
  }

  /// A rule on all parts, and on nothing that is opaque in them.
  template <class Work>
  bool apply_outside(const Rule& rule, const Work& work) {
    if (!has_polynomials_ || stopped_) return false;
    bool changed = false;
    for (IndexPolynomial& polynomial : polynomials_) changed = work(polynomial) || changed;
    if (changed) push_polynomials(rule, rule);
    return changed;
  }

  template <class Work>
  bool apply_within(IndexPolynomial& polynomial, const Work& work) {
    bool changed = false;
    for (IndexMonomial& term : polynomial.terms) {
      for (IndexFactor& factor : term.factors) {
        if (factor.argument == nullptr) continue;
        IndexPolynomial argument = *factor.argument;
        if (!apply_within(argument, work)) continue;
        factor.argument = std::make_shared<const IndexPolynomial>(std::move(argument));
        changed = true;
      }
    }
    return work(polynomial) || changed;
  }

  void collect() {
    apply({RuleKind::rearranged}, [&](IndexPolynomial& polynomial) {
      polynomial = collected(tree_, polynomial);
      return true;
    });
  }

  /// Terms that vanish or cancel are not worth contracting.
  bool shorten() {
    return apply({RuleKind::rearranged}, [&](IndexPolynomial& polynomial) {
      IndexPolynomial shorter = collected(tree_, polynomial);
      if (shorter.terms.size() >= polynomial.terms.size()) return false;
      polynomial = std::move(shorter);
      return true;
    });
  }

  bool contract() {
    const SymbolTable& symbols = tree_.symbols;
    const bool along = rules_.notation == DescentNotation::axes;
    if (along && apply({RuleKind::along_axes}, [](IndexPolynomial& each) { return write_out_sums(each); }))
      return true;
    if (apply({RuleKind::delta_contracted}, {RuleKind::delta_put_in},
              [](IndexPolynomial& each) { return contract_deltas(each); }))
      return true;
    const bool direct = rules_.notation == DescentNotation::direct;
    const RuleKind vanishing = direct ? RuleKind::product_with_itself : RuleKind::antisymmetric_epsilon;
    if (apply({vanishing}, [&](IndexPolynomial& each) { return drop_antisymmetric(symbols, each); }))
      return true;
    if (shorten()) return true;
    if (apply({RuleKind::orthogonal_rotation},
              [&](IndexPolynomial& each) { return contract_rotations(symbols, each); }))
      return true;
    if (apply({RuleKind::unit_vector},
              [&](IndexPolynomial& each) { return contract_unit_vectors(symbols, each); }))
      return true;
    for (const NamedReplacement& each : rules_.replacements) {
      const auto replace = [&](IndexPolynomial& polynomial) {
        return replace_given(tree_, each.replacement, polynomial);
      };
      const Rule rule{RuleKind::named, each.name};
      if (each.replacement.inside ? apply(rule, replace) : apply_outside(rule, replace)) return true;
    }
    if (apply({double_product()}, [&](IndexPolynomial& each) {
          if (!contract_epsilons(each)) return false;
          if (direct) contract_deltas(each);  // no δ is written there
          return true;
        }))
      return true;
    return apply({RuleKind::squares_of_sine_and_cosine},
                 [](IndexPolynomial& each) { return replace_cosines(each); });
  }

  /// What is ε–δ in components, in direct notation.
  RuleKind double_product() const {
    if (rules_.notation != DescentNotation::direct) return RuleKind::epsilon_delta;
    for (const ExprId part : parts()) {
      if (crosses_a_cross(part)) return RuleKind::cross_of_cross;
    }
    return RuleKind::dot_of_crosses;
  }

  bool crosses_a_cross(ExprId root) const {
    return std::ranges::any_of(nodes_below(tree_, {root}), [&](ExprId id) {
      return tree_[id].op == Op::cross && std::ranges::any_of(tree_.children(id), [&](ExprId child) {
               return tree_[child].op == Op::cross;
             });
    });
  }

  void leave_out_second_order() {
    std::vector<IndexPolynomial> kept = polynomials_;
    std::vector<ExprId> left_out;
    bool any = false;
    for (IndexPolynomial& polynomial : kept) {
      const auto rest = without_second_order(tree_, rules_.small, polynomial);
      if (!rest) return;
      any = any || !tree_.is_zero_literal(*rest);
      left_out.push_back(*rest);
    }
    if (!any) return;
    polynomials_ = std::move(kept);
    std::string rule = "first order in ";
    for (const ExprId small : rules_.small)
      rule += (small == rules_.small[0] ? "" : ", ") + print_latex(tree_, small);
    if (push_polynomials({RuleKind::named, rule}, {RuleKind::named, rule}))
      lines_.back().left_out = std::move(left_out);
  }

  ExprTree& tree_;
  const DescentRules& rules_;
  std::vector<Line> lines_;
  std::vector<IndexPolynomial> polynomials_;
  Rules pending_down_;  // since the last line
  Rules pending_up_;
  bool has_polynomials_ = false;
  bool stopped_ = false;
};

}  // namespace

Descent descend(ExprTree& tree, ExprId side, const DescentRules& rules) {
  return Descending(tree, rules).descend(side);
}

}  // namespace rigor
