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
  for (const char* text : {"`$$x$$`",
                           "`` ` $$x$$ ``",
                           "```\n$$x$$\n# no\n```",
                           "~~~tex\n\\[x\\]\n~~~",
                           "<!-- $$x$$ -->",
                           "costs $5",
                           "$5 and $6",
                           "from $5 to $10, or \\$\\$7",
                           "$x$ and $y$",
                           "\\(x\\)",
                           "a \\[not a link]",
                           "a `` ` b",
                           "\\\\(x\\\\)",
                           "---\ntitle: $$x$$\n---\n",
                           "$x $",
                           "a\n\n    $$x$$",
                           "- a\n\n      $$x$$",
                           "<pre>\n$$x$$\n\n$$y$$\n</pre>",
                           "<PRE>$$x$$</PRE>",
                           "<script>\nlet a = `$$x$$`\n</script>",
                           "a <code>$$x$$</code> b",
                           "%% $$x$$ %%",
                           "%%\n$$x$$\n\n$$y$$\n%%",
                           "$`x`$",
                           "a $`b$c`$ d",
                           "```{python}\n\"$$x$$\"\n```",
                           "```{.python}\n$$x$$\n```",
                           ":::{code-block} tex\n$$x$$\n\n$$y$$\n:::"}) {
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
  CHECK(markdown("# A #\n## B#\n####### no\n#no\n\nC\n===\nD *e*\n---\n\n---\n- f\n---\n") ==
        "h1 A\nh2 B#\nh1 C\nh2 D *e*\n");
  CHECK(markdown("---\ntitle: A\n---\nB\n---\n") == "h2 B\n");
  CHECK(markdown("$$x$$\n---\n") == "display <> x\n");
  CHECK(markdown("A long\ntitle\n-----\n") == "h2 A long title\n");
  CHECK(markdown("> # no\n\n- ## no\n").empty());
}

TEST_CASE("Markdown: lines of a display are no blocks") {
  for (const char* body : {"a\n- b", "a\n= b", "a\n=\nb", "a\n+ b\n1. c", "a\n> b", "a\n\n    + b",
                           "<div>\na", "a\n\n- b\n\n+ c"}) {
    const std::string text = std::string("$$\n") + body + "\n$$\n";
    INFO(text);
    CHECK(markdown(text + "Words.\n\n    $$code$$\n\n$$z$$\n") ==
          std::string("display <> ") + body + "\ndisplay <> z\n");
  }
}

TEST_CASE("Markdown: a display goes on behind a blank line where mathematics does") {
  CHECK(markdown("$$\n\na\n\n$$\n\n$$\n\nb\n\n$$\n") == "display <> a\ndisplay <> b\n");
  CHECK(markdown("$$\na = b\n\n+ c\n$$\nwhere\n\n$$d$$") == "display <> a = b\n\n+ c\ndisplay <> d\n");
  CHECK(markdown("\\[\na\n\n= b\n\\]") == "display <> a\n\n= b\n");
  CHECK(markdown("> $$\n> a\n>\n> + b\n> $$\n") == "display <> > a\n>\n> + b\n>\n");
  CHECK(markdown("$$\na\n\n\\text{if $b$ is so, and not otherwise}\n$$\n").find("otherwise}") !=
        std::string::npos);
}

TEST_CASE("Markdown: an open display does not take in what is behind it") {
  const auto found = [](const char* text) { return markdown(text) + markdown_complaints(text); };
  CHECK(found("$$\na = b\n\nThen we have\n\n$$c = d$$\n") == "display <> c = d\n1:1 `$$` is not closed\n");
  CHECK(found("$$\na = b\n\nWhere $c$ is\n\n$$\nd\n$$\n") == "display <> d\n1:1 `$$` is not closed\n");
  CHECK(found("$$\na = b\n\n$$\nc = d\n$$\n\nEnd.") == "display <> c = d\n1:1 `$$` is not closed\n");
  CHECK(found("$$\na = b\n\n$$c = d$$\n") == "display <> c = d\n1:1 `$$` is not closed\n");
  CHECK(found("> $$\n> a = b\n\n$$\nc\n$$\n") == "display <> c\n1:3 `$$` is not closed\n");
  CHECK(found("<pre>\na\n\n$$b$$") == "display <> b\n1:1 `<pre` is not closed\n");
}

TEST_CASE("Markdown: options of a fence are no mathematics") {
  CHECK(markdown("```{math}\n:label: wave\n:nowrap:\n\nx\n```") == "display <> x\n");
  CHECK(markdown("```{math}\n---\nlabel: wave\n---\nx\n```") == "display <> x\n");
  CHECK(markdown("```{math} x = y\n```") == "display <> x = y\n");
  CHECK(markdown(":::{math}\n:label: wave\nx\n\ny\n:::\n\n$$z$$") == "display <> x\n\ny\ndisplay <> z\n");
  CHECK(markdown("```math\n: a\n```") == "display <> : a\n");
  CHECK(markdown("```{math}\n:label: wave\n```").empty());
}

TEST_CASE("Markdown: containers of all dialects hold Markdown") {
  for (const char* text : {"```{note}\n$$x$$\n```",
                           "```{admonition} A title\n:class: tip\n\n$$x$$\n```",
                           "````{tab-set}\n```{tab-item} A\n$$x$$\n```\n````",
                           "````{exercise}\n```{dropdown} A\n$$x$$\n````",
                           "~~~{dropdown}\n---\nopen: true\n---\n$$x$$\n~~~",
                           ":::{warning}\n$$x$$\n:::",
                           "::: {.callout-note}\n$$x$$\n:::",
                           ":::tip\n$$x$$\n:::",
                           "::::{grid}\n:::{card}\n$$x$$\n:::\n::::",
                           "- a\n  ```{prf:theorem}\n  $$x$$\n  ```",
                           "!!! note \"A\"\n\n    $$x$$",
                           "=== \"Tab\"\n    $$x$$",
                           "[^1]: a\n\n    $$x$$",
                           "[^1]: $$x$$",
                           "Term\n:   a\n\n    $$x$$",
                           "<div>\n\n$$x$$\n\n</div>",
                           "<details>$$x$$</details>",
                           "> [!note]\n> $$x$$",
                           "| a |\n|---|\n| $$x$$ |",
                           "1. a\n   - b\n\n     $$x$$",
                           "```{=latex}\n$$x$$\n```"}) {
    INFO(text);
    CHECK(markdown(text) == "display <> x\n");
    CHECK(markdown_complaints(text).empty());
  }
  CHECK(markdown_complaints("```{eval-rst}\n.. math:: x\n```") ==
        "1:1 displays of reStructuredText are not read\n");
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
