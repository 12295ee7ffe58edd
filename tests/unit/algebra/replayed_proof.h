// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs put to the test: cofactors are multiplied out at exact points by an evaluator that knows nothing of
// the one that found them, and the polynomials that they are about are compared with the sides of the
// question.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algebra/verdict.h"
#include "catch.h"
#include "expr/statement/proof.h"

namespace rigor::build {

using Values = std::vector<Rational>;  // of a proof's letters

[[nodiscard]] inline Rational value_at(const ProofPolynomial& polynomial, const Values& values) {
  Rational total = 0;
  for (const ProofTerm& term : polynomial) {
    Rational product = *from_text(term.coefficient);
    for (const ProofPower& power : term.powers)
      product = product * power_of(values.at(power.letter), static_cast<int>(power.exponent));
    total = total + product;
  }
  return total;
}

/// Small numbers that differ from letter to letter and from seed to seed.
[[nodiscard]] inline Values some_values(const Proof& proof, int seed) {
  Values values;
  for (std::size_t i = 0; i < proof.letters.size(); ++i) {
    const auto k = static_cast<long>(i);
    values.push_back(Rational((7 * k + 3 * seed * seed + 5) % 23 - 11) / Rational(2 + (k + seed) % 3));
  }
  return values;
}

[[nodiscard]] inline Rational factor_at(const Proof& proof, const ProofStep& step, const Values& values) {
  Rational factor = 1;
  for (const ProofFactor& each : step.factors) {
    factor = factor * power_of(value_at(proof.nonzero.at(each.nonzero).polynomial, values),
                               static_cast<int>(each.exponent));
  }
  return factor;
}

/// f · numerator = Σ c · e at points that meet no assumption.
[[nodiscard]] inline bool multiplies_out(const Proof& proof) {
  for (int seed = 1; seed <= 5; ++seed) {
    const Values values = some_values(proof, seed);
    for (const ProofStep& step : proof.steps) {
      if (step.kind != ProofStep::Kind::combination) return false;
      Rational sum = 0;
      for (const ProofCofactor& each : step.cofactors)
        sum = sum + value_at(each.cofactor, values) *
                        value_at(proof.equations.at(each.equation).polynomial, values);
      if (factor_at(proof, step, values) * value_at(step.numerator, values) != sum) return false;
    }
  }
  return true;
}

/// An equation's left − right where the letters of a proof are its symbols' components; the others are 0.
[[nodiscard]] inline Rational difference_at(const Question& question, const Equation& of, const Proof& proof,
                                            const Values& values, std::vector<std::uint8_t> axes) {
  Question alone{.tree = question.tree, .claim = of};
  Sample sample;
  std::map<SymbolId, std::vector<std::string>> components;
  for (const SymbolId symbol : symbols_of_sample(alone)) {
    const int rank = question.tree->symbols[symbol].rank;
    components[symbol].assign(component_count(rank), "0");
  }
  for (std::size_t i = 0; i < proof.letters.size(); ++i) {
    const ProofLetter& letter = proof.letters[i];
    REQUIRE(letter.kind == ProofLetter::Kind::component);
    if (components.contains(letter.symbol))
      components[letter.symbol].at(letter.component) = to_text(values[i]);
  }
  for (const auto& [symbol, texts] : components) sample.values.push_back({symbol, 0, texts});
  sample.axes = std::move(axes);
  const std::optional<SideValues> sides = replay(alone, sample);
  REQUIRE(sides);
  return *from_text(sides->left) - *from_text(sides->right);
}

/// The numerators and equations of a proof without denominators are those of the question.
[[nodiscard]] inline bool is_about(const Proof& proof, const Question& question) {
  for (int seed = 1; seed <= 3; ++seed) {
    const Values values = some_values(proof, seed);
    for (const ProofStep& step : proof.steps) {
      const Rational left_minus_right = difference_at(question, question.claim, proof, values, step.axes);
      if (value_at(step.numerator, values) != left_minus_right) return false;
    }
    for (const ProofEquation& each : proof.equations) {
      const Equation& given = question.assumptions.at(each.assumption);
      if (value_at(each.polynomial, values) != difference_at(question, given, proof, values, each.axes))
        return false;
    }
  }
  return true;
}

[[nodiscard]] inline Proof proof_of(const Question& question) {
  const Decision decision = decide(question);
  REQUIRE(decision.outcome == Outcome::proved);
  REQUIRE(decision.proof);
  CHECK(decision.assumptions == assumptions_of(*decision.proof));
  CHECK(decision.unfolded == decision.proof->unfolded);
  CHECK(cofactors_hold(*decision.proof));
  return *decision.proof;
}

}  // namespace rigor::build
