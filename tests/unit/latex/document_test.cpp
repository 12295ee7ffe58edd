// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document/document.h"

#include "catch.h"
#include "latex/notes.h"

using namespace rigor;

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
        "\\newenvironment{q}{\\begin{align}}{\\end{align}}",
        "\\begin{filecontents*}{a}\\[x\\]\\end{filecontents*}", "\\endinput\\[x\\]",
        "\\excludecomment{q}\\begin{q}\\[x\\]\\end{q}"}) {
    INFO(text);
    CHECK(latex(text).empty());
    CHECK(latex_complaints(text).empty());
  }
}

TEST_CASE("LaTeX: a branch counts if the notes say so") {
  CHECK(latex("\\iffalse\\[a\\]\\else\\[b\\]\\fi\\[c\\]") == "display <> b\ndisplay <> c\n");
  CHECK(latex("\\iftrue\\[a\\]\\else\\iffalse\\else\\[b\\]\\fi\\fi") == "display <> a\n");
  CHECK(latex("\\newif\\ifx \\ifx\\[a\\]\\fi \\xtrue\\ifx\\[b\\]\\fi \\xfalse\\ifx\\[c\\]\\fi") ==
        "display <> b\n");
  CHECK(latex("\\ifodd1 \\[a\\]\\else\\[b\\]\\fi") == "display <> a\n");
  CHECK(latex_complaints("\\ifodd1 \\[a\\]\\else\\[b\\]\\fi") ==
        "1:14 a display in a branch that may not be typeset is not read\n");
  CHECK(latex_complaints("\\ifodd1 \\[a\\]\\else b\\fi").empty());
  CHECK(latex_complaints("\\iffalse\\[a\\]") == "1:1 `\\iffalse` is not closed\n");
  CHECK(latex("\\iftoggle{a}{\\[x\\]}{\\[y\\]}") == "display <> x\ndisplay <> y\n");
}

TEST_CASE("LaTeX: macros that are defined in a group stand between its marks") {
  CHECK(latex("{\\def\\a{1}}\\[a\\]") == "{\nmacro \\def\\a{1}\n}\ndisplay <> a\n");
  CHECK(latex("\\begin{x}{a}{{\\def\\a{1}\\end{x}") == "{\n{\n{\nmacro \\def\\a{1}\n}\n}\n}\n");
  CHECK(latex("\\bgroup\\gdef\\a{1}\\egroup}") == "{\nglobal macro \\gdef\\a{1}\n}\n");
  CHECK(latex("\\AtBeginDocument{\\def\\a{1}}") == "macro \\def\\a{1}\n");
  CHECK(latex("\\footnote{\\def\\a{1}}") == "{\nmacro \\def\\a{1}\n}\n");
  CHECK(latex("\\setup{\\def\\a{1}}\\begin{document}") == "macro \\def\\a{1}\n");
  CHECK(latex("{\\newcommand{\\be}{\\[}}\\be a\\]") == "{\nmacro \\newcommand{\\be}{\\[}\n}\n");
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

TEST_CASE("a display that opens in the author's own definition is a complaint where that is used") {
  const std::string renamed =
      "\\newenvironment{eq}{\\begin{equation}}{\\end{equation}} \\begin{eq} a \\end{eq}";
  CHECK(latex_complaints(renamed).empty());
  CHECK(latex(renamed).find("a\n") != std::string::npos);
  CHECK(latex_complaints("\\newcommand{\\dis}[1]{\\[#1\\]} \\dis{a}\\dis{b}") ==
        "1:30 the definition of `\\dis` opens a display, which is not read\n"
        "1:37 the definition of `\\dis` opens a display, which is not read\n");
  CHECK(markdown_complaints("\\def\\dis#1{$$#1$$}\n\n\\dis{a}\n") ==
        "3:1 the definition of `\\dis` opens a display, which is not read\n");
  CHECK(latex_complaints(
            "\\newenvironment{said}[1]{\\begin{quote}\\\\[2pt]}{\\end{quote}} \\begin{said}{x} a \\end{said}")
            .empty());
  CHECK(latex_complaints("\\newcommand{\\dis}{\\[} \\renewcommand{\\dis}{x} \\dis").empty());
}

TEST_CASE("LaTeX: a display that is not closed is one complaint at its opening, and reading goes on") {
  ReadNotes notes("notes.tex", "\\begin{align}\n a = b\n\ntext\n\\[ c \\]\n");
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

TEST_CASE("a display in the words of an \\intertext is a complaint, and the one around it goes on") {
  const char* const around =
      "\\begin{align} a \\intertext{so {x} \\[ b \\] $$ c $$} d \\end{align} \\[ e \\]";
  CHECK(latex(around) == "display <align> a \\intertext{so {x} \\[ b \\] $$ c $$} d\ndisplay <> e\n");
  CHECK(latex_complaints(around) == "1:35 a display in the words of `\\intertext` is not read\n");
  CHECK(latex_complaints("\\begin{align} a \\intertext{so \n\n \\[ b \\]") ==
        "1:1 `\\begin{align}` is not closed\n");
  for (const char* words :
       {"$$ b $$", "\\begin{equation} b \\end{equation}", "\\begin{gather} b \\end{gather}"}) {
    INFO(words);
    const std::string text = "\\begin{align} a \\shortintertext{" + std::string(words) + "} d \\end{align}";
    CHECK(latex_complaints(text) == "1:33 a display in the words of `\\intertext` is not read\n");
  }
  CHECK(latex_complaints("\\begin{align} a \\intertext{so $x$ and \\emph{y}} d \\end{align}").empty());
}

TEST_CASE("the end of another environment is a complaint with a label at it") {
  ReadNotes notes("notes.tex", "\\begin{align} a \\end{equation} \\[ b \\]");
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
