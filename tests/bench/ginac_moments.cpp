// SPDX-License-Identifier: GPL-3.0-or-later
#include "ginac_moments.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace rigor {

struct GinacMoments::Formula {
  std::array<std::array<GiNaC::symbol, 3>, 3> entry;  // lower triangle
  std::array<GiNaC::ex, 3> moments;
};

GinacMoments::GinacMoments() : formula_(std::make_unique<Formula>()) {
  const auto at = [&](std::size_t i, std::size_t j) {
    return formula_->entry[std::max(i, j)][std::min(i, j)];
  };
  const GiNaC::ex q = (at(0, 0) + at(1, 1) + at(2, 2)) / 3;
  GiNaC::ex squares = 0;
  GiNaC::ex determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    squares += GiNaC::pow(at(i, i) - q, 2) + 2 * GiNaC::pow(at(j, k), 2);
    const auto b = [&](std::size_t row, std::size_t column) {
      return at(row, column) - (row == column ? q : GiNaC::ex(0));
    };
    determinant += b(0, i) * (b(1, j) * b(2, k) - b(1, k) * b(2, j));
  }
  const GiNaC::ex p = GiNaC::sqrt(squares / 6);
  const GiNaC::ex phi = GiNaC::acos(determinant / (2 * GiNaC::pow(p, 3))) / 3;
  for (int k = 0; k < 3; ++k)
    formula_->moments[static_cast<std::size_t>(k)] = q + 2 * p * GiNaC::cos(phi + 2 * GiNaC::Pi * k / 3);
}

GinacMoments::~GinacMoments() = default;

Position GinacMoments::evaluate(const InertiaTensor& tensor) const {
  Position moments{};
  moments.fill(std::numeric_limits<double>::quiet_NaN());
  try {
    GiNaC::exmap numbers;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j) numbers[formula_->entry[i][j]] = tensor[i][j];
    for (std::size_t k = 0; k < 3; ++k) {
      const GiNaC::ex value = formula_->moments[k].subs(numbers).evalf();
      if (GiNaC::is_a<GiNaC::numeric>(value))
        moments[k] = GiNaC::ex_to<GiNaC::numeric>(value).real().to_double();
    }
  } catch (const std::exception&) {
    return moments;  // a pole, because all moments are equal, or numbers that are too small
  }
  std::sort(moments.begin(), moments.end());
  return moments;
}

}  // namespace rigor
