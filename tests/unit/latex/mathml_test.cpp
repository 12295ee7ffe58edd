// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/mathml.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <variant>

#include "base/splitmix.h"
#include "catch.h"
#include "latex/document/document.h"
#include "latex/macro/macros.h"
#include "latex/written_box.h"

namespace rigor {

TEST_CASE("letters, numbers and scripts become elements of their own") {
  CHECK(mathml_of("A_i^2") == "<msubsup><mi>A</mi><mi>i</mi><mn>2</mn></msubsup>");
  CHECK(mathml_of("x'") ==
        "<msup><mi>x</mi><mo form=\"infix\" stretchy=\"false\" lspace=\"0\" rspace=\"0\">′</mo></msup>");
  CHECK(mathml_of("3.14") == "<mn>3.14</mn>");
}

TEST_CASE("typefaces are mathematical letters") {
  CHECK(mathml_of(R"(\mathbf{A})") == "<mi>𝐀</mi>");
  CHECK(mathml_of(R"(\boldsymbol{\omega})") == "<mi>𝝎</mi>");
  CHECK(mathml_of(R"(\mathbb R)") == "<mi>ℝ</mi>");
  CHECK(mathml_of(R"(\mathcal{L})") == "<mi>ℒ</mi>");
  CHECK(mathml_of(R"(\mathsf{I})") == "<mi>𝖨</mi>");
  CHECK(mathml_of(R"(\mathrm{d})") == "<mi mathvariant=\"normal\">d</mi>");
  CHECK(mathml_of(R"(T_{\mathrm{rot}})") == "<msub><mi>T</mi><mi>rot</mi></msub>");
}

TEST_CASE("an index under a bold letter is not bold") {
  CHECK(mathml_of(R"(\mathbf{r}_\alpha)") == "<msub><mi>𝐫</mi><mi>α</mi></msub>");
  CHECK(mathml_of(R"(\mathbf{r_i})") == "<msub><mi>𝐫</mi><mi>i</mi></msub>");
}

TEST_CASE("fractions, roots and accents hold their arguments") {
  CHECK(mathml_of(R"(\frac{a}{b})") == "<mfrac><mi>a</mi><mi>b</mi></mfrac>");
  CHECK(mathml_of(R"(\frac12)") == "<mfrac><mn>1</mn><mn>2</mn></mfrac>");
  CHECK(mathml_of(R"(\sqrt[3]{x})") == "<mroot><mi>x</mi><mn>3</mn></mroot>");
  CHECK(mathml_of(R"(\ddot x)") == "<mover accent=\"true\"><mi>x</mi><mo stretchy=\"false\">¨</mo></mover>");
}

TEST_CASE("the scripts of a sum stand above and below it, those of an integral beside it") {
  CHECK(mathml_of(R"(\sum_\alpha)") == "<munder><mo>∑</mo><mi>α</mi></munder>");
  CHECK(mathml_of(R"(\int_0^1)") == "<msubsup><mo>∫</mo><mn>0</mn><mn>1</mn></msubsup>");
}

TEST_CASE("a minus sign at the start of a term is a prefix") {
  CHECK(mathml_of("-a").starts_with("<mrow><mo form=\"prefix\""));
  CHECK(mathml_of("b=-a").find("form=\"prefix\"") != std::string::npos);
  CHECK(mathml_of("b-a").find("form=\"prefix\"") == std::string::npos);
}

TEST_CASE("what the notes hold cannot leave its element") {
  CHECK(mathml_of(R"(\text{<script>alert("1")</script>})") ==
        "<mtext>&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;</mtext>");
  CHECK(mathml_of(R"(\foo)") == "<mtext>\\foo</mtext>");
}

TEST_CASE("rows of aligned are rows of a table and keep their tags") {
  const ShownDisplay shown = display_of(R"(a &= b \tag{1} \\ &= c \tag{2'})", "align");
  CHECK(shown.tag.empty());
  REQUIRE(shown.box.kind == BoxKind::table);
  CHECK(shown.box.tags == std::vector<std::string>{"(1)", "(2’)"});
  CHECK(shown.box.row_ends == std::vector<std::size_t>{2, 4});
}

TEST_CASE("a tag of the whole display is handed out beside it") {
  const ShownDisplay shown = display_of(R"(\begin{aligned} a &= b \\ &= c \end{aligned} \tag{6})");
  CHECK(shown.tag == "(6)");
  CHECK(shown.box.kind == BoxKind::table);
}

TEST_CASE("brackets that are opened ten thousand times are shown as they were typed") {
  for (const char* open : {"{", "\\left(", "\\sqrt{", "\\begin{matrix}", "x_{", "\\text{a$"}) {
    std::string deep;
    for (int k = 0; k < 10'000; ++k) deep += open;
    CHECK(is_well_formed(mathml_of(deep)));
    CHECK_FALSE(plain_of(deep).empty());
  }
}

TEST_CASE("any soup of tokens makes well-formed elements") {
  static constexpr std::string_view pieces[] = {"a",
                                                "1",
                                                ".",
                                                "{",
                                                "}",
                                                "^",
                                                "_",
                                                "&",
                                                "\\\\",
                                                "\\frac",
                                                "\\left(",
                                                "\\right)",
                                                "\\left.",
                                                "\\sum",
                                                "\\mathbf",
                                                "'",
                                                "\\begin{aligned}",
                                                "\\end{aligned}",
                                                "\\begin{pmatrix}",
                                                "\\end{pmatrix}",
                                                "\\begin{odd}",
                                                "\\end{odd}",
                                                "\\text{",
                                                "$",
                                                "<",
                                                ">",
                                                "\"",
                                                "&amp;",
                                                "\\tag{<b>}",
                                                "\\sqrt[",
                                                "]",
                                                "[",
                                                "\\over",
                                                "\\not",
                                                "\\dv",
                                                "\\qty(",
                                                "\\SI{1}{",
                                                ")",
                                                "\\underbrace",
                                                "\\limits",
                                                "\\big",
                                                "\\bm",
                                                "\\hspace",
                                                "\\kern-1pt",
                                                "\\x@y",
                                                "#1",
                                                "~",
                                                "%\n",
                                                "ω",
                                                "𝐀",
                                                "\x01",
                                                "\\rm",
                                                "\\xrightarrow[",
                                                "\\overset",
                                                "\\bigl",
                                                "\\mqty",
                                                "\\dd",
                                                "\\operatorname*{",
                                                "\\cancelto",
                                                "|",
                                                "-",
                                                "="};
  SplitMix random(20);
  for (int k = 0; k < 3000; ++k) {
    std::string soup;
    const std::size_t length = random.below(24);
    for (std::size_t i = 0; i < length; ++i) soup += pieces[random.below(std::size(pieces))];
    INFO(soup);
    CHECK(is_well_formed(mathml_of(soup)));
    CHECK(is_well_formed(to_mathml(display_of(soup, k % 2 == 0 ? "align" : "").box, MathStyle::display)));
    CHECK(plain_of(soup).find('\n') == std::string::npos);
  }
}

TEST_CASE("every display of the notes that are here is well-formed and shown without unknown names") {
  std::size_t displays = 0;
  for (const char* folder : {"derivations", "tests/notes/pass", "tests/notes/fail"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".md" && extension != ".tex") continue;
      std::ifstream stream(entry.path());
      std::stringstream text;
      text << stream.rdbuf();
      SourceMap sources;
      Diagnostics diagnostics;
      const FileId file = sources.add(entry.path().string(), text.str());
      MacroTable macros;
      for (const Item& item : read_document(sources, file, diagnostics).items) {
        if (const auto* macro = std::get_if<MacroText>(&item))
          static_cast<void>(expand(lex(sources, macro->span), macros, diagnostics));
        const auto* display = std::get_if<Display>(&item);
        if (display == nullptr) continue;
        const auto tokens = expand(lex(sources, display->body, display->quotes), macros, diagnostics);
        if (!tokens) continue;
        ++displays;
        const ShownDisplay shown = layout_of_display(*tokens, display->environment);
        const std::string mathml = to_mathml(shown.box, MathStyle::display);
        INFO(entry.path().string() + ": " + mathml);
        CHECK(is_well_formed(mathml));
        CHECK_FALSE(to_plain_text(shown.box).empty());
        if (std::string_view(folder) == "derivations") CHECK(mathml.find("<mtext>\\") == std::string::npos);
      }
    }
  }
  CHECK(displays > 300);
}

}  // namespace rigor
