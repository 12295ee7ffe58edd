// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_body.h"

#include <cmath>
#include <limits>

namespace rigor {

SceneBody::SceneBody(const Body& body, SceneLedger& ledger) : body_(body), ledger_(ledger) {
  for (const char* node : {particles_node, tensor_node, moments_node, axes_node, places_node}) {
    ledger.expect(node, "nothing that was asked needs it");
  }
}

const Result<InertiaTensor>& SceneBody::tensor() {
  if (!tensor_) {
    tensor_ = ledger_.compute(tensor_node, "of the body's particles", [&] { return inertia_tensor(body_); });
  }
  return *tensor_;
}

Result<bool> SceneBody::is_along_principal_axes() {
  const auto& inertia = tensor();
  if (!inertia) return tl::unexpected(inertia.error());
  const InertiaTensor& i = *inertia;
  const double trace = i[0][0] + i[1][1] + i[2][2];
  const double products = std::abs(i[0][1]) + std::abs(i[0][2]) + std::abs(i[1][2]);
  return products <= 32 * std::numeric_limits<double>::epsilon() * trace;
}

const Result<Position>& SceneBody::moments() {
  if (moments_) return *moments_;
  const auto along = is_along_principal_axes();
  if (!along) {
    moments_ = tl::unexpected(along.error());
  } else if (*along) {
    const InertiaTensor& i = **tensor_;
    moments_ =
        ledger_.compute(moments_node, "the body is along its principal axes: the tensor's diagonal", [&] {
          return Result<Position>(Position{i[0][0], i[1][1], i[2][2]});
        });
  } else {
    moments_ = ledger_.compute(moments_node, "values alone",
                               [&] { return principal_moments(**tensor_).map(&PrincipalMoments::values); });
  }
  return *moments_;
}

const Result<SceneBody::Axes>& SceneBody::axes() {
  if (axes_) return *axes_;
  const auto along = is_along_principal_axes();
  if (!along) {
    axes_ = tl::unexpected(along.error());
  } else if (*along) {
    ledger_.skip(axes_node, "the body is along its principal axes");
    axes_ = std::array<Position, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  } else {
    axes_ = ledger_.compute(axes_node, "vectors of the tensor", [&] {
      return principal_axes(**tensor_).map([](const PrincipalAxes& axes) { return axes.axes; });
    });
  }
  return *axes_;
}

const Result<SceneBody::Places>& SceneBody::places_along_axes() {
  if (places_) return *places_;
  const auto& turn = axes();
  if (!turn) {
    places_ = tl::unexpected(turn.error());
    return *places_;
  }
  places_ = ledger_.compute(places_node, "turned", [&] {
    Places places;
    for (std::size_t k = 0; k < 3; ++k) {
      places[k].resize(body_.size());
      const Position& axis = (*turn)[k];
      for (std::size_t p = 0; p < body_.size(); ++p) {
        places[k][p] = axis[0] * body_.positions[0][p] + axis[1] * body_.positions[1][p] +
                       axis[2] * body_.positions[2][p];
      }
    }
    return Result<Places>(std::move(places));
  });
  return *places_;
}

}  // namespace rigor
