// SPDX-License-Identifier: GPL-3.0-or-later
// Rewritings take slips of the pen back, on tokens.
#include "latex/reading/rewritings.h"

#include <algorithm>

#include "catch.h"
#include "latex/token/token.h"

using namespace rigor;

namespace {

using Texts = std::vector<std::string>;

/// A side and its tokens, which are views into it.
struct Written {
  explicit Written(const std::string& side) {
    const FileId file = sources.add("side.tex", side);
    tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(side.size())});
  }
  SourceMap sources;
  Tokens tokens;
};

/// The side after each rewriting of one kind.
Texts rewritings(Slip slip, const std::string& side) {
  const Written written(side);
  Texts texts;
  for (const Rewriting& change : rewritings_of(written.tokens, {written.tokens}, true)) {
    if (change.slip == slip) texts.push_back(text_of(rewritten(written.tokens, change)));
  }
  return texts;
}

bool has(const Texts& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

std::string with_times(const std::string& side, std::size_t term, Coefficient times) {
  const Written written(side);
  return text_of(rewritten(written.tokens, with_coefficient(written.tokens, term, times)));
}

std::string with_more(const std::string& side, const std::string& term, Coefficient times) {
  const Written written(side);
  const Written more(term);
  return text_of(rewritten(written.tokens, with_term(written.tokens, more.tokens, times)));
}

Texts images(const std::string& term, const std::string& chain) {
  const Written written(term);
  const Written other(chain);
  Texts texts;
  for (const Tokens& image : images_of_term(written.tokens, {other.tokens})) texts.push_back(text_of(image));
  return texts;
}

}  // namespace

TEST_CASE("signs are turned inside of brackets, too") {
  CHECK(rewritings(Slip::sign, "m(a - b)") == Texts{"-m(a - b)", "m(-a - b)", "m(a + b)"});
}

TEST_CASE("the factors of a cross product change places, and a dot becomes a cross") {
  CHECK(rewritings(Slip::order, "\\mathbf{A}\\times\\mathbf{B}") == Texts{"\\mathbf{B}\\times\\mathbf{A}"});
  CHECK(rewritings(Slip::product, "\\mathbf{A}\\cdot\\mathbf{B}") == Texts{"\\mathbf{A}\\times\\mathbf{B}"});
  CHECK(rewritings(Slip::product, "\\mathbf{A}\\times\\mathbf{B}") == Texts{"\\mathbf{A}\\cdot\\mathbf{B}"});
}

TEST_CASE("indices are exchanged, replaced by those of the chain, and primed") {
  CHECK(rewritings(Slip::indices_swapped, "\\epsilon_{ij}") == Texts{"\\epsilon_{ji}"});
  const Texts replaced = rewritings(Slip::index, "A_iB_j");
  CHECK(has(replaced, "A_jB_j"));
  CHECK(has(replaced, "A_iB_i"));
  CHECK(has(replaced, "A_{i}'B_j") == false);
  CHECK(has(rewritings(Slip::index, "\\lambda_{i'j}"), "\\lambda_{ij}"));
  CHECK(has(rewritings(Slip::index, "\\lambda_{j'i}"), "\\lambda_{ji'}"));
  CHECK(has(rewritings(Slip::index, "\\lambda_{ji'}"), "\\lambda_{j'i}"));
  CHECK(has(rewritings(Slip::index, "\\lambda_{ij}"), "\\lambda_{i'j}"));
}

TEST_CASE("where one axis is named, each can be meant") {
  CHECK(rewritings(Slip::index, "A_1").size() == 3);  // 2, 3, a prime
  CHECK(has(rewritings(Slip::index, "A_x"), "A_z"));
  CHECK_FALSE(has(rewritings(Slip::index, "A_i"), "A_z"));
}

TEST_CASE("words on a subscript are no indices") {
  CHECK(rewritings(Slip::index, "T_{\\text{rot}}").empty());
}

TEST_CASE("powers, bars, dots and primes come and go") {
  CHECK(rewritings(Slip::power, "a^2") == Texts{"a", "a^3"});
  CHECK(rewritings(Slip::power, "a") == Texts{"a^2"});
  CHECK(has(rewritings(Slip::bars, "|a|^2"), "(a)^2"));
  CHECK(has(rewritings(Slip::bars, "(a)^2"), "|a|^2"));
  CHECK(has(rewritings(Slip::rate, "\\dot{\\mathbf{r}}"), "\\mathbf{r}"));
  CHECK(has(rewritings(Slip::rate, "\\mathbf{r}"), "\\dot{\\mathbf{r}}"));
  CHECK(has(rewritings(Slip::prime, "\\mathbf{r}'"), "\\mathbf{r}"));
  CHECK(has(rewritings(Slip::prime, "\\mathbf{r}"), "\\mathbf{r}'"));
}

TEST_CASE("a letter is replaced by others with the same face") {
  const Texts offered = rewritings(Slip::letter, "m\\mathbf{a}\\cdot\\mathbf{b}");
  CHECK(has(offered, "m\\mathbf{b}\\cdot\\mathbf{b}"));
  CHECK(has(offered, "m\\mathbf{a}\\cdot\\mathbf{a}"));
  CHECK_FALSE(has(offered, "\\mathbf{a}\\mathbf{a}\\cdot\\mathbf{b}"));
}

TEST_CASE("a coefficient takes the sign and the number that stand there into account") {
  CHECK(with_times("a - b", 1, {-1, 1}) == "a + b");
  CHECK(with_times("a + b", 0, {-1, 1}) == "-a + b");
  CHECK(with_times("-a", 0, {-1, 1}) == "a");
  CHECK(with_times("2\\cdot a", 0, {1, 2}) == "a");
  CHECK(with_times("\\frac{1}{2}a", 0, {2, 1}) == "a");
  CHECK(with_times("\\frac{1}{2}a", 0, {1, 2}) == "\\frac{1}{4}a");
  CHECK(with_times("a + 3b", 1, {2, 3}) == "a + 2b");
  CHECK(with_times("a + b", 1, {3, 2}) == "a + \\frac{3}{2}b");
  CHECK(with_times("6", 0, {1, 2}) == "3");
  CHECK(with_times("6", 0, {1, 6}) == "1");
  CHECK(with_times("100\\,\\mathrm{mm}", 0, {10, 1}) == "1000\\,\\mathrm{mm}");
}

TEST_CASE("a number with a power or a decimal point is no coefficient") {
  CHECK(with_times("2^n", 0, {2, 1}) == "2\\cdot2^n");
  CHECK(with_times("0.5a", 0, {2, 1}).starts_with("2\\cdot0"));
}

TEST_CASE("a term that is nothing is left out") {
  CHECK(with_times("a + b - c", 1, {0, 1}) == "a - c");
  CHECK(with_times("a + b", 0, {0, 1}) == "b");
  CHECK(with_times("a - b", 0, {0, 1}) == "- b");
  CHECK(with_times("a", 0, {0, 1}) == "0");
}

TEST_CASE("a term more stands at the end, or instead of 0") {
  CHECK(with_more("a", "b", {1, 1}) == "a + b");
  CHECK(with_more("a", "2b", {-1, 1}) == "a - 2b");
  CHECK(with_more("a", "b", {-3, 2}) == "a - \\frac{3}{2}b");
  CHECK(with_more("0", "b", {1, 1}) == "b");
}

TEST_CASE("images of a term have other letters and indices") {
  CHECK(has(images("\\mathbf{B}(\\mathbf{A}\\cdot\\mathbf{C})", ""),
            "\\mathbf{C}(\\mathbf{A}\\cdot\\mathbf{B})"));
  CHECK(has(images("\\delta_{jl}\\delta_{km}", ""), "\\delta_{jm}\\delta_{kl}"));
  CHECK(has(images("I_1\\omega_1^2", ""), "I_2\\omega_2^2"));
  CHECK(has(images("A_yB_z", ""), "A_zB_x"));
  CHECK(has(images("A^2", "A^2 + B^2"), "B^2"));
  CHECK_FALSE(has(images("A^2", "A^2"), "B^2"));
}

TEST_CASE("terms of the chain and images are inserted in brackets") {
  const Written side("\\mathbf{A}\\cdot(\\mathbf{B})");
  const Written other("\\mathbf{A}\\cdot\\mathbf{C}");
  Texts texts;
  for (const Rewriting& change : insertions_of(side.tokens, {side.tokens, other.tokens}))
    texts.push_back(text_of(rewritten(side.tokens, change)));
  CHECK(has(texts, "\\mathbf{A}\\cdot(\\mathbf{B} + \\mathbf{C})"));
  CHECK(has(texts, "\\mathbf{A}\\cdot(\\mathbf{B} - \\mathbf{C})"));
}

TEST_CASE("an empty side has no rewritings, and 0 no terms") {
  CHECK(rewritings_of({}, {}, true).empty());
  const Written zero("0");
  CHECK(terms_of_side(zero.tokens).empty());
}
