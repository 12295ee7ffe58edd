// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/directive/directive.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

struct Reading {
  SourceMap sources;
  MacroTable macros;
  SyntaxTree syntax;
  Diagnostics diagnostics;
  std::optional<Directive> directive;

  explicit Reading(const std::string& line) {
    const FileId file = sources.add("notes.md", line);
    directive = read_directive(sources, {file, 0, static_cast<std::uint32_t>(line.size())}, macros, syntax,
                               diagnostics);
  }

  /// The symbols and chains that were read, or the column and kind of what is wrong.
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
      text += std::to_string(diagnostic.span.begin + 1) + " " + std::string(info(diagnostic.kind).name);
    }
    if (!directive) return text.empty() ? "nothing" : text;
    for (const SyntaxId symbol : directive->symbols)
      text += (text.empty() ? "" : " ") + dump_syntax(syntax, symbol);
    for (const ParsedChain& chain : directive->chains)
      text += (text.empty() ? "" : " // ") + dump_chain(chain.written);
    return text;
  }
};

std::string read(const std::string& line) { return Reading(line).text(); }
DirectiveKind kind_of(const std::string& line) { return Reading(line).directive.value().kind; }
std::string help_of(const std::string& line) { return Reading(line).diagnostics.at(0).help.at(0); }

}  // namespace

TEST_CASE("a directive begins with its word") {
  CHECK(kind_of("vector \\mathbf{A}") == DirectiveKind::vector);
  CHECK(kind_of("scalar a") == DirectiveKind::scalar);
  CHECK(kind_of("tensor I") == DirectiveKind::tensor);
  CHECK(kind_of("particles \\alpha") == DirectiveKind::particles);
  CHECK(kind_of("constant m") == DirectiveKind::constant);
  CHECK(kind_of("variable q") == DirectiveKind::variable);
  CHECK(kind_of("rotation R") == DirectiveKind::rotation);
  CHECK(kind_of("basis \\mathbf{e}_{i'}") == DirectiveKind::basis);
  CHECK(kind_of("space plane 2") == DirectiveKind::space);
  CHECK(kind_of("small \\delta_2") == DirectiveKind::small);
  CHECK(kind_of("where a = b") == DirectiveKind::where);
  CHECK(kind_of("let a = b") == DirectiveKind::let);
  CHECK(kind_of("given a = b") == DirectiveKind::given);
  CHECK(kind_of("claim a = b") == DirectiveKind::claim);
  CHECK(kind_of("expect refuted") == DirectiveKind::expect);
  CHECK(kind_of("skip a table") == DirectiveKind::skip);
}

TEST_CASE("declared symbols are separated by commas") {
  CHECK(read("vector \\mathbf{A}, \\vec{B},C") == "vector:A vector:B C");
  CHECK(read("constant m_\\alpha, I_1, T_{\\text{rot}}") == "m[\\alpha] I[1] T[\"rot\"]");
}

TEST_CASE("adjectives stand before the word or behind it in brackets") {
  CHECK(Reading("unit vector \\mathbf{n}").directive->unit);
  CHECK(Reading("symmetric tensor I").directive->symmetric);
  CHECK(Reading("tensor (symmetric) \\mathbf{I}").directive->symmetric);
  CHECK(read("tensor (symmetric) S, T") == "S T");
  CHECK_FALSE(Reading("tensor I").directive->symmetric);
  CHECK(read("symmetric tensor S, T") == "S T");
}

TEST_CASE("equations of a directive are chains") {
  CHECK(read("let \\mathbf{r}' = \\mathbf{R} + \\mathbf{r}") == "\\mathbf{r}' = \\mathbf{R} + \\mathbf{r}");
  CHECK(read("claim a = b = c") == "a = b = c");
  CHECK(read("given a = b, c = d") == "a = b // c = d");
}

TEST_CASE("a comment at the end is no part of the directive") {
  CHECK(read("given a = 0   # centre of mass") == "a = 0");
  CHECK(Reading("given a = 0   # centre of mass").directive->text == "given a = 0");
  CHECK(read("# only a comment") == "nothing");
}

TEST_CASE("a number sign inside a word begins no comment") {
  SourceMap sources;
  const FileId file = sources.add("notes.md", "  a#b # c ");
  CHECK(sources.text(without_comment(sources, {file, 0, 10})) == "a#b");
}

TEST_CASE("an unknown word is reported with the nearest known one") {
  CHECK(read("vectr \\mathbf{A}") == "1 unknown-directive");
  CHECK(help_of("vectr \\mathbf{A}") == "did you mean `vector`?");
  CHECK(help_of("xyzzy a").starts_with("known are vector, scalar"));
}

TEST_CASE("units names a dimension for each symbol") {
  const Reading reading("units m_\\alpha: M, \\mathbf{r}_\\alpha: L, \\boldsymbol{\\omega}: 1/T, F: N, q: 1");
  REQUIRE(reading.directive);
  std::string text;
  for (const Dimension& dimension : reading.directive->dimensions) text += dimension.text() + ";";
  CHECK(text == "M;L;T^{-1};M L T^{-2};1;");
  CHECK(reading.directive->symbols.size() == 5);
  CHECK(read("units m") == "7 bad-directive");
  CHECK(read("units m: X") == "7 bad-directive");
  CHECK(read("units m:") == "7 bad-directive");
}

TEST_CASE("a frame has two names and an angular velocity") {
  const Reading reading("frame rot rotates with \\boldsymbol{\\omega} in in");
  CHECK(reading.directive->kind == DirectiveKind::frame);
  CHECK(reading.directive->rotating == "rot");
  CHECK(reading.directive->fixed == "in");
  CHECK(reading.text() == "vector:\\omega");
  CHECK(read("frame rot rotates with \\omega") == "1 bad-directive");
  CHECK(read("frame rot in in") == "1 bad-directive");
  CHECK(read("frame rot rotates with \\omega in rot") == "1 bad-directive");
  CHECK(read("frame rot rotates with in in") == "1 bad-directive");
}

TEST_CASE("first order is a directive of two words") {
  CHECK(kind_of("first order") == DirectiveKind::first_order);
  CHECK(read("order") == "1 bad-directive");
}

TEST_CASE("what is declared is a symbol") {
  CHECK(read("vector \\mathbf{A} + \\mathbf{B}") == "8 bad-directive");
  CHECK(read("scalar a, 2") == "11 bad-directive");
  CHECK(read("vector") == "1 bad-directive");
  CHECK(read("scalar ,") == "1 bad-directive");
}

TEST_CASE("what is given, claimed or defined is an equation") {
  CHECK(read("given") == "1 bad-directive");
  CHECK(read("given a + b") == "1 bad-directive");
  CHECK(read("claim a = b, c") != "1 bad-directive");
}

TEST_CASE("only a refutation can be expected") {
  CHECK(read("expect proved") == "1 bad-directive");
  CHECK(read("expect") == "1 bad-directive");
}

TEST_CASE("a directive may use the author's macros") {
  SourceMap sources;
  MacroTable macros;
  SyntaxTree syntax;
  Diagnostics diagnostics;
  const std::string text = "\\newcommand{\\v}[1]{\\mathbf{#1}}vector \\v{A}";
  const FileId file = sources.add("notes.md", text);
  const auto line = static_cast<std::uint32_t>(text.find("vector"));
  CHECK(expand(lex(sources, {file, 0, line}), macros, diagnostics).has_value());
  const auto directive = read_directive(sources, {file, line, static_cast<std::uint32_t>(text.size())},
                                        macros, syntax, diagnostics);
  REQUIRE(directive.has_value());
  CHECK(dump_syntax(syntax, directive->symbols.at(0)) == "vector:A");
  CHECK(sources.text(directive->span) == "vector \\v{A}");
}

TEST_CASE("a chain is parsed side by side") {
  Stretch stretch("a + b &= c \\\\ &= \\mathbf{d}");
  SyntaxTree syntax;
  const std::vector<ParsedChain> chains = parse_chains(stretch.tokens, "align", syntax, stretch.diagnostics);
  REQUIRE(chains.size() == 1);
  REQUIRE(chains[0].sides.size() == 3);
  CHECK(dump_syntax(syntax, chains[0].sides[0]) == "(sum +a +b)");
  CHECK(dump_syntax(syntax, chains[0].sides[2]) == "vector:d");
}

TEST_CASE("`allow` and `warn` name warnings, with a reason behind a colon") {
  const auto warnings = [](const std::string& line) {
    const Reading reading(line);
    std::string names;
    for (const DiagnosticKind kind : reading.directive.value().warnings)
      names += (names.empty() ? "" : " ") + std::string(info(kind).name);
    return names;
  };
  CHECK(kind_of("allow bold-index") == DirectiveKind::allow);
  CHECK(kind_of("warn bold-index") == DirectiveKind::warn);
  CHECK(warnings("allow bold-index, idle-sum: as in the book, (7)") == "bold-index idle-sum");
  CHECK(warnings("warn scalar-zero mixed-parity") == "scalar-zero mixed-parity");
  CHECK(Reading("allow here idle-sum").directive.value().here);
  CHECK_FALSE(Reading("allow idle-sum: here").directive.value().here);
  CHECK(read("allow bold-idx") == "7 bad-directive");
  CHECK(help_of("allow bold-indx") == "did you mean `bold-index`?");
  CHECK(read("allow refuted, bold-index") == "7 bad-directive");
  CHECK(read("allow : why") == "1 bad-directive");
  CHECK(read("warn here") == "1 bad-directive");
}

TEST_CASE("only a vector is declared polar or axial") {
  CHECK(Reading("axial vector \\mathbf{B}").directive.value().polar == false);
  CHECK(Reading("vector (polar) \\mathbf{E}").directive.value().polar == true);
  CHECK_FALSE(Reading("vector \\mathbf{E}").directive.value().polar.has_value());
  CHECK(read("axial scalar h") == "1 bad-directive");
}
