// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "numeric/mesh.h"

namespace rigor {
namespace {

struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  bool forward;  // passed from the low vertex to the high one

  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends() const { return {low, high}; }
};

std::string text_of(const Position& p) { return fmt::format("({}, {}, {})", p[0], p[1], p[2]); }

std::vector<Edge> edges_of(const Mesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k];
      const std::uint32_t to = triangle[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& a, const Edge& b) { return a.ends() < b.ends(); });
  return edges;
}

}  // namespace

Mesh welded(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return mesh.vertices[a] < mesh.vertices[b]; });
  Mesh result;
  std::vector<std::uint32_t> renamed(mesh.vertices.size());
  for (const std::uint32_t vertex : order) {
    if (result.vertices.empty() || result.vertices.back() != mesh.vertices[vertex])
      result.vertices.push_back(mesh.vertices[vertex]);
    renamed[vertex] = static_cast<std::uint32_t>(result.vertices.size() - 1);
  }
  for (auto triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = renamed[corner];
    const auto [a, b, c] = triangle;
    if (a != b && b != c && c != a) result.triangles.push_back(triangle);
  }
  return result;
}

Result<void> check_closed(const Mesh& mesh) {
  const std::vector<Edge> edges = edges_of(mesh);
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].ends() == edges[first].ends()) ++last;
    if (last - first == 2 && edges[first].forward != edges[first + 1].forward) continue;
    const std::string edge = fmt::format("the edge from {} to {}", text_of(mesh.vertices[edges[first].low]),
                                         text_of(mesh.vertices[edges[first].high]));
    if (last - first == 1)
      return tl::unexpected(Error{edge + " belongs to one triangle only: the surface is open"});
    if (last - first == 2)
      return tl::unexpected(
          Error{edge + " is passed twice in the same direction: the triangles are not oriented alike"});
    return tl::unexpected(Error{fmt::format("{} belongs to {} triangles, not to two", edge, last - first)});
  }
  return {};
}

}  // namespace rigor
