// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/mesh_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <limits>

#include "catch.h"
#include "numeric/meshes.h"

namespace rigor {
namespace {

template <class T>
std::string reason(const Result<T>& result) {
  return result ? "accepted" : result.error().reason;
}

std::string ascii_stl(const Mesh& mesh) {
  std::string text = "solid a b\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle) {
      const Position& p = mesh.vertices[corner];
      text += fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a b\n";
}

void append(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
}

std::string binary_stl(const Mesh& mesh, std::string header = "solid, says the header") {
  header.resize(80);
  append(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) append(header, 0);
    for (const std::uint32_t corner : triangle) {
      for (const double x : mesh.vertices[corner])
        append(header, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    }
    header += "ab";
  }
  return header;
}

TEST_CASE("ASCII and binary STL give the same triangles") {
  const Mesh box = box_mesh({1, 2, 0.5}, {-1, 0, 3});
  const auto ascii = read_stl(ascii_stl(box));
  const auto binary = read_stl(binary_stl(box));
  REQUIRE((ascii && binary));
  CHECK(ascii->vertices == binary->vertices);
  CHECK(ascii->triangles == binary->triangles);
  CHECK(mesh_mass(*ascii)->volume == Approx(1));
}

TEST_CASE("all solids of an STL file are read, and what is none is refused") {
  const std::string ascii = ascii_stl(tetrahedron_mesh());
  const auto one = read_stl(ascii);
  const auto two = read_stl(ascii + ascii);
  REQUIRE(one);
  REQUIRE(two);
  CHECK(two->triangles.size() == 2 * one->triangles.size());
  CHECK(reason(read_stl(ascii + "facets\n")) == "line 31: `facets` was found where `solid` was expected");
}

TEST_CASE("a truncated STL file is refused with what is missing") {
  const std::string ascii = ascii_stl(tetrahedron_mesh());
  CHECK(reason(read_stl(ascii.substr(0, ascii.size() - 13))) == "line 30: the file ends before `endsolid`");
  CHECK(reason(read_stl(ascii.substr(0, 66))) == "line 6: the file ends where `vertex` was expected");
  CHECK(reason(read_stl("solid a\nfacet normal 0 0 0\nouter loop\nvertex 1 2")) ==
        "line 4: the file ends inside a vertex");
  const std::string binary = binary_stl(tetrahedron_mesh(), "made by hand");
  CHECK(reason(read_stl(binary.substr(0, 200))) ==
        "a binary STL file of 4 triangles has 284 bytes, but this one has 200: it is truncated, or not STL");
  CHECK(reason(read_stl(binary + "x")) ==
        "a binary STL file of 4 triangles has 284 bytes, but this one has 285: it is truncated, or not STL");
  CHECK(
      reason(read_stl("")) ==
      "this is not an STL file: it does not begin with `solid`, and its 0 bytes are too few for the header");
  // Every prefix ends in a reason.
  for (std::size_t size = 0; size < binary.size(); ++size) CHECK_FALSE(read_stl(binary.substr(0, size)));
  for (std::size_t size = 0; size + 13 < ascii.size(); ++size) CHECK_FALSE(read_stl(ascii.substr(0, size)));
}

TEST_CASE("an STL file with a wrong word or number is refused with the line") {
  CHECK(reason(read_stl("solid a\nfacet normal 0 0 0\nouter lop\n")) ==
        "line 3: `lop` was found where `loop` was expected");
  CHECK(reason(read_stl("solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 nan 0\n")) ==
        "line 4: `nan` is not a finite number");
  CHECK(reason(read_stl("solid a\n\x01\x02\x7f garbage\n")) ==
        "line 2: `???` was found where `facet` was expected");
  Mesh mesh = tetrahedron_mesh();
  mesh.vertices[3][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK(reason(read_stl(binary_stl(mesh))) == "triangle 2 has the coordinate nan, which must be finite");
}

TEST_CASE("OBJ faces become fans, and negative indices count back") {
  const auto mesh = read_obj(
      "# a square pyramid\r\nmtllib none.mtl\no pyramid\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0\nvn 0 0 "
      "1\nvt 0 0\n"
      "v +.5 .5 1e0\nusemtl none\nf 4/1/1 3//1 2/1 1\nf 1 2 -1\nf 2 3 5\nf 3 4 5\nf -2 -5 -1 # the last");
  REQUIRE(mesh);
  CHECK(mesh->triangles.size() == 6);
  CHECK(mesh->triangles[0] == std::array<std::uint32_t, 3>{3, 2, 1});
  CHECK(mesh->triangles[1] == std::array<std::uint32_t, 3>{3, 1, 0});
  CHECK(mesh_mass(*mesh)->volume == Approx(1. / 3));
}

TEST_CASE("a wrong OBJ file is refused with the line") {
  CHECK(reason(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")) ==
        "line 4: a face names vertex 4, but 3 are defined above it");
  CHECK(reason(read_obj("v 0 0 0\nf 1 1 0\n")) ==
        "line 2: a face names vertex 0, but 1 are defined above it");
  CHECK(reason(read_obj("v 0 0 0\nf 1 1 -2\n")) ==
        "line 2: a face names vertex -2, but 1 are defined above it");
  CHECK(reason(read_obj("v 0 0 0\nf 1 1 99999999999999999999\n")) ==
        "line 2: `99999999999999999999` is not a corner of a face");
  CHECK(reason(read_obj("v 0 0\n")) == "line 1: a vertex has fewer than three coordinates");
  CHECK(reason(read_obj("v 0 0 inf\n")) == "line 1: `inf` is not a finite number");
  CHECK(reason(read_obj("v 0 0 0\nf 1 1\n")) == "line 2: a face has 2 corners, fewer than three");
  CHECK(reason(read_obj(std::string("\0\x01PNG\n", 6))) ==
        "line 1: `??PNG` is not a statement of an OBJ file");
  CHECK(reason(read_obj("")) == "the file has no faces");
  CHECK(reason(read_obj("wiggle-wiggle-wiggle-wiggle 3\n")) ==
        "line 1: `wiggle-wiggle-wiggle-wig…` is not a statement of an OBJ file");
}

TEST_CASE("the kind of a mesh file follows from its name") {
  CHECK(read_mesh("a/b.STL", binary_stl(tetrahedron_mesh())));
  CHECK(reason(read_mesh("b.obj", "")) == "the file has no faces");
  CHECK(reason(read_mesh("b.ply", "")) == "the name of a mesh file must end in `.stl` or `.obj`");
  CHECK(reason(read_mesh("b", "")) == "the name of a mesh file must end in `.stl` or `.obj`");
}

}  // namespace
}  // namespace rigor
