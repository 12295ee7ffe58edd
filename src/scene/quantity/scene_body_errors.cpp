// SPDX-License-Identifier: GPL-3.0-or-later
// How far what is computed of a scene's body may be from the body that was described.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "numeric/body/body_errors.h"
#include "scene/quantity/scene_body.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;
constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr Position unknown{unbounded, unbounded, unbounded};

/// Of the axes as they are found, and their lengths: 6 u and 10 u, which are measured, not proved.
constexpr double axis_rounding = 16 * u;

double greatest_moment(const SharpPosition& moments) {
  double greatest = 0;
  for (const HighLow& moment : moments) greatest = std::max(greatest, std::abs(moment.high));
  return greatest;
}

/// Of the axes of moments, of a tensor that is off by so much in the 2-norm: sin θ ≤ 2 |E|/gap, and |δn| ≤ √2
/// sin θ (C. Davis, W. M. Kahan, SIAM J. Numer. Anal. 7 (1970) 1; Y. Yu, T. Wang, R. J. Samworth, Biometrika
/// 102 (2015) 315). Where the tensor is exact, any axes of equal moments are right.
Position turned_by(const SharpPosition& moments, double off) {
  Position errors{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) {
      const double gap = std::abs((moments[k].high - moments[l].high) + (moments[k].low - moments[l].low));
      if (k == l || off == 0) continue;
      errors[k] = std::max(errors[k], gap > 4 * off ? 3 * off / gap : unbounded);
    }
  }
  return errors;
}

}  // namespace

double SceneBody::described_error() {
  RIGOR_CHECK(described_error_ || !turned_);
  if (!described_error_) described_error_ = inertia_error(body_);
  return *described_error_;
}

double SceneBody::tensor_error() {
  if (!tensor()) return unbounded;
  return tensor_rounding_ + described_error();
}

double SceneBody::sharp_tensor_error() {
  if (!sharp_tensor()) return unbounded;
  return is_said_ ? body_.known->error : sharp_tensor_rounding_ + described_error();
}

Position SceneBody::moment_errors() {
  const auto& found = moments();
  if (!found) return unknown;
  if (const ExactMoments* all = exact()) {
    Position errors = left_out_;
    for (std::size_t k = 0; k < 3; ++k)
      errors[k] += all->moments[exact_order_[k]].error + 0x1p-104 * std::abs((*found)[k].high) + 0x1p-1070;
    return errors;
  }
  const double solver = moments_error * greatest_moment(*found) + 0x1p-1070;
  const double off = 3 * sharp_tensor_error();  // |E| ≤ 3 max |E_ij|
  Position errors{};
  for (std::size_t k = 0; k < 3; ++k) errors[k] = off + solver + left_out_[k];
  return errors;
}

double SceneBody::axes_off() { return exact() != nullptr ? 0 : 3 * sharp_tensor_error(); }

Position SceneBody::turning_errors() {
  const auto along = is_along_principal_axes();
  if (!along) return unknown;
  if (*along) return {};
  const auto& found = moments();
  if (!found) return unknown;
  Position errors = turned_by(*found, axes_off());
  for (double& error : errors) error += axis_rounding;
  return errors;
}

Position SceneBody::axis_errors() {
  const auto along = is_along_principal_axes();
  if (!along) return unknown;
  if (!*along) return turning_errors();
  const auto& found = moments();
  const auto& inertia = sharp_tensor();
  if (!found || !inertia) return unknown;
  const double products =
      std::abs((*inertia)[1][0].high) + std::abs((*inertia)[2][0].high) + std::abs((*inertia)[2][1].high);
  return turned_by(*found, 3 * sharp_tensor_error() + 2 * products);
}

ErrorBounds SceneBody::place_errors_along(std::size_t k) {
  return turned_place_errors(body_, turning_errors()[k]);
}

}  // namespace rigor
