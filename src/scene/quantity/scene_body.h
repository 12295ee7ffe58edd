// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's body and what can be known of it, each computed once and only when asked: the inertia tensor, the
// principal moments (values alone), the principal axes, the particles along them.
#pragma once

#include <optional>

#include "numeric/body/body.h"
#include "numeric/kernels/principal_moments.h"
#include "numeric/program/samples.h"
#include "scene/quantity/explain.h"

namespace rigor {

class SceneBody {
 public:
  static constexpr const char* particles_node = "particles";
  static constexpr const char* tensor_node = "inertia tensor";
  static constexpr const char* sharp_tensor_node = "inertia tensor to 100 bits";
  static constexpr const char* moments_node = "principal moments";
  static constexpr const char* axes_node = "principal axes";
  static constexpr const char* places_node = "particles along the principal axes";

  /// The ledger is kept by reference. `with_errors`: bounds of errors will be asked for.
  SceneBody(Body body, bool with_errors, SceneLedger& ledger);

  /// Its places are along `axes` once `turn_places` was called.
  [[nodiscard]] const Body& body() const { return body_; }
  [[nodiscard]] const Result<InertiaTensor>& tensor();
  /// Is the file's set of axes a principal one? No product of inertia exceeds 64 u times the trace.
  [[nodiscard]] Result<bool> is_along_principal_axes();
  /// In the order of the axes where the body is along them, else ascending. Computes no axes.
  /// To about 100 bits of the greatest, so that their differences keep their digits. Where the body is along
  /// the file's axes, each goes to the nearest one; two that the rounding of places leaves alike are taken
  /// for the tensor's diagonal.
  [[nodiscard]] const Result<SharpPosition>& moments();
  /// All digits of a moment, where 100 bits leave open whether moments differ; null elsewhere.
  [[nodiscard]] const LongNumber* digits_of_moment(std::size_t k);
  /// In the order of `moments`, right-handed. Where the body is along them, e₁, e₂, e₃, and nothing is
  /// computed.
  using Axes = std::array<Position, 3>;
  [[nodiscard]] const Result<Axes>& axes();
  /// Turns the particles where they lie, so that a large cloud is in memory once, and asks for what is known
  /// of the places before.
  [[nodiscard]] const Result<void>& turn_places();

  /// Bounds of the errors of what these give, for the body that was described (`BodyErrors`); infinite where
  /// none is known, also where they fail. Of any entry of the tensor; of each moment; of any component of
  /// each axis, and of each that particles are turned to.
  [[nodiscard]] double tensor_error();
  [[nodiscard]] Position moment_errors();
  [[nodiscard]] Position axis_errors();
  [[nodiscard]] Position turning_errors();
  /// Of the coordinates along an axis of particles that are turned.
  [[nodiscard]] ErrorBounds place_errors_along(std::size_t k);

 private:
  const Result<SharpTensor>& sharp_tensor();
  /// Of any entry of that.
  [[nodiscard]] double sharp_tensor_error();
  /// What the tensor that the file says has for moments, where that is known in integers.
  [[nodiscard]] const ExactMoments* exact();
  /// How far the tensor may be off of which the axes are, in the 2-norm.
  [[nodiscard]] double axes_off();
  /// What the body's file says of it, where its particles stand for that and differ by their rounding alone.
  std::optional<SharpTensor> said_inertia();

  /// Of any entry of the tensor, by what the particles lost when they were made.
  [[nodiscard]] double described_error();

  Body body_;
  bool with_errors_;
  SceneLedger& ledger_;
  std::optional<Result<InertiaTensor>> tensor_;
  double tensor_rounding_ = 0;                       // of its sums
  double sharp_tensor_rounding_ = 0;                 // kg m²
  bool is_said_ = false;                             // the sharp tensor is what the file says
  Position left_out_{};                              // of the moments: what a tensor has off its diagonal
  std::array<std::size_t, 3> exact_order_{0, 1, 2};  // which of the exact moments is which
  std::optional<Result<SharpTensor>> sharp_tensor_;
  std::optional<Result<SharpPosition>> moments_;
  std::optional<Result<Axes>> axes_;
  std::optional<double> described_error_;
  std::optional<Result<void>> turned_;
};

}  // namespace rigor
