// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/family/families.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "catch.h"
#include "numeric/body/shapes.h"
#include "numeric/kernels/principal_moments.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;
constexpr std::size_t samples = 100;

/// Letters of all kinds.
struct Letters {
  ExprTree tree;
  SymbolId a = add({.name = "\\mathbf{A}", .rank = 1});
  SymbolId i1 = add({.name = "I_{1}"});
  SymbolId i2 = add({.name = "I_{2}"});
  SymbolId e = add({.name = "\\mathbf{e}", .rank = 1, .unit = true});
  SymbolId b = add({.name = "\\mathbf{B}", .rank = 1});
  SymbolId m = add({.name = "m", .rank = 0, .per_particle = true});
  SymbolId r = add({.name = "\\mathbf{r}", .rank = 1, .per_particle = true});
  SymbolId tensor = add({.name = "I", .rank = 2, .symmetric = true});
  SymbolId rotation = add({.name = "\\lambda", .rank = 2, .rotation = true});
  SymbolId metre = add({.name = "\\mathrm{m}", .unit_of_measure = Dimension()});
  SymbolId values = add({.name = "I", .rank = 1});

  SymbolId add(Symbol symbol) { return tree.symbols.add(std::move(symbol)); }

  [[nodiscard]] std::vector<SymbolId> all() const {
    return {a, i1, i2, e, b, m, r, tensor, rotation, metre, values};
  }
  [[nodiscard]] Samples draw(const InputFamily& family,
                             const DrawOptions& options = {.samples = samples}) const {
    return *draw_samples(tree, all(), family, options);
  }
};

double at(const Samples& drawn, SymbolId id, std::uint32_t component, std::size_t sample,
          std::size_t particle = 0) {
  const Column* column = drawn.find(id, component);
  REQUIRE(column != nullptr);
  return column->values[sample * column->sample_stride + particle * column->particle_stride];
}

Position vector_at(const Samples& drawn, SymbolId id, std::size_t sample) {
  return {at(drawn, id, 0, sample), at(drawn, id, 1, sample), at(drawn, id, 2, sample)};
}

/// The rows of a tensor; of a symmetric one the canonical components are there only.
InertiaTensor tensor_at(const Samples& drawn, const Letters& letters, SymbolId id, std::size_t sample) {
  InertiaTensor rows{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j)
      rows[i][j] =
          at(drawn, id, static_cast<std::uint32_t>(canonical_component(letters.tree.symbols[id], 3 * i + j)),
             sample);
  }
  return rows;
}

double dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length_of_cross(const Position& a, const Position& b) {
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i)
    square += std::pow(a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3], 2);
  return std::sqrt(square);
}

double sine_of_angle(const Position& a, const Position& b) {
  return length_of_cross(a, b) / std::sqrt(dot(a, a) * dot(b, b));
}

TEST_CASE("in every family unit vectors, rotations and symmetric tensors are what they say") {
  const Letters letters;
  const Body rod = *quadrature_body("rod", {ShapeKind::box, 1, {1, 2, 3}});
  for (const InputFamily& family : input_families()) {
    INFO(name_of(family));
    const Samples drawn = letters.draw(family, {.samples = samples, .body = &rod});
    for (std::size_t s = 0; s < samples; ++s) {
      const Position e = vector_at(drawn, letters.e, s);
      CHECK(std::abs(dot(e, e) - 1) <= 16 * u);
      const InertiaTensor q = tensor_at(drawn, letters, letters.rotation, s);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) CHECK(std::abs(dot(q[i], q[j]) - (i == j ? 1 : 0)) <= 32 * u);
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        CHECK(std::abs(q[0][i] - (q[1][j] * q[2][k] - q[1][k] * q[2][j])) <= 32 * u);
      }
      const InertiaTensor inertia = tensor_at(drawn, letters, letters.tensor, s);
      CHECK(check_inertia(inertia));
      CHECK(principal_moments(inertia)->moments[0] > 0);
      CHECK(at(drawn, letters.metre, 0, s) == 1);
      CHECK(at(drawn, letters.i1, 0, s) > 0);
    }
    CHECK(drawn.find(letters.tensor, 3) == nullptr);  // equal to component 1
  }
}

TEST_CASE("the same seed gives the same values, whatever else is drawn") {
  const Letters letters;
  for (const InputFamily& family : {InputFamily{FamilyKind::random, 0}, InputFamily{FamilyKind::gap, 1e-8}}) {
    const Samples both = letters.draw(family);
    const Samples one = *draw_samples(letters.tree, std::vector{letters.i2}, family, {.samples = samples});
    const Samples other = letters.draw(family, {.samples = samples, .seed = 2});
    CHECK(both.find(letters.i2, 0)->values == one.find(letters.i2, 0)->values);
    CHECK(both.find(letters.i2, 0)->values != other.find(letters.i2, 0)->values);
    CHECK(both.find(letters.a, 0)->values != both.find(letters.b, 0)->values);
  }
}

TEST_CASE("`random` is in its bounds and fills them") {
  const Letters letters;
  const Samples drawn = letters.draw({FamilyKind::random, 0}, {.samples = 2'000});
  const auto scalars = drawn.find(letters.i1, 0)->values;
  const auto components = drawn.find(letters.a, 1)->values;
  const auto [least, most] = std::minmax_element(scalars.begin(), scalars.end());
  CHECK(*least >= 0.125);
  CHECK(*least < 0.13);
  CHECK(*most < 8);
  CHECK(*most > 7.5);
  const auto [left, right] = std::minmax_element(components.begin(), components.end());
  CHECK((*left >= -1 && *left < -0.99));
  CHECK((*right < 1 && *right > 0.99));
}

TEST_CASE("`angle` is the angle between vectors and of rotations, down to rounding") {
  const Letters letters;
  for (const double angle : {1e-4, 1e-8, 1e-15}) {
    const Samples drawn = letters.draw({FamilyKind::angle, angle});
    for (std::size_t s = 0; s < samples; ++s) {
      const Position a = vector_at(drawn, letters.a, s);
      const double rounding = 16 * u;
      CHECK(std::abs(sine_of_angle(a, vector_at(drawn, letters.b, s)) - angle) <= angle * angle + rounding);
      CHECK(std::abs(sine_of_angle(a, vector_at(drawn, letters.e, s)) - angle) <= angle * angle + rounding);
      const InertiaTensor q = tensor_at(drawn, letters, letters.rotation, s);
      const double turned = std::sqrt(std::pow(q[2][1] - q[1][2], 2) + std::pow(q[0][2] - q[2][0], 2) +
                                      std::pow(q[1][0] - q[0][1], 2)) /
                            2;
      CHECK(std::abs(turned - angle) <= angle * angle + rounding);
    }
  }
}

TEST_CASE("`orthogonal` vectors have products that are exactly 0") {
  const Letters letters;
  const Samples drawn = letters.draw({FamilyKind::orthogonal, 0});
  for (std::size_t s = 0; s < samples; ++s) {
    CHECK(dot(vector_at(drawn, letters.a, s), vector_at(drawn, letters.b, s)) == 0);
    CHECK(dot(vector_at(drawn, letters.a, s), vector_at(drawn, letters.a, s)) > 0);
    CHECK(std::abs(dot(vector_at(drawn, letters.a, s), vector_at(drawn, letters.e, s))) <= 4 * u * 128);
  }
}

TEST_CASE("`integers` are whole and not all 0") {
  const Letters letters;
  const Samples drawn = letters.draw({FamilyKind::integers, 0});
  for (std::size_t s = 0; s < samples; ++s) {
    const Position a = vector_at(drawn, letters.a, s);
    for (const double x : a) CHECK(x == std::round(x));
    CHECK(dot(a, a) > 0);
    CHECK(at(drawn, letters.i1, 0, s) == std::round(at(drawn, letters.i1, 0, s)));
  }
}

TEST_CASE("`lengths` makes the first vector long and the others short, but for unit vectors") {
  const Letters letters;
  const Samples plain = letters.draw({FamilyKind::random, 0});
  const Samples drawn = letters.draw({FamilyKind::lengths, 1e160});
  for (std::size_t s = 0; s < samples; ++s) {
    CHECK(at(drawn, letters.a, 0, s) == at(plain, letters.a, 0, s) * 1e160);
    CHECK(at(drawn, letters.b, 0, s) == at(plain, letters.b, 0, s) / 1e160);
    CHECK(at(drawn, letters.r, 0, s) == at(plain, letters.r, 0, s));
  }
}

TEST_CASE("`gap` sets letters with digits, components and eigenvalues a relative distance apart") {
  const Letters letters;
  for (const double gap : {1e-4, 1e-8, 1e-12}) {
    const Samples drawn = letters.draw({FamilyKind::gap, gap});
    for (std::size_t s = 0; s < samples; ++s) {
      const auto apart = [](double low, double high) { return (high - low) / low; };
      CHECK(std::abs(apart(at(drawn, letters.i1, 0, s), at(drawn, letters.i2, 0, s)) - gap) <=
            gap * gap + 4 * u);
      const Position values = vector_at(drawn, letters.values, s);
      CHECK(std::abs(apart(values[0], values[1]) - gap) <= gap * gap + 4 * u);
      const Position moments = principal_moments(tensor_at(drawn, letters, letters.tensor, s))->moments;
      CHECK(std::abs(apart(moments[0], moments[2]) - 2 * gap) <= 4 * gap * gap + 64 * u);
    }
  }
}

TEST_CASE("a body gives its letters, and its thin axis the vectors") {
  const Letters letters;
  const Body rod = *quadrature_body("rod", {ShapeKind::rod, 2, {0, 0, 1}});
  const DrawOptions options{
      .samples = samples, .body = &rod, .letters = {.mass = letters.m, .position = letters.r}};
  const Samples drawn = letters.draw({FamilyKind::thin_axis, 0}, options);
  CHECK(drawn.particles() == 2);
  CHECK(at(drawn, letters.m, 0, 5, 1) == 1);
  CHECK(at(drawn, letters.r, 2, 5, 1) == rod.positions[2][1]);
  for (std::size_t s = 0; s < samples; ++s) {
    const Position a = vector_at(drawn, letters.a, s);
    CHECK((a[0] == 0 && a[1] == 0 && a[2] >= 0.125));
  }
  CHECK(draw_samples(letters.tree, letters.all(), {FamilyKind::thin_axis, 0}, {}).error().reason ==
        "the family `thin axis` needs a body");
}

TEST_CASE("the letters of many particles are the same for all samples") {
  const Letters letters;
  const Samples few = letters.draw({FamilyKind::random, 0}, {.samples = 4, .particles = 10});
  CHECK(few.find(letters.r, 0)->values.size() == 40);
  CHECK(at(few, letters.r, 0, 1, 9) != at(few, letters.r, 0, 2, 9));
  const Samples many = letters.draw({FamilyKind::random, 0}, {.samples = 1'000, .particles = 2'000});
  CHECK(many.find(letters.r, 0)->values.size() == 2'000);
  CHECK(at(many, letters.r, 0, 1, 9) == at(many, letters.r, 0, 2, 9));
}

TEST_CASE("a family applies where there is something that it is about") {
  Letters letters;
  const auto applies_to = [&](FamilyKind kind, const std::vector<SymbolId>& symbols,
                              const Body* body = nullptr) {
    return applies({kind, 1}, letters.tree, symbols, body);
  };
  CHECK(applies_to(FamilyKind::random, {}));
  CHECK(applies_to(FamilyKind::angle, {letters.a, letters.b}));
  CHECK(applies_to(FamilyKind::angle, {letters.rotation}));
  CHECK_FALSE(applies_to(FamilyKind::angle, {letters.a, letters.r}));
  CHECK_FALSE(applies_to(FamilyKind::lengths, {letters.a}));
  CHECK(applies_to(FamilyKind::gap, {letters.i1, letters.i2}));
  CHECK_FALSE(applies_to(FamilyKind::gap, {letters.i1}));
  CHECK_FALSE(applies_to(FamilyKind::gap, {letters.i1, letters.add({.name = "J_{2}"}), letters.a}));
  CHECK_FALSE(applies_to(FamilyKind::thin_axis, {letters.a}));
  const Body rod = *quadrature_body("rod", {ShapeKind::rod, 2, {0, 0, 1}});
  CHECK(applies_to(FamilyKind::thin_axis, {letters.a}, &rod));
}

TEST_CASE("the names of families are all different, and each has a line") {
  std::set<std::string> names;
  for (const InputFamily& family : input_families()) {
    CHECK(names.insert(name_of(family)).second);
    CHECK_FALSE(description_of(family.kind).empty());
  }
}

}  // namespace
}  // namespace rigor
