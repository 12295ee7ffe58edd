// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor report --latex` through pdflatex: it compiles, and the log has nothing to say.
#include <algorithm>

#include "browser.h"
#include "catch.h"
#include "program.h"

namespace rigor {
namespace {

/// The lines of the log that TeX would like somebody to read.
std::string complaints(const Folder& folder, const std::string& notes) {
  const Outcome outcome = run_program({"report", notes, "--latex", folder.path("d.tex")});
  if (outcome.code > 2) return outcome.text;
  static_cast<void>(printed_by("cd '" + folder.path("") +
                               "' && timeout 100 pdflatex -interaction=nonstopmode -halt-on-error d.tex"));
  return printed_by("grep -aE '^!|Overfull|Warning|Missing character|no output' '" + folder.path("d.log") +
                    "'") +
         (printed_by("ls '" + folder.path("d.pdf") + "'").find("No such") != std::string::npos ? "no pages"
                                                                                               : "");
}

constexpr const char* odd_notes = R"(# 100 % of _this_ & #that ~ $A_i$ \ {x} 中文 ünïcode naïve

$$\undefinedcontrol{a}_b^c = \begin{odd} x & y \end{odd} \quad\text{50\% of é 中 # \& _ $x_1$}$$

$$a \over b = {c$$

$$\left( a = b$$

$$x_{1_{2_{3_{4_{5}}}}} = \ce{H2O} + 名$$

$$\mathcal{l} + \mathbb{q} + \boldsymbol{\mathsf{I}} + \mathfrak{g} + \mathtt{t} = \hat{\hat{\hat{a}}} + a'''^2$$

$$\def\loop{\loop}\loop = 1$$

$$a_1 + a_2 + a_3 + a_4 + a_5 + a_6 + a_7 + a_8 + a_9 + b_1 + b_2 + b_3 + b_4 + b_5 + b_6 + b_7 + b_8 + b_9 + c_1 + c_2 + c_3 + c_4 = x$$

$$\sqrt{a_1 + a_2 + a_3 + a_4 + a_5 + a_6 + a_7 + a_8 + a_9 + b_1 + b_2 + b_3 + b_4 + b_5 + b_6 + b_7 + b_8 + b_9 + c_1 + c_2 + c_3 + c_4} = x \tag{a long tag that goes on and on for ever and ever}$$
)";

}  // namespace

TEST_CASE("the document of every note in derivations compiles without a warning") {
  if (!is_there("pdflatex")) return;
  for (const std::string& notes : notes_in("derivations")) {
    const Folder folder;
    INFO(notes);
    CHECK(complaints(folder, notes) == "");
  }
}

TEST_CASE("the document of every note in pass compiles without a warning") {
  if (!is_there("pdflatex")) return;
  for (const std::string& notes : notes_in("tests/notes/pass")) {
    const Folder folder;
    INFO(notes);
    CHECK(complaints(folder, notes) == "");
  }
}

TEST_CASE("the document of what TeX itself would not set compiles without a warning") {
  if (!is_there("pdflatex")) return;
  const Folder folder;
  write_file(folder.path("a_b#c%.md"), odd_notes);
  CHECK(complaints(folder, folder.path("a_b#c%.md")) == "");
}

TEST_CASE("a sample that is as wide as a line stands below its label") {
  if (!is_there("pdflatex")) return;
  const Folder folder;
  write_file(folder.path("n.md"), "<!-- rigor: tensor X_{ijkl} -->\n\n$$X_{ijkl} = X_{jikl}$$\n");
  CHECK(complaints(folder, folder.path("n.md")) == "");
}

TEST_CASE("the document says what is wrong, where, and what is true") {
  if (!is_there("pdflatex") || !is_there("pdftotext")) return;
  const Folder folder;
  CHECK(complaints(folder, "tests/notes/run/refuted.md") == "");
  const std::string text = printed_by("pdftotext -layout '" + folder.path("d.pdf") + "' -");
  CHECK(text.find("refuted") != std::string::npos);
  CHECK(text.find("sample") != std::string::npos);
  CHECK(text.find("true is") != std::string::npos);
}

TEST_CASE("the document shows each step with the macros that were in force there") {
  const Folder folder;
  write_file(
      folder.path("n.tex"),
      "\\newcommand{\\sgn}{-}\n\\[ \\mathbf{A}\\times\\mathbf{B} = \\sgn\\mathbf{B}\\times\\mathbf{A} \\]\n"
      "\\renewcommand{\\sgn}{+}\n\\[ \\mathbf{A}\\cdot\\mathbf{B} = \\sgn\\mathbf{B}\\cdot\\mathbf{A} \\]\n");
  const std::string text = run_program({"report", folder.path("n.tex"), "--latex", "-"}).text;
  INFO(text);
  CHECK(text.find("\\times }\\mathbf{B}\\mathrel{=}{-}\\mathbf{B}\\mathbin{\\times }") != std::string::npos);
  CHECK(text.find("\\cdot }\\mathbf{B}\\mathrel{=}{+}\\mathbf{B}\\mathbin{\\cdot }") != std::string::npos);
}

TEST_CASE("what rigor printed is shown without the macros of the notes") {
  const Folder folder;
  write_file(folder.path("n.tex"),
             "\\renewcommand{\\cdot}{\\times}\n"
             "\\[ \\mathbf{C}\\bullet\\mathbf{B} = \\mathbf{B}\\bullet\\mathbf{C} \\]\n");
  const std::string text = run_program({"report", folder.path("n.tex"), "--latex", "-"}).text;
  INFO(text);
  CHECK(text.find("\\rigorsmall{2em}{\\mathbf{C}\\mathbin{\\cdot }\\mathbf{B}}") != std::string::npos);
}

TEST_CASE("a display whose macros never end is shown as its source") {
  const Folder folder;
  write_file(folder.path("n.tex"), "\\def\\z{\\z\\z}\n\\[\\z = 1\\]\n");
  const std::string text = run_program({"report", folder.path("n.tex"), "--latex", "-"}).text;
  INFO(text);
  CHECK(text.find("\\textbackslash{}z\\ =\\ 1") != std::string::npos);
}

TEST_CASE("a proved step without small steps says why, in the document and on the page") {
  const Folder folder;
  write_file(folder.path("n.md"), "<!-- rigor: scalar x -->\n\n$$x^2 + 1 > 0$$\n");
  for (const char* option : {"--latex", "--html"}) {
    const std::string text = run_program({"report", folder.path("n.md"), option, "-", "--no-forms"}).text;
    INFO(text);
    CHECK(text.find("none: one side of an order is not turned into the other") != std::string::npos);
  }
}

}  // namespace rigor
