// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "latex/notes.h"

using namespace rigor;

TEST_CASE("Markdown: every delimiter of a display is read") {
  CHECK(markdown("text $$x$$ text\n\n$$\ny\n$$\n") == "display <> x\ndisplay <> y\n");
  CHECK(markdown("\\[ x \\] and \\\\[ y \\\\[2pt] z \\\\]") == "display <> x\ndisplay <> y \\\\[2pt] z\n");
  CHECK(markdown("```math\nx\n```\n~~~~ math\ny\n~~~\n~~~~\n") == "display <> x\ndisplay <> y\n~~~\n");
  CHECK(markdown("\\begin{align}x\\end{align}") == "display <align> x\n");
  CHECK(markdown("$$\\begin{align}x\\end{align}$$") == "display <> \\begin{align}x\\end{align}\n");
  CHECK(markdown("- item\n\n    $$x$$\n1. ```math\n   y\n   ```\n") == "display <> x\ndisplay <> y\n");
}

TEST_CASE("Markdown: the marks of a quotation do not reach the tokens") {
  ReadNotes notes("notes.md", "> $$\n> a\n> $$\n\n> ```math\n> b > c\n> ```\n");
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
    const ReadNotes notes(file, text);
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
