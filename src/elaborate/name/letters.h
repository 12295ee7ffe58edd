// SPDX-License-Identifier: GPL-3.0-or-later
// Which of a statement's subscript letters are indices and which are labels. `v_i` next to `v_f` is an
// initial velocity; `\epsilon_{abc}` makes a, b, c indices; i … n are indices unless the statement says
// otherwise.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elaborate/name/names.h"
#include "latex/token/syntax.h"

namespace rigor {

struct Letters {
  std::set<std::string> indices;          // letters other than i … n that are indices in this statement
  std::set<std::string> labels;           // letters of i … n that are labels in this statement
  std::set<std::string> indexed_vectors;  // bases that occur with one index letter in this statement
  std::set<std::string> changes;          // \delta of `\delta x`
  std::set<std::string> bold_vectors;     // bases that occur in bold or under an arrow in this statement
  std::set<std::string> bare;             // plain letters that stand without a subscript
  std::set<std::string> below;            // small Latin letters that are subscripts
  std::set<std::string> counted;          // k and n of `\sum_{k=1}^n`: whole numbers
  std::set<std::string> by;  // r of `\frac{dV}{dr}`: letters that this statement differentiates by
  bool has_nabla = false;
  bool has_usual_triple = false;  // Pauli matrices that are not on the page
  bool has_operators = false;     // other letters that the section shows to be operators
  bool evidence =
      false;  // something shows that index notation is meant: δ, ε, a component of a vector, a repetition

  std::set<std::string> sure;  // indices in every reading: on δ, ε, ∂ and on known vectors, and next to those

  [[nodiscard]] bool is_index(const std::string& letter) const;
  /// Primes after the letter do not count.
  [[nodiscard]] bool is_sure(std::string_view letter) const;
};

/// Looks at all sides of one statement.
[[nodiscard]] Letters read_letters(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides,
                                   const Names& names);

/// `x_i` beside a sum that runs i through whole numbers.
[[nodiscard]] bool is_member_of_sequence(const WrittenSymbol& symbol, const std::string& counter);
/// `\sum_{k=0}^n`: does it run over whole numbers, and not over axes or particles? One from 1 to the number
/// of axes does where its letter stands for a number in what is added.
[[nodiscard]] bool runs_over_numbers(const SyntaxTree& syntax, SyntaxId big_sum, const Names& names);

/// Notes how every symbol of a statement is written. Passes in this order over the whole file: sums, then
/// faces, then indices.
void sight_sums(const SyntaxTree& syntax, SyntaxId root, Sightings& sightings);
void sight_faces(const SyntaxTree& syntax, SyntaxId root, Names& names);
void sight_indices(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Names& names);
/// What is differentiated, which axes are primed, and which one-index quantities are a tensor's diagonal.
void sight_changes(const SyntaxTree& syntax, SyntaxId root, Names& names);
void sight_diagonals(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Sightings& sightings);

/// A written symbol taken apart: its base (letter, accent, primes, labels), and the subscripts that may be
/// indices.
struct WrittenName {
  std::string base;                     // `r`, `T_{rot}`, `\hat{n}`, `r'`: the same for every face
  std::vector<WrittenIndex> axes;       // digits, index letters and x, y, z, in order
  std::vector<WrittenIndex> particles;  // particle labels
  Directives used = {};                 // that say which subscripts these are
  [[nodiscard]] bool per_particle() const { return !particles.empty(); }
};
[[nodiscard]] WrittenName take_apart(const WrittenSymbol& symbol, const Letters& letters, const Names& names);

/// Is it a letter without face, accent, primes, dots and a change before it? Subscripts may be on it.
[[nodiscard]] bool is_undecorated(const WrittenSymbol& symbol);
/// The time `t`; `t'` and `t_0` are quantities.
[[nodiscard]] bool is_time(const WrittenSymbol& symbol);
/// ∇, also with marks that make it another operator: `\nabla'`, `\nabla_\perp`.
[[nodiscard]] bool is_nabla(const SyntaxTree& syntax, SyntaxId id);
/// ∇, ∇² or (A·∇).
[[nodiscard]] bool acts_as_operator(const SyntaxTree& syntax, SyntaxId id);
[[nodiscard]] bool is_kronecker(const WrittenSymbol& symbol);
/// `\delta_{mn}` where m or n numbers states.
[[nodiscard]] bool is_kronecker_of_states(const WrittenSymbol& symbol, const Evidence& evidence);
[[nodiscard]] bool is_levi_civita(const WrittenSymbol& symbol);
/// `\mathbf{e}_i`, `\hat{e}_x`: a vector of the basis.
[[nodiscard]] bool is_basis_family(const WrittenSymbol& symbol);
/// `x`, `y`, `z`, `x_i`, `r_i`: what is differentiated by, as a place.
[[nodiscard]] bool names_a_place(const WrittenSymbol& variable);
/// `x` is 1, `y` 2, `z` 3; other texts are 0.
[[nodiscard]] std::uint8_t axis_of_letter(const std::string& letter);

}  // namespace rigor
