// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/letters.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// One side of a statement, and what its letters are beside what the file shows of them.
struct Side {
  Stretch stretch;
  SyntaxTree tree;
  SyntaxId root;
  Names names;

  explicit Side(const std::string& text) : stretch(text), root(parse_side(stretch.tokens, {}, tree)) {
    sight_sums(tree, root, names.symbols.sightings.write());
    sight_faces(tree, root, names);
    sight_indices(tree, {root}, names);
  }
  [[nodiscard]] Letters letters() const { return read_letters(tree, {root}, names); }
  [[nodiscard]] bool is_index(const std::string& letter) const { return letters().is_index(letter); }
};

/// The base, the axes and the particles of one written symbol: `r_{\text{cm}} [i] [\alpha]`.
std::string apart(const std::string& text, const std::string& summed = "") {
  Side side(text);
  if (!summed.empty()) side.names.symbols.sightings.write().summed_greek.insert(summed);
  const WrittenName name = take_apart(side.tree.symbol(side.root), side.letters(), side.names);
  return name.base + " " + dump_indices(name.axes) + " " + dump_indices(name.particles);
}

WrittenSymbol symbol(const std::string& text) {
  const Side side(text);
  return side.tree.symbol(side.root);
}

}  // namespace

TEST_CASE("the letters i to n are indices, others are not") {
  const Side side("A_i + B_n + C_a + D_p");
  for (const char* letter : {"i", "j", "k", "l", "m", "n"}) CHECK(side.is_index(letter));
  for (const char* letter : {"a", "h", "p", "x", "ij"}) CHECK_FALSE(side.is_index(letter));
}

TEST_CASE("letters on δ, ε, a bracket, a basis vector or under a sum are indices") {
  CHECK(Side("\\delta_{ab}").is_index("a"));
  CHECK(Side("\\epsilon_{pqr}").is_index("q"));
  CHECK(Side("(\\mathbf{A}\\times\\mathbf{B})_p").is_index("p"));
  CHECK_FALSE(Side("\\mathbf{e}_r").is_index("r"));
  CHECK(Side("\\sum_a B").is_index("a"));
  CHECK_FALSE(Side("\\delta_{xy}").is_index("x"));
}

TEST_CASE("a letter on a vector that is known is an index") {
  CHECK(Side("\\mathbf{A}\\cdot\\mathbf{A} - A_a A_a").is_index("a"));
  CHECK_FALSE(Side("\\mathbf{B} - A_a A_a").is_index("a"));
}

TEST_CASE("a letter beside an index on one symbol is an index") {
  CHECK(Side("I_{ia}").is_index("a"));
  CHECK_FALSE(Side("I_{ab}").is_index("a"));
}

TEST_CASE("letters that change places on one symbol are indices") {
  CHECK(Side("Q_{ab} + Q_{ba}").is_index("a"));
  CHECK_FALSE(Side("Q_{ab} + P_{ba}").is_index("a"));
}

TEST_CASE("i beside f on one letter are initial and final, not indices") {
  const Side side("v_f^2 - v_i^2");
  CHECK_FALSE(side.is_index("i"));
  CHECK_FALSE(side.is_index("f"));
  CHECK(Side("v_i - u_f").is_index("i"));
  CHECK(Side("\\delta_{ij} v_i - v_f").is_index("i"));
}

TEST_CASE("n beside a bare n is a number of a state, not an index") {
  CHECK_FALSE(Side("E_n - n^2 E").is_index("n"));
  CHECK(Side("E_n - m^2 E").is_index("n"));
}

TEST_CASE("index notation is evident from δ, a known vector or a repetition") {
  CHECK(Side("\\delta_{ij}").letters().evidence);
  CHECK(Side("A_iB_i").letters().evidence);
  CHECK(Side("\\mathbf{A} + A_i").letters().evidence);
  CHECK_FALSE(Side("A_i").letters().evidence);
  CHECK_FALSE(Side("A_i + B_i").letters().evidence);
}

TEST_CASE("a written symbol falls apart into base, axes and particles") {
  CHECK(apart("A") == "A  ");
  CHECK(apart("A_i") == "A [i] ");
  CHECK(apart("I_{1j}") == "I [1,j] ");
  CHECK(apart("r_{\\alpha i}", "\\alpha") == "r [i] [\\alpha]");
  CHECK(apart("r_{\\alpha i}") == "r_{\\alpha} [i] ");
  CHECK(apart("T_{\\text{rot}}") == "T_{\\text{rot}}  ");
  CHECK(apart("A_x") == "A [x] ");
  CHECK(apart("A_7") == "A_{7}  ");
}

TEST_CASE("face is no part of the base, accents and primes are") {
  CHECK(apart("\\mathbf{A}") == apart("A"));
  CHECK(apart("\\hat{n}") == "\\hat{n}  ");
  CHECK(apart("\\bar{x}") == "\\bar{x}  ");
  CHECK(apart("\\mathbf{r}'_i") == "r' [i] ");
}

TEST_CASE("labels stand in one subscript, words as text") {
  CHECK(with_labels("m", {}) == "m");
  CHECK(with_labels("m", {{"1", IndexForm::digit, 0, {}}, {"2", IndexForm::digit, 0, {}}}) == "m_{12}");
  CHECK(with_labels("T", {{"rot", IndexForm::word, 0, {}}}) == "T_{\\text{rot}}");
  CHECK(with_labels("A", {{"\\perp", IndexForm::word, 0, {}}}) == "A_{\\perp}");
  CHECK(with_labels("A", {{"a", IndexForm::letter, 1, {}}}) == "A_{a'}");
}

TEST_CASE("only plain δ with two indices and ε with three are the built-in symbols") {
  CHECK(is_kronecker(symbol("\\delta_{ij}")));
  CHECK_FALSE(is_kronecker(symbol("\\delta_i")));
  CHECK_FALSE(is_kronecker(symbol("\\boldsymbol{\\delta}_{ij}")));
  CHECK(is_levi_civita(symbol("\\varepsilon_{ijk}")));
  CHECK_FALSE(is_levi_civita(symbol("\\epsilon_{ij}")));
  CHECK_FALSE(is_levi_civita(symbol("\\bar\\epsilon_{ijk}")));
}

TEST_CASE("a bold or hatted e with one index is a basis vector") {
  CHECK(is_basis_family(symbol("\\mathbf{e}_i")));
  CHECK(is_basis_family(symbol("\\hat{e}_x")));
  CHECK_FALSE(is_basis_family(symbol("e_i")));
  CHECK_FALSE(is_basis_family(symbol("\\mathbf{e}")));
  CHECK_FALSE(is_basis_family(symbol("\\mathbf{e}'_i")));
}

TEST_CASE("x, y and z are the axes") {
  CHECK(axis_of_letter("x") == 1);
  CHECK(axis_of_letter("y") == 2);
  CHECK(axis_of_letter("z") == 3);
  CHECK(axis_of_letter("i") == 0);
}

TEST_CASE("a file remembers what was bold, indexed, summed over and crossed") {
  const Side side("\\sum_\\alpha\\mathbf{r}_\\alpha\\times\\mathbf{v}_1 + I_{ij} + \\boldsymbol{\\omega}_i");
  const Sightings& sightings = *side.names.symbols.sightings;
  CHECK(sightings.summed_greek == std::set<std::string>{"\\alpha"});
  CHECK(sightings.bold == std::set<std::pair<std::string, bool>>{{"r", true}, {"v_{1}", false}});
  CHECK(sightings.bold_indexed == std::set<std::string>{"\\omega"});
  CHECK(sightings.crossed == std::set<std::string>{"r", "v"});
  CHECK(sightings.indexed.contains({"I", 2, false}));
}
