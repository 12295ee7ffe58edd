// SPDX-License-Identifier: GPL-3.0-or-later
// Single statements that `rigor derive` must not answer wrongly, lose or hang on.
#include <string>
#include <vector>

#include "app/derived.h"
#include "catch.h"

namespace rigor {

TEST_CASE("a hole under a derivative says so, and the other holes are answered") {
  for (const std::string statement :
       {R"(\nabla\square = \nabla f)", R"(\nabla\cdot\square = \nabla\cdot\mathbf b)",
        R"(\nabla\times\square = \nabla\times\mathbf b)", R"(\nabla^2(\square) = \nabla^2 f)",
        R"(\partial_i\square = \partial_i f)", R"(\frac{d\square}{dt} = \dot a)",
        R"(\frac{d}{dt}\square = 0)"}) {
    const Derived result = derived({statement});
    INFO(statement << ": " << result.err);
    CHECK(result.code == 2);
    CHECK(result.err.find("it is differentiated") != std::string::npos);
  }
  const HoleFile notes("$$\\nabla\\square = \\nabla f$$\n\n$$(a + b)^2 = \\square$$\n");
  CHECK(derived({notes.path(), "--write"}).out.find("a^2 + 2 a b + b^2") != std::string::npos);
  CHECK(notes.text().find("= a^2 + 2 a b + b^2$$") != std::string::npos);
}

TEST_CASE("what is no equation is not solved for a symbol") {
  const std::vector<std::vector<std::string>> uses{{R"(x\mathbf b = |\mathbf b|)", "x"},
                                                   {R"(\mathbf b + \mathbf c = |\mathbf c|)", R"(\mathbf b)"},
                                                   {R"(\nabla f - \mathbf b = |\mathbf c|)", R"(\mathbf b)"},
                                                   {R"(\mathbf a = |\mathbf b|)", R"(\mathbf a)"}};
  for (const auto& use : uses) {
    const Derived result = derived({use[0], "--solve-for", use[1]});
    INFO(use[0] << ": " << result.out << result.err);
    CHECK(result.code == 1);
    CHECK(result.out.empty());
    CHECK(result.err.find("[rank-mismatch]") != std::string::npos);
  }
}

TEST_CASE("a small factor is not taken for a part of the symbol behind it") {
  const Derived change = derived({R"((1 + \delta x)^3 = \square)", "--first-order", R"(\delta)"});
  CHECK(change.code == 2);
  CHECK(change.out.empty());
  CHECK(change.err.find("is read as one symbol, a change") != std::string::npos);
  CHECK(derived({R"((1 + x\delta)^3 = \square)", "--first-order", R"(\delta)"}).out == "1 + 3 x\\delta\n");
}

TEST_CASE("nothing is said of freedom to first order") {
  const HoleFile notes(
      "<!-- rigor:\nsmall \\boldsymbol\\epsilon\nsmall \\eta\n-->\n"
      "$$(\\mathbf a + \\boldsymbol\\epsilon)\\times\\mathbf b \\approx \\square$$\n\n"
      "$$\\eta\\,\\square \\approx \\eta a$$\n");
  const Derived result = derived({notes.path()});
  INFO(result.out << result.err);
  CHECK(result.code == 0);
  CHECK(result.out.find(": a\n") != std::string::npos);
  CHECK(result.err.empty());
}

TEST_CASE("an answer to first order has no terms of second order") {
  const HoleFile notes(
      "<!-- rigor:\nscalar \\theta\nsmall \\theta\nsmall \\eta\n-->\n"
      "$$(x + \\theta)^2 \\approx \\square$$\n\n$$a + \\eta^2 \\approx \\square$$\n");
  const Derived result = derived({notes.path()});
  INFO(result.out << result.err);
  CHECK(result.code == 0);
  CHECK(result.out == notes.path() + ":6:26: x^2 + 2 x\\theta\n" + notes.path() + ":8:22: a\n");
}

TEST_CASE("what is not linear in the hole below a product or a sum is not refuted") {
  for (const std::string statement :
       {R"(\mathbf a\cdot(\square^2\,\mathbf b) = 4\mathbf a\cdot\mathbf b)",
        R"(\mathbf a\cdot(\frac{1}{\square + 1}\mathbf b) = 4\mathbf a\cdot\mathbf b)",
        R"(\sum_i \square^2\,a_ib_i = 4a_ib_i)", R"(\sqrt\square = a)"}) {
    const Derived result = derived({statement});
    INFO(statement << ": " << result.err);
    CHECK(result.code == 2);
    CHECK(result.err.find("no value fits") == std::string::npos);
  }
  CHECK(derived({R"(\sqrt\square = a)"}).err.find("where the other side is not negative") !=
        std::string::npos);
  CHECK(derived({R"(\sqrt\square = |a|)"}).out == "a^2\n");
  CHECK(derived({R"(\mathbf a\cdot(\square\,\mathbf b) = 4\mathbf a\cdot\mathbf b)"}).out == "4\n");
}

TEST_CASE("a number on the other side is an answer, and what is short enough says so") {
  CHECK(derived({R"(0 = \square)"}).out == "0\n");
  CHECK(derived({R"(\square = 4)"}).out == "4\n");
  const Derived area = derived({R"(\pi r^2 = \square)"});
  CHECK(area.code == 2);
  CHECK(area.err.find("nothing shorter than the other side was found") != std::string::npos);
}

TEST_CASE("what is small on request leaves the lines of the notes their numbers") {
  const HoleFile notes("# T\n\n<!-- rigor: scalr x -->\n\n$$a = b$$\n");
  const Derived wrong =
      derived({R"((1 + \eta)^2 = \square)", "--in", notes.path(), "--first-order", R"(\eta)"});
  INFO(wrong.err);
  CHECK(wrong.err.find(notes.path() + ":3:") != std::string::npos);
}

TEST_CASE("the root of a square number is a number, and that of a negative one is none") {
  CHECK(derived({"x^2 = 4", "--solve-for", "x"}).out == "x = 2\nx = -2\n");
  CHECK(derived({"9 x^2 = 4", "--solve-for", "x"}).out == "x = \\frac{2}{3}\nx = -\\frac{2}{3}\n");
  CHECK(derived({"(x - 1)(x - 3) = 0", "--solve-for", "x"}).out == "x = 3\nx = 1\n");
  CHECK(derived({"x^2 = 2", "--solve-for", "x"}).out == "x = \\sqrt{2}\nx = -\\sqrt{2}\n");
  const Derived negative = derived({"x^2 + 1 = 0", "--solve-for", "x"});
  CHECK(negative.code == 2);
  CHECK(negative.out.empty());
  CHECK(negative.err.find("it would be the root of a negative number") != std::string::npos);
}

}  // namespace rigor
