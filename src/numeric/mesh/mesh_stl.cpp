// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "numeric/mesh/mesh_file.h"
#include "numeric/mesh/mesh_words.h"

namespace rigor {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t count_bytes = 4;
constexpr std::size_t triangle_bytes = 50;  // normal, three corners, two bytes of attributes

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// The size that a binary file with this count of triangles has.
std::uint64_t binary_size(std::string_view bytes) {
  return header_bytes + count_bytes + std::uint64_t{triangle_bytes} * little_endian(bytes, header_bytes);
}

void add_triangle(Mesh& mesh) {
  const auto size = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.triangles.push_back({size - 3, size - 2, size - 1});
}

Result<Mesh> read_binary(std::string_view bytes) {
  const std::uint32_t count = little_endian(bytes, header_bytes);
  Mesh mesh;
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    const std::size_t corners = header_bytes + count_bytes + triangle * triangle_bytes + 12;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Position vertex{};
      for (std::size_t k = 0; k < 3; ++k) {
        const float x = std::bit_cast<float>(little_endian(bytes, corners + 12 * corner + 4 * k));
        if (!std::isfinite(x))
          return tl::unexpected(
              Error{fmt::format("triangle {} has the coordinate {}, which must be finite", triangle + 1, x)});
        vertex[k] = static_cast<double>(x);
      }
      mesh.vertices.push_back(vertex);
    }
    add_triangle(mesh);
  }
  return mesh;
}

class AsciiStl {
 public:
  explicit AsciiStl(std::string_view text) : words_(text) {}

  Result<Mesh> read() {
    words_.next();  // `solid`, and its name
    words_.next_line();
    for (;;) {
      const std::string_view word = words_.next();
      if (word == "endsolid") {  // another one may follow
        words_.next_line();
        const std::string_view more = words_.next();
        if (more.empty()) return mesh_;
        if (more != "solid") return unexpected(more, "solid");
        words_.next_line();
        continue;
      }
      if (word.empty()) return words_.refuse("the file ends before `endsolid`");
      if (word != "facet") return unexpected(word, "facet");
      if (const auto facet = read_facet(); !facet) return tl::unexpected(facet.error());
    }
  }

 private:
  [[nodiscard]] tl::unexpected<Error> unexpected(std::string_view word, std::string_view wanted) const {
    if (word.empty()) return words_.refuse(fmt::format("the file ends where `{}` was expected", wanted));
    return words_.refuse(fmt::format("`{}` was found where `{}` was expected", shown(word), wanted));
  }

  Result<void> expect(std::string_view wanted) {
    if (const std::string_view word = words_.next(); word != wanted) return unexpected(word, wanted);
    return {};
  }

  Result<void> read_facet() {
    if (const auto normal = expect("normal"); !normal) return normal;
    for (int k = 0; k < 3; ++k) words_.next();  // not used, and often wrong
    for (const std::string_view word : {"outer", "loop"}) {
      if (const auto found = expect(word); !found) return found;
    }
    for (int corner = 0; corner < 3; ++corner) {
      if (const auto vertex = read_vertex(); !vertex) return vertex;
    }
    add_triangle(mesh_);
    if (const auto end = expect("endloop"); !end) return end;
    return expect("endfacet");
  }

  Result<void> read_vertex() {
    if (const auto found = expect("vertex"); !found) return found;
    Position vertex{};
    for (double& x : vertex) {
      const std::string_view word = words_.next();
      const auto number = finite_number(word);
      if (word.empty()) return words_.refuse("the file ends inside a vertex");
      if (!number) return words_.refuse(fmt::format("`{}` is not a finite number", shown(word)));
      x = *number;
    }
    mesh_.vertices.push_back(vertex);
    return {};
  }

  MeshWords words_;
  Mesh mesh_;
};

}  // namespace

Result<Mesh> read_stl(std::string_view bytes) {
  const bool has_count = bytes.size() >= header_bytes + count_bytes;
  if (has_count && binary_size(bytes) == bytes.size()) return read_binary(bytes);
  MeshWords words(bytes.substr(0, header_bytes));
  if (words.next() == "solid") return AsciiStl(bytes).read();
  if (!has_count)
    return refuse(
        fmt::format("this is not an STL file: it does not begin with `solid`, and its {} bytes are too few "
                    "for the header",
                    bytes.size()));
  return refuse(fmt::format(
      "a binary STL file of {} triangles has {} bytes, but this one has {}: it is truncated, or not STL",
      little_endian(bytes, header_bytes), binary_size(bytes), bytes.size()));
}

}  // namespace rigor
