// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor derive` as a whole command.
#include <unistd.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "app/command/run.h"
#include "app/derived.h"
#include "catch.h"

namespace rigor {
namespace {

/// The statement with what `derive` says in the place of its hole, as `check` ends on it.
int code_of_check(const std::string& statement) {
  const HoleFile file("$$" + statement + "$$\n");
  std::ostringstream out;
  std::ostringstream err;
  const std::string path = file.path();
  const char* words[] = {"rigor", "check", path.c_str()};
  return run(3, words, out, err);
}

std::string answer(const std::string& statement) { return derived({statement}).out; }

const std::string rigid_bodies = "derivations/rigid-bodies.md";

}  // namespace

TEST_CASE("the square of a cross product is answered") {
  const Derived result = derived({R"(|\mathbf A\times\mathbf B|^2 = \square)"});
  CHECK(result.code == 0);
  CHECK(result.out == "A^2 B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2\n");
  CHECK(result.err.empty());
}

TEST_CASE("the answer with another sign is refuted") {
  CHECK(code_of_check(R"(|\mathbf A\times\mathbf B|^2 = A^2 B^2 - (\mathbf{A}\cdot\mathbf{B})^2)") == 0);
  CHECK(code_of_check(R"(|\mathbf A\times\mathbf B|^2 = A^2 B^2 + (\mathbf{A}\cdot\mathbf{B})^2)") == 1);
  CHECK(answer(R"(\mathbf{A}\times(\mathbf{B}\times\mathbf{C}) = \square)") ==
        "(\\mathbf{A}\\cdot\\mathbf{C})\\,\\mathbf{B} - (\\mathbf{A}\\cdot\\mathbf{B})\\,\\mathbf{C}\n");
  CHECK(code_of_check(R"(\mathbf{A}\times(\mathbf{B}\times\mathbf{C}) =
    (\mathbf{A}\cdot\mathbf{C})\,\mathbf{B} + (\mathbf{A}\cdot\mathbf{B})\,\mathbf{C})") == 1);
}

TEST_CASE("a name of the notes is the answer where one fits") {
  CHECK(derived({R"(T_{rot} = \tfrac12\,\square\,\omega_i\omega_j)", "--in", rigid_bodies}).out ==
        "I_{ij}\n");
  CHECK(derived({R"(\mathbf L = \square\cdot\boldsymbol\omega)", "--in", rigid_bodies}).out ==
        "\\overleftrightarrow{\\mathbf{I}}\n");
}

TEST_CASE("what is nearly equal is answered with what the notes call small") {
  const Derived result = derived(
      {R"(\ddot\omega_2 \approx \square\,\omega_2)", "--in", rigid_bodies, "--at", "A thrown racket"});
  CHECK(result.code == 0);
  CHECK(result.out.starts_with("-"));
  CHECK(result.out.find("\\Omega_1") != std::string::npos);
}

TEST_CASE("an equality that only moves the other side is answered to first order where something is small") {
  const std::string rate = R"(\ddot\omega_2 = \square\,\omega_2)";
  const Derived nearly = derived({rate, "--in", rigid_bodies, "--at", "A thrown racket"});
  CHECK(nearly.out == "-\\Omega_1^2\n");
  CHECK(nearly.err.find("to first order") != std::string::npos);
  CHECK(
      derived({R"(\omega_2 + \omega_2 = \square\,\omega_2)", "--in", rigid_bodies, "--at", "A thrown racket"})
          .err == "");
  CHECK(answer(R"(F = \square\,a)") == "\\frac{F}{a}\n");
}

TEST_CASE("a hole in a sum, a product or a denominator is solved for") {
  CHECK(answer(R"((a + b)^2 = a^2 + b^2 + 2\square)") == "a b\n");
  CHECK(answer(R"(\frac{a}{\square} = b)") == "\\frac{a}{b}\n");
  CHECK(answer(R"(a^2 - b^2 = (a - b)\square)") == "a + b\n");
  CHECK(answer(R"(A_i (B_jC_j) = \square\, C_j)") == "A_i B_j\n");
}

TEST_CASE("a hole beside a sum over particles is answered") {
  CHECK(
      answer(
          R"(\sum_\alpha m_\alpha\square\,\mathbf r_\alpha\cdot\mathbf r_\alpha = \sum_\alpha m_\alpha r_\alpha^2)") ==
      "1\n");
  CHECK(
      answer(R"(\sum_\alpha m_\alpha(\boldsymbol\omega\times\mathbf r_\alpha)^2 = \square\,\omega_i\omega_j)")
          .find("\\delta_{ij}") != std::string::npos);
  const Derived vector = derived(
      {R"(\sum_\alpha m_\alpha\mathbf r_\alpha\times(\boldsymbol\omega\times\mathbf r_\alpha) = \square)"});
  CHECK(vector.code == 0);
}

TEST_CASE("what is not linear in the hole says so") {
  const Derived power = derived({R"(\square^2 = a^2)"});
  CHECK(power.code == 2);
  CHECK(power.out.empty());
  CHECK(power.err.find("the equation is not linear in it: it is in a power") != std::string::npos);
}

TEST_CASE("a hole with many answers says what is free") {
  const Derived cross = derived({R"(\mathbf A\times\square = \mathbf C)"});
  CHECK(cross.code == 2);
  CHECK(cross.err.find("any multiple of `\\mathbf{A}` can be added") != std::string::npos);
  const Derived dot = derived({R"(\mathbf A\cdot\square = c)"});
  CHECK(dot.code == 2);
  CHECK(dot.err.find("`\\mathbf{A}\\times\\mathbf{w}` with any vector `\\mathbf{w}` can be added") !=
        std::string::npos);
  CHECK(derived({R"((a - a)\square = 0)"}).err.find("every value fits") != std::string::npos);
}

TEST_CASE("a hole that nothing fits says why, and ends with 1") {
  const Derived zero = derived({R"((a - a)\square = 1)"});
  CHECK(zero.code == 1);
  CHECK(zero.err.find("does not depend on it, and does not hold") != std::string::npos);
  const Derived vectors = derived({R"(\mathbf{A} = \square\,\mathbf{B})"});
  CHECK(vectors.code == 1);
  CHECK(vectors.err.find("no value fits: it would have to be") != std::string::npos);
}

TEST_CASE("forms are made on request") {
  CHECK(derived({R"(\mathbf{A}\times\mathbf{B} = \square)", "--form", "components"}).out ==
        "(A_2 B_3 - A_3 B_2, A_3 B_1 - A_1 B_3, A_1 B_2 - A_2 B_1)\n");
  CHECK(derived({R"(a^2 + 2ab + b^2 = \square)", "--form", "factored"}).out == "(a + b)^2\n");
  CHECK(derived({R"((a + b)^3 = \square)", "--form", "expanded"}).out == "a^3 + 3 a^2 b + 3 a b^2 + b^3\n");
  CHECK(
      derived({R"(T_{rot} = \square)", "--in", rigid_bodies, "--in-terms-of", R"(I_{ij}, \boldsymbol\omega)"})
          .out.find("I_{ij}") != std::string::npos);
  CHECK(derived({R"((1+\delta)^3 = \square)", "--first-order", "\\delta"}).out == "1 + 3\\delta\n");
  CHECK(derived({R"(\mathbf r\times\mathbf p = \square)", "--derivative", "t"}).out ==
        "\\dot{\\mathbf{r}}\\times\\mathbf{p} + \\mathbf{r}\\times\\dot{\\mathbf{p}}\n");
}

TEST_CASE("an equation is solved for a symbol") {
  CHECK(derived({"m a = F + k x", "--solve-for", "x"}).out == "x = \\frac{m a - F}{k}\n");
  const Derived both = derived({"a x^2 + 2 b x + c = 0", "--solve-for", "x"});
  CHECK(both.code == 0);
  CHECK(both.out == "x = \\frac{-b + \\sqrt{b^2 - a c}}{a}\nx = \\frac{-b - \\sqrt{b^2 - a c}}{a}\n");
  CHECK(derived({"x^3 + x = a", "--solve-for", "x"}).err.find("power higher than the second") !=
        std::string::npos);
  CHECK(derived({"\\sin x = a", "--solve-for", "x"}).code == 2);
  CHECK(derived({"a = b", "--solve-for", "x"}).code != 0);
}

TEST_CASE("notes are answered in their places, and only where it is asked") {
  const HoleFile notes("$$(a + b)^2 = \\square \\tag{1}$$\n\n$$(a - b)^2 = ? \\tag{2}$$\n");
  const Derived all = derived({notes.path()});
  CHECK(all.code == 0);
  CHECK(all.out == notes.path() + ":1:15: a^2 + 2 a b + b^2\n" + notes.path() + ":3:15: a^2 - 2 a b + b^2\n");
  CHECK(derived({notes.path(), "--at", "(2)"}).out == notes.path() + ":3:15: a^2 - 2 a b + b^2\n");
  const Derived nowhere = derived({notes.path(), "--at", "(3)"});
  CHECK(nowhere.code == 1);
  CHECK(nowhere.err.find("no equation and no section is named `(3)`") != std::string::npos);
}

TEST_CASE("only the characters of holes are replaced, and a second time nothing") {
  const std::string before =
      "\xEF\xBB\xBF# T\r\n\r\n$$(a+b)^2 = \\square$$\r\n\r\n$$2c\\cdot\\Box\\, d = 2c(a + b)d$$";
  const HoleFile notes(before);
  CHECK(derived({notes.path(), "--write"}).code == 0);
  const std::string after = notes.text();
  CHECK(after ==
        "\xEF\xBB\xBF# T\r\n\r\n$$(a+b)^2 = a^2 + 2 a b + b^2$$\r\n\r\n$$2c\\cdot\\left(a + b\\right)\\, d = "
        "2c(a + b)d$$");
  CHECK(derived({notes.path(), "--write"}).code == 0);
  CHECK(notes.text() == after);
}

TEST_CASE("a hole without an answer keeps its characters") {
  const std::string text = "$$\\mathbf{A}\\times\\square = \\mathbf{C}$$\n";
  const HoleFile notes(text);
  CHECK(derived({notes.path(), "--write"}).code == 2);
  CHECK(notes.text() == text);
}

TEST_CASE("nothing is written into a file that is not UTF-8") {
  const std::string text = "$$(a+b)^2 = \\square$$\n\n$$a = \xFF$$\n";
  const HoleFile notes(text);
  CHECK(derived({notes.path(), "--write"}).code == 1);
  CHECK(notes.text() == text);
}

TEST_CASE("a hole of notes in Latin-1 is answered and not written") {
  const std::string text = "Carr\xE9s:\n\n$$(a+b)^2 = a^2 + b^2 + \\square$$\n";
  const HoleFile notes(text);
  const Derived answer = derived({notes.path()});
  CHECK(answer.code == 0);
  CHECK(answer.out.find("2 a b") != std::string::npos);
  CHECK(derived({notes.path(), "--write"}).code == 1);
  CHECK(notes.text() == text);
}

TEST_CASE("a hole that comes out of a macro is reported and not written") {
  const std::string text = "\\newcommand{\\gap}{\\square}\n$$(a+b)^2 = \\gap$$\n";
  const HoleFile notes(text, ".tex");
  const Derived result = derived({notes.path(), "--write"});
  CHECK(result.code == 2);
  CHECK(result.err.find("it comes from a macro") != std::string::npos);
  CHECK(notes.text() == text);
}

TEST_CASE("a hole in the argument of a macro is written") {
  const HoleFile notes("\\newcommand{\\sq}[1]{(#1)}\n$$(a+b)^2 = a^2 + b^2 + \\sq{\\square}$$\n", ".tex");
  CHECK(derived({notes.path(), "--write"}).code == 0);
  CHECK(notes.text() == "\\newcommand{\\sq}[1]{(#1)}\n$$(a+b)^2 = a^2 + b^2 + \\sq{2 a b}$$\n");
}

TEST_CASE("a folder that cannot be written leaves the notes as they are") {
  if (::geteuid() == 0) return;  // who may write anywhere
  const HoleFile notes("$$(a+b)^2 = \\square$$\n");
  std::filesystem::permissions(notes.path(), std::filesystem::perms::owner_read);
  CHECK(derived({notes.path(), "--write"}).code == 66);
}

TEST_CASE("odd holes end in words, not in a crash") {
  const std::vector<std::string> statements{
      R"(\square^\square)",
      R"(\frac{\square}{\square} = 1)",
      R"(A_\square = 2)",
      R"(\text{\square} = a)",
      R"(\square = \square)",
      R"(\square)",
      R"(= \square)",
      R"(a = ??)",
      R"(\dot\square = a)",
      R"(\square! = 2)",
      R"(a^\square = a)",
      R"(\square < 2)",
      R"(\square \in A)",
      R"(\sqrt{\square} = -1)",
      R"(\hat\square = a)",
      R"(\square' = a)",
      R"(\sum_\square a = b)",
      R"(\square_{ijklm} = a)",
      R"(\mathbf\square = \mathbf A)",
      std::string(10'000, '(') + R"(\square)" + std::string(10'000, ')') + " = a"};
  for (const std::string& statement : statements) {
    const Derived result = derived({statement});
    INFO(statement.substr(0, 60) << ": " << result.err);
    CHECK((result.code == 0 || result.code == 1 || result.code == 2));
    CHECK((!result.out.empty() || !result.err.empty()));
    CHECK(result.err.find("internal error") == std::string::npos);
  }
}

TEST_CASE("the same bytes come twice") {
  const std::vector<std::string> words{R"((a + b + c)^2 - (a - b)^2 = \square)", "--form", "factored"};
  CHECK(derived(words).out == derived(words).out);
}

TEST_CASE("a wrong use of derive ends with 64") {
  const std::vector<std::vector<std::string>> uses{
      {},
      {R"(a = \square)", "--write"},
      {R"(a = \square)", "--at", "(1)"},
      {R"(a = \square)", "--form", "short"},
      {R"(a = \square)", "--format", "html"},
      {R"(a = \square)", "--form", "factored", "--solve-for", "a"},
      {rigid_bodies, "--in", rigid_bodies},
      {rigid_bodies, "--solve-for", "x"},
      {rigid_bodies, "--derivative", "t"}};
  for (const auto& words : uses) {
    const Derived result = derived(words);
    CHECK(result.code == 64);
    CHECK(result.out.empty());
    CHECK(result.err.find("Try `rigor derive --help`.") != std::string::npos);
  }
}

TEST_CASE("notes that are missing end with 66") {
  CHECK(derived({"no/such/notes.md"}).code == 66);
  CHECK(derived({R"(a = \square)", "--in", "no/such/notes.md"}).code == 66);
  CHECK(derived({R"(a = \square)", "--sidecar", "no/such.rigor"}).code == 66);
}

TEST_CASE("a statement without a hole, and notes without one, are told so") {
  const Derived statement = derived({"a = b"});
  CHECK(statement.code == 1);
  CHECK(statement.err.find("the statement has no hole") != std::string::npos);
  const HoleFile notes("$$a = b$$\n");
  CHECK(derived({notes.path()}).code == 0);
  const HoleFile empty("");
  CHECK(derived({empty.path()}).code == 0);
}

}  // namespace rigor
