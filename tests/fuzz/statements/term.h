// SPDX-License-Identifier: GPL-3.0-or-later
// The generator's own expressions, and the letters that occur in them. Nothing here knows the checker.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "jet.h"

namespace fuzz {

enum class Op {
  number,        // p/q
  symbol,        // a letter, with `dots`, components `slots`, `particle`
  delta,         // δ with `slots`
  epsilon,       // ε with `slots`
  sum,           // of two or more
  negative,      //
  product,       // of two or more; at most one of them is no scalar
  quotient,      // of a scalar, vector or tensor and a scalar
  power,         // a scalar to the whole `p`
  root,          //
  absolute,      // of a scalar
  length,        // of a vector
  dot,           // of two vectors
  cross,         // of two vectors
  act,           // a tensor on a vector
  trace,         //
  function,      // of a scalar
  component,     // of a vector, `slots` has its index
  contract,      // sums over the indices in `slots`; nothing is written for it
  particle_sum,  // over `particle`
  rate,          // d/dt
  rate_in,       // d/dt as seen from the fixed axes, of a vector
  rate_rot,      // d/dt as seen from the turning axes, of a vector
  partial,       // by the coordinate in `slots`
  gradient,
  divergence,
  curl,
  laplacian,
  along,  // (A·∇)B
};

struct Node;
using Term = std::shared_ptr<const Node>;

struct Node {
  Op op = Op::number;
  std::vector<Term> parts = {};
  std::size_t letter = 0;
  std::string slots = {};  // `i`…`n` or `1`…`3`
  char particle = 0;       // a, b: α, β
  int dots = 0;
  Function function = Function::sin;
  long p = 0, q = 1;
  int decimals = 0;   // a number that is written with so many digits behind the point
  bool bare = false;  // `\\cos k(x - y)`: an argument a(b + c) is written without brackets around it
  int rank = 0;
};

enum class Nature {
  free,      // changes with the time
  constant,  //
  field,     // changes with time and place
  position,  // of the point where fields are taken
  small,     //
  unit,      // a vector of length 1, changes with the time
  spin,      // the angular velocity of the turning axes
};

struct Letter {
  std::string plain;  // `A`, `\omega`
  int rank = 0;
  Nature nature = Nature::free;
  bool symmetric = false;
  bool antisymmetric = false;
  bool of_particles = false;
  std::string label = {};  // a subscript in words or digits
  Term value = nullptr;    // what the letter's own random number becomes: `|a|` for a positive a
};

[[nodiscard]] Term number(long p, long q = 1);
[[nodiscard]] Term zero(int rank);
[[nodiscard]] Term decimal(double value, int decimals);  // rounded
[[nodiscard]] Term symbol(const std::vector<Letter>& letters, std::size_t letter, std::string slots = {},
                          char particle = 0, int dots = 0);
[[nodiscard]] Term delta(std::string slots);
[[nodiscard]] Term epsilon(std::string slots);
[[nodiscard]] Term sum(std::vector<Term> parts);
[[nodiscard]] Term product(std::vector<Term> parts);
[[nodiscard]] Term negative(Term part);
[[nodiscard]] Term power(Term base, long exponent);
[[nodiscard]] Term function_of(Function function, Term argument);
[[nodiscard]] Term contract(std::string slots, Term part);
[[nodiscard]] Term particle_sum(char particle, Term part);
[[nodiscard]] Term with_slots(Op op, Term part, std::string slots);
/// All others: the rank follows.
[[nodiscard]] Term make(Op op, std::vector<Term> parts);
/// The same node with other parts.
[[nodiscard]] Term rebuilt(const Term& term, std::vector<Term> parts);

[[nodiscard]] std::size_t size(const Term& term);
[[nodiscard]] bool same(const Term& a, const Term& b);
[[nodiscard]] const Term& node_at(const Term& term, std::size_t position);  // in preorder
/// `term` with the node at `position` replaced.
[[nodiscard]] Term replaced(const Term& term, std::size_t position, const Term& replacement);
void visit(const Term& term, const std::function<void(const Node&)>& see);

/// Whether it is written by the rules: ranks fit, each summed index stands twice in its term and nowhere
/// else, terms of a sum have the same free indices, particles are bound. `free`: the free indices, sorted.
[[nodiscard]] bool well_formed(const Term& term, const std::vector<Letter>& letters, std::string& free);

/// The other reading of what is written bare: cos(k)(x - y) for cos(k(x - y)).
[[nodiscard]] Term read_otherwise(const Term& term);

/// How many derivatives stand in one another.
[[nodiscard]] int derivative_order(const Term& term);

}  // namespace fuzz
