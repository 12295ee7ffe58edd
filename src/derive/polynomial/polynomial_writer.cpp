// SPDX-License-Identifier: GPL-3.0-or-later
// From a sum of monomials to an expression in index notation.
#include <algorithm>

#include "derive/polynomial/canonical.h"
#include "derive/polynomial/factor_node.h"
#include "derive/polynomial/index_polynomial.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

/// Numbers and scalars are in front, then δ and ε, then components.
int place_of(const IndexFactor& factor) {
  if (factor.kind == Kind::delta || factor.kind == Kind::epsilon) return 1;
  if (factor.kind == Kind::component) return factor.slots.empty() ? 0 : 2;
  return 3;
}

class PolynomialWriter {
 public:
  explicit PolynomialWriter(ExprTree& tree) : tree_(tree) {}

  ExprId write(const IndexPolynomial& polynomial) {
    std::vector<ExprId> terms;
    for (std::size_t k = 0; k < polynomial.terms.size();) {
      std::vector<IndexMonomial> group{polynomial.terms[k++]};
      while (k < polynomial.terms.size() && group[0].particles.size() == 1 &&
             polynomial.terms[k].particles.size() == 1)
        group.push_back(polynomial.terms[k++]);
      terms.push_back(group.size() == 1 ? term(group[0]) : under_one_sum(std::move(group)));
    }
    return sum_node(tree_, terms);
  }

 private:
  ExprId term(const IndexMonomial& monomial) {
    const bool negative = monomial.coefficient.over() < 0;
    const SmallRational size = negative ? monomial.coefficient * SmallRational(-1) : monomial.coefficient;
    ExprId body = product(size, monomial.factors, monomial.particles);
    for (auto index = monomial.indices.rbegin(); index != monomial.indices.rend(); ++index)
      body = index_sum_node(tree_, *index, body);
    return negative ? negated_node(tree_, body) : body;
  }

  /// The factors, with those that speak of a particle under its sum.
  ExprId product(SmallRational coefficient, std::vector<IndexFactor> factors,
                 std::vector<ParticleId> particles) {
    std::ranges::stable_sort(
        factors, [](const IndexFactor& a, const IndexFactor& b) { return place_of(a) < place_of(b); });
    if (particles.empty()) return quotient(coefficient, factors, {});
    const ParticleId particle = particles.front();
    particles.erase(particles.begin());
    std::vector<IndexFactor> inside;
    std::vector<IndexFactor> outside;
    for (const IndexFactor& factor : factors)
      (speaks_of(factor, particle) ? inside : outside).push_back(factor);
    std::vector<ParticleId> inner;  // sums over particles next to this one in a factor
    std::vector<ParticleId> beside;
    for (const ParticleId other : particles) {
      const bool joined =
          std::ranges::any_of(inside, [&](const IndexFactor& each) { return speaks_of(each, other); });
      (joined ? inner : beside).push_back(other);
    }
    if (!inner.empty()) {
      inside = factors;
      outside.clear();
      inner = particles;
      beside.clear();
    }
    const ExprId sum = particle_sum_node(tree_, particle, product(1, inside, inner));
    if (beside.empty()) return quotient(coefficient, outside, {sum});
    return product_node(tree_, {quotient(coefficient, {}, {sum}), product(1, outside, beside)});
  }

  ExprId quotient(SmallRational coefficient, const std::vector<IndexFactor>& factors,
                  const std::vector<ExprId>& behind) {
    std::vector<ExprId> over;
    std::vector<ExprId> under;
    for (const IndexFactor& factor : factors) {
      (factor.exponent < 0 ? under : over).push_back(factor_node(tree_, factor));
    }
    over.insert(over.end(), behind.begin(), behind.end());
    if (coefficient == SmallRational(1) || under.empty()) {
      if (coefficient != SmallRational(1)) over.insert(over.begin(), rational_node(tree_, coefficient));
      const ExprId dividend = product_node(tree_, over);
      return under.empty() ? dividend : quotient_node(tree_, dividend, product_node(tree_, under));
    }
    over.insert(over.begin(), number_node(tree_, coefficient.over()));
    under.insert(under.begin(), number_node(tree_, coefficient.under()));
    return quotient_node(tree_, product_node(tree_, over), product_node(tree_, under));
  }

  /// Σ_α m_α (…): one sum over particles for terms that have one each, with what they share in front.
  ExprId under_one_sum(std::vector<IndexMonomial> group) {
    const ParticleId particle = group[0].particles[0];
    for (IndexMonomial& term : group) {
      replace_particle(term, term.particles[0], particle);
      term.particles = {particle};
    }
    std::vector<IndexFactor> shared = take_shared(group);
    const SmallRational size = take_size(group);
    std::vector<ExprId> terms;
    for (IndexMonomial& each : group) {
      each.particles.clear();
      terms.push_back(term(each));
    }
    std::vector<IndexFactor> inside;
    std::vector<IndexFactor> outside;
    for (const IndexFactor& factor : shared)
      (speaks_of(factor, particle) ? inside : outside).push_back(factor);
    const ExprId body = quotient(1, inside, {sum_node(tree_, terms)});
    return quotient(size, outside, {particle_sum_node(tree_, particle, body)});
  }

  /// Factors that all terms have and that no sum over components reaches.
  std::vector<IndexFactor> take_shared(std::vector<IndexMonomial>& group) {
    std::vector<IndexFactor> shared;
    for (std::size_t k = 0; k < group[0].factors.size();) {
      const IndexFactor candidate = group[0].factors[k];
      std::vector<std::size_t> places{k};
      for (std::size_t other = 1; other < group.size(); ++other) {
        const auto place = place_of_equal(group[other], candidate);
        if (place) places.push_back(*place);
      }
      if (places.size() < group.size() || !is_open(group[0], candidate)) {
        ++k;
        continue;
      }
      shared.push_back(candidate);
      for (std::size_t other = 0; other < group.size(); ++other)
        group[other].factors.erase(group[other].factors.begin() + static_cast<std::ptrdiff_t>(places[other]));
    }
    return shared;
  }

  static bool is_open(const IndexMonomial& term, const IndexFactor& factor) {
    return std::ranges::none_of(term.indices, [&](IndexId index) { return speaks_of(factor, index); });
  }

  std::optional<std::size_t> place_of_equal(const IndexMonomial& term, const IndexFactor& candidate) {
    const std::string wanted = canonical_text(tree_.symbols, {{IndexMonomial{.factors = {candidate}}}});
    for (std::size_t k = 0; k < term.factors.size(); ++k) {
      if (canonical_text(tree_.symbols, {{IndexMonomial{.factors = {term.factors[k]}}}}) == wanted &&
          is_open(term, term.factors[k]))
        return k;
    }
    return std::nullopt;
  }

  /// The size of the coefficients, if they differ in sign only.
  static SmallRational take_size(std::vector<IndexMonomial>& group) {
    const auto size_of = [](SmallRational value) {
      return value.over() < 0 ? value * SmallRational(-1) : value;
    };
    const SmallRational size = size_of(group[0].coefficient);
    for (const IndexMonomial& term : group) {
      if (size_of(term.coefficient) != size) return 1;
    }
    for (IndexMonomial& term : group) term.coefficient = term.coefficient / size;
    return size;
  }

  ExprTree& tree_;
};

}  // namespace

ExprId expression_of(ExprTree& tree, const IndexPolynomial& polynomial) {
  return PolynomialWriter(tree).write(polynomial);
}

}  // namespace rigor
