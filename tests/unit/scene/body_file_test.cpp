// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/body_file.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "catch.h"
#include "numeric/body/inertia.h"
#include "source/render.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

constexpr double u = 0x1p-53;

struct Read {
  std::optional<Body> body;
  std::string printed;

  [[nodiscard]] std::string first_line() const { return printed.substr(0, printed.find('\n')); }
};

Read read(std::string text, const fs::path& folder = "derivations/bodies") {
  SourceMap sources;
  Diagnostics diagnostics;
  Read result;
  const FileId file = sources.add("b.toml", std::move(text));
  if (const auto table = parse_toml(sources, file, diagnostics))
    result.body = read_body(*table, "b", folder, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics) result.printed += render(diagnostic, sources);
  CHECK(result.body.has_value() == diagnostics.empty());
  return result;
}

/// The first line of what is wrong.
std::string wrong(std::string text) { return read(std::move(text)).first_line(); }

Read read_file_at(const std::string& path) {
  SourceMap sources;
  Diagnostics diagnostics;
  Read result{read_body_file(path, sources, diagnostics), {}};
  for (const Diagnostic& diagnostic : diagnostics) result.printed += render(diagnostic, sources);
  return result;
}

/// A folder that is gone afterwards.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::temp_directory_path() / ("rigor-bodies-" + name + "-" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

TEST_CASE("a book has the moments of a box") {
  const auto [body, printed] =
      read("title = \"a book\"\nshape = \"box\"\nmass = \"12 kg\"\nsize = [\"10 cm\", 0.2, \"300 mm\"]\n");
  REQUIRE(body);
  CHECK(body->title == "a book");
  CHECK(body->name == "b");
  CHECK(body->size() == 8);
  CHECK(body->known->inertia[0][0] == Approx(0.04 + 0.09));
  CHECK(body->known->inertia[1][1] == Approx(0.01 + 0.09));
  CHECK(body->known->inertia[2][2] == Approx(0.01 + 0.04));
}

TEST_CASE("every shape is read, as particles and as a sampled cloud") {
  for (const std::string text :
       {"shape = \"rod\"\nlength = 1", "shape = \"hoop\"\nradius = 1", "shape = \"hoop\"\nradii = [1, 2]",
        "shape = \"disc\"\nradius = 1", "shape = \"plate\"\nsize = [1, 2]",
        "shape = \"box\"\nsize = [1, 2, 3]", "shape = \"sphere\"\nradius = 1",
        "shape = \"spherical shell\"\nradius = 1", "shape = \"ellipsoid\"\nradii = [1, 2, 3]",
        "shape = \"cylinder\"\nradius = 1\nheight = 2", "shape = \"cone\"\nradii = [1, 2]\nheight = 2"}) {
    INFO(text);
    CHECK(read(text + "\nmass = 1\n").body);
    const auto cloud = read(text + "\nmass = 1\npoints = 7\nseed = 3\n").body;
    REQUIRE(cloud);
    CHECK(cloud->size() == 7);
  }
  CHECK(read("shape = \"random cloud\"\npoints = 9\n").body->size() == 9);
}

TEST_CASE("`along` turns the z axis, and parts are placed by their centres of mass") {
  const auto rod = read("shape = \"rod\"\nmass = 3\nlength = 2\nalong = \"x\"\n").body;
  REQUIRE(rod);
  CHECK(rod->known->inertia[0][0] == 0);
  CHECK(rod->known->inertia[1][1] == 1);
  const auto cross = read(
                         "[[parts]]\nshape = \"rod\"\nmass = 3\nlength = 2\n[[parts]]\nshape = \"rod\"\nmass "
                         "= 3\nlength = 2\n"
                         "along = \"y\"\noffset = [0, 0, \"2 m\"]\n")
                         .body;
  REQUIRE(cross);
  CHECK(cross->known->mass == 6);
  CHECK(cross->known->inertia[0][0] == Approx(1 + 1 + 6));
  CHECK(wrong("shape = \"rod\"\nmass = 3\nlength = 2\nalong = \"w\"\n") ==
        "b.toml:4:9: error: `w` is not an axis: `along` must be `x`, `y` or `z` [bad-body]");
}

TEST_CASE("parts are counted while they are read") {
  std::string parts;
  for (int i = 0; i < 12; ++i) parts += "[[parts]]\nshape = \"random cloud\"\npoints = 1000000\n";
  CHECK(wrong(parts) ==
        "b.toml:31:1: error: the parts up to this one have 11000000 particles, at most 10000000 [bad-body]");
}

TEST_CASE("particles are placed by coordinates or by distance and angles") {
  const auto body =
      read(
          "particles = [{ mass = \"1 kg\", position = [1, 0, 0] },\n"
          "  { mass = \"1 kg\", distance = \"1 m\", polar = \"90 deg\", azimuth = \"180 deg\" }]\n")
          .body;
  REQUIRE(body);
  CHECK(body->positions[0][0] == Approx(1));
  CHECK(body->positions[0][1] == Approx(-1));
  CHECK(std::abs(body->positions[2][1]) < 1e-15);
}

TEST_CASE("a body without particles, mass or extent is refused at the place") {
  CHECK(wrong("particles = []\n") == "b.toml:1:1: error: the body has no particles [bad-body]");
  CHECK(wrong("particles = [{ mass = 0, position = [0, 0, 0] }]\n") ==
        "b.toml:1:1: error: the body has no mass [bad-body]");
  CHECK(read("particles = [\n  { mass = \"-1 kg\", position = [0, 0, 0] },\n]\n").printed ==
        "b.toml:2:12: error: `mass` is -1, but must not be negative [bad-body]\n"
        "    2 |   { mass = \"-1 kg\", position = [0, 0, 0] },\n"
        "      |            ^~~~~~~\n");
  CHECK(wrong("shape = \"sphere\"\nmass = 0\nradius = 1\n") ==
        "b.toml:2:8: error: `mass` is 0, but must be positive [bad-body]");
  CHECK(wrong("shape = \"sphere\"\nmass = 1\nradius = \"-3 cm\"\n") ==
        "b.toml:3:10: error: `radius` is -0.03, but must be positive [bad-body]");
  CHECK(wrong("shape = \"box\"\nmass = 1\nsize = [1, 0, 1]\n") ==
        "b.toml:3:12: error: `size` is 0, but must be positive [bad-body]");
  CHECK(wrong("shape = \"sphere\"\nmass = nan\nradius = 1\n") ==
        "b.toml:2:8: error: `mass` is nan, but must be finite [bad-toml]");
  CHECK(wrong("shape = \"sphere\"\nmass = 1\nradius = inf\n") ==
        "b.toml:3:10: error: `radius` is inf, but must be finite [bad-toml]");
  CHECK(wrong("shape = \"sphere\"\nmass = 1\nradius = 1\npoints = 0\n") ==
        "b.toml:4:10: error: `points` is 0, but must be from 1 to 10000000 [bad-body]");
  CHECK(wrong("shape = \"sphere\"\nmass = 1e300\nradius = 1e300\n") ==
        "b.toml:1:1: error: the sphere's moments of inertia overflow [bad-body]");
  CHECK(wrong("parts = []\n") == "b.toml:1:1: error: the body has no parts [bad-body]");
}

TEST_CASE("an unknown shape is answered with the nearest, or with all of them") {
  CHECK(read("shape = \"spere\"\nmass = 1\nradius = 1\n").printed ==
        "b.toml:1:9: error: `spere` is not a known shape [bad-body]\n"
        "    1 | shape = \"spere\"\n"
        "      |         ^~~~~~~\n"
        "help: did you mean `sphere`?\n");
  CHECK(read("shape = \"dodecahedron\"\n")
            .printed.find("help: the shapes are rod, hoop, disc, plate, box, sphere, spherical shell, "
                          "ellipsoid, cylinder, cone, "
                          "random cloud\n") != std::string::npos);
}

TEST_CASE("a misspelled key is reported with what is missing and what is meant") {
  CHECK(read("shape = \"sphere\"\nmass = 1\nradios = 1\n").printed ==
        "b.toml:1:1: error: the body has no `radius` [bad-toml]\n"
        "    1 | shape = \"sphere\"\n"
        "      | ^\n"
        "b.toml:3:1: error: the body has a key `radios`, which is not known [unknown-key]\n"
        "    3 | radios = 1\n"
        "      | ^~~~~~\n"
        "help: did you mean `radius`?\n");
  CHECK(wrong("mass = 1\n") ==
        "b.toml:1:1: error: the body has a key `mass`, which is not known [unknown-key]");
  CHECK(wrong("") ==
        "b.toml:1:1: error: the body has none of the keys `shape`, `particles`, `mesh`, `cloud`, `moments`, "
        "`inertia`, `parts` [bad-body]");
  CHECK(wrong("shape = \"rod\"\nmesh = \"a.obj\"\n") ==
        "b.toml:2:1: error: the body has both `shape` and `mesh` [bad-body]");
  CHECK(wrong("particles = [3]\n") ==
        "b.toml:1:14: error: `particles` is a number, but must be a table [bad-toml]");
  CHECK(wrong("particles = [{ mass = 1 }]\n") ==
        "b.toml:1:14: error: the particle has no `position` [bad-toml]");
}

TEST_CASE("contradictory units are refused at the place") {
  CHECK(wrong("shape = \"rod\"\nmass = \"3 s\"\nlength = 1\n") ==
        "b.toml:2:8: error: `3 s` is a time (T), but `mass` must be a mass (M) [wrong-unit]");
  CHECK(wrong("shape = \"rod\"\nmass = \"3 kg\"\nlength = \"2 kg\"\n") ==
        "b.toml:3:10: error: `2 kg` is a mass (M), but `length` must be a length (L) [wrong-unit]");
  CHECK(wrong("shape = \"rod\"\nmass = \"3\"\nlength = 1\n") ==
        "b.toml:2:8: error: `3` is a pure number, but `mass` must be a mass (M) [wrong-unit]");
  CHECK(wrong("moments = [\"1 kg\", 1, 1]\nmass = 1\n") ==
        "b.toml:1:12: error: `1 kg` is a mass (M), but `moments` must be a quantity of dimension M L^2 "
        "[wrong-unit]");
}

TEST_CASE("given moments must be those of a body") {
  CHECK(read("moments = [1, 2, 3]\nmass = 1\n").body);
  CHECK(wrong("moments = [1, 2, 3.5]\nmass = 1\n") ==
        "b.toml:1:1: error: moment of inertia 3 is 3.5 kg m^2, greater than the sum of the others, 1 and 2 "
        "[bad-body]");
  CHECK(read("inertia = [[2, 0.5, 0], [0.5, 2, 0], [0, 0, 3]]\nmass = 1\n").body);
  CHECK(wrong("inertia = [[2, 1, 0], [0, 2, 0], [0, 0, 3]]\nmass = 1\n") ==
        "b.toml:1:1: error: the inertia tensor is not symmetric: I_12 = 1, I_21 = 0 [bad-body]");
  CHECK(wrong("inertia = [[2, 1, 0]]\nmass = 1\n") ==
        "b.toml:1:11: error: `inertia` has 1 rows, but must have 3 [bad-toml]");
}

TEST_CASE("a mesh is read from the body's folder, with a unit and a density") {
  const auto wedge = read("mesh = \"wedge.obj\"\nunit = \"1 cm\"\ndensity = \"0.7 g/cm^3\"\n").body;
  REQUIRE(wedge);
  CHECK(total_mass(*wedge) == Approx(0.7e-3 * 12 * 4 * 1.75));
  const auto tetrahedron = read_file_at("derivations/bodies/tetrahedron.toml").body;
  REQUIRE(tetrahedron);
  // Edges a = 2√2 cm: I = m a²/20 about every axis.
  for (std::size_t i = 0; i < 3; ++i) CHECK(tetrahedron->known->inertia[i][i] == Approx(0.02 * 8e-4 / 20));
  CHECK(wrong("mesh = \"wedge.obj\"\ndensity = 1\nmass = 1\n") ==
        "b.toml:2:1: error: the body has both `mass` and `density` [bad-body]");
  CHECK(wrong("mesh = \"wedge.obj\"\n") == "b.toml:1:1: error: the body has no `mass` [bad-toml]");
  CHECK(wrong("mesh = \"none.obj\"\nmass = 1\n") ==
        "b.toml:1:8: error: `none.obj`: no such file or directory [bad-mesh]");
  CHECK(wrong("mesh = \"../bodies/wedge.obj\"\nmass = 1\n") ==
        "b.toml:1:8: error: `../bodies/wedge.obj` is not in the folder of the body's file [bad-mesh]");
  CHECK(wrong("mesh = \"/etc/passwd\"\nmass = 1\n") ==
        "b.toml:1:8: error: `/etc/passwd` is not in the folder of the body's file [bad-mesh]");
}

TEST_CASE("a truncated, binary or open mesh is refused with its reason") {
  const Folder folder("meshes");
  folder.write("short.stl", std::string(80, ' ') + std::string("\4\0\0\0", 4) + std::string(60, '\1'));
  folder.write("binary.obj", std::string("\x7f"
                                         "ELF\0\1\2",
                                         7));
  folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 4 3\nf 1 2 4\n");
  folder.write("turned.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n");
  const auto of = [&](const std::string& file) {
    return read("mesh = \"" + file + "\"\nmass = 1\n", folder.at("")).first_line();
  };
  CHECK(of("short.stl") ==
        "b.toml:1:8: error: `short.stl`: a binary STL file of 4 triangles has 284 bytes, but this one has "
        "144: it is truncated, or not STL [bad-mesh]");
  CHECK(of("binary.obj") ==
        "b.toml:1:8: error: `binary.obj`: line 1: `?ELF???` is not a statement of an OBJ file [bad-mesh]");
  CHECK(
      of("open.obj") ==
      "b.toml:1:8: error: `open.obj`: the edge from (0, 0, 1) to (0, 1, 0) belongs to one triangle only: the "
      "surface is open [bad-mesh]");
  CHECK(of("turned.obj").empty());
}

TEST_CASE("a cloud of points is read from the body's folder, binary or text, with a unit") {
  const Folder folder("clouds");
  const std::array<double, 8> points{1e9, 1, 0, 2, 1e9 + 8, 1, -4, 2};  // x, y, z, m
  folder.write("pair.bin", {reinterpret_cast<const char*>(points.data()), sizeof points});
  folder.write("pair.csv", "# x, y, z, m\n1e9, 1, 0, 2\n\n  1000000008,+1 ,-4\t2  # the other\r\n");
  for (const std::string file : {"pair.bin", "pair.csv"}) {
    INFO(file);
    const auto [body, printed] = read("cloud = \"" + file + "\"\nunit = \"1 cm\"\n", folder.at(""));
    CHECK(printed.empty());
    REQUIRE(body);
    CHECK(body->masses == std::vector<double>{2, 2});
    CHECK(body->position(0) == Position{-0.04, 0, 0.02});
    CHECK(body->position(1) == Position{0.04, 0, -0.02});
  }
}

TEST_CASE("a cloud that is no body is refused with its point or line") {
  const Folder folder("bad-clouds");
  const auto of = [&](const std::string& file) {
    return read("cloud = \"" + file + "\"\n", folder.at("")).first_line();
  };
  std::array<double, 8> points{0, 1, 0, 2, 8, std::nan(""), -4, 2};
  const std::string bytes(reinterpret_cast<const char*>(points.data()), sizeof points);
  folder.write("nan.bin", bytes);
  folder.write("short.bin", bytes.substr(0, 60));
  folder.write("empty.bin", "");
  folder.write("comment.txt", "# nothing\n\n");
  folder.write("word.txt", "1 2 3 4\n1 2 three 4\n");
  folder.write("line.txt", "1 2 3 4\n1 2 3\n");
  folder.write("long.txt", "1 2 3 4 5\n");
  folder.write("commas.csv", "1,,2,3\n");
  folder.write("infinite.csv", "1,2,inf,3\n");
  folder.write("mass.csv", "1,2,3,-4");
  folder.write("cloud.ply", "1 2 3 4\n");
  const std::string place = "b.toml:1:9: error: ";
  CHECK(of("nan.bin") == place + "`nan.bin`: particle 2 has y = nan m, which must be finite [bad-cloud]");
  CHECK(of("short.bin") == place +
                               "`short.bin`: its 60 bytes are not a multiple of 32: each point has four "
                               "doubles x, y, z and m [bad-cloud]");
  CHECK(of("empty.bin") == place + "`empty.bin`: the file is empty [bad-cloud]");
  CHECK(of("comment.txt") == place + "`comment.txt`: the body has no particles [bad-cloud]");
  CHECK(of("word.txt") == place + "`word.txt`: line 2: `three` is not a finite number [bad-cloud]");
  CHECK(of("line.txt") ==
        place + "`line.txt`: line 2: the line has 3 of the 4 numbers x, y, z and m [bad-cloud]");
  CHECK(of("long.txt") ==
        place + "`long.txt`: line 1: more than the 4 numbers x, y, z and m are on the line [bad-cloud]");
  CHECK(of("commas.csv") ==
        place + "`commas.csv`: line 1: there is no number between two commas [bad-cloud]");
  CHECK(of("infinite.csv") == place + "`infinite.csv`: line 1: `inf` is not a finite number [bad-cloud]");
  CHECK(of("mass.csv") == place +
                              "`mass.csv`: particle 1 has the mass -4 kg, which must be finite and not "
                              "negative [bad-cloud]");
  CHECK(of("cloud.ply") ==
        place + "`cloud.ply`: a cloud's name ends in `.bin`, `.txt` or `.csv` [bad-cloud]");
  CHECK(of("none.bin") == place + "`none.bin`: no such file or directory [bad-cloud]");
  CHECK(of("../none.bin") == place + "`../none.bin` is not in the folder of the body's file [bad-cloud]");
}

TEST_CASE(
    "every body in derivations/bodies is read, has a title, and its analytic moments agree with its "
    "particles") {
  const auto names = body_names({"derivations/bodies"});
  CHECK(names.size() >= 20);
  for (const std::string& name : names) {
    INFO(name);
    const auto path = find_body(name, {"derivations/bodies"});
    REQUIRE(path);
    const auto [body, printed] = read_file_at(*path);
    CHECK(printed.empty());
    REQUIRE(body);
    CHECK(body->name == name);
    CHECK_FALSE(body->title.empty());
    CHECK(check_body(*body));
    const InertiaTensor inertia = *inertia_tensor(*body);
    const bool is_sampled = body->size() > 20;
    if (!body->known || is_sampled) continue;
    CHECK(check_inertia(body->known->inertia));
    const double scale = inertia[0][0] + inertia[1][1] + inertia[2][2];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        CHECK(std::abs(inertia[i][j] - body->known->inertia[i][j]) <= 16 * u * scale);
  }
}

TEST_CASE("the water molecule has the moments of its geometry") {
  const auto [body, printed] = read_file_at("derivations/bodies/water.toml");
  REQUIRE(body);
  const double m = 1.00783;
  const double o = 15.9949;
  const double d = 95.72e-12;
  const double half = 52.26 * std::acos(-1.0) / 180;
  const double about_axis = 2 * m * std::pow(d * std::sin(half), 2);
  const double in_plane = 2 * m * o / (2 * m + o) * std::pow(d * std::cos(half), 2);
  const double u_kg = 1.66053906892e-27;
  const InertiaTensor inertia = *inertia_tensor(*body);
  CHECK(inertia[2][2] == Approx(about_axis * u_kg).epsilon(1e-13));
  CHECK(inertia[0][0] == Approx(in_plane * u_kg).epsilon(1e-13));
  CHECK(inertia[1][1] == Approx((about_axis + in_plane) * u_kg).epsilon(1e-13));
}

TEST_CASE("files that are missing or no text end in a diagnostic") {
  CHECK(read_file_at("derivations/bodies/none.toml").printed ==
        "derivations/bodies/none.toml:1:1: error: no such file or directory [unreadable-file]\n");
  const Folder folder("text");
  folder.write("latin.toml", "shape = \"rod\xe9\"\n");
  CHECK(read_file_at(folder.at("latin.toml")).printed.find("[invalid-utf8]") != std::string::npos);
  folder.write("nul.toml", std::string("a\0b", 3));
  CHECK(read_file_at(folder.at("nul.toml")).printed.find("[nul-byte]") != std::string::npos);
  folder.write("book.toml", "shape = \"box\n");
  CHECK(read_file_at(folder.at("book.toml")).printed.find("[bad-toml]") != std::string::npos);
}

TEST_CASE("a body is found by its name or path, and a slip is answered with the nearest") {
  const std::vector<std::string> folders{"derivations/none", "derivations/bodies", "derivations/none"};
  CHECK(find_body("book", folders) == "derivations/bodies/book.toml");
  CHECK(find_body("derivations/bodies/book.toml", {}) == "derivations/bodies/book.toml");
  CHECK(find_body("rackett", folders).error().reason ==
        "there is no body `rackett` in `derivations/none`, `derivations/bodies`; did you mean `racket`?");
  CHECK(find_body("zebra", {"derivations/bodies"})
            .error()
            .reason.find("; there are asymmetric-rotor, book, box") != std::string::npos);
  CHECK(find_body("./book.toml", folders).error().reason == "there is no file `./book.toml`");
  CHECK_FALSE(find_body("", folders));
}

}  // namespace
}  // namespace rigor
