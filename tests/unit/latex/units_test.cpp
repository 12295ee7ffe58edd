// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/units.h"

#include "catch.h"

namespace rigor {
namespace {

/// `1000 10^-3 kg m^2`: factor, power of ten, base units; or what is wrong.
std::string unit(std::string_view text, UnitNames names = UnitNames::units) {
  std::string problem;
  const auto read = read_unit(text, names, &problem);
  if (!read) return problem;
  std::string printed = read->factor.text();
  if (read->ten != 0) printed += " 10^" + std::to_string(read->ten);
  for (std::size_t k = 0; k < base_units.size(); ++k) {
    if (read->exponents[k].is_zero()) continue;
    printed += " " + std::string(base_units[k]);
    if (read->exponents[k] != SmallRational(1)) printed += "^" + read->exponents[k].text();
  }
  return printed;
}

TEST_CASE("units are products of powers, however they are written") {
  for (const char* text : {"kg.m^2", "kg m^2", "kg\\,m^{2}", "\\mathrm{kg}\\cdot\\mathrm{m}^2", "kg~m^2",
                           "\\kilo\\gram\\metre\\squared", "\\kilogram\\square\\meter"}) {
    INFO(text);
    const std::string read = unit(text);
    CHECK((read == "1 kg m^2" || read == "1 10^0 kg m^2"));
  }
  for (const char* text : {"m/s^2", "m.s^{-2}", "m s^-2", "\\metre\\per\\second\\squared", "N/kg"}) {
    INFO(text);
    CHECK(unit(text) == "1 m s^-2");
  }
}

TEST_CASE("derived units, multiples and prefixes are exact") {
  CHECK(unit("N") == "1 kg m s^-2");
  CHECK(unit("km") == "1 10^3 m");
  CHECK(unit("g") == "1 10^-3 kg");
  CHECK(unit("km/h") == "1/3600 10^3 m s^-1");
  CHECK(unit("\\milli\\second") == "1 10^-3 s");
  CHECK(unit("min") == "60 s");
  CHECK(unit("k\\Omega") == "1 10^3 kg m^2 s^-3 A^-2");
  CHECK(unit("\\mu s") == "1 10^-6 s");
  CHECK(unit("cm^3") == "1 10^-6 m^3");
  CHECK(unit("J/(kg K)") == "1 m^2 s^-2 K^-1");
  CHECK(unit("1/s") == "1 s^-1");
  CHECK(unit("kg^{1/2}") == "1 kg^1/2");
}

TEST_CASE("units beside those of the SI are exact multiples of these") {
  CHECK(unit("MeV") == "1602176634 10^-22 kg m^2 s^-2");
  CHECK(unit("\\kilo\\electronvolt") == unit("keV"));
  CHECK(unit("atm") == "101325 kg m^-1 s^-2");
  CHECK(unit("mbar") == "1 10^2 kg m^-1 s^-2");
  CHECK(unit("kG") == "1 10^-1 kg s^-2 A^-1");
  CHECK(unit("au") == "149597870700 m");
  CHECK(unit("days") == "86400 s");
  for (const char* text : {"\\AA", "\\mathring{A}", "\\mathring{\\mathrm A}", "\\text{\\AA}"}) {
    INFO(text);
    CHECK(unit(text) == unit("Å"));
  }
  CHECK(unit("kdays") == "`kdays` is not a unit");
  CHECK(unit("eV^3") == "a factor of a unit is too large");
}

TEST_CASE("abbreviations of siunitx are signs as controls") {
  CHECK(unit("\\km\\per\\s") == unit("km/s"));
  CHECK(unit("\\um") == unit("\\micro\\metre"));
  CHECK(unit("\\kohm") == unit("k\\Omega"));
  CHECK(unit("\\m\\tothe{3}") == "1 m^3");
  CHECK(unit("\\percent") == "1 10^-2");
  CHECK(unit("\\angstrom") == unit("\\nano\\metre").substr(0, 2) + "10^-10 m");
  for (const char* text : {"\\d", "\\t", "\\min", "\\kilo\\m", "\\foo"}) {
    INFO(text);
    CHECK(unit(text).find("is not a unit") != std::string::npos);
  }
}

TEST_CASE("M, L and T are dimensions where these are meant, and units elsewhere") {
  CHECK(unit("M L^2 T^{-2}", UnitNames::dimensions) == "1 kg m^2 s^-2");
  CHECK(unit("1/T", UnitNames::dimensions) == "1 s^-1");
  CHECK(unit("kg/m^3", UnitNames::dimensions) == "1 kg m^-3");
  CHECK(unit("1", UnitNames::dimensions) == "1");
  CHECK(unit("T") == "1 kg s^-2 A^-1");
  CHECK(unit("M") == "`M` is not a unit");
}

TEST_CASE("what is no unit is not read") {
  CHECK(unit("") == "a unit is missing");
  CHECK(unit("kk") == "`kk` is not a unit");
  CHECK(unit("kmin") == "`kmin` is not a unit");
  CHECK(unit("\\foo") == "`\\foo` is not a unit");
  CHECK(unit("m^") == "an exponent is missing");
  CHECK(unit("m^{1/0}") == "an exponent is missing");
  CHECK(unit("(m") == "a bracket is not closed");
  CHECK(unit("J/kg K") == "what follows `/` can be read in two ways");
  CHECK(unit("m/s/s") == "what follows `/` can be read in two ways");
  CHECK(unit("km^{1/2}") == "a root of a multiple of a unit is not read");
  CHECK(unit("h^{99}") == "a factor of a unit is too large");
}

TEST_CASE("a roman word behind a number is a unit, if it cannot be a letter") {
  CHECK(is_unit_word("kg", false));
  CHECK(is_unit_word("m", true));
  CHECK_FALSE(is_unit_word("m", false));
  CHECK_FALSE(is_unit_word("d", true));
  CHECK_FALSE(is_unit_word("and", true));
  CHECK_FALSE(is_unit_word("if", true));
}

}  // namespace
}  // namespace rigor
