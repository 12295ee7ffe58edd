// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <string>

#include "catch.h"
#include "check/constant/constant_letters.h"
#include "check/constant/number_slip.h"
#include "check/constant/physical_constants.h"
#include "latex/unit/units.h"

namespace rigor {
namespace {

constexpr double pi = 3.14159265358979323846;

double constant(std::string_view name) {
  for (const PhysicalConstant& each : physical_constants()) {
    if (each.name == name)
      return std::strtod(std::string(each.digits).c_str(), nullptr) * std::pow(10.0, each.ten);
  }
  FAIL("no constant is called " << name);
  return 0;
}

std::string names_of(std::string_view letter, std::string_view text) {
  std::string names;
  for (const PhysicalConstant* each : constants_of(letter, spoken_words(text)))
    names += (names.empty() ? "" : ", ") + std::string(each->name);
  return names;
}

TEST_CASE("constants that follow from others agree with them") {
  const double c = constant("the speed of light");
  const double h = constant("Planck's constant");
  const double e = constant("the elementary charge");
  const double k = constant("Boltzmann's constant");
  const double m = constant("the mass of the electron");
  const double epsilon = constant("the electric constant");
  const double hbar = h / (2 * pi);
  const double alpha = e * e / (4 * pi * epsilon * hbar * c);
  const auto agrees = [](double value, std::string_view name) {
    INFO(name);
    CHECK(std::abs(value / constant(name) - 1) < 2e-9);
  };
  agrees(hbar, "the reduced Planck constant");
  agrees(k * constant("Avogadro's constant"), "the gas constant");
  agrees(e * constant("Avogadro's constant"), "Faraday's constant");
  agrees(2 * std::pow(pi, 5) * std::pow(k, 4) / (15 * std::pow(h, 3) * c * c),
         "the Stefan-Boltzmann constant");
  agrees(h * c / (k * 4.965114231744276), "Wien's constant");
  agrees(h / (2 * e), "the quantum of magnetic flux");
  agrees(1 / (epsilon * c * c), "the magnetic constant");
  agrees(1 / (4 * pi * epsilon), "Coulomb's constant");
  agrees(1 / (epsilon * c), "the impedance of free space");
  agrees(alpha, "the fine-structure constant");
  agrees(hbar / (m * c * alpha), "Bohr's radius");
  agrees(alpha * alpha * m * c / (2 * h), "Rydberg's constant");
  agrees(constant("Rydberg's constant") / (1 + m / constant("the mass of the proton")),
         "Rydberg's constant of hydrogen");
  agrees(alpha * alpha * m * c * c / 2, "the Rydberg energy");
  agrees(alpha * alpha * m * c * c, "the Hartree energy");
  agrees(e * hbar / (2 * m), "Bohr's magneton");
  agrees(e * hbar / (2 * constant("the mass of the proton")), "the nuclear magneton");
  agrees(alpha * hbar / (m * c), "the classical radius of the electron");
  agrees(h / (m * c), "the Compton wavelength of the electron");
  agrees(8 * pi / 3 * std::pow(alpha * hbar / (m * c), 2), "the cross section of Thomson");
}

TEST_CASE("every constant has a unit that is read, and a name") {
  for (const PhysicalConstant& each : physical_constants()) {
    INFO(each.name);
    CHECK((each.unit.empty() || read_unit(each.unit, UnitNames::units)));
    CHECK_FALSE((each.own.empty() && each.usual.empty() && each.spoken.empty()));
    CHECK((each.spoken.empty() || !each.words.empty()));
  }
}

TEST_CASE("a letter is a constant by its name, or by the words around it") {
  CHECK(names_of("m_{\\text{e}}", "") == "the mass of the electron");
  CHECK(names_of("m_{e}", "") == "the mass of the electron");
  CHECK(names_of("m", "") == "");
  CHECK(names_of("m", "Two electrons collide.") == "the mass of the electron");
  CHECK(names_of("m", "the electron's mass") == "the mass of the electron");
  CHECK(names_of("m", "an energy of ten electron volts") == "");
  CHECK(names_of("m", "electronics") == "");
  CHECK(names_of("m", "a proton and an electron") == "the mass of the electron, the mass of the proton");
  CHECK(names_of("k_{\\text{B}}", "") == "Boltzmann's constant");
  CHECK(names_of("R", "") == "the gas constant");
  CHECK(names_of("R", "one mole of gas") == "the gas constant, the gas constant for one mole");
  CHECK(names_of("x", "an electron") == "");
}

TEST_CASE("a slip of a number is taken back where the side shows it") {
  const auto slip = [](const char* side, const char* digits, double ratio) {
    const WrittenNumber number{digits, 0, ratio};
    const auto found = slip_of(number_in(side, number));
    const auto mended = with_right_number(side, number);
    return found.value_or("no slip") + ": " + mended.value_or("not found");
  };
  CHECK(slip("2.43\\times10^{-11}\\,\\mathrm m", "2.43", 0.1) ==
        "the power of ten is another one: 2.43\\times10^{-12}\\,\\mathrm m");
  CHECK(slip("\\SI{2.43e12}{m}", "2430000000000", 1e-24) ==
        "the exponent has the other sign: \\SI{2.43e-12}{m}");
  CHECK(slip("3.14\\,\\mathrm s", "3.14", 2) == "it differs by a factor of 2: 6.28\\,\\mathrm s");
  CHECK(slip("1.00\\,\\mathrm s", "1.00", 2 * pi) == "it differs by a factor of 2π: 6.28\\,\\mathrm s");
  CHECK(slip("173", "173", 137.0 / 173) == "two digits are exchanged: 137");
  CHECK(slip("1.00\\,\\mathrm s", "1.00", 1.3) == "no slip: 1.30\\,\\mathrm s");
}

}  // namespace
}  // namespace rigor
