// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas that a program is made of, checked where they are used. Catch2 2 or 3.
#include <rigor/catch.h>

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_macros.hpp>
#endif

TEST_CASE("the square of a cross product has two terms of opposite sign") {
  CHECK_THAT(rigor::step(R"(|\mathbf{A}\times\mathbf{B}|^2 = A^2B^2 - (\mathbf{A}\cdot\mathbf{B})^2)"),
             rigor::is_proved());
  CHECK_THAT(rigor::step(R"(|\mathbf{A}\times\mathbf{B}|^2 = A^2B^2 + (\mathbf{A}\cdot\mathbf{B})^2)"),
             rigor::is_refuted());
}

TEST_CASE("a spring's energy is constant where its law holds") {
  const char* const law = R"(
% rigor: scalar x, m, k
% rigor: constant m, k
% rigor: given m\ddot{x} = -kx
)";
  CHECK_THAT(rigor::step(R"(\frac{d}{dt}\left(\tfrac12 m\dot{x}^2 + \tfrac12 kx^2\right) = 0)", law),
             rigor::is_proved());
}

TEST_CASE("every step of a page of notes holds") {
  CHECK_THAT(rigor::notes("notes/vectors.md"), rigor::all_hold());
}
