// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/held_words.h"

#include "catch.h"

namespace {

std::string held(std::string_view text) {
  const rigor::HeldByWords found = rigor::held_by_words(text);
  std::string all;
  for (const std::size_t each : found.maths) all += std::to_string(each) + " ";
  for (const std::string& each : found.nouns) all += each + " ";
  return all;
}

}  // namespace

TEST_CASE("words before a row hold a letter or what a noun calls", "[held]") {
  CHECK(held("At constant $ we find") == "0 ");
  CHECK(held("With $ we get for fixed $") == "1 ");
  CHECK(held("At constant temperature the gas does the work") == "temperature ");
  CHECK(held("Keeping $ fixed,") == "0 ");
  CHECK(held("with the pressure held constant") == "pressure ");
  CHECK(held("where $ is constant") == "0 ");
  CHECK(held("In an isothermal expansion") == "temperature ");
}

TEST_CASE("what denies, supposes or compares holds nothing", "[held]") {
  CHECK(held("The temperature $ is not constant, so").empty());
  CHECK(held("If $ is constant").empty());
  CHECK(held("Unlike an isothermal expansion").empty());
  CHECK(held("with a constant force").empty());
  CHECK(held("the constant $ is").empty());
}

TEST_CASE("a sentence calls a letter by a noun", "[held]") {
  CHECK(rigor::maths_called("$ is the pressure, $ the absolute temperature", "temperature") == 1);
  CHECK(rigor::maths_called("the temperature $ of the gas", "temperature") == 0);
  CHECK(rigor::maths_called("The temperature is $.", "temperature") == 0);
  CHECK_FALSE(rigor::maths_called("$ is the critical temperature", "temperature"));
  CHECK_FALSE(rigor::maths_called("the temperature grows with $", "temperature"));
}
