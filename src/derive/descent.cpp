// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/descent.h"

#include <algorithm>
#include <array>

#include "derive/along_axes.h"
#include "derive/canonical.h"
#include "derive/contraction.h"
#include "derive/in_components.h"
#include "derive/line.h"
#include "derive/unfold.h"

namespace rigor {
namespace {

constexpr int most_lines = 40;
constexpr std::uint32_t most_weight = 20'000;

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

class Descending {
 public:
  Descending(ExprTree& tree, const DescentRules& rules) : tree_(tree), rules_(rules) {}

  Descent descend(ExprId side) {
    push({side}, "", "", false);
    if (rules_.axes) write_cases();
    while (!stopped_ && (unfold() || (rules_.axes ? write_along_axes() : write_components()))) {
    }
    if (!stopped_ && multiply_out()) {
      while (!stopped_ && contract()) {
      }
      apply("like terms collected", "terms split", [&](IndexPolynomial& polynomial) {
        polynomial = collected(tree_, polynomial);
        return true;
      });
    }
    if (!has_polynomials_ || stopped_) polynomials_.clear();
    return {std::move(lines_), std::move(polynomials_)};
  }

 private:
  [[nodiscard]] const std::vector<ExprId>& parts() const { return lines_.back().parts; }

  /// Puts a line behind the others, unless it says the same as the last one.
  bool push(std::vector<ExprId> parts, std::string down, std::string up, bool flat) {
    Line line{.parts = {}, .down = std::move(down), .up = std::move(up), .flat = flat};
    for (const ExprId part : parts) line.parts.push_back(with_letters(tree_, part, rules_.letters));
    std::uint64_t weight = 0;
    for (const ExprId part : line.parts) weight += tree_[part].weight;
    if (lines_.size() >= most_lines || weight > most_weight) {
      stopped_ = true;
      return false;
    }
    describe(tree_, line);
    if (!lines_.empty() && line.shape == lines_.back().shape && line.terms == lines_.back().terms &&
        line.parts.size() == lines_.back().parts.size()) {
      lines_.back().flat = lines_.back().flat || flat;
      return false;
    }
    lines_.push_back(std::move(line));
    return true;
  }

  bool unfold() {
    for (const NamedRule& rule : rules_.definitions) {
      std::vector<ExprId> changed = parts();
      for (ExprId& part : changed) part = unfolded(tree_, part, rule.definition);
      if (changed != parts() && push(std::move(changed), rule.name, rule.name, false)) return true;
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
    return push({after}, rule, rule, false);
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
    const std::string rule = rules_.free.empty() ? "components along the axes 1, 2, 3"
                                                 : "component by component along the axes 1, 2, 3";
    return push(std::move(written), rule, rule, false);
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
    for (const ExprId part : parts()) {
      auto polynomial = polynomial_of(tree_, part);
      if (!polynomial) return false;
      polynomials_.push_back(*std::move(polynomial));
    }
    has_polynomials_ = true;
    push_polynomials("multiplied out", "factored");
    return true;
  }

  bool push_polynomials(std::string down, std::string up) {
    std::vector<ExprId> written;
    for (const IndexPolynomial& polynomial : polynomials_) written.push_back(expression_of(tree_, polynomial));
    return push(std::move(written), std::move(down), std::move(up), true);
  }

  /// A rule on all parts; true if a part changed.
  template <class Rule>
  bool apply(const std::string& down, const std::string& up, const Rule& rule) {
    if (!has_polynomials_ || stopped_) return false;
    bool changed = false;
    for (IndexPolynomial& polynomial : polynomials_) changed = rule(polynomial) || changed;
    if (changed) push_polynomials(down, up);
    return changed;
  }

  /// Terms that vanish or cancel are not worth contracting.
  bool shorten() {
    return apply("like terms collected", "terms split", [&](IndexPolynomial& polynomial) {
      IndexPolynomial shorter = collected(tree_, polynomial);
      if (shorter.terms.size() >= polynomial.terms.size()) return false;
      polynomial = std::move(shorter);
      return true;
    });
  }

  bool contract() {
    if (rules_.axes && apply("components along the axes 1, 2, 3", "components along the axes 1, 2, 3",
                             [](IndexPolynomial& polynomial) { return write_out_sums(polynomial); }))
      return true;
    if (apply("δ contracted", "δ put in", [](IndexPolynomial& polynomial) { return contract_deltas(polynomial); }))
      return true;
    if (shorten()) return true;
    const SymbolTable& symbols = tree_.symbols;
    if (apply("a rotation is orthogonal", "a rotation is orthogonal", [&](IndexPolynomial& polynomial) {
          return contract_rotations(symbols, polynomial);
        }))
      return true;
    if (apply("length of a unit vector", "length of a unit vector", [&](IndexPolynomial& polynomial) {
          return contract_unit_vectors(symbols, polynomial);
        }))
      return true;
    for (const NamedReplacement& each : rules_.replacements) {
      if (apply(each.name, each.name, [&](IndexPolynomial& polynomial) {
            return replace_given(tree_, each.replacement, polynomial);
          }))
        return true;
    }
    return apply("ε–δ", "ε–δ", [](IndexPolynomial& polynomial) { return contract_epsilons(polynomial); });
  }

  ExprTree& tree_;
  const DescentRules& rules_;
  std::vector<Line> lines_;
  std::vector<IndexPolynomial> polynomials_;
  bool has_polynomials_ = false;
  bool stopped_ = false;
};

}  // namespace

Descent descend(ExprTree& tree, ExprId side, const DescentRules& rules) {
  return Descending(tree, rules).descend(side);
}

}  // namespace rigor
