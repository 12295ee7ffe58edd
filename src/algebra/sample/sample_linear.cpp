// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/sample_linear.h"

#include <cstddef>
#include <utility>

namespace rigor {
namespace {

/// Subtracts `factor` times an entry from another, in each of the columns and on the right.
class Rows {
 public:
  Rows(LinearColumns columns, std::vector<Rational> right)
      : columns_(std::move(columns)), right_(std::move(right)), taken_(right_.size(), false) {}

  /// The row by which an unknown is fixed: all others lose it. Empty: it is free.
  [[nodiscard]] std::optional<std::size_t> fix(std::size_t column) {
    for (std::size_t row = 0; row < right_.size(); ++row) {
      if (taken_[row] || cln::zerop(columns_[column][row])) continue;
      taken_[row] = true;
      eliminate(column, row);
      return row;
    }
    return std::nullopt;
  }
  [[nodiscard]] Rational value(std::size_t column, std::size_t row) const {
    return right_[row] / columns_[column][row];
  }
  [[nodiscard]] bool is_solvable() const {
    for (std::size_t row = 0; row < right_.size(); ++row) {
      if (!taken_[row] && !cln::zerop(right_[row])) return false;
    }
    return true;
  }

 private:
  void eliminate(std::size_t column, std::size_t row) {
    for (std::size_t other = 0; other < right_.size(); ++other) {
      if (other == row || cln::zerop(columns_[column][other])) continue;
      const Rational factor = columns_[column][other] / columns_[column][row];
      for (auto& each : columns_) {
        if (!cln::zerop(each[row])) each[other] = each[other] - factor * each[row];
      }
      right_[other] = right_[other] - factor * right_[row];
    }
  }

  LinearColumns columns_;
  std::vector<Rational> right_;
  std::vector<bool> taken_;
};

}  // namespace

std::optional<std::vector<Rational>> solve_linear(LinearColumns columns, std::vector<Rational> right) {
  std::vector<Rational> solution(columns.size(), 0);
  Rows rows(std::move(columns), std::move(right));
  std::vector<std::pair<std::size_t, std::size_t>> fixed;
  for (std::size_t column = 0; column < solution.size() && !rows.is_solvable(); ++column) {
    if (const auto row = rows.fix(column)) fixed.emplace_back(column, *row);
  }
  if (!rows.is_solvable()) return std::nullopt;
  for (const auto& [column, row] : fixed) solution[column] = rows.value(column, row);
  return solution;
}

}  // namespace rigor
