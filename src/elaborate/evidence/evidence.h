// SPDX-License-Identifier: GPL-3.0-or-later
// What one section shows of its letters. A letter is known by what it is without subscripts: `r`, `\hat n`.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "latex/token/syntax.h"

namespace rigor {

struct Evidence {
  std::set<std::string> vectors;   // bold or under an arrow somewhere
  std::set<std::string> crossed;   // factors of a cross product
  std::set<std::string> numbers;   // divisors, and small Latin letters next to a vector
  std::set<std::string> ordered;   // what may be a matrix or an operator: the order of factors may matter
  std::set<std::string> labelled;  // of those, what has a subscript there: components of a vector of matrices
  std::set<std::string> hatted;    // `\hat x`: a unit vector or an operator
  std::set<std::string> real;      // in an order, in a sine, or said to be real
  std::set<std::string> complex;   // conjugated somewhere: `\bar z`, `\psi^*`
  std::set<std::string> letters;   // all that are in equations, without faces and accents; `i` among them
  std::set<std::string> points;    // of names such as `ABC` in the prose
  std::set<std::string> components;                        // u, v, w of `\mathbf u = (u, v, w)`: no lengths
  std::set<std::string> units;                             // "the unit matrix $I$": 1 among matrices
  std::set<std::string> functionals;                       // `E[X]`: square brackets stand directly after
  std::map<std::string, std::set<std::string>> functions;  // \omega of `\omega(k) = …`, with k
  bool third_axis = false;         // a component along z, or three of them: it is not about the plane alone
  bool operators = false;          // a commutator, a dagger, a bra or ket, `\hat p` or `\hat H`
  bool speaks_of_order = false;    // the words speak of matrices or operators: then capitals may be some
  bool order_in_heading = false;   // a heading does, or words of a group: then small letters may be some, too
  bool speaks_of_numbers = false;  // they say "numbers" and name none
  bool speaks_of_complex = false;  // the words do
  bool complex_vectors = false;    // and so that fields and amplitudes may be complex as well
  std::string other_space;         // words of another number of dimensions, or another metric
  std::string other_metric;        // of another metric
  std::string other_axes;          // words of components that are not Cartesian
  std::string other_arithmetic;    // words of sums and products that are not those of real numbers
  std::set<std::string> raised;    // x of `x^\mu`, `x^1 = x`: its upper indices are no powers
  bool speaks_of_raised = false;   // the words do, and name no letter
  bool speaks_of_segments = false;  // of triangles and segments: `AB` can be the name of one
  bool sentence_is_open = false;    // while reading: such a sentence goes on with the next display

  /// May the letter be a matrix or an operator?
  [[nodiscard]] bool is_ordered(const std::string& letter) const;
};

/// Adds what the faces, products and fractions below `root` show.
void see_kinds(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence);

/// Adds what equations between a vector and its components show.
void see_components(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);

/// `\hat n` for `\hat n_i`: letter, accent, change and primes.
[[nodiscard]] std::string letter_with_marks(const WrittenSymbol& symbol);

}  // namespace rigor
