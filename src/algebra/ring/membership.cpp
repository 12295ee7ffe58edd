// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/membership.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "algebra/engine/exact_number.h"

namespace rigor {
namespace {

using Row = SparsePolynomial;

/// A combination of equations, and which they are.
struct Multiple {
  Row row;
  std::set<std::size_t> from = {};
  std::map<std::size_t, Rational> made_of = {};  // multiples, by position, if an account is kept
};

constexpr int more_degrees = 2;  // so far above the value's degree may multiples reach

[[nodiscard]] int degree(const Exponents& monomial) {
  int total = 0;
  for (const char exponent : monomial) total += exponent;
  return total;
}

[[nodiscard]] int degree(const Row& row) {
  int largest = 0;
  for (const auto& [monomial, coefficient] : row) largest = std::max(largest, degree(monomial));
  return largest;
}

/// a/b, if b divides a.
[[nodiscard]] std::optional<Exponents> quotient(const Exponents& a, const Exponents& b) {
  Exponents result = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] < b[i]) return std::nullopt;
    result[i] = static_cast<char>(a[i] - b[i]);
  }
  return result;
}

[[nodiscard]] Exponents product(const Exponents& a, const Exponents& b) {
  Exponents result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = static_cast<char>(a[i] + b[i]);
  return result;
}

/// The multiples of equations that may take part, by layers: those with a monomial of the value, those with a
/// monomial of these, and so on.
class Multiples {
 public:
  Multiples(const std::vector<Row>& equations, std::size_t limit) : equations_(equations), limit_(limit) {}

  [[nodiscard]] std::vector<Multiple> around(const Row& value) {
    largest_degree_ = degree(value) + more_degrees;
    for (const auto& [monomial, coefficient] : value) meet(monomial);
    for (std::size_t i = 0; i < met_.size() && rows_.size() < limit_; ++i) {
      const Exponents monomial = met_[i];
      for (std::size_t k = 0; k < equations_.size(); ++k) add_multiples(k, monomial);
    }
    return std::move(rows_);
  }
  /// For each row: which equation, times which monomial.
  [[nodiscard]] const std::vector<std::pair<std::size_t, Exponents>>& multiples() const { return multiples_; }

 private:
  void meet(const Exponents& monomial) {
    if (known_.insert(monomial).second) met_.push_back(monomial);
  }

  void add_multiples(std::size_t equation, const Exponents& wanted) {
    for (const auto& [term, coefficient] : equations_[equation]) {
      const std::optional<Exponents> factor = quotient(wanted, term);
      if (!factor || rows_.size() >= limit_) continue;
      if (degree(*factor) + degree(equations_[equation]) > largest_degree_) continue;
      if (!taken_.emplace(equation, *factor).second) continue;
      multiples_.emplace_back(equation, *factor);
      Row row;
      for (const auto& [monomial, number] : equations_[equation]) {
        row.emplace(product(monomial, *factor), number);
      }
      for (const auto& [monomial, number] : row) meet(monomial);
      rows_.push_back({std::move(row), {equation}});
    }
  }

  const std::vector<Row>& equations_;
  std::size_t limit_;
  int largest_degree_ = 0;
  std::vector<Exponents> met_;
  std::set<Exponents> known_;
  std::set<std::pair<std::size_t, Exponents>> taken_;
  std::vector<std::pair<std::size_t, Exponents>> multiples_;
  std::vector<Multiple> rows_;
};

/// Rows in echelon form, by their last monomials.
class Echelon {
 public:
  explicit Echelon(std::size_t operations) : left_(operations) {}

  [[nodiscard]] bool exhausted() const { return left_ == 0; }
  [[nodiscard]] std::size_t left() const { return left_; }
  /// What is left of a row when the others are subtracted.
  [[nodiscard]] Multiple reduced(Multiple multiple) {
    Row& row = multiple.row;
    Row rest;
    while (!row.empty() && !exhausted()) {
      const auto last = std::prev(row.end());
      const auto pivot = pivots_.find(last->first);
      if (pivot == pivots_.end()) {
        rest.insert(row.extract(last));
      } else {
        multiple.from.insert(pivot->second.from.begin(), pivot->second.from.end());
        note_subtracted(multiple, last->second, pivot->second);
        subtract(row, last->second, pivot->second.row);
      }
    }
    return {std::move(rest), std::move(multiple.from), std::move(multiple.made_of)};
  }
  void insert(Multiple multiple) {
    Multiple rest = reduced(std::move(multiple));
    if (rest.row.empty()) return;
    const auto last = std::prev(rest.row.end());
    const Rational scale = last->second;
    for (auto& [monomial, coefficient] : rest.row) coefficient = coefficient / scale;
    for (auto& [position, coefficient] : rest.made_of) coefficient = coefficient / scale;
    pivots_.emplace(last->first, std::move(rest));
  }

 private:
  static void note_subtracted(Multiple& from, const Rational factor, const Multiple& pivot) {
    for (const auto& [position, coefficient] : pivot.made_of) {
      const auto [at, is_new] = from.made_of.try_emplace(position, 0);
      at->second = at->second - factor * coefficient;
    }
  }
  void subtract(Row& row, const Rational factor, const Row& pivot) {
    for (const auto& [monomial, coefficient] : pivot) {
      if (left_ > 0) --left_;
      const auto [at, is_new] = row.try_emplace(monomial, 0);
      at->second = at->second - factor * coefficient;
      if (cln::zerop(at->second)) row.erase(at);
    }
  }

  std::map<Exponents, Multiple> pivots_;  // the last coefficient is 1
  std::size_t left_;
};

/// Empty where an exponent is too large.
[[nodiscard]] std::optional<Row> row_of(const Numerator& value, const PackedLetters& letters) {
  const PackedPolynomial* const polynomial = value.packed(letters);
  if (polynomial == nullptr) return std::nullopt;
  Row row;
  for (std::size_t i = 0; i < polynomial->size(); ++i) {
    Exponents monomial(letters.count(), '\0');
    int largest = 0;
    polynomial->for_each_power(i, [&](std::size_t letter, int exponent) {
      monomial[letter] = static_cast<char>(exponent);
      largest = std::max(largest, exponent);
    });
    if (largest > largest_sparse_exponent) return std::nullopt;
    row.emplace(std::move(monomial), polynomial->coefficient(i).exact());
  }
  return row;
}

}  // namespace

std::optional<std::set<std::size_t>> combination(const Numerator& value, std::span<const Numerator> equations,
                                                 const PackedLetters& letters,
                                                 const MembershipLimits& limits) {
  std::vector<Row> given;
  for (const Numerator& equation : equations) given.push_back(row_of(equation, letters).value_or(Row{}));
  const std::optional<Row> wanted = row_of(value, letters);
  if (!wanted) return std::nullopt;
  Echelon echelon(limits.operations);
  std::vector<Multiple> multiples = Multiples(given, limits.multiples).around(*wanted);
  if (limits.budget != nullptr) limits.budget->count(price::row_of_multiples * multiples.size());
  for (Multiple& each : multiples) echelon.insert(std::move(each));
  Multiple rest = echelon.reduced({*wanted});
  if (limits.budget != nullptr) limits.budget->count(limits.operations - echelon.left());
  if (!rest.row.empty() || echelon.exhausted()) return std::nullopt;
  return std::move(rest.from);
}

bool is_combination(const Numerator& value, std::span<const Numerator> equations,
                    const PackedLetters& letters, const MembershipLimits& limits) {
  return combination(value, equations, letters, limits).has_value();
}

/// What is subtracted of the value to leave nothing is the combination.
std::optional<std::vector<SparsePolynomial>> cofactors(const SparsePolynomial& value,
                                                       std::span<const SparsePolynomial> equations,
                                                       const MembershipLimits& limits) {
  const std::vector<Row> given(equations.begin(), equations.end());
  Echelon echelon(limits.operations);
  Multiples around(given, limits.multiples);
  std::vector<Multiple> multiples = around.around(value);
  for (std::size_t i = 0; i < multiples.size(); ++i) {
    multiples[i].made_of.emplace(i, 1);
    echelon.insert(std::move(multiples[i]));
  }
  const Multiple rest = echelon.reduced({value});
  if (!rest.row.empty() || echelon.exhausted()) return std::nullopt;
  std::vector<SparsePolynomial> found(given.size());
  for (const auto& [position, coefficient] : rest.made_of) {
    const auto& [equation, monomial] = around.multiples()[position];
    if (!cln::zerop(coefficient)) found[equation].emplace(monomial, -coefficient);
  }
  return found;
}

}  // namespace rigor
