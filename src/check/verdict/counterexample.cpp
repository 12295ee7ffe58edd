// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/counterexample.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "algebra/decide/decide.h"
#include "base/among.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

tl::unexpected<Error> does_not_fit(std::string reason) {
  return tl::make_unexpected(Error{std::move(reason)});
}

/// How many axes the value of a side has, in a sample that gives matrices of any size one.
int axes_in_sample(const ExprTree& tree, ExprId side) {
  if (tree[side].rank > 0) return tree[side].rank;
  const UnsizedShape shape = unsized_shape(tree, side);
  return shape == UnsizedShape::matrix ? 2 : shape == UnsizedShape::number ? 0 : 1;
}

/// The claim's axes and particles; the description names their indices.
/// How the first axis of the claim's k-th index is numbered: 0 in space-time.
int first_number(const Question& question, std::size_t k) {
  const std::vector<IndexId>& indices = question.claim.indices;
  return k < indices.size() && question.tree->space(indices[k]) == space_time ? 0 : 1;
}

Result<Sample> placed(const Question& question, const Counterexample& example) {
  constexpr std::uint32_t most_particles = 100;  // a sample that we make has 6 at most
  if (example.particles > most_particles) return does_not_fit("the sample has too many particles");
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  constexpr int most_rows = 3;  // of a matrix of any size
  const int of_sides = std::max(axes_in_sample(tree, claim.left), axes_in_sample(tree, claim.right));
  const std::size_t axes = claim.indices.size() + static_cast<std::size_t>(of_sides);
  Sample sample;
  sample.particles = example.particles;
  if (example.component.size() != axes + claim.particles.size())
    return does_not_fit("the sample's component does not fit the step");
  for (std::size_t k = 0; k < example.component.size(); ++k) {
    const auto& [index, value] = example.component[k];
    const bool is_particle = k >= axes;
    const int axis_of_side = static_cast<int>(k) - static_cast<int>(claim.indices.size());
    const std::string expected = is_particle                ? tree.name(claim.particles[k - axes])
                                 : k < claim.indices.size() ? tree.name(claim.indices[k])
                                                            : "";
    const int most = is_particle                  ? static_cast<int>(example.particles)
                     : k < claim.indices.size()   ? tree.space(claim.indices[k]).dimension
                     : tree[claim.left].rank == 0 ? most_rows
                                                  : tree[claim.left].axes[axis_of_side].dimension;
    const int number = value + 1 - (is_particle ? 1 : first_number(question, k));
    if (index != expected || number < 1 || number > most)
      return does_not_fit("the sample's component does not fit the step");
    if (is_particle) {
      sample.free_particles.push_back(static_cast<std::uint32_t>(number));
    } else {
      sample.axes.push_back(static_cast<std::uint8_t>(number));
    }
  }
  return sample;
}

/// As its values are printed: matrices and columns of any size have a size in a sample.
int printed_rank(const Symbol& symbol) {
  if (symbol.unsized == Unsized::none) return symbol.rank;
  return symbol.unsized == Unsized::column ? 1 : 2;
}

/// `x^\mu` for a tensor of space-time, which can have the letter of a coordinate.
std::string name_in_sample(const ExprTree& tree, SymbolId id) {
  const Symbol& symbol = tree.symbols[id];
  const Symbol& base = tree.symbols[base_of(tree.symbols, id)];
  if (base.rank == 0 || base.axes[0] != space_time) return symbol.name;
  static constexpr std::array<std::string_view, 4> letters{"\\mu", "\\nu", "\\rho", "\\sigma"};
  std::string above;
  for (std::size_t k = 0; k < static_cast<std::size_t>(base.rank) && k < letters.size(); ++k)
    above += letters[k];
  return symbol.name + (base.rank == 1 ? "^" + above : "^{" + above + "}");
}

Counterexample::Value described(const ExprTree& tree, const SampleValue& value) {
  const Symbol& symbol = tree.symbols[value.symbol];
  return {name_in_sample(tree, value.symbol), value.particle, printed_rank(symbol), value.components};
}

/// Which derivatives a reader needs to see that the assumptions hold and the sides differ: those in the step,
/// and those in what is assumed, but for what vanishes.
class Needed {
 public:
  explicit Needed(const Prepared& prepared) : tree_(*prepared.question.tree) {
    Question question = prepared.question;
    question.assumptions.resize(prepared.without_slack);
    by_assumptions_ = symbols_of_sample(question);
    question.assumptions.clear();
    by_claim_ = symbols_of_sample(question);
  }
  [[nodiscard]] bool is_needed(const SampleValue& value) const {
    if (!tree_.symbols[value.symbol].derivation || is_one_of(value.symbol, by_claim_)) return true;
    const bool vanishes =
        std::ranges::all_of(value.components, [](const std::string& each) { return each == "0"; });
    return !vanishes && is_one_of(value.symbol, by_assumptions_);
  }

 private:
  const ExprTree& tree_;
  std::vector<SymbolId> by_assumptions_;
  std::vector<SymbolId> by_claim_;
};

}  // namespace

Counterexample describe(const Prepared& prepared, const Sample& sample) {
  const ExprTree& tree = *prepared.question.tree;
  const Equation& claim = prepared.question.claim;
  const Needed needed(prepared);
  Counterexample example;
  example.particles = sample.particles;
  for (const SampleValue& value : sample.values) {
    example.values.push_back(described(tree, value));
    example.values.back().beyond = !needed.is_needed(value);
  }
  for (const SampleValue& value : following_values(prepared.question, sample)) {
    const Span seen = tree.symbols[value.symbol].first_seen;  // the rotation behind a frame is not written
    if (seen.begin != seen.end) example.follows.push_back(described(tree, value));
  }
  for (std::size_t k = 0; k < sample.axes.size(); ++k) {
    const std::string index = k < claim.indices.size() ? tree.name(claim.indices[k]) : "";
    example.component.push_back({index, sample.axes[k] - 1 + first_number(prepared.question, k)});
  }
  for (std::size_t k = 0; k < sample.free_particles.size() && k < claim.particles.size(); ++k) {
    example.component.push_back({tree.name(claim.particles[k]), static_cast<int>(sample.free_particles[k])});
  }
  example.left = sample.left;
  example.right = sample.right;
  return example;
}

Result<Sample> sample_of(const Question& question, const Counterexample& example) {
  Result<Sample> sample = placed(question, example);
  if (!sample) return sample;
  std::vector<bool> taken(example.values.size(), false);
  for (const SymbolId id : symbols_of_sample(question)) {
    const Symbol& symbol = question.tree->symbols[id];
    const std::uint32_t last = symbol.per_particle ? example.particles : 0;
    for (std::uint32_t particle = symbol.per_particle ? 1 : 0; particle <= last; ++particle) {
      std::size_t k = 0;
      while (k < taken.size() &&
             (taken[k] || example.values[k].symbol != name_in_sample(*question.tree, id) ||
              example.values[k].rank != printed_rank(symbol) || example.values[k].particle != particle))
        ++k;
      if (k == taken.size())
        return does_not_fit(fmt::format("the sample has no value of rank {} for `{}`{}", printed_rank(symbol),
                                        symbol.name,
                                        particle > 0 ? fmt::format(" of particle {}", particle) : ""));
      taken[k] = true;
      sample->values.push_back({id, particle, example.values[k].components});
    }
  }
  const auto extra = std::ranges::find(taken, false);
  if (extra == taken.end()) return sample;
  const auto& value = example.values[static_cast<std::size_t>(extra - taken.begin())];
  return does_not_fit(fmt::format("the step does not depend on `{}`", value.symbol));
}

}  // namespace rigor
