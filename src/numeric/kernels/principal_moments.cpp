// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/principal_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "base/check.h"
#include "numeric/kernels/moments_exact.h"

namespace rigor {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

const double* high_of(const double& entry) { return &entry; }
const double* high_of(const HighLow& entry) { return &entry.high; }
bool is_finite(double entry) { return std::isfinite(entry); }
bool is_finite(const HighLow& entry) { return std::isfinite(entry.high) && std::isfinite(entry.low); }

SharpTensor tensor_of(const MomentsColumns& c, std::size_t at) {
  SharpTensor a{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    a[i][i] = {c.diagonal[i][at], c.diagonal_low[i] != nullptr ? c.diagonal_low[i][at] : 0};
    a[j][k] = {c.off[i][at], c.off_low[i] != nullptr ? c.off_low[i][at] : 0};
    a[k][j] = a[j][k];
  }
  return a;
}

void put_axes(const MomentsColumns& c, std::size_t at, const std::array<Position, 3>& axes) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (c.axes[k][i] != nullptr) c.axes[k][i][at] = axes[k][i];
    }
  }
}

void put_moments(const MomentsColumns& c, std::size_t at, const PrincipalMoments& principal) {
  for (std::size_t k = 0; k < 3; ++k) {
    c.moments[k][at] = principal.moments[k].high;
    if (c.moments_low[k] != nullptr) c.moments_low[k][at] = principal.moments[k].low;
  }
  for (std::size_t k = 0; k < 2; ++k) c.gaps[k][at] = principal.gaps[k];
}

/// NaN everywhere where there is no_number.
void put(const MomentsColumns& c, std::size_t at, const std::optional<PrincipalAxes>& solved) {
  constexpr Position nowhere = {no_number, no_number, no_number};
  constexpr HighLow unknown = {no_number, no_number};
  constexpr PrincipalAxes nothing{{{unknown, unknown, unknown}, {no_number, no_number}},
                                  {nowhere, nowhere, nowhere}};
  const PrincipalAxes& found = solved ? *solved : nothing;
  put_moments(c, at, found.principal);
  put_axes(c, at, found.axes);
  c.state[at] = solved ? MomentsState::mended : MomentsState::none;
}

/// All three moments are so alike that they differ in the low parts only, and the kernel's axes, which start
/// from a rotation in doubles, are off by (2^-106/gap)².
bool has_lost_axes(const MomentsColumns& c, std::size_t at) {
  return c.axes[0][0] != nullptr && c.diagonal_low[0] != nullptr &&
         c.gaps[0][at] + c.gaps[1][at] < 0x1p-60 * std::abs(c.moments[2][at]);
}

/// The results that the kernel got wrong for being small, put right without rotations if that does.
bool mend(const MomentsColumns& c, std::size_t at, const SharpTensor& tensor) {
  const double state = c.state[at];
  if (state >= MomentsState::lost) return false;
  PrincipalMoments principal;
  for (std::size_t k = 0; k < 3; ++k)
    principal.moments[k] = {c.moments[k][at], c.moments_low[k] != nullptr ? c.moments_low[k][at] : 0};
  for (std::size_t k = 0; k < 2; ++k) principal.gaps[k] = c.gaps[k][at];
  constexpr double both = MomentsState::small_gap + MomentsState::small_moment;
  const bool small_gap = state == MomentsState::small_gap || state == both;
  const MendedResults mended =
      mend_by_invariants(tensor, {small_gap, state >= MomentsState::small_moment}, principal);
  if (!mended.good) return false;
  if (small_gap && c.axes[0][0] != nullptr && !mended.equal) {
    // Axes of moments that are as close as that are lost, too.
    if (const auto turned = solved_in_many_digits(tensor)) put_axes(c, at, turned->axes);
  }
  put_moments(c, at, principal);
  c.state[at] = MomentsState::mended;
  return true;
}

PrincipalMoments& moments_in(PrincipalMoments& found) { return found; }
PrincipalMoments& moments_in(PrincipalAxes& found) { return found.principal; }
double* axes_in(PrincipalMoments&) { return nullptr; }
double* axes_in(PrincipalAxes& found) { return found.axes[0].data(); }

/// A column of one tensor, and its results as columns.
template <class Tensor, class Found>
MomentsColumns columns_of_one(const Tensor& tensor, Found& found, double& state) {
  MomentsColumns c;
  c.count = 1;
  PrincipalMoments& principal = moments_in(found);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto& beside = tensor[std::max(j, k)][std::min(j, k)];
    c.diagonal[i] = high_of(tensor[i][i]);
    c.off[i] = high_of(beside);
    if constexpr (std::is_same_v<Tensor, SharpTensor>) {
      c.diagonal_low[i] = &tensor[i][i].low;
      c.off_low[i] = &beside.low;
    }
    c.moments[i] = &principal.moments[i].high;
    c.moments_low[i] = &principal.moments[i].low;
    if constexpr (std::is_same_v<Found, PrincipalAxes>)
      for (std::size_t l = 0; l < 3; ++l) c.axes[i][l] = &found.axes[i][l];
  }
  for (std::size_t k = 0; k < 2; ++k) c.gaps[k] = &principal.gaps[k];
  c.state = &state;
  return c;
}

/// What the kernel leaves takes the way of many tensors.
template <class Found, class Tensor>
Result<Found> mended(const Tensor& tensor) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (!is_finite(tensor[i][j])) return refuse("the inertia tensor is not finite");
    }
  }
  Found found;
  double state = MomentsState::none;
  solve_principal_moments(columns_of_one(tensor, found, state));
  if (state == MomentsState::none) return refuse("a principal moment or a gap between two overflows");
  return found;
}

/// Low parts may leave axes that only more digits find. An entry that is not finite makes no state good.
template <class Found, class Tensor>
Result<Found> result_of(const Tensor& tensor) {
  constexpr bool sharp = std::is_same_v<Tensor, SharpTensor>;
  if constexpr (sharp && std::is_same_v<Found, PrincipalAxes>) return mended<Found>(tensor);
  Result<Found> result;
  PrincipalMoments& principal = moments_in(*result);
  const double state = lane_kernels().principal_moments_of_one(
      high_of(tensor[0][0]), sharp, &principal.moments[0].high, principal.gaps.data(), axes_in(*result));
  if (state != MomentsState::good) result = mended<Found>(tensor);
  return result;
}

/// A tensor below the range in which the kernel loses nothing, solved times a power of two, which is exact.
std::optional<PrincipalAxes> solved_larger(const SharpTensor& tensor) {
  constexpr int power = 1000;
  double greatest = 0;
  SharpTensor larger = tensor;
  for (auto& row : larger) {
    for (HighLow& entry : row) {
      greatest = std::max(greatest, std::abs(entry.high));
      entry = {std::ldexp(entry.high, power), std::ldexp(entry.low, power)};
    }
  }
  if (greatest == 0 || !(greatest < 0x1p-900)) return std::nullopt;
  auto solved = result_of<PrincipalAxes>(larger);
  if (!solved) return std::nullopt;
  PrincipalAxes& result = *solved;
  for (HighLow& moment : result.principal.moments)
    moment = {std::ldexp(moment.high, -power), std::ldexp(moment.low, -power)};
  for (double& gap : result.principal.gaps) gap = std::ldexp(gap, -power);
  return result;
}

/// What is given is complete: all of it or no_number of it, and room for what there always is.
void check_columns(const MomentsColumns& c) {
  const bool sharp = c.diagonal_low[0] != nullptr;
  const bool with_axes = c.axes[0][0] != nullptr;
  RIGOR_CHECK(c.state != nullptr && c.gaps[0] != nullptr && c.gaps[1] != nullptr, c.count);
  for (std::size_t i = 0; i < 3; ++i) {
    RIGOR_CHECK(c.diagonal[i] != nullptr && c.off[i] != nullptr && c.moments[i] != nullptr, i);
    RIGOR_CHECK((c.diagonal_low[i] != nullptr) == sharp && (c.off_low[i] != nullptr) == sharp, i);
    RIGOR_CHECK((c.moments_low[i] != nullptr) == (c.moments_low[0] != nullptr), i);
    for (const double* component : c.axes[i]) RIGOR_CHECK((component != nullptr) == with_axes, i);
  }
}

}  // namespace

double RoundedMoments::gap(std::size_t i, std::size_t j) const {
  RIGOR_CHECK(i < 3 && j < 3, i, j);
  if (i < j) return 0 - gap(j, i);
  double sum = 0;
  for (std::size_t k = j; k < i; ++k) sum += gaps[k];
  return sum;
}

Result<RoundedMoments> principal_moments(const InertiaTensor& tensor) {
  RoundedMoments rounded;
  if (lane_kernels().distinct_moments(tensor[0].data(), rounded.moments.data(), rounded.gaps.data()))
    return rounded;
  return result_of<PrincipalMoments>(tensor).map(&PrincipalMoments::rounded);
}
Result<PrincipalMoments> principal_moments(const SharpTensor& tensor) {
  return result_of<PrincipalMoments>(tensor);
}
Result<PrincipalAxes> principal_axes(const InertiaTensor& tensor) { return result_of<PrincipalAxes>(tensor); }
Result<PrincipalAxes> principal_axes(const SharpTensor& tensor) { return result_of<PrincipalAxes>(tensor); }

void solve_principal_moments(const MomentsColumns& columns, const LaneKernels& kernels) {
  check_columns(columns);
  kernels.principal_moments(columns);
  for (std::size_t at = 0; at < columns.count; ++at) {
    if (columns.state[at] == MomentsState::good && !has_lost_axes(columns, at)) continue;
    const SharpTensor tensor = tensor_of(columns, at);
    if (columns.state[at] == MomentsState::good) {
      if (const auto turned = solved_in_many_digits(tensor)) put_axes(columns, at, turned->axes);
      continue;
    }
    const bool only_sorted = is_diagonal(tensor);
    const auto larger = only_sorted ? std::nullopt : solved_larger(tensor);
    if (!only_sorted && !larger && mend(columns, at, tensor)) continue;
    put(columns, at, larger ? larger : solved_in_many_digits(tensor));
  }
}

}  // namespace rigor
