// SPDX-License-Identifier: GPL-3.0-or-later
// A proof as a value: how the difference of a claim's sides was reduced to zero, and by what.
//
// A component of left − right is a fraction; its numerator is a polynomial in *letters*, and most numerators
// are the polynomial zero as they stand. What is left of the others vanishes by the assumptions. Where these
// are used as polynomials the proof has the cofactors,
//
//   f · numerator = Σ_k c_k · e_k,   e_k = 0 for each k,   f not 0,
//
// an identity that anyone can check by multiplying out, without knowing how the cofactors were found. Two
// kinds of step have no cofactors: a distinction of cases, and a sign.
//
// No type of a computer algebra system appears here. Numbers are text, `-3/2`; letters, equations and terms
// have an order that is the same in every run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "expr/tree/symbol.h"

namespace rigor {

struct ProofPower {
  std::uint32_t letter = 0;  // position in Proof::letters
  std::uint32_t exponent = 1;
};

struct ProofTerm {
  std::string coefficient;         // not 0
  std::vector<ProofPower> powers;  // by ascending letter
};

using ProofPolynomial = std::vector<ProofTerm>;  // of no terms: 0

/// An indeterminate of the proof, and what it means.
struct ProofLetter {
  enum class Kind : std::uint8_t {
    component,    // of `symbol`, row by row
    projection,   // p or q of a unit vector: (2p, 2q, 1 − p² − q²) / (1 + p² + q²)
    quaternion,   // w, v_1, v_2 or v_3 of a rotation
    moment,       // the sum of of/over over all particles (both empty: too long to be written down)
    root,         // not negative; an equation says its square
    sine,         // of of/over
    cosine,       // of of/over
    exponential,  // of of/over
    logarithm,    // of |of/over|
    arcsine,      // of of/over
    arctangent,   // of of/over
    circle,       // π
    parameter,    // any number: how far something is from a bound
  };
  Kind kind = Kind::component;
  SymbolId symbol{};
  std::uint32_t component = 0;
  std::uint32_t particle = 0;  // 0: of none; 1: of any; then those that the claim names, and one summed over
  ProofPolynomial of = {};
  ProofPolynomial over = {};  // not 0
};

/// polynomial = 0.
struct ProofEquation {
  enum class Source : std::uint8_t {
    assumption,   // the numerator of a component of its left − right
    unit_vector,  // n·n = 1
    square,       // s² = R of a root, a sine, or the third component of a particle's unit vector
  };
  Source source = Source::assumption;
  std::size_t assumption = 0;                 // position in Question::assumptions
  std::vector<std::uint8_t> axes = {};        // which component, as in `Sample`
  std::vector<std::uint32_t> particles = {};  // what its free particles are, as in `ProofLetter`
  ProofPolynomial polynomial;
  std::optional<std::uint32_t> solved_for = {};  // the letter that it was solved for
};

/// A polynomial that is not 0: it is in a denominator, or an assumption says so.
struct ProofNonzero {
  ProofPolynomial polynomial;
  std::optional<std::size_t> assumption = {};
};

/// An assumption about each particle, solved for one of the particle's own numbers: letter = worth. The
/// letter occurs in no equation from here on; the worth may have letters that later ones are solved for.
struct ProofSolution {
  std::size_t assumption = 0;
  std::uint32_t letter = 0;
  ProofPolynomial worth;
};

struct ProofCofactor {
  std::uint32_t equation = 0;  // position in Proof::equations
  ProofPolynomial cofactor;
};

struct ProofFactor {
  std::uint32_t nonzero = 0;  // position in Proof::nonzero
  std::uint32_t exponent = 1;
};

/// Why one component of the claim holds.
struct ProofStep {
  enum class Kind : std::uint8_t {
    combination,  // the product of `factors`, times `numerator`, is the sum of `cofactors` times equations
    long_combination,  // there is such a sum, too long to be written down
    cases,             // it vanishes in each case of a distinction of cases
    sign,              // it has a sign that the claim's relation allows
  };
  Kind kind = Kind::combination;
  std::vector<std::uint8_t> axes = {};        // which component
  ProofPolynomial numerator = {};             // of left − right; combination only
  std::vector<ProofFactor> factors = {};      // combination only
  std::vector<ProofCofactor> cofactors = {};  // combination only
  std::vector<std::size_t> assumptions = {};  // by which it holds; a combination says it by its equations
};

struct Proof {
  enum class Method : std::uint8_t {
    normal_form,  // each component of left − right vanishes at the generic point
    sign,         // or has a sign, for a claim with <, ≤ or ≠
    value,        // the claim has no letters, and its numbers are related as it says
  };
  Method method = Method::normal_form;
  bool vanishes = false;  // each side is zero by itself
  bool moments = false;   // what the normal form took
  bool unit_vectors = false;
  bool rotations = false;
  bool functions = false;
  bool radicals = false;
  bool words = false;                   // products of operators, in their order
  std::vector<SymbolId> unfolded = {};  // definitions
  std::vector<ProofLetter> letters = {};
  std::vector<ProofEquation> equations = {};  // those with a cofactor in a step
  std::vector<ProofNonzero> nonzero = {};     // those that are factors in a step
  std::vector<ProofSolution> solutions = {};
  std::vector<ProofStep> steps = {};       // for each component that is not zero as it stands
  std::vector<std::size_t> in_force = {};  // further assumptions that were not shown to be needless
};

/// The positions of the assumptions that a proof rests on, ascending.
[[nodiscard]] std::vector<std::size_t> assumptions_of(const Proof& proof);

/// `component normal form, radicals`…
[[nodiscard]] std::string route_of(const Proof& proof);

/// Are the combinations of a proof identities between polynomials? Both sides are evaluated at some points
/// modulo a prime number p; a false identity passes with a probability of about (degree/p)^points. How they
/// were found plays no part, nor what the equations have to do with a question.
[[nodiscard]] bool cofactors_hold(const Proof& proof);

/// All symbols that a proof (constant or not) names, each as a reference.
template <class AnyProof, class Visit>
void for_each_symbol(AnyProof& proof, const Visit& visit) {
  for (auto& symbol : proof.unfolded) visit(symbol);
  for (auto& letter : proof.letters) {
    if (letter.kind <= ProofLetter::Kind::quaternion) visit(letter.symbol);
  }
}

// --- as bytes (`base/archive.h`)

template <class Archive>
void fields(Archive& archive, ProofPower& power) {
  archive(power.letter, power.exponent);
}

template <class Archive>
void fields(Archive& archive, ProofTerm& term) {
  archive(term.coefficient, term.powers);
}

template <class Archive>
void fields(Archive& archive, ProofLetter& letter) {
  archive.bounded(letter.kind, 13);
  archive(letter.symbol, letter.component, letter.particle, letter.of, letter.over);
}

template <class Archive>
void fields(Archive& archive, ProofEquation& equation) {
  archive.bounded(equation.source, 3);
  archive(equation.assumption, equation.axes, equation.particles, equation.polynomial, equation.solved_for);
}

template <class Archive>
void fields(Archive& archive, ProofNonzero& nonzero) {
  archive(nonzero.polynomial, nonzero.assumption);
}

template <class Archive>
void fields(Archive& archive, ProofSolution& solution) {
  archive(solution.assumption, solution.letter, solution.worth);
}

template <class Archive>
void fields(Archive& archive, ProofCofactor& cofactor) {
  archive(cofactor.equation, cofactor.cofactor);
}

template <class Archive>
void fields(Archive& archive, ProofFactor& factor) {
  archive(factor.nonzero, factor.exponent);
}

template <class Archive>
void fields(Archive& archive, ProofStep& step) {
  archive.bounded(step.kind, 4);
  archive(step.axes, step.numerator, step.factors, step.cofactors, step.assumptions);
}

template <class Archive>
void fields(Archive& archive, Proof& proof) {
  archive.bounded(proof.method, 3);
  archive(proof.vanishes, proof.moments, proof.unit_vectors, proof.rotations, proof.functions, proof.radicals,
          proof.words);
  archive(proof.unfolded, proof.letters, proof.equations, proof.nonzero, proof.solutions, proof.steps,
          proof.in_force);
}

}  // namespace rigor
