// SPDX-License-Identifier: GPL-3.0-or-later
// The cofactors of polynomials that vanished under assumptions. They are found after the fact, so that a
// search that fails does not pay for them: the steps of the trace are repeated with polynomials of our own,
// each with an account of the given equations that went into it. Elimination of x = w subtracts a quotient by
// x − w (Horner), roots a quotient by s² − R; a combination is searched for again (`cofactors` in
// `membership.h`); a determinant is that of M n = 0 by the adjugate matrix,
// (n·n) det(a, b, c) = (a·n) n·(b × c) + (b·n) n·(c × a) + (c·n) n·(a × b). Nothing here decides anything.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "algebra/generic/constraints_trace.h"
#include "algebra/generic/generic_evaluator.h"
#include "algebra/ring/sparse_polynomial.h"

namespace rigor {

/// A polynomial and how much of each equation went into it: value = start + Σ cofactors · equations. The
/// start is 0 for what follows from equations.
struct Account {
  SparsePolynomial value;
  std::map<std::size_t, SparsePolynomial> cofactors;
};

/// Equations have positions: those of the trace first, then s² = R of the relations.
class CofactorSearch {
 public:
  CofactorSearch(GenericDomain& domain, const ConstraintsTrace& trace);

  struct Combination {
    SparsePolynomial numerator = {};
    std::optional<std::size_t> nonzero = {};  // position in the trace
    int power = 0;                            // nonzero^power · numerator = Σ cofactors · equations
    std::map<std::size_t, SparsePolynomial> cofactors = {};
  };
  /// Empty where a distinction of cases made it vanish, or the cofactors are too long.
  [[nodiscard]] std::optional<Combination> find(const ConstraintsTrace::Vanishing& vanishing);

  /// Throws TooLong.
  [[nodiscard]] SparsePolynomial read(const GiNaC::ex& value) const;
  [[nodiscard]] SparsePolynomial equation(std::size_t position) const;
  [[nodiscard]] const SparseReader& reader() const { return reader_; }

 private:
  [[nodiscard]] std::size_t position(const GiNaC::ex& indeterminate) const;
  [[nodiscard]] Account given(std::size_t position);
  [[nodiscard]] Account square_of(const Account& previous);
  [[nodiscard]] Account determinant(const ConstraintsTrace::Determinant& which);
  void eliminate();
  void subtract(Account& from, const SparsePolynomial& quotient, const Account& by);
  void divide(Account& value, std::size_t x, const Account& by);
  void reduce_roots(Account& value);
  void put_in(Account& value, std::size_t x, const Account& by);
  void solve(Account& value);
  void reduce(Account& value);
  [[nodiscard]] bool multiply_out(Account& value, Combination& found,
                                  const ConstraintsTrace::Vanishing& vanishing);

  GenericDomain& domain_;
  const ConstraintsTrace& trace_;
  SparseReader reader_;
  SparseArithmetic arithmetic_;
  struct Relation {
    std::size_t letter = 0;
    SparsePolynomial polynomial;  // s² − R
  };
  std::vector<Relation> relations_;
  std::vector<Account> given_;  // with all that was solved put into it
  bool eliminated_ = false;
  bool too_long_ = false;  // the elimination was broken off
};

}  // namespace rigor
