// SPDX-License-Identifier: GPL-3.0-or-later
// What a decorated letter means: whole, a component, a length, a label.
#include "catch.h"
#include "elaborate/elaborated.h"

using namespace rigor;

TEST_CASE("bold letters and letters under an arrow are vectors, others scalars") {
  CHECK(meaning("\\mathbf{A}") == "\\mathbf{A}");
  CHECK(meaning("\\vec{A}\\cdot\\mathbf{A}") == "(dot \\mathbf{A} \\mathbf{A})");
  CHECK(meaning("\\boldsymbol\\omega") == "\\boldsymbol{\\omega}");
  CHECK(meaning("a x") == "(multiply a x)");
}

TEST_CASE("a plain letter beside its bold form is the length") {
  CHECK(meaning("A\\mathbf{A}") == "(multiply (length \\mathbf{A}) \\mathbf{A})");
  CHECK(meaning("A^2 = \\mathbf{A}\\cdot\\mathbf{A}") ==
        "(power (length \\mathbf{A}) 2) = (dot \\mathbf{A} \\mathbf{A})");
  CHECK(meaning("r'\\mathbf{r}'") == "(multiply (length \\mathbf{r}') \\mathbf{r}')");
  CHECK(meaning("r\\mathbf{r}'") == "(multiply r \\mathbf{r}')");
}

TEST_CASE("the length of a vector is a convention that is noted") {
  Statements statements;
  statements.meaning("A^2 = \\mathbf{A}\\cdot\\mathbf{A}");
  CHECK(statements.conventions == std::vector<std::string>{"`A` is the length of `\\mathbf{A}`"});
  CHECK_FALSE(statements.guess.has_value());
}

TEST_CASE("a letter that is bold elsewhere only is a length by guess") {
  Statements statements;
  statements.beside("\\mathbf{R}");
  CHECK(statements.meaning("R") == "(length \\mathbf{R})");
  REQUIRE(statements.guess.has_value());
  CHECK(statements.guess->kind == DiagnosticKind::ambiguous_reading);
  CHECK(statements.meaning("R_1 + R_2") == "(add \\mathbf{R}[1] \\mathbf{R}[2])");
  CHECK(statements.guess.has_value());
  statements.meaning("R\\mathbf{R}");
  CHECK_FALSE(statements.guess.has_value());
  statements.meaning("R_i R_i = R^2");
  CHECK_FALSE(statements.guess.has_value());
}

TEST_CASE("a declared vector needs no bold letter and no guess") {
  Statements statements;
  statements.declare({"R", 1, false}).beside("\\mathbf{R}");
  CHECK(statements.meaning("R_1 + R_2") == "(add R[1] R[2])");
  CHECK_FALSE(statements.guess.has_value());
}

TEST_CASE("a declared scalar is itself, though the letter is bold elsewhere") {
  Statements statements;
  statements.declare({"R", 0, false}).beside("\\mathbf{R}");
  CHECK(statements.meaning("R") == "R");
  CHECK_FALSE(statements.guess.has_value());
}

TEST_CASE("an index letter on a plain letter makes a component") {
  CHECK(meaning("A_i") == "A[i]");
  CHECK(meaning("I_{ij}") == "I[i,j]");
  CHECK(meaning("T_{ijkl}") == "T[i,j,k,l]");
  CHECK(meaning("T_{ijklm}") == "1 unsupported: ?");
}

TEST_CASE("the length of a vector with components only is a guess") {
  Statements statements;
  CHECK(statements.meaning("A_iA_i = A^2") == "(index-sum i (multiply A[i] A[i])) = (power (length A) 2)");
  CHECK(statements.guess.has_value());
}

TEST_CASE("digits and x, y, z pick a component of a vector that is known, else they are labels") {
  CHECK(meaning("A_1\\mathbf{A}") == "(multiply \\mathbf{A}[1] \\mathbf{A})");
  CHECK(meaning("v_y\\mathbf{v}") == "(multiply \\mathbf{v}[2] \\mathbf{v})");
  CHECK(meaning("m_1 m_2") == "(multiply m_{1} m_{2})");
  CHECK(meaning("v_x + v_y") == "(add v_{x} v_{y})");
  CHECK(meaning("A_{1i}") == "A[1,i]");
}

TEST_CASE("two digits pick a component of a tensor that is known") {
  Statements statements;
  statements.beside("I_{ij}\\omega_j");
  CHECK(statements.meaning("I_{12}") == "I[1,2]");
  CHECK(statements.meaning("I_{xz}") == "I[1,3]");
  CHECK(statements.meaning("I_1") == "I_{1}");
  CHECK(meaning("I_{12}") == "I_{12}");
}

TEST_CASE("a letter without indices, with one and with two are three symbols") {
  Statements statements;
  statements.beside("I_{ij}");
  CHECK(statements.meaning("I") == "I");
  statements.meaning("I_i");
  CHECK(find_symbol(statements.names.symbols, {"I", 0, false}) !=
        find_symbol(statements.names.symbols, {"I", 1, false}));
  CHECK(find_symbol(statements.names.symbols, {"I", 1, false}) !=
        find_symbol(statements.names.symbols, {"I", 2, false}));
}

TEST_CASE("digits on a bold letter are labels of a vector of its own") {
  CHECK(meaning("\\mathbf{F}_1 + \\mathbf{F}_2") == "(add \\mathbf{F}_{1} \\mathbf{F}_{2})");
  CHECK(meaning("\\mathbf{A}_1\\cdot\\mathbf{A}") == "(dot \\mathbf{A}_{1} \\mathbf{A})");
}

TEST_CASE("a digit that can name a component or a length is ambiguous") {
  Statements statements;
  statements.beside("\\mathbf{r}").beside("\\mathbf{r}_1");
  CHECK(statements.meaning("r_1") == "1 ambiguous-reading: ?");
  CHECK(statements.meaning("|\\mathbf{r}_1|") == "(length \\mathbf{r}_{1})");
}

TEST_CASE("an index on a bold letter is read as the component, with a warning") {
  CHECK(meaning("\\mathbf{A}\\cdot\\mathbf{A} = \\mathbf{A}_i A_i") ==
        "29 bold-index: (dot \\mathbf{A} \\mathbf{A}) = (index-sum i (multiply \\mathbf{A}[i] "
        "\\mathbf{A}[i]))");
}

TEST_CASE("an index on a bold letter that is never whole can be a particle") {
  CHECK(meaning("m\\mathbf{A}_i") == "2 ambiguous-reading: ?");
}

TEST_CASE("Greek labels name particles where a sum over them is written") {
  Statements statements;
  statements.beside("\\sum_\\alpha m_\\alpha");
  CHECK(statements.meaning("m_\\alpha\\mathbf{r}_\\alpha") == "(multiply m{\\alpha} \\mathbf{r}{\\alpha})");
  CHECK(statements.meaning("r_{\\alpha i}") == "\\mathbf{r}{\\alpha}[i]");
  CHECK(meaning("\\mathbf{r}_\\alpha") == "\\mathbf{r}_{\\alpha}");
}

TEST_CASE("a symbol with a particle and one without are two symbols") {
  Statements statements;
  statements.beside("\\sum_\\alpha m_\\alpha");
  CHECK(statements.meaning("m + M") == "(add m M)");
  statements.meaning("m_\\alpha");
  CHECK(find_symbol(statements.names.symbols, {"m", 0, false}) !=
        find_symbol(statements.names.symbols, {"m", 0, true}));
}

TEST_CASE("a quantity of two particles is not decided") {
  Statements statements;
  statements.beside("\\sum_\\alpha m_\\alpha").beside("\\sum_\\beta m_\\beta");
  CHECK(statements.meaning("\\mathbf{r}_{\\alpha\\beta}") == "1 unsupported: ?");
}

TEST_CASE("words in a subscript are labels") {
  CHECK(meaning("T_{\\text{rot}} + T_{trans}") == "(add T_{\\text{rot}} T_{\\text{trans}})");
  CHECK(meaning("\\mathbf{F}_{\\text{ext}}") == "\\mathbf{F}_{\\text{ext}}");
}

TEST_CASE("initial and final values and numbers of states are labels") {
  CHECK(meaning("v_f - v_i") == "(add v_{f} (negate v_{i}))");
  CHECK(meaning("E_n = n^2 E") == "E_{n} = (multiply (power n 2) E)");
}

TEST_CASE("letters a to h are labels unless index notation makes them indices") {
  CHECK(meaning("A_aB_a") == "(multiply A_{a} B_{a})");
  CHECK(meaning("\\delta_{ab}A_b") == "(index-sum b (multiply delta[a,b] A[b]))");
}

TEST_CASE("primes on a letter are part of its name, primed axes need a rotation") {
  CHECK(meaning("\\mathbf{r}'\\cdot\\mathbf{r}") == "(dot \\mathbf{r}' \\mathbf{r})");
  CHECK(meaning("A'_i") == "A'[i]");
  CHECK(meaning("A_{i'}") == "1 ambiguous-reading: ?");
}

TEST_CASE("δ and ε take index letters and axes") {
  CHECK(meaning("\\delta_{12}\\varepsilon_{1jk}") == "(multiply delta[1,2] epsilon[1,j,k])");
  CHECK(meaning("\\delta_{i4}") == "1 unsupported: ?");
}

TEST_CASE("δ before a letter is part of its name, and π is the number") {
  CHECK(meaning("\\delta x") == "\\delta x");
  CHECK(meaning("\\Delta x") == "\\Delta x");
  Statements statements;
  CHECK(statements.meaning("\\pi") == "\\pi");
  CHECK(statements.tree.symbols[SymbolId{0}].circle_number);
}

TEST_CASE("hats over x, y, z and a bold e are the basis") {
  CHECK(meaning("\\hat{x}\\times\\hat{y} = \\hat{z}") == "(cross e[1] e[2]) = e[3]");
  CHECK(meaning("\\hat\\imath\\times\\hat\\jmath = \\hat k") == "(cross e[1] e[2]) = e[3]");
  CHECK(meaning("\\mathbf{e}_i\\cdot\\hat{e}_2") == "(dot e[i] e[2])");
  CHECK(meaning("\\hat k") == "\\hat{k}");
}

TEST_CASE("a hat makes a unit vector") {
  Statements statements;
  CHECK(statements.meaning("\\hat{n}\\cdot\\hat{\\mathbf{n}}") == "(dot \\hat{n} \\hat{n})");
  CHECK(statements.tree.symbols[*find_symbol(statements.names.symbols, {"\\hat{n}", 1, false})].unit);
  CHECK(statements.meaning("\\hat{n}_i") == "\\hat{n}[i]");
}

TEST_CASE("bold letters with two indices elsewhere can be a vector or a tensor") {
  Statements statements;
  statements.beside("I_{ij}");
  CHECK(statements.meaning("\\mathbf{I}") == "1 ambiguous-reading: ?");
  CHECK(statements.meaning("\\overleftrightarrow{\\mathbf{I}}") == "I");
  CHECK(statements.meaning("\\mathbf{I}\\times\\mathbf{A}") == "(cross \\mathbf{I} \\mathbf{A})");
  statements.declare({"I", 2, false});
  CHECK(statements.meaning("\\overleftrightarrow{\\mathbf{I}}_{ij}") == "I[i,j]");
}

TEST_CASE("a repeated index on one symbol is summed") {
  CHECK(meaning("I_{ii}") == "(index-sum i I[i,i])");
  CHECK(meaning("\\delta_{ii}") == "(index-sum i delta[i,i])");
  CHECK(meaning("\\epsilon_{iij}") == "(index-sum i epsilon[i,i,j])");
}

TEST_CASE("a reading returns the directives behind what it looked up") {
  Statements file;
  file.declare({"A", 1, false}).declare({"m", 0, false}).particles("n");  // 0, 1 and 2
  CHECK(file.meaning("\\mathbf{A}") != "?");
  CHECK(file.used == Directives{0});
  file.meaning("m x_n");
  CHECK(file.used == Directives{1, 2});
  file.meaning("x + y");
  CHECK(file.used.empty());
}
