// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic/written_proof.h"

#include <ginac/ginac.h>

#include <cstdlib>
#include <map>
#include <utility>

#include "algebra/engine/terms.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::size_t largest_meaning = 1'000;  // operations for what a letter stands for

/// A polynomial in the indeterminates' positions, which are those of letters when all are known.
[[nodiscard]] ProofPolynomial written(const SparsePolynomial& value) {
  ProofPolynomial terms;
  for (const auto& [monomial, number] : value) {
    ProofTerm& term = terms.emplace_back(ProofTerm{to_text(number), {}});
    for (std::size_t x = 0; x < monomial.size(); ++x) {
      if (monomial[x] != 0)
        term.powers.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(monomial[x])});
    }
  }
  return terms;
}

/// Writes one proof.
class ProofWriter {
 public:
  ProofWriter(Proof& proof, const Scope& scope, GenericDomain& domain, const ConstraintsTrace& trace)
      : proof_(proof), scope_(scope), domain_(domain), trace_(trace), search_(domain, trace) {}

  void add(const ConstraintsTrace::Vanishing& vanishing, std::vector<std::uint8_t> axes);
  void add(const ConstraintsTrace::OfEachParticle& solution);
  /// Gives all letters that occur their meaning, and numbers them.
  void finish();

 private:
  [[nodiscard]] std::uint32_t equation(std::size_t position);
  [[nodiscard]] std::uint32_t nonzero(std::size_t position);
  [[nodiscard]] std::uint32_t position(const ex& indeterminate) const {
    return static_cast<std::uint32_t>(domain_.indeterminates().origin(indeterminate).position);
  }
  [[nodiscard]] ProofLetter letter(std::uint32_t position) const;
  [[nodiscard]] ProofLetter coordinate(const Indeterminates::Origin& origin) const;
  void note_quotient(ProofLetter& letter, const ex& value, int divisor) const;
  template <class Visit>
  void for_each_polynomial(const Visit& visit);

  Proof& proof_;
  const Scope& scope_;
  GenericDomain& domain_;
  const ConstraintsTrace& trace_;
  CofactorSearch search_;
  std::map<std::size_t, std::uint32_t> equations_;
  std::map<std::size_t, std::uint32_t> nonzero_;
};

std::uint32_t ProofWriter::equation(std::size_t at) {
  const auto [known, is_new] = equations_.try_emplace(at, proof_.equations.size());
  if (!is_new) return known->second;
  ProofEquation written_equation;
  written_equation.polynomial = written(search_.equation(at));
  if (at >= trace_.given.size()) {
    written_equation.source = ProofEquation::Source::square;
  } else if (trace_.given[at].origin == ConstraintsTrace::Given::Origin::unit_vector) {
    written_equation.source = ProofEquation::Source::unit_vector;
  } else {
    written_equation.assumption = trace_.given[at].assumption;
    written_equation.axes = trace_.given[at].axes;
    written_equation.particles = trace_.given[at].particles;
  }
  for (const auto& each : trace_.eliminations) {
    if (each.given == at) written_equation.solved_for = position(each.indeterminate);
  }
  proof_.equations.push_back(std::move(written_equation));
  return known->second;
}

std::uint32_t ProofWriter::nonzero(std::size_t at) {
  const auto [known, is_new] = nonzero_.try_emplace(at, proof_.nonzero.size());
  if (is_new)
    proof_.nonzero.push_back(
        {written(search_.read(trace_.nonzero[at].value)), trace_.nonzero[at].assumption});
  return known->second;
}

void ProofWriter::add(const ConstraintsTrace::Vanishing& vanishing, std::vector<std::uint8_t> axes) {
  ProofStep step{.axes = std::move(axes)};
  if (const auto found = search_.find(vanishing)) {
    step.numerator = written(found->numerator);
    if (found->nonzero)
      step.factors.push_back({nonzero(*found->nonzero), static_cast<std::uint32_t>(found->power)});
    for (const auto& [at, cofactor] : found->cofactors)
      step.cofactors.push_back({equation(at), written(cofactor)});
  } else {
    const bool cases = vanishing.how == ConstraintsTrace::Vanishing::How::cases;
    step.kind = cases ? ProofStep::Kind::cases : ProofStep::Kind::long_combination;
    step.assumptions.assign(vanishing.from.begin(), vanishing.from.end());
  }
  proof_.steps.push_back(std::move(step));
}

void ProofWriter::add(const ConstraintsTrace::OfEachParticle& solution) {
  const auto worth = search_.reader().read(solution.worth);
  if (worth)
    proof_.solutions.push_back({solution.assumption, position(solution.indeterminate), written(*worth)});
}

ProofLetter ProofWriter::coordinate(const Indeterminates::Origin& origin) const {
  ProofLetter named{.symbol = origin.symbol, .component = origin.component, .particle = origin.frame};
  if (scope_.is_defined(origin.symbol)) return named;
  const Symbol& symbol = scope_.tree().symbols[origin.symbol];
  if (symbol.rotation) named.kind = ProofLetter::Kind::quaternion;
  if (symbol.unit && !domain_.is_coordinates(origin.symbol)) named.kind = ProofLetter::Kind::projection;
  return named;
}

/// Factors with negative powers are in the denominator.
void ProofWriter::note_quotient(ProofLetter& letter, const ex& value, int divisor) const {
  SparseArithmetic arithmetic(search_.reader().variables(), largest_meaning);
  try {
    SparsePolynomial of = arithmetic.number(1);
    SparsePolynomial over = arithmetic.number(divisor);
    for (const ex& factor : factors_of(value)) {
      const auto [base, exponent] = split_power(factor);
      SparsePolynomial& part = exponent < 0 ? over : of;
      part = arithmetic.product(part, arithmetic.power(search_.read(base), std::abs(exponent)));
    }
    letter.of = written(of);
    letter.over = written(over);
  } catch (const TooLong&) {
    // its meaning is not written down
  }
}

ProofLetter ProofWriter::letter(std::uint32_t at) const {
  using Kind = ProofLetter::Kind;
  const ex& indeterminate = domain_.indeterminates().all()[at];
  const Indeterminates::Origin& origin = domain_.indeterminates().origin(indeterminate);
  if (origin.kind == Indeterminates::Kind::coordinate) return coordinate(origin);
  ProofLetter named{.kind = origin.kind == Indeterminates::Kind::radical ? Kind::root : Kind::parameter};
  for (const auto& [key, moment] : domain_.moments().by_key()) {
    if (!moment.is_equal(indeterminate)) continue;
    named.kind = Kind::moment;
    note_quotient(named, key, 1);
  }
  for (const auto& [quantity, functions] : domain_.functions().by_quantity()) {
    const bool sine = functions.sine.is_equal(indeterminate);
    const bool cosine = functions.cosine.is_equal(indeterminate);
    if (!sine && !cosine && !functions.exponential.is_equal(indeterminate)) continue;
    named.kind = sine ? Kind::sine : cosine ? Kind::cosine : Kind::exponential;
    note_quotient(named, quantity, domain_.functions().divisor());
  }
  for (const Functions::Value& value : domain_.functions().values()) {
    if (!value.symbol.is_equal(indeterminate)) continue;
    named.kind = value.function == Function::log      ? Kind::logarithm
                 : value.function == Function::arcsin ? Kind::arcsine
                                                      : Kind::arctangent;
    note_quotient(named, value.argument, 1);
  }
  if (domain_.functions().is_circle_number(indeterminate)) named.kind = Kind::circle;
  return named;
}

template <class Visit>
void ProofWriter::for_each_polynomial(const Visit& visit) {
  for (ProofEquation& each : proof_.equations) visit(each.polynomial);
  for (ProofNonzero& each : proof_.nonzero) visit(each.polynomial);
  for (ProofSolution& each : proof_.solutions) visit(each.worth);
  for (ProofStep& step : proof_.steps) {
    visit(step.numerator);
    for (ProofCofactor& each : step.cofactors) visit(each.cofactor);
  }
  for (ProofLetter& each : proof_.letters) {
    visit(each.of);
    visit(each.over);
  }
}

void ProofWriter::finish() {
  std::map<std::uint32_t, ProofLetter> letters;  // by position
  std::vector<std::uint32_t> open;
  const auto meet = [&](const ProofPolynomial& polynomial) {
    for (const ProofTerm& term : polynomial) {
      for (const ProofPower& power : term.powers) open.push_back(power.letter);
    }
  };
  for_each_polynomial(meet);
  for (const ProofSolution& each : proof_.solutions) open.push_back(each.letter);
  for (const ProofEquation& each : proof_.equations) {
    if (each.solved_for) open.push_back(*each.solved_for);
  }
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    if (letters.contains(at)) continue;
    const ProofLetter& named = letters[at] = letter(at);
    meet(named.of);
    meet(named.over);
  }
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (auto& [at, named] : letters) {
    numbers.emplace(at, static_cast<std::uint32_t>(numbers.size()));
    proof_.letters.push_back(std::move(named));
  }
  for_each_polynomial([&](ProofPolynomial& polynomial) {
    for (ProofTerm& term : polynomial) {
      for (ProofPower& power : term.powers) power.letter = numbers.at(power.letter);
    }
  });
  for (ProofSolution& each : proof_.solutions) each.letter = numbers.at(each.letter);
  for (ProofEquation& each : proof_.equations) {
    if (each.solved_for) each.solved_for = numbers.at(*each.solved_for);
  }
}

}  // namespace

void write_steps(Proof& proof, const Scope& scope, GenericDomain& domain, const ConstraintsTrace& trace,
                 std::span<const std::vector<std::uint8_t>> axes) {
  if (trace.vanishings.empty() && trace.of_each_particle.empty()) return;
  ProofWriter writer(proof, scope, domain, trace);
  for (std::size_t i = 0; i < trace.vanishings.size(); ++i) writer.add(trace.vanishings[i], axes[i]);
  for (const auto& solution : trace.of_each_particle) writer.add(solution);
  writer.finish();
}

}  // namespace rigor
