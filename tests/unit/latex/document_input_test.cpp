// SPDX-License-Identifier: GPL-3.0-or-later
// `\input`, and notes that were written to be hard to read.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "catch.h"
#include "latex/notes.h"

namespace {

using namespace rigor;

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
  [[nodiscard]] ReadNotes read(const std::string& text) const {
    return {(path / "notes/top.tex").string(), text};
  }
};

}  // namespace

TEST_CASE("\\input is followed in place, inside the folder of the notes") {
  Folder folder("rigor-document-test-input");
  folder.write("notes/part.tex", "\\[ b \\]\\input{sub/deeper}");
  folder.write("notes/sub/deeper.tex", "\\[ c \\]\\input{beside}");
  folder.write("notes/sub/beside.tex", "\\[ d \\]");
  folder.write("outside.tex", "\\[ no \\]");
  ReadNotes notes = folder.read("\\[ a \\]\\input{part}\\include{part}\\input part.tex \\[ e \\]");
  CHECK(notes.dump() == "display <> a\ndisplay <> b\ndisplay <> c\ndisplay <> d\ndisplay <> e\n");
  CHECK(notes.complaints() ==
        "1:20 `part.tex` was read before; its equations are not checked again here\n"
        "1:34 `part.tex` was read before; its equations are not checked again here\n");
  folder.write("notes/macros.tex", "\\newcommand{\\x}{x}\\section{x}");
  CHECK(folder.read("\\input{macros}\\input{macros}").complaints().empty());
  CHECK(folder.read("\\input{../outside}").complaints() ==
        "1:1 `../outside.tex` is outside the folder of the notes\n");
  CHECK(folder.read("\\input{/etc/passwd}").diagnostics[0].kind == DiagnosticKind::input_outside);
  CHECK(folder.read("\\input{nowhere}").diagnostics[0].kind == DiagnosticKind::missing_input);
  CHECK(folder.read("\\input{sub.}").diagnostics[0].kind == DiagnosticKind::missing_input);
  CHECK(folder.read("\\input{}").diagnostics.empty());
}

TEST_CASE("\\input is followed inside the repository that the notes are in") {
  Folder folder("rigor-document-test-repository");
  folder.write("preamble.tex", "\\[ a \\]");
  CHECK(folder.read("\\input{../preamble}").diagnostics[0].kind == DiagnosticKind::input_outside);
  folder.write("rigor.toml", "");
  const ReadNotes notes = folder.read("\\input{../preamble}");
  CHECK(notes.dump() == "display <> a\n");
  CHECK(notes.complaints().empty());
  CHECK(folder.read("\\input{../../preamble}").diagnostics[0].kind == DiagnosticKind::input_outside);
}

TEST_CASE("\\input finds a file as TeX does: without quotes, and NAME.tex before NAME") {
  Folder folder("rigor-document-test-names");
  folder.write("notes/sub dir/p q.tex", "\\[ a \\]");
  folder.write("notes/p.y", "\\[ no \\]");
  folder.write("notes/p.y.tex", "\\[ b \\]");
  folder.write("notes/bare", "\\[ c \\]");
  folder.write("notes/lone.y", "\\[ d \\]");
  const auto displays = [&](const std::string& text) {
    const ReadNotes notes = folder.read(text);
    return notes.dump() + notes.complaints();
  };
  CHECK(displays("\\input{\"sub dir/p q\"}") == "display <> a\n");
  CHECK(displays("\\input \"sub dir/p q\" \\[ z \\]") == "display <> a\ndisplay <> z\n");
  CHECK(displays("\\input{p.y}") == "display <> b\n");
  CHECK(displays("\\input{bare}") == "display <> c\n");
  CHECK(displays("\\input{lone.y}") == "display <> d\n");
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
  const ReadNotes deep = folder.read("\\input{n0}");
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
      const ReadNotes notes(path, repeat(piece, 20'000));
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
      const ReadNotes notes(path, text);
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
