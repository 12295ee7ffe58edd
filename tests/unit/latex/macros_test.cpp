// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macros.h"

#include <string>

#include "catch.h"
#include "latex/token/tokens.h"

namespace {

using namespace rigor;

/// Expands texts one after the other with one table; what the last one gives is kept.
struct Expansion {
  SourceMap sources;
  MacroTable macros;
  Diagnostics diagnostics;
  std::optional<Tokens> tokens;

  Expansion& run(std::string text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    const FileId file = sources.add("notes.tex", std::move(text));
    tokens = expand(lex(sources, {file, 0, size}), macros, diagnostics);
    return *this;
  }

  [[nodiscard]] std::string text() const { return tokens ? text_of(*tokens) : "(nothing)"; }
  [[nodiscard]] std::string message() const { return diagnostics.empty() ? "" : diagnostics.back().message; }
  /// What stands in the source where the token was written.
  [[nodiscard]] std::string place(std::size_t token) const {
    return std::string(sources.text(tokens->at(token).span));
  }
};

std::string expanded(std::string text) {
  Expansion expansion;
  expansion.run(std::move(text));
  return expansion.message().empty() ? expansion.text() : expansion.message();
}

}  // namespace

TEST_CASE("text without macros stays as it is") {
  CHECK(expanded("\\frac{a}{b} + \\mathbf c") == "\\frac{a}{b} + \\mathbf c");
}

TEST_CASE("every command that defines a macro does") {
  CHECK(expanded("\\newcommand{\\v}[1]{\\mathbf{#1}}\\v{a}") == "\\mathbf{a}");
  CHECK(expanded("\\newcommand*\\v[1]{\\mathbf{#1}}\\v a") == "\\mathbf{a}");
  CHECK(expanded("\\DeclareRobustCommand{\\v}{x}\\v") == "x");
  CHECK(expanded("\\def\\v#1#2{#2#1}\\v ab") == "ba");
  CHECK(expanded("\\NewDocumentCommand{\\v}{O{2} m}{#2^#1}\\v{a}\\v[3]{b}") == "a^2b^3");
  CHECK(expanded("\\DeclareMathOperator{\\tr}{tr}\\tr A") == "\\operatorname{tr}A");
  CHECK(expanded("\\DeclareMathOperator*{\\best}{best}\\best") == "\\operatorname*{best}");
  CHECK(expanded("\\newcommand\\x a\\x") == "a");
}

TEST_CASE("an optional first argument has its default") {
  const std::string power = "\\newcommand{\\power}[2][2]{{#2}^{#1}}";
  CHECK(expanded(power + "\\power{x}") == "{x}^{2}");
  CHECK(expanded(power + "\\power [4] {x}") == "{x}^{4}");
}

TEST_CASE("an argument is a group or one token, spaces skipped") {
  CHECK(expanded("\\def\\v#1#2{(#1,#2)}\\v  {ab} c") == "(ab,c)");
  CHECK(expanded("\\def\\v#1{(#1)}\\v\\alpha") == "(\\alpha)");
}

TEST_CASE("\\providecommand keeps an older definition, \\newcommand replaces it") {
  CHECK(expanded("\\newcommand{\\v}{a}\\providecommand{\\v}{b}\\v") == "a");
  CHECK(expanded("\\providecommand{\\v}{b}\\v") == "b");
  CHECK(expanded("\\newcommand{\\v}{a}\\newcommand{\\v}{b}\\v") == "b");
}

TEST_CASE("a definition lives on behind the text that made it") {
  Expansion expansion;
  expansion.run("\\newcommand{\\w}{\\mathbf{w}}");
  CHECK(expansion.text().empty());
  CHECK(expansion.run("\\w").text() == "\\mathbf{w}");
  CHECK(expansion.run("\\renewcommand{\\w}{u}").run("\\w").text() == "u");
}

TEST_CASE("\\let keeps the meaning of now") {
  CHECK(expanded("\\def\\a{1}\\let\\b=\\a\\def\\a{2}\\b\\a") == "12");
  CHECK(expanded("\\let\\eps\\varepsilon\\eps_i") == "\\varepsilon_i");
  CHECK(expanded("\\let\\old\\vec\\renewcommand{\\vec}[1]{\\old{\\mathbf{#1}}}\\vec{a}") ==
        "\\vec{\\mathbf{a}}");
  CHECK(expanded("\\let\\nc\\newcommand\\nc{\\v}{x}\\v") == "x");
}

TEST_CASE("a delimiter pair grows with its argument, whatever its size command") {
  const std::string abs = "\\DeclarePairedDelimiter{\\abs}{\\lvert}{\\rvert}";
  CHECK(expanded(abs + "\\abs{x}") == "\\left\\lvert x\\right\\rvert");
  CHECK(expanded(abs + "\\abs*{x}") == "\\left\\lvert x\\right\\rvert");
  CHECK(expanded(abs + "\\abs[\\Big]{x}") == "\\left\\lvert x\\right\\rvert");
  CHECK(expanded("\\DeclarePairedDelimiterX{\\inner}[2]{\\langle}{\\rangle}{#1,#2}\\inner{a}{b}") ==
        "\\left\\langle a,b\\right\\rangle");
}

TEST_CASE("a definition inside a body doubles its marks") {
  CHECK(expanded("\\def\\make#1{\\def\\v##1{#1##1}}\\make{a}\\v b") == "ab");
}

TEST_CASE("a macro without braces stays one argument") {
  const std::string letters = "\\def\\a{x+y}\\def\\b{\\boldsymbol{\\omega}}\\def\\c{z}";
  CHECK(expanded(letters + "\\frac\\a\\b") == "\\frac{x+y}{\\boldsymbol{\\omega}}");
  CHECK(expanded(letters + "\\dot\\b") == "\\dot{\\boldsymbol{\\omega}}");
  CHECK(expanded(letters + "\\sqrt[3]\\a \\a") == "\\sqrt[3]{x+y}x+y");
  CHECK(expanded(letters + "\\frac{\\a}\\a\\a") == "\\frac{x+y}{x+y}x+y");
  CHECK(expanded(letters + "\\frac12\\a") == "\\frac12x+y");
  CHECK(expanded(letters + "\\dot\\c") == "\\dot z");
  CHECK(expanded(letters + "x^\\a") == "x^x+y");  // as TeX does
}

TEST_CASE("a macro that calls itself ends in a diagnostic") {
  for (const char* text : {"\\def\\a{\\a}\\a", "\\def\\a{x\\a y}\\a", "\\def\\a{\\b}\\def\\b{\\a\\a}\\a",
                           "\\newcommand{\\vec}[1]{\\vec{#1}}\\vec a", "\\def\\a#1{\\a{#1#1}}\\a x"}) {
    Expansion expansion;
    expansion.run(text);
    CHECK_FALSE(expansion.tokens.has_value());
    REQUIRE(expansion.diagnostics.size() == 1);
    CHECK(expansion.diagnostics[0].kind == DiagnosticKind::macro_recursion);
  }
}

TEST_CASE("a macro that grows without end is stopped") {
  std::string text = "\\def\\a{xx}";
  for (char c = 'b'; c <= 'z'; ++c) {
    text +=
        std::string("\\def\\") + c + "{\\" + static_cast<char>(c - 1) + "\\" + static_cast<char>(c - 1) + "}";
  }
  Expansion expansion;
  CHECK_FALSE(expansion.run(text + "\\z").tokens.has_value());
  CHECK(expansion.diagnostics.back().kind == DiagnosticKind::macro_recursion);
  text = "\\def\\d#1{#1#1#1#1#1#1#1#1#1#1}\\d{\\d{\\d{\\d{\\d{\\d{x}}}}}}";
  CHECK_FALSE(expansion.run(text).tokens.has_value());
}

TEST_CASE("a body's tokens stand at the call, an argument's where it was written") {
  Expansion expansion;
  expansion.run("\\newcommand{\\v}[1]{\\mathbf{#1}}");
  expansion.run("x\\v{ab}");  // x \mathbf { a b }
  REQUIRE(expansion.tokens->size() == 6);
  CHECK(expansion.place(0) == "x");
  CHECK(expansion.place(1) == "\\v{ab}");
  CHECK(expansion.place(3) == "a");
  CHECK(expansion.place(4) == "b");
  CHECK(expansion.place(5) == "\\v{ab}");
}

TEST_CASE("nested bodies stand at the outermost call, arguments keep their place through every depth") {
  Expansion expansion;
  expansion.run("\\newcommand{\\v}[1]{\\mathbf{#1}}\\newcommand{\\cr}[2]{\\v{#1}\\times\\v{#2}}");
  expansion.run("\\cr{a}{b}");  // \mathbf { a } \times \mathbf { b }
  REQUIRE(expansion.tokens->size() == 9);
  CHECK(expansion.place(0) == "\\cr{a}{b}");
  CHECK(expansion.place(2) == "a");
  CHECK(expansion.place(4) == "\\cr{a}{b}");
  CHECK(expansion.place(7) == "b");
  expansion.run("\\cr{\\v c}{d}");  // the author wrote the call of \v inside
  CHECK(expansion.place(2) == "\\v c");
}

TEST_CASE("a default value stands at the call") {
  Expansion expansion;
  expansion.run("\\newcommand{\\power}[2][2]{#2^#1}\\power x");
  CHECK(expansion.place(2) == "\\power x");
}

TEST_CASE("a call without its arguments is reported at the call") {
  Expansion expansion;
  expansion.run("\\def\\v#1#2{#1#2} x + {\\v a}");
  CHECK_FALSE(expansion.tokens.has_value());
  REQUIRE(expansion.diagnostics.size() == 1);
  CHECK(expansion.diagnostics[0].kind == DiagnosticKind::bad_macro);
  CHECK(expansion.sources.text(expansion.diagnostics[0].span) == "\\v");
  CHECK(expansion.message() == "`\\v` takes 2 arguments, and has 1 here");
  CHECK(expanded("\\def\\v#1{#1}\\v") == "`\\v` takes 1 argument, and has 0 here");
  CHECK(expanded("\\def\\v#1{#1}\\v {a") == "`\\v` takes 1 argument, and has 0 here");
}

TEST_CASE("a definition that cannot be read is said to be so") {
  CHECK(expanded("\\def\\v#1.{#1}") == "`\\v` is defined with delimited parameters, which are not read");
  CHECK(expanded("\\newcommand{\\v}[x]{a}") ==
        "`\\v` is defined with `[x]`, which is not a number of arguments");
  CHECK(expanded("\\newcommand{\\v}[1]{#2}") == "`\\v` uses `#2` and has 1 parameter");
  CHECK(expanded("\\newcommand{\\v}") == "`\\v` is not closed or has no body");
  CHECK(expanded("\\newcommand v{a}") == "`\\newcommand` is not followed by the name of a macro");
  CHECK(expanded("\\NewDocumentCommand{\\v}{e m}{#2}") ==
        "`\\v` has an argument of type `e`, which is not read");
}

TEST_CASE("a macro whose definition was not read is not called, whatever it meant before") {
  Expansion expansion;
  expansion.run("\\def\\v#1{#1}\\def\\v#1.{#1}");
  CHECK(expansion.run("\\v a.").message() == "`\\v` has a definition that is not read");
  CHECK_FALSE(expansion.tokens.has_value());
}

TEST_CASE("no tokens disturb the expansion") {
  const std::string_view pieces[] = {"\\def", "\\let",  "\\newcommand",
                                     "\\a",   "\\b",    "{",
                                     "}",     "[",      "]",
                                     "#1",    "#",      "#2",
                                     " ",     "=",      "*",
                                     "x",     "1",      "2",
                                     "\n\n",  "\\frac", "\\DeclarePairedDelimiter"};
  std::uint32_t state = 7;
  for (int round = 0; round < 2000; ++round) {
    Expansion expansion;
    std::string text = "\\def\\a#1{x#1}\\def\\b{\\a}";
    for (int i = 0; i < 40; ++i) {
      state = state * 1664525U + 1013904223U;
      text += pieces[(state >> 16U) % std::size(pieces)];
    }
    expansion.run(text);
    CHECK((expansion.tokens.has_value() || !expansion.diagnostics.empty()));
  }
}
