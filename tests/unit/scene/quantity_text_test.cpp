// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/quantity_text.h"

#include <numbers>

#include "catch.h"

namespace rigor {
namespace {

std::string reason(std::string_view text) {
  const auto quantity = read_quantity(text);
  return quantity ? "read" : quantity.error().reason;
}

TEST_CASE("a quantity in a power of ten of SI units is rounded once") {
  CHECK(read_quantity("95.72 pm")->value == 95.72e-12);
  CHECK(read_quantity("1e3 g")->value == 1.0);
  CHECK(read_quantity(" -2.5e-3 kg ")->value == -2.5e-3);
  CHECK(read_quantity("0.3 µm")->value == 0.3e-6);
  CHECK(read_quantity("7 g/cm^3")->value == 7000.0);
  CHECK(read_quantity("7 g/cm^3")->dimension == density_dimension());
  CHECK(read_quantity("0e2147483647 km")->value == 0);
  CHECK(read_quantity("3")->dimension.is_none());
}

TEST_CASE("degrees, turns a minute, atomic masses and lengths are read") {
  CHECK(read_quantity("180 deg")->value == std::numbers::pi);
  CHECK(read_quantity("30 rpm")->value == Approx(std::numbers::pi));
  CHECK(read_quantity("30 rpm")->dimension == rate_dimension());
  CHECK(read_quantity("1 u")->dimension == mass_dimension());
  CHECK(read_quantity("0.9572 Å")->value == Approx(0.9572e-10).epsilon(1e-15));
  CHECK(read_quantity("2 min")->value == 120.0);
}

TEST_CASE("what is no finite number with a unit is refused with the reason") {
  CHECK(reason("kg") == "`kg` does not begin with a finite number");
  CHECK(reason("") == "`` does not begin with a finite number");
  CHECK(reason("nan kg") == "`nan kg` does not begin with a finite number");
  CHECK(reason("1e999 kg") == "`1e999 kg` does not begin with a finite number");
  CHECK(reason("1e308 t") == "`1e308 t` does not begin with a finite number");
  CHECK(reason("1-2 kg") == "`1-2 kg` does not begin with a finite number");
  CHECK(reason("1e99999999999999 km") == "`1e99999999999999 km` does not begin with a finite number");
  CHECK(reason("3 furlong") == "the unit of `3 furlong` is not read: `furlong` is not a unit");
}

TEST_CASE("dimensions have names") {
  CHECK(name_of(length_dimension()) == "a length (L)");
  CHECK(name_of(Dimension()) == "a pure number");
  CHECK(name_of(length_dimension() + length_dimension()) == "a quantity of dimension L^2");
}

}  // namespace
}  // namespace rigor
