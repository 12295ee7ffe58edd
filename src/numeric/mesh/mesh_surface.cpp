// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/splitmix.h"
#include "numeric/kernels/mesh_sums.h"
#include "numeric/mesh/mesh.h"

namespace rigor {
namespace {

constexpr std::uint32_t no_corner = std::numeric_limits<std::uint32_t>::max();

/// The vertices by their places: a hash table with open addresses, at most half full.
class VertexTable {
 public:
  explicit VertexTable(const std::vector<Position>& vertices)
      : vertices_(vertices), slots_(std::bit_ceil(2 * vertices.size() + 1), no_corner) {}

  /// The first vertex that was asked for at the place of this one.
  std::uint32_t first_at(std::uint32_t vertex) {
    const Position& place = vertices_[vertex];
    std::size_t slot = hash(place);
    while (true) {
      slot &= slots_.size() - 1;
      if (slots_[slot] == no_corner) return slots_[slot] = vertex;
      if (vertices_[slots_[slot]] == place) return slots_[slot];
      ++slot;
    }
  }

 private:
  static std::size_t hash(const Position& place) {
    std::uint64_t bits = 0;
    for (const double x : place) {
      bits ^= std::bit_cast<std::uint64_t>(x + 0.0);  // −0 becomes 0
      bits *= 0x9e3779b97f4a7c15U;
      bits ^= bits >> 32;
    }
    return SplitMix(bits).next();
  }

  const std::vector<Position>& vertices_;
  std::vector<std::uint32_t> slots_;
};

/// Half-edges by the lower of their vertices: those of vertex v are `ends[first[v]]` to `ends[first[v + 1]]`,
/// each twice the higher vertex, and one more if it goes there.
struct HalfEdges {
  std::vector<std::uint32_t> first;
  std::vector<std::uint64_t> ends;
};

template <class Visit>
void for_each_half_edge(const Mesh& mesh, const Visit& visit) {
  for (const auto& [a, b, c] : mesh.triangles) {
    visit(a, b);
    visit(b, c);
    visit(c, a);
  }
}

HalfEdges half_edges(const Mesh& mesh) {
  HalfEdges edges;
  edges.first.resize(mesh.vertices.size() + 2);
  for_each_half_edge(mesh, [&](std::uint32_t a, std::uint32_t b) { ++edges.first[std::min(a, b) + 2]; });
  std::partial_sum(edges.first.begin(), edges.first.end(), edges.first.begin());
  edges.ends.resize(3 * mesh.triangles.size());
  for_each_half_edge(mesh, [&](std::uint32_t a, std::uint32_t b) {  // leaves the starts in `first`
    edges.ends[edges.first[std::min(a, b) + 1]++] = 2 * std::uint64_t{std::max(a, b)} + (a < b ? 1 : 0);
  });
  return edges;
}

/// Do they come in pairs, once there and once back? Sorts them.
bool are_paired(std::span<std::uint64_t> ends) {
  constexpr std::size_t few = 32;
  if (ends.size() > few) {
    std::ranges::sort(ends);
  } else {
    for (std::size_t n = 1; n < ends.size(); ++n)
      for (std::size_t k = n; k > 0 && ends[k] < ends[k - 1]; --k) std::swap(ends[k], ends[k - 1]);
  }
  if (ends.size() % 2 != 0) return false;
  for (std::size_t n = 0; n < ends.size(); n += 2) {
    if (ends[n] % 2 != 0 || ends[n + 1] != ends[n] + 1) return false;
    if (n > 0 && ends[n - 1] == ends[n] + 1) return false;
  }
  return true;
}

struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  bool forward;  // passed from the low vertex to the high one

  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends() const { return {low, high}; }
};

std::string text_of(const Position& p) { return fmt::format("({}, {}, {})", p[0], p[1], p[2]); }

/// Equal places are found by comparison, which a NaN never passes.
Result<void> check_finite(const std::vector<Position>& vertices) {
  for (std::size_t n = 0; n < vertices.size(); ++n)
    for (const double x : vertices[n])
      if (!std::isfinite(x))
        return tl::unexpected(
            Error{fmt::format("vertex {} is at {}: not finite", n + 1, text_of(vertices[n]))});
  return {};
}

/// In the order of the coordinates of their ends.
std::vector<Edge> sorted_edges(const Mesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for_each_half_edge(mesh, [&](std::uint32_t a, std::uint32_t b) {
    edges.push_back({std::min(a, b), std::max(a, b), a < b});
  });
  std::ranges::stable_sort(edges, {}, &Edge::ends);
  return edges;
}

/// The vertices in the order of their coordinates.
Mesh in_order(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(
      order, [&](std::uint32_t a, std::uint32_t b) { return mesh.vertices[a] < mesh.vertices[b]; });
  Mesh result;
  std::vector<std::uint32_t> renamed(mesh.vertices.size());
  for (const std::uint32_t vertex : order) {
    renamed[vertex] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[vertex]);
  }
  result.triangles = mesh.triangles;
  for (auto& triangle : result.triangles)
    for (std::uint32_t& corner : triangle) corner = renamed[corner];
  return result;
}

/// Names the first edge that is wrong.
Result<void> check_edges(const Mesh& mesh) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].ends() == edges[first].ends()) ++last;
    if (last - first == 2 && edges[first].forward != edges[first + 1].forward) continue;
    const std::string edge = fmt::format("the edge from {} to {}", text_of(mesh.vertices[edges[first].low]),
                                         text_of(mesh.vertices[edges[first].high]));
    if (last - first == 1) return refuse(edge + " belongs to one triangle only: the surface is open");
    if (last - first == 2)
      return tl::unexpected(
          Error{edge + " is passed twice in the same direction: the triangles are not oriented alike"});
    return refuse(fmt::format("{} belongs to {} triangles, not to two", edge, last - first));
  }
  return {};
}

}  // namespace

Result<Mesh> welded(const Mesh& mesh) {
  if (const auto corners = check_corners(mesh.vertices.size(), mesh.triangles); !corners)
    return tl::unexpected(corners.error());
  if (const auto finite = check_finite(mesh.vertices); !finite) return tl::unexpected(finite.error());
  VertexTable table(mesh.vertices);
  std::vector<std::uint32_t> first(mesh.vertices.size());
  for (std::uint32_t vertex = 0; vertex < first.size(); ++vertex) first[vertex] = table.first_at(vertex);
  Mesh result;
  result.triangles.reserve(mesh.triangles.size());
  std::vector<std::uint32_t> renamed(mesh.vertices.size(), no_corner);
  for (auto triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = first[corner];
    const auto [a, b, c] = triangle;
    if (a == b || b == c || c == a) continue;
    for (const std::uint32_t corner : triangle) renamed[corner] = 0;
    result.triangles.push_back(triangle);
  }
  result.vertices.reserve(mesh.vertices.size());
  for (std::size_t vertex = 0; vertex < renamed.size(); ++vertex) {
    if (renamed[vertex] == no_corner) continue;
    renamed[vertex] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(mesh.vertices[vertex]);
  }
  for (auto& triangle : result.triangles)
    for (std::uint32_t& corner : triangle) corner = renamed[corner];
  return result;
}

Result<void> check_closed(const Mesh& mesh) {
  if (auto corners = check_corners(mesh.vertices.size(), mesh.triangles); !corners) return corners;
  HalfEdges edges = half_edges(mesh);
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const std::size_t from = edges.first[vertex];
    if (!are_paired(std::span(edges.ends).subspan(from, edges.first[vertex + 1] - from)))
      return check_edges(in_order(mesh));
  }
  return {};
}

}  // namespace rigor
