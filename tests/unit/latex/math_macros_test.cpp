// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/math_macros.h"

#include "catch.h"

namespace {

using namespace rigor;

std::string definitions(const std::vector<MathMacro>& macros) {
  std::string text;
  for (const MathMacro& macro : macros) text += definition_of(macro) + "\n";
  return text;
}

std::string of_yaml(const std::string& lines) {
  return definitions(macros_of_front_matter("math:\n" + lines));
}
std::string of_script(const std::string& entries) {
  return definitions(macros_of_script("MathJax = { tex: { macros: {" + entries + "} } };"));
}

}  // namespace

TEST_CASE("entries of math are definitions, with as many parameters as they use") {
  CHECK(of_yaml("  '\\vect': '\\mathbf{#1}'\n") == "\\renewcommand{\\vect}[1]{\\mathbf{#1}}\n");
  CHECK(of_yaml("  \"\\\\RR\": \"\\\\mathbb{R}\"  # real\n") == "\\renewcommand{\\RR}{\\mathbb{R}}\n");
  CHECK(of_yaml("  \\half: \\frac{1}{2} # one half\n") == "\\renewcommand{\\half}{\\frac{1}{2}}\n");
  CHECK(of_yaml("  '\\a': ['#1 b', 2]\n") == "\\renewcommand{\\a}[2]{#1 b}\n");
  CHECK(of_yaml("  '\\a':\n    macro: 'it''s'\n    title: t\n") == "\\renewcommand{\\a}{it's}\n");
}

TEST_CASE("what is not plain in math is left out") {
  for (const char* lines :
       {"  '\\a': '{b'\n", "  '\\a': 'b}'\n", "  '\\a': 'b % c'\n", "  '\\a': \"\\mathbf{b}\"\n",
        "  '\\a1': 'b'\n", "  a: 'b'\n", "  '\\a': ['#2', 1]\n", "  '\\a': ['b', x]\n", "  '\\a': |\n",
        "  '\\a': {macro: b}\n", "  '\\a\n", "other:\n  '\\a': 'b'\n"}) {
    INFO(lines);
    CHECK(of_yaml(lines).empty());
  }
  CHECK(definitions(macros_of_front_matter("maths:\n  '\\a': 'b'\n")).empty());
}

TEST_CASE("macros of MathJax and KaTeX are definitions") {
  CHECK(of_script("RR: \"\\\\mathbb{R}\", bm: ['\\\\boldsymbol{#1}', 1]") ==
        "\\renewcommand{\\RR}{\\mathbb{R}}\n\\renewcommand{\\bm}[1]{\\boldsymbol{#1}}\n");
  CHECK(of_script("// c\n \"\\\\e\": \"#1+#2\", /* d */ f: [\"#1#2\", 2, \"x\"],") ==
        "\\renewcommand{\\e}[2]{#1+#2}\n\\renewcommand{\\f}[2][x]{#1#2}\n");
  CHECK(of_script("a: String.raw`\\frac{1}{2}`") == "\\renewcommand{\\a}{\\frac{1}{2}}\n");
  CHECK(definitions(macros_of_script("{\"Macros\": {a: \"b\"}} and macros: {c: 'd'}")) ==
        "\\renewcommand{\\a}{b}\n\\renewcommand{\\c}{d}\n");
}

TEST_CASE("a script that computes its macros ends them") {
  CHECK(of_script("a: \"b\", c: f(), d: \"e\"") == "\\renewcommand{\\a}{b}\n");
  for (const char* entries :
       {"a: \"\\mathbf{b}\"", "a: \"b", "a: [\"b\", n]", "a", "...others", "[a]: 'b'"}) {
    INFO(entries);
    CHECK(of_script(entries).empty());
  }
  CHECK(macros_of_script("const macros = load();").empty());
  CHECK(macros_of_script("macros: {").empty());
}

TEST_CASE("runs of entries that are not closed take no time") {
  std::string yaml = "math:\n";
  for (int k = 0; k < 20'000; ++k) yaml += "  '\\a': '{\n";
  CHECK(macros_of_front_matter(yaml).empty());
  std::string script;
  for (int k = 0; k < 20'000; ++k) script += "macros: {a: '";
  CHECK(macros_of_script(script).empty());
}
