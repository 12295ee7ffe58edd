// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "base/among.h"
#include "base/ascii.h"
#include "numeric/mesh/mesh_file.h"
#include "numeric/mesh/mesh_words.h"

namespace rigor {
namespace {

constexpr std::array<std::string_view, 11> ignored{"vt", "vn", "vp",     "g",      "o", "s",
                                                   "l",  "p",  "usemtl", "mtllib", "mg"};

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : words_(text) {}

  Result<Mesh> read() {
    do {
      const std::string_view word = words_.next_on_line();
      if (word.empty() || is_one_of(word, ignored)) continue;
      if (word != "v" && word != "f")
        return words_.refuse(fmt::format("`{}` is not a statement of an OBJ file", shown(word)));
      const auto done = word == "v" ? read_vertex() : read_face();
      if (!done) return tl::unexpected(done.error());
    } while (words_.next_line());
    if (mesh_.triangles.empty()) return refuse("the file has no faces");
    return mesh_;
  }

 private:
  /// What comes after the three coordinates, a weight or a colour, is ignored.
  Result<void> read_vertex() {
    Position vertex{};
    for (double& x : vertex) {
      const std::string_view word = words_.next_on_line();
      if (word.empty()) return words_.refuse("a vertex has fewer than three coordinates");
      const auto number = finite_number(word);
      if (!number) return words_.refuse(fmt::format("`{}` is not a finite number", shown(word)));
      x = *number;
    }
    mesh_.vertices.push_back(vertex);
    return {};
  }

  Result<void> read_face() {
    std::vector<std::uint32_t> corners;
    for (auto word = words_.next_on_line(); !word.empty(); word = words_.next_on_line()) {
      const auto corner = read_corner(word);
      if (!corner) return tl::unexpected(corner.error());
      corners.push_back(*corner);
    }
    if (corners.size() < 3)
      return words_.refuse(fmt::format("a face has {} corners, fewer than three", corners.size()));
    for (std::size_t k = 2; k < corners.size(); ++k)
      mesh_.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    return {};
  }

  /// `7`, `7/1`, `7/1/2`, `7//2`, `-1`.
  Result<std::uint32_t> read_corner(std::string_view word) {
    const std::string_view index = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(index.data(), index.data() + index.size(), number);
    if (error != std::errc() || end != index.data() + index.size())
      return words_.refuse(fmt::format("`{}` is not a corner of a face", shown(word)));
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t from_zero = number < 0 ? count + number : number - 1;
    if (number == 0 || from_zero < 0 || from_zero >= count)
      return words_.refuse(fmt::format("a face names vertex {}, but {} are defined above it", number, count));
    return static_cast<std::uint32_t>(from_zero);
  }

  MeshWords words_;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> read_obj(std::string_view bytes) { return ObjReader(bytes).read(); }

Result<Mesh> read_mesh(std::string_view file_name, std::string_view bytes) {
  const std::string ending =
      lowered(file_name.substr(std::min(file_name.size(), file_name.find_last_of('.'))));
  if (ending == ".stl") return read_stl(bytes);
  if (ending == ".obj") return read_obj(bytes);
  return refuse("the name of a mesh file must end in `.stl` or `.obj`");
}

}  // namespace rigor
