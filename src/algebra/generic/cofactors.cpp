// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic/cofactors.h"

#include <ginac/ginac.h>

#include <array>
#include <utility>

#include "algebra/ring/membership.h"

namespace rigor {

using GiNaC::ex;

namespace {

using SparseTriple = std::array<SparsePolynomial, 3>;

constexpr std::size_t largest_account = 30'000;  // operations for all that is written down of one proof

}  // namespace

CofactorSearch::CofactorSearch(GenericDomain& domain, const ConstraintsTrace& trace)
    : domain_(domain),
      trace_(trace),
      reader_(domain.indeterminates().all()),
      arithmetic_(reader_.variables(), largest_account) {}

std::size_t CofactorSearch::position(const ex& indeterminate) const {
  return domain_.indeterminates().origin(indeterminate).position;
}

SparsePolynomial CofactorSearch::read(const ex& value) const {
  auto polynomial = reader_.read(value);
  if (!polynomial) throw TooLong();
  return *std::move(polynomial);
}

SparsePolynomial CofactorSearch::equation(std::size_t position) const {
  if (position >= trace_.given.size()) return relations_[position - trace_.given.size()].polynomial;
  return read(trace_.given[position].equation);
}

/// from − quotient · by
void CofactorSearch::subtract(Account& from, const SparsePolynomial& quotient, const Account& by) {
  arithmetic_.add_product(from.value, quotient, by.value, -1);
  for (const auto& [equation, cofactor] : by.cofactors)
    arithmetic_.add_product(from.cofactors[equation], quotient, cofactor, -1);
}

/// What is left after a division in x by an equation that has a number as its leading coefficient.
void CofactorSearch::divide(Account& value, std::size_t x, const Account& by) {
  // A step that is repeated need not come out as it did, where roots became known in between.
  if (degree(by.value, x) == 0) throw TooLong();
  const SparsePolynomial quotient = arithmetic_.divide_in(x, value.value, by.value);
  for (const auto& [equation, cofactor] : by.cofactors)
    arithmetic_.add_product(value.cofactors[equation], quotient, cofactor, -1);
}

void CofactorSearch::reduce_roots(Account& value) {
  for (std::size_t i = relations_.size(); i-- > 0;) {
    if (degree(value.value, relations_[i].letter) < 2) continue;
    divide(value, relations_[i].letter,
           {relations_[i].polynomial, {{trace_.given.size() + i, arithmetic_.number(1)}}});
  }
}

Account CofactorSearch::given(std::size_t position) {
  return {equation(position), {{position, arithmetic_.number(1)}}};
}

/// Of a s + b with the single root s: (b − a s)(b + a s).
Account CofactorSearch::square_of(const Account& previous) {
  for (const Relation& relation : relations_) {
    if (degree(previous.value, relation.letter) == 0) continue;
    SparsePolynomial opposite = arithmetic_.product(
        arithmetic_.coefficient(previous.value, relation.letter, 1), arithmetic_.variable(relation.letter));
    arithmetic_.add(opposite, arithmetic_.coefficient(previous.value, relation.letter, 0), -1);
    Account square;
    subtract(square, opposite, previous);
    reduce_roots(square);
    return square;
  }
  return {};
}

void CofactorSearch::put_in(Account& value, std::size_t x, const Account& by) {
  if (degree(value.value, x) == 0) return;
  divide(value, x, by);
  reduce_roots(value);
}

/// Once, when the first cofactors are asked for.
void CofactorSearch::eliminate() {
  if (eliminated_) return;
  eliminated_ = true;
  too_long_ = true;
  for (const auto& [symbol, square] : domain_.radicals().relations()) {
    SparsePolynomial relation = arithmetic_.power(arithmetic_.variable(position(symbol)), 2);
    arithmetic_.add(relation, read(square), -1);
    relations_.push_back({position(symbol), std::move(relation)});
  }
  for (std::size_t i = 0; i < trace_.given.size(); ++i) {
    const bool squared = trace_.given[i].origin == ConstraintsTrace::Given::Origin::square_of_previous;
    if (trace_.given[i].equation.is_zero()) {
      given_.emplace_back();
    } else {
      given_.push_back(squared ? square_of(given_[i - 1]) : given(i));
    }
  }
  for (const auto& each : trace_.eliminations) {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (i != each.given) put_in(given_[i], position(each.indeterminate), given_[each.given]);
    }
  }
  too_long_ = false;
}

void CofactorSearch::solve(Account& value) {
  for (const auto& each : trace_.eliminations)
    put_in(value, position(each.indeterminate), given_[each.given]);
}

/// By what was solved, and by what is left and monic.
void CofactorSearch::reduce(Account& value) {
  solve(value);
  for (const auto& each : trace_.left) {
    if (each.monic_in.is_zero()) continue;
    const std::size_t x = position(each.monic_in);
    const Account& by = given_[each.given];
    if (degree(by.value, x) > 0 && degree(value.value, x) >= degree(by.value, x)) divide(value, x, by);
  }
}

Account CofactorSearch::determinant(const ConstraintsTrace::Determinant& which) {
  std::array<SparseTriple, 3> rows;
  SparseTriple n;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = arithmetic_.variable(position(which.vector[i]));
    for (std::size_t row = 0; row < 3; ++row)
      rows[row][i] = arithmetic_.coefficient(equation(which.rows[row]), position(which.vector[i]), 1);
  }
  const auto triple_product = [&](const SparseTriple& u, const SparseTriple& v, const SparseTriple& w) {
    SparsePolynomial total;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      arithmetic_.add_product(total, u[i], arithmetic_.product(v[j], w[k]));
      arithmetic_.add_product(total, u[i], arithmetic_.product(v[k], w[j]), -1);
    }
    return total;
  };
  Account found{triple_product(rows[0], rows[1], rows[2]), {}};
  for (std::size_t row = 0; row < 3; ++row)
    found.cofactors[which.rows[row]] = triple_product(n, rows[(row + 1) % 3], rows[(row + 2) % 3]);
  arithmetic_.add(found.cofactors[which.unit_vector], found.value, -1);
  return found;
}

/// nonzero^p · value = Σ h_i r_i with the equations r_i that are left. Here r is what `nonzero` is reduced
/// to, by r − nonzero = Σ d e, and r^p · core = Σ h_i r_i is searched for, where value = g · core.
bool CofactorSearch::multiply_out(Account& value, Combination& found,
                                  const ConstraintsTrace::Vanishing& vanishing) {
  const auto common = arithmetic_.quotient(value.value, read(vanishing.core));
  if (!common) return false;
  Account factor;
  SparsePolynomial original;
  if (vanishing.nonzero) {
    found.nonzero = vanishing.nonzero;
    found.power = vanishing.power;
    original = factor.value = read(trace_.nonzero[*vanishing.nonzero].value);
    reduce(factor);
  }
  std::vector<SparsePolynomial> left;
  for (const std::size_t each : vanishing.left) left.push_back(given_[trace_.left[each].given].value);
  const SparsePolynomial multiple =
      arithmetic_.product(read(vanishing.core), arithmetic_.power(factor.value, vanishing.power));
  const auto searched = rigor::cofactors(multiple, left);
  if (!searched) return false;
  SparsePolynomial between;  // (nonzero^p − r^p) / (nonzero − r)
  for (int k = 0; k < vanishing.power; ++k)
    arithmetic_.add_product(between, arithmetic_.power(original, k),
                            arithmetic_.power(factor.value, vanishing.power - 1 - k));
  Account sum;  // of cofactors only
  const SparsePolynomial kept = arithmetic_.power(original, vanishing.power);
  for (const auto& [equation, cofactor] : value.cofactors)
    arithmetic_.add_product(sum.cofactors[equation], kept, cofactor);
  const SparsePolynomial of_factor = arithmetic_.product(between, value.value);
  for (const auto& [equation, cofactor] : factor.cofactors)
    arithmetic_.add_product(sum.cofactors[equation], of_factor, cofactor);
  value.value = {};
  for (std::size_t i = 0; i < left.size(); ++i) {
    const SparsePolynomial cofactor = arithmetic_.product(*common, (*searched)[i]);
    for (const auto& [equation, part] : given_[trace_.left[vanishing.left[i]].given].cofactors)
      arithmetic_.add_product(sum.cofactors[equation], cofactor, part, -1);
  }
  value.cofactors = std::move(sum.cofactors);
  return true;
}

std::optional<CofactorSearch::Combination> CofactorSearch::find(
    const ConstraintsTrace::Vanishing& vanishing) {
  using How = ConstraintsTrace::Vanishing::How;
  if (vanishing.how == How::cases) return std::nullopt;
  try {
    eliminate();
    if (too_long_) return std::nullopt;
    Combination found;
    arithmetic_.add(found.numerator, read(vanishing.value));
    Account value{found.numerator, {}};
    solve(value);
    if (vanishing.how == How::determinant) {
      Account zero = determinant(trace_.determinants[vanishing.determinant]);
      solve(zero);
      const auto quotient = arithmetic_.quotient(value.value, zero.value);
      if (quotient) subtract(value, *quotient, zero);
    } else if (vanishing.how == How::combination) {
      if (!multiply_out(value, found, vanishing)) return std::nullopt;
    } else if (vanishing.how == How::divided) {
      reduce(value);
    }
    if (!value.value.empty()) return std::nullopt;
    for (auto& [equation, cofactor] : value.cofactors) {
      SparsePolynomial& opposite = found.cofactors[equation];
      arithmetic_.add(opposite, cofactor, -1);
      if (opposite.empty()) found.cofactors.erase(equation);
    }
    return found;
  } catch (const TooLong&) {
    return std::nullopt;
  }
}

}  // namespace rigor
