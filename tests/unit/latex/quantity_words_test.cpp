// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/quantity_words.h"

#include <algorithm>

#include "catch.h"
#include "latex/token/vocabulary.h"
#include "latex/unit/quantity_names.h"

using namespace rigor;

namespace {

std::string read(std::string_view text, const std::set<std::string>& shown = {}) {
  return text_of(with_quantity_words(lex_text(text), shown));
}

std::set<std::string> shown_by(std::string_view text) {
  std::set<std::string> shown;
  add_quantity_words(lex_text(text), shown);
  return shown;
}

/// How many letters stand for words.
std::size_t count_in(std::string_view text, const std::set<std::string>& shown = {}) {
  const Tokens tokens = with_quantity_words(lex_text(text), shown);
  return static_cast<std::size_t>(std::ranges::count_if(
      tokens, [](const Token& token) { return letter_of(token).starts_with("\\text{"); }));
}

}  // namespace

TEST_CASE("words beside signs are one letter, whatever they are typed with", "[latex]") {
  CHECK(read(R"(\mathrm{KE} = \operatorname{PE}+{\rm GE})") == R"(\text{KE} = \text{PE}+\text{GE})");
  CHECK(read(R"(\text{K.E.}_f - \mathit{KE}_i)") == R"(\text{KE}_f - \text{KE}_i)");
  CHECK(count_in(R"(\text{density} = \frac{\text{mass}}{\text{Total volume}})") == 3);
  CHECK(count_in(R"(\frac{\text{mass}}{\text{Total volume}} = a)") == 0);
  CHECK(count_in(R"(f = g + \text{friction})") == 0);
  CHECK(count_in(R"(W = -\Delta\dot{\text{KE}})") == 1);
}

TEST_CASE("words of sentences, of properties and of units stay words", "[latex]") {
  for (const char* text :
       {R"(x = 1 \text{ for } y)", R"(pV = \text{const})", R"(pV = \text{fixed} + 1)",
        R"(v = 3\,\text{apples})", R"(a = \frac{\text{miles}}{\text{hour}})", R"(\text{rate of } p = F)",
        R"(\mathrm{erf}(x) = 1)", R"(\mathrm{SO}(3) = G)", R"(\frac{\mathrm{dy}}{\mathrm{dx}} = 1)",
        R"(v = \text{velocity})", R"(v_{\text{max}} + a^{\text{lab}})", R"(a \quad \text{energy})",
        R"(\text{energy})"})
    CHECK(count_in(text) == 0);
}

TEST_CASE("a symbol that a row shows to be a quantity is one next to factors", "[latex]") {
  const auto shown = shown_by(R"(\mathrm{Re} = a, \quad \text{heat} = q)");
  CHECK(shown == std::set<std::string>{R"(\text{Re})", R"(\text{heat})"});
  CHECK(count_in(R"(b = 2\,\mathrm{Re}\,\mathrm{Pe})", shown) == 1);
  CHECK(count_in(R"(b = \mathrm{Re}\,z)", shown) == 0);
  CHECK(count_in(R"(b = \mathrm{Re}(z))", shown) == 0);
  CHECK(count_in(R"(b + c = \text{heat})", shown) == 1);
  CHECK(count_in(R"(b_1 = \text{heat})", shown) == 0);
  CHECK(count_in(R"(b = \mathrm{Re})", shown) == 1);
  CHECK(count_in(R"(b = 2\,\text{heat})", shown) == 0);
  CHECK(count_in(R"(b = c~\mathrm{Re})", shown) == 0);
  CHECK(count_in(R"(\frac{\text{heat}}{2})", shown) == 1);
}

TEST_CASE("a word is a quantity where it is the first side", "[latex]") {
  CHECK(count_in(R"(\text{Total} = a + b)") == 1);
  CHECK(count_in(R"(a + \text{total} = b)") == 0);
  CHECK(count_in(R"(\frac{\text{Total}}{2} = a)", shown_by(R"(\text{Total} = a + b)")) == 1);
}

TEST_CASE("a subscript inside the braces of a word is a label", "[latex]") {
  CHECK(read(R"(\mathrm{PE_{el}} = \mathrm{KE_1})") == R"(\text{PE}_{\mathrm{el}} = \text{KE}_{1})");
}

TEST_CASE("noun phrases can name a quantity", "[latex]") {
  for (const char* name : {"KE", "K.E.", "Total energy", "work done by friction", "Young's modulus", "SNR"})
    CHECK(can_name_quantity(name));
  for (const char* other : {"x", "if", "kg", "sin", "mgh", "dx", "nRT", "constant", "mean of x", "is large",
                            "a sentence of more than five words", "change of", "photons", "pH", "2nd law"})
    CHECK_FALSE(can_name_quantity(other));
  CHECK(is_symbol_of_letters("Re"));
  CHECK_FALSE(is_symbol_of_letters("Work"));
}
