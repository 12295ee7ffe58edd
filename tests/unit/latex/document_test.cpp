// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "catch.h"
#include "latex/token.h"

namespace {

using namespace rigor;

struct Notes {
  SourceMap sources;
  Diagnostics diagnostics;
  Document document;

  Notes(std::string path, std::string text) {
    const FileId file = sources.add(std::move(path), std::move(text));
    document = read_document(sources, file, diagnostics);
  }

  /// One item a line: `h1 Title`, `directive …`, `macro …`, `display <environment> …` with the body's blanks
  /// trimmed.
  [[nodiscard]] std::string dump() const {
    std::string result;
    for (const Item& item : document.items)
      result += std::visit([&](const auto& it) { return line(it); }, item);
    return result;
  }

  /// One diagnostic a line: the line, the text at the place, the message.
  [[nodiscard]] std::string complaints() const {
    std::string result;
    for (const Diagnostic& diagnostic : diagnostics) {
      const auto place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
      result +=
          std::to_string(place.line) + ":" + std::to_string(place.column) + " " + diagnostic.message + "\n";
    }
    return result;
  }

 private:
  [[nodiscard]] std::string line(const Heading& heading) const {
    return "h" + std::to_string(heading.level) + " " + heading.title + "\n";
  }
  [[nodiscard]] std::string line(const DirectiveLine& directive) const {
    return "directive " + std::string(sources.text(directive.span)) + "\n";
  }
  [[nodiscard]] std::string line(const MacroText& macro) const {
    return "macro " + std::string(sources.text(macro.span)) + "\n";
  }
  [[nodiscard]] std::string line(const Display& display) const {
    std::string body(sources.text(display.body));
    while (!body.empty() && (body.front() == ' ' || body.front() == '\n')) body.erase(0, 1);
    while (!body.empty() && (body.back() == ' ' || body.back() == '\n')) body.pop_back();
    return "display <" + display.environment + "> " + body + "\n";
  }
};

std::string latex(std::string text) { return Notes("notes.tex", std::move(text)).dump(); }
std::string markdown(std::string text) { return Notes("notes.md", std::move(text)).dump(); }
std::string latex_complaints(std::string text) { return Notes("notes.tex", std::move(text)).complaints(); }
std::string markdown_complaints(std::string text) { return Notes("notes.md", std::move(text)).complaints(); }

/// A folder of its own that goes with the test.
struct Folder {
  std::filesystem::path path;

  explicit Folder(const std::string& name)
      : path(std::filesystem::temp_directory_path() / (name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path / "notes");
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path / name).parent_path());
    std::ofstream(path / name) << text;
  }
  [[nodiscard]] Notes read(const std::string& text) const {
    return {(path / "notes/top.tex").string(), text};
  }
};

}  // namespace

TEST_CASE("the name of a file says its format") {
  CHECK(format_of("a/b.tex") == Format::latex);
  CHECK(format_of("b.sty") == Format::latex);
  CHECK(format_of("tex.md") == Format::markdown);
  CHECK(format_of("notes") == Format::markdown);
}

TEST_CASE("LaTeX: every delimiter of a display is read") {
  CHECK(latex("a $$x$$ b \\[y\\] c") == "display <> x\ndisplay <> y\n");
  for (const char* name :
       {"equation", "align*", "flalign", "gather", "multline*", "eqnarray", "displaymath", "dmath"}) {
    const std::string text = std::string("\\begin{") + name + "}x &= y \\\\[2pt] z\\end{" + name + "}";
    CHECK(latex(text) == std::string("display <") + name + "> x &= y \\\\[2pt] z\n");
  }
  CHECK(latex("\\begin{subequations}\\begin{align}x\\end{align}\\end{subequations}") ==
        "display <align> x\n");
}

TEST_CASE("LaTeX: an argument of the environment is not part of the body") {
  CHECK(latex("\\begin{alignat}{2}x\\end{alignat}") == "display <alignat> x\n");
  CHECK(latex("\\begin{IEEEeqnarray*}{rCl}x\\end{IEEEeqnarray*}") == "display <IEEEeqnarray*> x\n");
  CHECK(latex("\\begin{empheq}[box=\\fbox]{align*}x\\end{empheq}") == "display <align*> x\n");
}

TEST_CASE("LaTeX: environments inside a display belong to its body") {
  CHECK(latex("\\[\\begin{aligned}a\\end{aligned}\\]") == "display <> \\begin{aligned}a\\end{aligned}\n");
  CHECK(latex("$$\\begin{align}a\\end{align}$$") == "display <> \\begin{align}a\\end{align}\n");
}

TEST_CASE("LaTeX: what is escaped, verbatim, commented out or inline is no display") {
  for (const char* text :
       {"\\$\\$x\\$\\$", "a \\\\[2pt] b", "% $$x$$", "\\verb|$$x$$|", "\\verb*!\\[x\\]!",
        "\\begin{verbatim}$$x$$\\end{verbatim}", "\\begin{lstlisting}\n\\[x\\]\n\\end{lstlisting}",
        "\\begin{comment}\\[x\\]\\end{comment}", "\\iffalse\\ifx a b\\fi \\[x\\]\\fi",
        "\\end{document}\\[x\\]", "$x$", "\\(x\\)", "$\\text{if $x$}$", "100\\% $x$",
        "\\newenvironment{q}{\\begin{align}}{\\end{align}}"}) {
    INFO(text);
    CHECK(latex(text).empty());
    CHECK(latex_complaints(text).empty());
  }
}

TEST_CASE("LaTeX: headings have their balanced titles, the highest is level 1") {
  CHECK(latex("\\section{A {b} \\} c}\\subsection*{ D }\\subsubsection[e]{E}\\section{F}") ==
        "h1 A {b} \\} c\nh2 D\nh3 E\nh1 F\n");
  CHECK(latex("\\chapter{A}\\section{B}") == "h1 A\nh2 B\n");
  CHECK(latex("\\sectionmark{A} \\section") == "");
}

TEST_CASE("LaTeX: directives are comments that begin with rigor:") {
  CHECK(latex("% rigor: vector A, B  \n%rigor:given x\ntext %% rigor: skip this\n% rigor:\n% rigorous: no") ==
        "directive vector A, B\ndirective given x\ndirective skip this\n");
}

TEST_CASE("a directive inside a display comes before it") {
  CHECK(latex("\\[ a = b % rigor: expect refuted\n\\]") ==
        "directive expect refuted\ndisplay <> a = b % rigor: expect refuted\n");
}

TEST_CASE("LaTeX: a definition is covered whole") {
  for (const char* text :
       {"\\newcommand{\\v}[1]{\\mathbf{#1}}", "\\newcommand*\\v[2][x]{{#1}#2}", "\\def\\v#1#2{#1{#2}}",
        "\\let\\v=\\vec", "\\let\\v\\vec", "\\let\\bgroup={", "\\DeclareMathOperator{\\tr}{tr}",
        "\\DeclareMathOperator*{\\tr}{tr}", "\\DeclarePairedDelimiter{\\abs}{\\lvert}{\\rvert}",
        "\\DeclarePairedDelimiterX\\abs[1]{<}{>}{#1}", "\\NewDocumentCommand{\\v}{m}{#1}",
        "\\newcommand\\v\\vec", "\\newcommand{\\v}% remark }\n  {a % }\n b}", "\\newcommand\\v α",
        "\\renewcommand{\\v}{\\begin{align}}"}) {
    INFO(text);
    CHECK(latex(std::string(text) + " $x$ }") == std::string("macro ") + text + "\n");
  }
}

TEST_CASE("short names for a display's ends are followed") {
  CHECK(latex("\\newcommand{\\be}{\\begin{equation}}\\def\\ee{\\end{equation}}\\be x \\ee") ==
        "macro \\newcommand{\\be}{\\begin{equation}}\nmacro \\def\\ee{\\end{equation}}\ndisplay <equation> "
        "x\n");
  CHECK(latex_complaints("\\def\\ee{\\end{equation}}\\ee") == "1:24 `\\ee` closes nothing\n");
}

TEST_CASE("LaTeX: a display that is not closed is one complaint at its opening, and reading goes on") {
  Notes notes("notes.tex", "\\begin{align}\n a = b\n\ntext\n\\[ c \\]\n");
  CHECK(notes.complaints() == "1:1 `\\begin{align}` is not closed\n");
  CHECK(notes.dump() == "display <> c\n");
  REQUIRE(notes.diagnostics[0].labels.size() == 1);
  CHECK(notes.sources.text(notes.diagnostics[0].labels[0].span) == "\\[");
  REQUIRE(notes.diagnostics[0].help.size() == 1);
  CHECK(notes.diagnostics[0].help[0] == "close it with `\\end{align}`");
  CHECK(latex_complaints("$$ a = b\n\n$$ c $$") == "1:1 `$$` is not closed\n");
  CHECK(latex("$$ a = b\n\n$$ c $$") == "display <> c\n");
  CHECK(latex_complaints("\\[ a \\section{B}") == "1:1 `\\[` is not closed\n");
}

TEST_CASE("the end of another environment is a complaint with a label at it") {
  Notes notes("notes.tex", "\\begin{align} a \\end{equation} \\[ b \\]");
  CHECK(notes.complaints() == "1:1 `\\begin{align}` is not closed before `\\end{equation}`\n");
  REQUIRE(notes.diagnostics[0].labels.size() == 1);
  CHECK(notes.sources.text(notes.diagnostics[0].labels[0].span) == "\\end{equation}");
  CHECK(notes.dump() == "display <> b\n");
  CHECK(latex_complaints("a\n\\end{align}") == "2:1 `\\end{align}` closes nothing\n");
}

TEST_CASE("LaTeX: inline mathematics ends with its paragraph at the latest") {
  CHECK(latex_complaints("a $x\n\nb $y$") == "1:3 `$` is not closed in its paragraph\n");
  CHECK(latex_complaints("a \\(x\n\nb") == "1:3 `\\(` is not closed in its paragraph\n");
}

TEST_CASE("LaTeX: other things that are not closed are complaints too") {
  CHECK(latex_complaints("\\begin{verbatim} \\[x\\]") == "1:1 `\\begin{verbatim}` is not closed\n");
  CHECK(latex_complaints("\\section{a\n\n}") == "1:1 `\\section{` is not closed in its paragraph\n");
  CHECK(latex_complaints("\\newcommand{\\v}{a") == "1:1 a definition is not closed\n");
  CHECK(latex_complaints("\\iffalse a") == "1:1 `\\iffalse` is not closed\n");
}

TEST_CASE("Markdown: every delimiter of a display is read") {
  CHECK(markdown("text $$x$$ text\n\n$$\ny\n$$\n") == "display <> x\ndisplay <> y\n");
  CHECK(markdown("\\[ x \\] and \\\\[ y \\\\[2pt] z \\\\]") == "display <> x\ndisplay <> y \\\\[2pt] z\n");
  CHECK(markdown("```math\nx\n```\n~~~~ math\ny\n~~~\n~~~~\n") == "display <> x\ndisplay <> y\n~~~\n");
  CHECK(markdown("\\begin{align}x\\end{align}") == "display <align> x\n");
  CHECK(markdown("$$\\begin{align}x\\end{align}$$") == "display <> \\begin{align}x\\end{align}\n");
  CHECK(markdown("- item\n\n    $$x$$\n1. ```math\n   y\n   ```\n") == "display <> x\ndisplay <> y\n");
}

TEST_CASE("Markdown: the marks of a quotation do not reach the tokens") {
  Notes notes("notes.md", "> $$\n> a\n> $$\n\n> ```math\n> b > c\n> ```\n");
  std::string bodies;
  for (const Item& item : notes.document.items) {
    const auto& display = std::get<Display>(item);
    for (const Token& token : lex(notes.sources, display.body, display.quotes)) bodies += token.text;
    bodies += '|';
  }
  CHECK(bodies == " a | b > c |");
  CHECK(notes.complaints().empty());
}

TEST_CASE("words right behind a display say it for the other axes, too") {
  const auto cyclic = [](const char* file, const std::string& text) {
    const Notes notes(file, text);
    return std::get<Display>(notes.document.items.at(0)).cyclic;
  };
  for (const char* words :
       {"and cyclic permutations.", "\nand cyclically", " (and cyclic\npermutations of 1, 2, 3)",
        "\nPlus cyclic permutations", ", etc.", " etc. Next"}) {
    INFO(words);
    CHECK(cyclic("notes.tex", std::string("\\[ x \\]") + words));
    CHECK(cyclic("notes.tex", std::string("\\begin{align}x\\end{align}") + words));
    CHECK(cyclic("notes.md", std::string("$$\nx\n$$") + words));
  }
  CHECK(cyclic("notes.md", "```math\nx\n```\nand cyclic permutations"));
  CHECK(cyclic("notes.md", "> $$\n> x\n> $$\n> and cyclic permutations"));
  for (const char* words : {"", "\n\nand cyclic permutations", "\nand", "\nwhere etc.", "\ncyclic in i"}) {
    INFO(words);
    CHECK_FALSE(cyclic("notes.tex", std::string("\\[ x \\]") + words));
    CHECK_FALSE(cyclic("notes.md", std::string("$$\nx\n$$") + words));
  }
}

TEST_CASE("Markdown: code, comments and prices are no displays") {
  for (const char* text :
       {"`$$x$$`", "`` ` $$x$$ ``", "```\n$$x$$\n# no\n```", "~~~tex\n\\[x\\]\n~~~", "<!-- $$x$$ -->",
        "costs $5", "$5 and $6", "from $5 to $10, or \\$\\$7", "$x$ and $y$", "\\(x\\)", "a \\[not a link]",
        "a `` ` b", "\\\\(x\\\\)", "---\ntitle: $$x$$\n---\n", "$x $"}) {
    INFO(text);
    CHECK(markdown(text).empty());
    CHECK(markdown_complaints(text).empty());
  }
}

TEST_CASE("Markdown: a price does not hide the display behind it") {
  CHECK(markdown("costs $5\n$$\nx\n$$\n") == "display <> x\n");
  CHECK(markdown("a $ b and `c\n\n$$x$$") == "display <> x\n");
}

TEST_CASE("Markdown: headings by marks and by lines beneath") {
  CHECK(markdown("# A #\n## B#\n####### no\n#no\nC\n===\nD *e*\n---\n\n---\n- f\n---\n") ==
        "h1 A\nh2 B#\nh1 C\nh2 D *e*\n");
  CHECK(markdown("---\ntitle: A\n---\nB\n---\n") == "h2 B\n");
  CHECK(markdown("$$x$$\n---\n") == "display <> x\n");
}

TEST_CASE("Markdown: each line of a rigor comment is a directive") {
  CHECK(markdown("<!-- rigor: vector A -->\n<!--rigor:\n  given x\n\n  small y\n-->\n<!-- other -->") ==
        "directive vector A\ndirective given x\ndirective small y\n");
}

TEST_CASE("Markdown: definitions count in prose and in inline mathematics") {
  CHECK(markdown("\\newcommand{\\v}[1]{\\mathbf{#1}}\n\n$\\def\\a{b}\n\\let\\c\\d$ text") ==
        "macro \\newcommand{\\v}[1]{\\mathbf{#1}}\nmacro \\def\\a{b}\nmacro \\let\\c\\d\n");
  CHECK(markdown("`\\newcommand{\\v}{a}`").empty());
}

TEST_CASE("Markdown: what is not closed is one complaint, and reading goes on behind the next blank line") {
  CHECK(markdown_complaints("$$ a\n\n$$b$$") == "1:1 `$$` is not closed\n");
  CHECK(markdown("$$ a\n\n$$b$$") == "display <> b\n");
  CHECK(markdown_complaints("\\[ a\n\nb") == "1:1 `\\[` is not closed\n");
  CHECK(markdown_complaints("a <!-- b\n\n$$c$$") == "1:3 `<!--` is not closed\n");
  CHECK(markdown("a <!-- b\n\n$$c$$") == "display <> c\n");
  CHECK(markdown_complaints("```math\na\n\n$$b$$") == "1:1 a fenced block is not closed\n");
  CHECK(markdown_complaints("\\begin{align} a\n# B\n") == "1:1 `\\begin{align}` is not closed\n");
}

TEST_CASE("\\input is followed in place, inside the folder of the notes") {
  Folder folder("rigor-document-test-input");
  folder.write("notes/part.tex", "\\[ b \\]\\input{sub/deeper}");
  folder.write("notes/sub/deeper.tex", "\\[ c \\]\\input{beside}");
  folder.write("notes/sub/beside.tex", "\\[ d \\]");
  folder.write("outside.tex", "\\[ no \\]");
  Notes notes = folder.read("\\[ a \\]\\input{part}\\include{part}\\input part.tex \\[ e \\]");
  CHECK(notes.dump() == "display <> a\ndisplay <> b\ndisplay <> c\ndisplay <> d\ndisplay <> e\n");
  CHECK(notes.complaints().empty());
  CHECK(folder.read("\\input{../outside}").complaints() ==
        "1:1 `../outside.tex` is outside the folder of the notes\n");
  CHECK(folder.read("\\input{/etc/passwd}").diagnostics[0].kind == DiagnosticKind::input_outside);
  CHECK(folder.read("\\input{nowhere}").diagnostics[0].kind == DiagnosticKind::missing_input);
  CHECK(folder.read("\\input{sub.}").diagnostics[0].kind == DiagnosticKind::missing_input);
  CHECK(folder.read("\\input{}").diagnostics.empty());
}

TEST_CASE("\\input ends where files read each other or are nested too deep") {
  Folder folder("rigor-document-test-cycle");
  folder.write("notes/a.tex", "\\input{b}");
  folder.write("notes/b.tex", "\\input{a}\\input{top}");
  folder.write("notes/top.tex", "");
  CHECK(folder.read("\\input{a}").complaints() == "1:1 `a.tex` reads itself\n1:10 `top.tex` reads itself\n");
  for (int i = 0; i < 40; ++i) {
    folder.write("notes/n" + std::to_string(i) + ".tex", "\\[x\\]\\input{n" + std::to_string(i + 1) + "}");
  }
  const Notes deep = folder.read("\\input{n0}");
  CHECK(deep.document.items.size() == 16);
  CHECK(deep.diagnostics.size() == 1);
}

TEST_CASE("hostile notes end in few complaints") {
  const auto repeat = [](std::string_view piece, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += piece;
    return text;
  };
  for (const std::string_view piece : {"\\begin{align}",
                                       "$",
                                       "$a ",
                                       "{",
                                       "\\[",
                                       "\\\\[a ",
                                       "\\end{align}\n\n",
                                       "\\begin{align}\n\n",
                                       "`",
                                       "` `` ",
                                       "```\n",
                                       "````x\n",
                                       "<!--\n\n",
                                       "\\(",
                                       "\\newcommand{\\a}{",
                                       "\\newcommand{\\a}[",
                                       "\\section{",
                                       "\\section[",
                                       "\\begin{verbatim}\n\n",
                                       "\\verb!",
                                       "\\iffalse",
                                       "\\begin{alignat}{\\end{alignat}",
                                       "> ",
                                       "- ",
                                       "\\input{",
                                       "%",
                                       "\\",
                                       "a\n",
                                       "\\begin{dmath}[\\end{dmath}",
                                       "# ",
                                       "#",
                                       "\\def\\a"}) {
    for (const char* path : {"notes.tex", "notes.md"}) {
      INFO(path << ": " << piece);
      const Notes notes(path, repeat(piece, 20'000));
      CHECK(notes.diagnostics.size() <= 1000);
    }
  }
}

TEST_CASE("no bytes disturb the readers") {
  const std::string_view pieces[] = {"$",
                                     "$$",
                                     "\\[",
                                     "\\]",
                                     "\\\\[",
                                     "\\(",
                                     "\\)",
                                     "`",
                                     "```",
                                     "math",
                                     "\n",
                                     "\n\n",
                                     " ",
                                     "{",
                                     "}",
                                     "[",
                                     "]",
                                     "\\begin{align}",
                                     "\\end{align}",
                                     "\\newcommand{\\a}",
                                     "% rigor: x",
                                     "<!-- rigor:",
                                     "-->",
                                     "# ",
                                     "> ",
                                     "- ",
                                     "---",
                                     "\\section{",
                                     "\\verb|",
                                     "\\def\\b#1",
                                     "\\let",
                                     "\\",
                                     "a",
                                     "α",
                                     "\\begin{verbatim}",
                                     "\\end{verbatim}",
                                     "\\iffalse",
                                     "\\fi"};
  std::uint32_t state = 11;
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (int i = 0; i < 60; ++i) {
      state = state * 1664525U + 1013904223U;
      text += pieces[(state >> 16U) % std::size(pieces)];
      if (round % 3 == 0) text += static_cast<char>(state >> 24U);
    }
    for (const char* path : {"notes.tex", "notes.md"}) {
      const Notes notes(path, text);
      bool inside = true;
      for (const Diagnostic& diagnostic : notes.diagnostics)
        inside = inside && diagnostic.span.end <= text.size();
      for (const Item& item : notes.document.items) {
        const Span span = std::visit([](const auto& it) { return it.span; }, item);
        inside = inside && span.begin <= span.end && span.end <= text.size();
      }
      CHECK(inside);
    }
  }
}
