// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/scene_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {
namespace {

/// 64 u, relative to the trace: what differs by less is the rounding of places.
constexpr double alike = 64 * 0x1p-53;

double size_of(double entry) { return std::abs(entry); }
double size_of(const HighLow& entry) { return std::abs(entry.high); }

template <class Tensor>
double greatest_of(const Tensor& tensor) {
  double greatest = 0;
  for (const auto& row : tensor) {
    for (const auto& entry : row) greatest = std::max(greatest, size_of(entry));
  }
  return greatest;
}

/// Which of the axes is nearest to each of the file's, each taken once.
struct NearestAxes {
  std::array<std::size_t, 3> order{};
  std::array<std::size_t, 3> group{0, 1, 2};  // of the file's axes: those of one may have each other's
};
/// `uncertainty`: of the difference of two components.
NearestAxes nearest_axes(const std::array<Position, 3>& axes, double uncertainty) {
  constexpr std::size_t none = 3;
  NearestAxes found{{none, none, none}};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t nearest = none;
    for (std::size_t i = 0; i < 3; ++i) {
      if (found.order[i] != none) continue;
      if (nearest == none || std::abs(axes[k][i]) > std::abs(axes[k][nearest])) nearest = i;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_near = std::abs(axes[k][nearest]) - std::abs(axes[k][i]) <= uncertainty;
      if (found.order[i] != none || !is_near) continue;
      const std::size_t joined = found.group[i];
      std::ranges::replace(found.group, joined, found.group[nearest]);
    }
    found.order[nearest] = k;
  }
  return found;
}

SharpPosition in_order(const SharpPosition& moments, const std::array<std::size_t, 3>& order) {
  return {moments[order[0]], moments[order[1]], moments[order[2]]};
}

/// Moments of axes of one group may be each other's: by how much, of moments in the file's order.
Position open_order(const SharpPosition& moments, const NearestAxes& nearest) {
  Position off{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (nearest.group[i] != nearest.group[j]) continue;
      off[i] = std::max(off[i], std::abs((moments[i] - moments[j]).high) * (1 + 0x1p-40));
    }
  }
  return off;
}

/// Whether no two moments are closer than that: by what is proved of gaps.
bool are_apart(const PrincipalMoments& principal, double off) {
  return std::ranges::all_of(std::array{1U, 2U}, [&](std::size_t k) {
    const EnclosedGap gap = principal.enclosed_gap(k, k - 1);
    return gap.value - gap.error > off;
  });
}

/// Of a tensor that is diagonal to rounding and off by so much in the 2-norm: each moment goes to the axis
/// nearest to its own. Where two moments are so close that their axes are not known, the diagonal is taken,
/// but for an entry so far from the others that the moment of its rank is its own (H. Weyl). `left_out`: what
/// that may be off by.
Result<SharpPosition> moments_in_order_of_axes(const SharpTensor& tensor, double off, Position& left_out) {
  SharpPosition diagonal{tensor[0][0], tensor[1][1], tensor[2][2]};
  const double products =
      std::abs(tensor[1][0].high) + std::abs(tensor[2][0].high) + std::abs(tensor[2][1].high);
  if (products == 0) return diagonal;
  const auto system = principal_axes(tensor);
  if (!system) return tl::unexpected(system.error());
  if (are_apart(system->principal, 32 * off)) {
    const SharpPosition& found = system->principal.moments;
    const double gap = std::min((found[1] - found[0]).high, (found[2] - found[1]).high);
    const NearestAxes nearest = nearest_axes(system->axes, alike + 8 * off / gap);  // sin θ ≤ 2 |E|/gap
    SharpPosition ordered = in_order(found, nearest.order);
    left_out = open_order(ordered, nearest);
    return ordered;
  }
  SharpPosition moments = diagonal;
  left_out = {2 * products, 2 * products, 2 * products};
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t rank = 0;
    bool is_apart = true;
    for (std::size_t j = 0; j < 3; ++j) {
      if (i == j) continue;
      const double more = (diagonal[i] - diagonal[j]).high;
      if (more > 0) ++rank;
      is_apart = is_apart && std::abs(more) > 32 * products;
    }
    if (!is_apart) continue;
    moments[i] = system->principal.moments[rank];
    left_out[i] = 0;
  }
  return moments;
}

}  // namespace

SceneBody::SceneBody(Body body, bool with_errors, SceneLedger& ledger)
    : body_(std::move(body)), with_errors_(with_errors), ledger_(ledger) {
  for (const char* node :
       {particles_node, tensor_node, sharp_tensor_node, moments_node, axes_node, places_node}) {
    ledger.expect(node, "nothing that was asked needs it");
  }
}

const Result<InertiaTensor>& SceneBody::tensor() {
  if (!tensor_) {
    tensor_ = ledger_.compute(tensor_node, "of the body's particles", [&]() -> Result<InertiaTensor> {
      const auto sums = check_count(body_).and_then([&] { return mass_sums(points_of(body_)); });
      if (!sums) return tl::unexpected(sums.error());
      tensor_rounding_ = sums->error == 0 ? 0 : sums->error * greatest_of(sums->inertia);
      return sums->inertia;
    });
  }
  return *tensor_;
}

Result<bool> SceneBody::is_along_principal_axes() {
  const auto& inertia = tensor();
  if (!inertia) return tl::unexpected(inertia.error());
  const InertiaTensor& i = *inertia;
  const double trace = i[0][0] + i[1][1] + i[2][2];
  const double products = std::abs(i[0][1]) + std::abs(i[0][2]) + std::abs(i[1][2]);
  return products <= alike * trace;
}

std::optional<SharpTensor> SceneBody::said_inertia() {
  const auto& of_particles = tensor();
  if (!body_.known || !body_.known->is_sharp || !of_particles) return std::nullopt;
  const double allowed =
      alike * (*of_particles)[0][0] + alike * (*of_particles)[1][1] + alike * (*of_particles)[2][2];
  SharpTensor said{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      said[i][j] = {body_.known->inertia[i][j], body_.known->low[i][j]};
      if (!(std::abs(said[i][j].high - (*of_particles)[i][j]) <= allowed)) return std::nullopt;
    }
  }
  return said;
}

const Result<SharpTensor>& SceneBody::sharp_tensor() {
  if (!sharp_tensor_) {
    if (const auto said = said_inertia()) {
      ledger_.skip(sharp_tensor_node, "the body's file says it");
      is_said_ = true;
      sharp_tensor_ = *said;
    } else {
      const auto sum = [&]() -> Result<SharpTensor> {
        const auto sums = check_count(body_).and_then([&] { return sharp_mass_sums(points_of(body_)); });
        if (!sums) return tl::unexpected(sums.error());
        sharp_tensor_rounding_ = sums->error == 0 ? 0 : sums->error * greatest_of(sums->inertia);
        return sums->inertia;
      };
      sharp_tensor_ = ledger_.compute(sharp_tensor_node, "for the differences of principal moments", sum);
    }
  }
  return *sharp_tensor_;
}

const ExactMoments* SceneBody::exact() {
  return sharp_tensor() && is_said_ ? body_.known->exact.get() : nullptr;
}

const LongNumber* SceneBody::digits_of_moment(std::size_t k) {
  if (!moments() || exact() == nullptr || left_out_[k] != 0) return nullptr;
  return &exact()->moments[exact_order_[k]];
}

const Result<SharpPosition>& SceneBody::moments() {
  if (moments_) return *moments_;
  const auto along = is_along_principal_axes();
  if (!along) {
    moments_ = tl::unexpected(along.error());
    return *moments_;
  }
  const auto& inertia = sharp_tensor();
  if (!inertia) {
    moments_ = tl::unexpected(inertia.error());
  } else if (const ExactMoments* all = exact()) {
    NearestAxes nearest;
    nearest.order = exact_order_;
    if (*along) nearest = nearest_axes(all->axes, alike);
    exact_order_ = nearest.order;
    ledger_.skip(moments_node, "known to all digits");
    moments_ = in_order(all->principal.moments, exact_order_);
    left_out_ = open_order(**moments_, nearest);
  } else if (*along) {
    moments_ = ledger_.compute(moments_node, "the body's axes are its principal axes", [&] {
      return moments_in_order_of_axes(*inertia, 3 * sharp_tensor_error(), left_out_);
    });
  } else {
    moments_ = ledger_.compute(moments_node, "values alone", [&] {
      return principal_moments(*inertia).map([](const PrincipalMoments& each) { return each.moments; });
    });
  }
  return *moments_;
}

const Result<SceneBody::Axes>& SceneBody::axes() {
  if (axes_) return *axes_;
  const auto along = is_along_principal_axes();
  if (!along) {
    axes_ = tl::unexpected(along.error());
  } else if (*along) {
    ledger_.skip(axes_node, "the body's axes are its principal axes");
    axes_ = std::array<Position, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  } else if (const auto& inertia = sharp_tensor(); !inertia) {
    axes_ = tl::unexpected(inertia.error());
  } else if (const ExactMoments* all = exact()) {
    ledger_.skip(axes_node, "known to all digits");
    axes_ = all->axes;
  } else {
    axes_ = ledger_.compute(axes_node, "vectors of the tensor", [&] {
      return principal_axes(*inertia).map([](const PrincipalAxes& axes) { return axes.axes; });
    });
  }
  return *axes_;
}

const Result<void>& SceneBody::turn_places() {
  if (turned_) return *turned_;
  const auto& turn = axes();  // asks for the tensor, too
  if (with_errors_) (void)described_error();
  if (!turn) {
    turned_ = tl::unexpected(turn.error());
    return *turned_;
  }
  turned_ = ledger_.compute(places_node, "turned", [&]() -> Result<void> {
    auto& [x, y, z] = body_.positions;
    for (std::size_t p = 0; p < body_.size(); ++p) {
      const Position place = body_.position(p);
      const auto along = [&](const Position& axis) {
        return axis[0] * place[0] + axis[1] * place[1] + axis[2] * place[2];
      };
      x[p] = along((*turn)[0]);
      y[p] = along((*turn)[1]);
      z[p] = along((*turn)[2]);
    }
    return {};
  });
  return *turned_;
}

}  // namespace rigor
