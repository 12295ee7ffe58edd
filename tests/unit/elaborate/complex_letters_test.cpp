// SPDX-License-Identifier: GPL-3.0-or-later
// What shows that `i` is the imaginary unit and that a letter is complex, and what does not.
#include <deque>
#include <string>
#include <vector>

#include "catch.h"
#include "elaborate/evidence/evidence.h"
#include "latex/dump_syntax.h"
#include "latex/parse/parse.h"

namespace {

using namespace rigor;

/// What one equation shows, with words beside it.
Evidence shown(const std::vector<std::string>& sides, const std::string& words = "") {
  std::deque<Stretch> stretches;
  SyntaxTree syntax;
  std::vector<SyntaxId> parsed;
  for (const std::string& side : sides) {
    const Tokens& tokens = stretches.emplace_back(side).tokens;
    parsed.push_back(parse_side(tokens, span_of(tokens), syntax));
  }
  Evidence evidence;
  for (const SyntaxId side : parsed) see_changing(syntax, side, evidence);
  see_complex(syntax, parsed, evidence);
  see_said_complex(words, evidence);
  settle_complex(evidence);
  return evidence;
}

bool shows_unit(const std::vector<std::string>& sides, const std::string& words = "") {
  return shown(sides, words).imaginary_units.contains("i");
}

bool shows_complex(const std::string& letter, const std::vector<std::string>& sides,
                   const std::string& words = "") {
  return shown(sides, words).complex_numbers.contains(letter);
}

}  // namespace

TEST_CASE("an i above an e, beside hbar or in words is the imaginary unit", "[evidence]") {
  CHECK(shows_unit({"a", "e^{i\\omega t}"}));
  CHECK(shows_unit({"a", "\\exp(-i\\theta)"}));
  CHECK(shows_unit({"i\\hbar\\frac{d\\psi}{dt}", "E\\psi"}));
  CHECK(shows_unit({"i^2", "-1"}));
  CHECK(shows_unit({"i", "\\sqrt{-1}"}));
  CHECK(shows_unit({"z", "x + iy"}, "Complex numbers are"));
  CHECK(shows_unit({"a", "b"}, "with $e^{i\\theta}$"));
  CHECK(shows_unit({"z", "i"}, "complex numbers"));
}

TEST_CASE("an i that is an index, a current or a number shows nothing", "[evidence]") {
  CHECK_FALSE(shows_unit({"v", "iR"}));
  CHECK_FALSE(shows_unit({"a", "e^{k_i x}"}));
  CHECK_FALSE(shows_unit({"i", "5"}, "complex numbers"));
  CHECK_FALSE(shows_unit({"v", "L\\frac{di}{dt}"}, "complex impedances are complex numbers"));
  CHECK_FALSE(shown({"u", "e^{i(kja - \\omega t)}"}).imaginary_units.contains("j"));
}

TEST_CASE("what is made of i or beside its own conjugate is complex", "[evidence]") {
  CHECK(shows_complex("z", {"z", "re^{i\\theta}"}));
  CHECK(shows_complex("\\psi", {"\\psi(x, t)", "Ae^{i(kx - \\omega t)}"}));
  CHECK(shows_complex("\\psi", {"\\rho", "\\psi^*\\psi"}));
  CHECK(shows_complex("\\mathbf{E}", {"\\mathbf E", "\\mathbf A e^{-i\\omega t}"}));
  CHECK(shows_complex("A", {"x", "A"}, "with a complex amplitude $A$"));
  CHECK(shows_complex("w", {"z", "w"}, "For the complex numbers $z$ and $w$"));
  CHECK(shows_complex("z_{1}", {"a", "b"}, "where $z_1$ is complex"));
}

TEST_CASE("a modulus, a real part and a mean are no complex numbers", "[evidence]") {
  CHECK_FALSE(shows_complex("x", {"x", "\\operatorname{Re}(Ae^{i\\omega t})"}));
  CHECK_FALSE(shows_complex("P", {"P", "|e^{i\\theta}|^2"}));
  CHECK_FALSE(shows_complex("\\rho", {"\\rho", "\\psi^*\\psi"}));
  CHECK_FALSE(shows_complex("x", {"d", "x\\bar x"}));
  CHECK_FALSE(shows_complex("m", {"E", "\\frac{p^2}{2m^*}"}, "Bloch waves $e^{ikx}$"));
  CHECK_FALSE(shows_complex("\\mathbf{a}", {"\\mathbf a^*\\cdot\\mathbf a", "2\\pi"}));
  CHECK(shows_complex("z", {"d", "z\\bar z"}, "with $e^{i\\theta}$"));
}
