// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/mesh_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rigor {
namespace {

/// Sets of vertices, each known by one of them.
class VertexSets {
 public:
  explicit VertexSets(std::size_t vertices) : above_(vertices) {
    std::iota(above_.begin(), above_.end(), 0U);
  }
  std::uint32_t of(std::uint32_t vertex) {
    while (above_[vertex] != vertex) vertex = above_[vertex] = above_[above_[vertex]];
    return vertex;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = of(a);
    const std::uint32_t second = of(b);
    above_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> above_;
};

constexpr std::uint32_t none = ~std::uint32_t{0};

/// Relative to a result of a few operations on two parts each.
constexpr double rounding = 0x1p-97;

/// A part, with its share of the volume and its centre from that of the largest.
struct Share {
  const MeshMoments* moments;
  HighLow weight;
  double weight_error;  // of itself
  SharpPosition at;
  std::array<double, 3> at_error;
};

/// Σ w_p x_p with a bound of its error.
struct WeightedSum {
  HighLow value{};
  double error = 0;
  double sizes = 0;
  int terms = 0;

  void add(const Share& share, const HighLow& x, double x_error) {
    const double weight = std::abs(share.weight.high);
    const double size = weight * std::abs(x.high);
    value = value + share.weight * x;
    error += weight * (1 + share.weight_error) * x_error + size * share.weight_error;
    sizes += size;
    ++terms;
  }
  [[nodiscard]] double bound() const { return (error + (terms + 4) * 0x1p-103 * sizes) * (1 + 0x1p-20); }
};

std::vector<Share> shares_of(const std::vector<MeshMoments>& parts, const MeshMoments& largest,
                             const MeshMoments& whole) {
  std::vector<Share> shares;
  for (const MeshMoments& part : parts) {
    Share share{
        &part, part.volume / whole.volume, part.errors.volume + whole.errors.volume + rounding, {}, {}};
    for (std::size_t i = 0; i < 3 && &part != &largest; ++i) {
      share.at[i] = part.centre[i] - largest.centre[i];
      share.at_error[i] =
          part.errors.centre[i] + largest.errors.centre[i] + 0x1p-104 * std::abs(share.at[i].high);
    }
    shares.push_back(share);
  }
  return shares;
}

/// The second moment ij about the common centre, which is at `from` from that of the largest part.
WeightedSum second_moment(const std::vector<Share>& shares, const std::array<WeightedSum, 3>& from,
                          std::size_t i, std::size_t j) {
  WeightedSum sum;
  for (const Share& share : shares) {
    const HighLow& x = share.at[i];
    const HighLow& y = share.at[j];
    const double size = std::abs(x.high * y.high);
    sum.add(share, share.moments->second_moments[i][j], share.moments->errors.second_moments[i][j]);
    sum.add(share, x * y,
            std::abs(x.high) * share.at_error[j] + std::abs(y.high) * share.at_error[i] +
                share.at_error[i] * share.at_error[j] + rounding * size);
  }
  const double size = std::abs(from[i].value.high * from[j].value.high);
  sum.value = sum.value - from[i].value * from[j].value;
  sum.error += std::abs(from[i].value.high) * from[j].bound() +
               std::abs(from[j].value.high) * from[i].bound() + from[i].bound() * from[j].bound() +
               rounding * size;
  return sum;
}

Result<void> set_second_moments(MeshMoments& whole, const std::vector<Share>& shares,
                                const std::array<WeightedSum, 3>& from) {
  std::array<double, 3> diagonal{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const WeightedSum sum = second_moment(shares, from, i, j);
      if (!std::isfinite(sum.value.high)) return refuse("the second moments overflow");
      whole.second_moments[i][j] = whole.second_moments[j][i] = sum.value;
      whole.errors.second_moments[i][j] = whole.errors.second_moments[j][i] = sum.bound();
    }
    diagonal[i] = whole.second_moments[i][i].high;
    whole.errors.greatest =
        std::max(whole.errors.greatest, whole.errors.second_moments[i][i] / std::abs(diagonal[i]));
  }
  return check_second_moments(diagonal, whole.errors);
}

/// The common volume and what else is just added up.
Result<MeshMoments> volume_of(const std::vector<MeshMoments>& parts) {
  MeshMoments whole;
  whole.sharp = true;
  HighLow volume{};
  double volumes = 0;
  double error = 0;
  for (const MeshMoments& part : parts) {
    const double size = std::abs(part.volume.high);
    volume = volume + part.volume;
    volumes += size;
    error += size * part.errors.volume;
    whole.flat += part.flat;
  }
  error += static_cast<double>(parts.size()) * 0x1p-104 * volumes;
  if (!std::isfinite(volumes)) return refuse("the volume overflows");
  if (!(error < 0x1p-10 * std::abs(volume.high))) return refuse("the mesh encloses no volume");
  whole.volume = volume;
  whole.errors.volume = error / std::abs(volume.high) * (1 + 0x1p-9);
  return whole;
}

}  // namespace

std::vector<Mesh> connected_parts(const Mesh& mesh) {
  VertexSets sets(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(b, c);
  }
  std::vector<Mesh> parts;
  std::vector<std::uint32_t> part_of(mesh.vertices.size(), none);
  std::vector<std::uint32_t> place(mesh.vertices.size(), none);
  for (auto triangle : mesh.triangles) {
    std::uint32_t& part = part_of[sets.of(triangle[0])];
    if (part == none) {
      part = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    Mesh& own = parts[part];
    for (std::uint32_t& corner : triangle) {
      if (place[corner] == none) {
        place[corner] = static_cast<std::uint32_t>(own.vertices.size());
        own.vertices.push_back(mesh.vertices[corner]);
      }
      corner = place[corner];
    }
    own.triangles.push_back(triangle);
  }
  return parts;
}

Result<MeshMoments> moments_of_parts(const std::vector<Mesh>& parts) {
  std::vector<MeshMoments> moments;
  for (const Mesh& part : parts) {
    const auto own = mesh_moments(part.vertices, part.triangles, MeshSharpness::always);
    if (!own) return tl::unexpected(own.error());
    moments.push_back(*own);
  }
  auto whole = volume_of(moments);
  if (!whole) return whole;
  const MeshMoments& largest = std::ranges::max(moments, [](const MeshMoments& a, const MeshMoments& b) {
    return std::abs(a.volume.high) < std::abs(b.volume.high);
  });
  const std::vector<Share> shares = shares_of(moments, largest, *whole);
  std::array<WeightedSum, 3> from;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Share& share : shares) from[i].add(share, share.at[i], share.at_error[i]);
    whole->centre[i] = largest.centre[i] + from[i].value;
    whole->errors.centre[i] =
        from[i].bound() + largest.errors.centre[i] + 0x1p-104 * std::abs(whole->centre[i].high);
  }
  if (const auto set = set_second_moments(*whole, shares, from); !set) return tl::unexpected(set.error());
  return whole;
}

}  // namespace rigor
