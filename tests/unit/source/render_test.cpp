// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/render.h"

#include "base/utf8.h"
#include "catch.h"

namespace rigor {
namespace {

/// A diagnostic of one file, whose places are named by what stands there.
class Note {
 public:
  explicit Note(std::string text) : text_(std::move(text)), file_(sources_.add("notes/euler.tex", text_)) {}

  [[nodiscard]] Span span(std::string_view part, std::size_t nth = 0) const {
    std::size_t at = text_.find(part);
    while (nth-- > 0) at = text_.find(part, at + 1);
    return {file_, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + part.size())};
  }
  [[nodiscard]] std::string show(const Diagnostic& diagnostic, std::uint32_t width = 160) const {
    return render(diagnostic, sources_, {false, width});
  }
  SourceMap& sources() { return sources_; }

 private:
  SourceMap sources_;
  std::string text_;
  FileId file_;
};

Diagnostic repeats(Span span) {
  return {DiagnosticKind::index_repeats, span, "index `j` occurs 3 times", {}, {}};
}

TEST_CASE("a caret stands under the place, tildes under the labels of its line, help at the end") {
  const Note note(std::string(56, '\n') + "  \\epsilon_{ijk} I_{jl} \\omega_l \\omega_j\n");
  Diagnostic diagnostic = repeats(note.span("j", 2));
  diagnostic.message = "index `j` occurs 3 times in one term";
  diagnostic.labels = {{note.span("j", 0), ""}, {note.span("j", 1), ""}};
  diagnostic.help = {"with `I_{kl}` for `I_{jl}` the free index matches the left side"};
  CHECK(note.show(diagnostic) ==
        "notes/euler.tex:57:41: error: index `j` occurs 3 times in one term [index-repeats]\n"
        "   57 |   \\epsilon_{ijk} I_{jl} \\omega_l \\omega_j\n"
        "      |              ~      ~                   ^\n"
        "help: with `I_{kl}` for `I_{jl}` the free index matches the left side\n");
}

TEST_CASE("the rest of a longer place is underlined, up to the end of its line") {
  const Note note("a = b \\cdot\nc\n");
  CHECK(note.show(repeats(note.span("\\cdot\nc"))) ==
        "notes/euler.tex:1:7: error: index `j` occurs 3 times [index-repeats]\n"
        "    1 | a = b \\cdot\n"
        "      |       ^~~~~\n");
}

TEST_CASE("a label on another line gets a line of its own") {
  const Note note("A = B\nA = C\n");
  Diagnostic diagnostic{DiagnosticKind::redefinition, note.span("A", 1), "`A` is defined again", {}, {}};
  diagnostic.labels = {{note.span("A", 0), "first defined here"}, {note.span("B"), ""}};
  CHECK(note.show(diagnostic) ==
        "notes/euler.tex:2:1: warning: `A` is defined again [redefinition]\n"
        "    2 | A = C\n"
        "      | ^\n"
        "notes/euler.tex:1:1: note: first defined here\n"
        "    1 | A = B\n"
        "      | ^\n"
        "notes/euler.tex:1:5: note: here\n"
        "    1 | A = B\n"
        "      |     ^\n");
}

TEST_CASE("the text of a label on the caret's line is not lost") {
  const Note note("A = B\n");
  Diagnostic diagnostic{DiagnosticKind::rank_mismatch, note.span("="), "a vector equals a scalar", {}, {}};
  diagnostic.labels = {{note.span("A"), "a vector"}, {note.span("B"), "a scalar"}};
  CHECK(note.show(diagnostic) ==
        "notes/euler.tex:1:3: error: a vector equals a scalar [rank-mismatch]\n"
        "    1 | A = B\n"
        "      | ~ ^ ~\n"
        "notes/euler.tex:1:1: note: a vector\n"
        "notes/euler.tex:1:5: note: a scalar\n");
}

TEST_CASE("a label in another file shows that file's line, and does not mark the caret's line") {
  Note note("A = B\n");
  const FileId sidecar = note.sources().add("notes/euler.rigor", "vector A\n");
  Diagnostic diagnostic = repeats(note.span("B"));
  diagnostic.labels = {{Span{sidecar, 0, 6}, "declared here"}};
  CHECK(note.show(diagnostic) ==
        "notes/euler.tex:1:5: error: index `j` occurs 3 times [index-repeats]\n"
        "    1 | A = B\n"
        "      |     ^\n"
        "notes/euler.rigor:1:1: note: declared here\n"
        "    1 | vector A\n"
        "      | ^~~~~~\n");
}

TEST_CASE("tabs, wide characters and combining marks keep the marks in place") {
  const Note tabs("\ta\tb\n");
  CHECK(tabs.show(repeats(tabs.span("b"))) ==
        "notes/euler.tex:1:4: error: index `j` occurs 3 times [index-repeats]\n"
        "    1 |     a   b\n"
        "      |         ^\n");
  const Note wide("力 = e\u0301 + x\n");
  CHECK(wide.show(repeats(wide.span("x"))) ==
        "notes/euler.tex:1:10: error: index `j` occurs 3 times [index-repeats]\n"
        "    1 | 力 = e\u0301 + x\n"
        "      |          ^\n");
  CHECK(wide.show(repeats(wide.span("力 = "))).ends_with("      | ^ ~~~\n"));
  CHECK(wide.show(repeats(wide.span("\u0301"))).ends_with("      |      ^\n"));
}

TEST_CASE("the end of a line, of a text and of an empty text are places") {
  const Note note("a = \nb\n");
  CHECK(note.show(repeats(Span{0, 4, 4})).ends_with("    1 | a =\n      |     ^\n"));
  CHECK(note.show(repeats(Span{0, 7, 7})) ==
        "notes/euler.tex:3:1: error: index `j` occurs 3 times [index-repeats]\n"
        "    3 |\n"
        "      | ^\n");
  CHECK(note.show(repeats(Span{0, 900, 1000})).ends_with("    3 |\n      | ^\n"));
  const Note empty("");
  CHECK(empty.show(repeats(Span{0, 0, 0})) ==
        "notes/euler.tex:1:1: error: index `j` occurs 3 times [index-repeats]\n");
}

TEST_CASE("the break of a line with a carriage return is a place too") {
  const Note note("a = \r\nb\r\n");
  CHECK(note.show(repeats(Span{0, 5, 6})).ends_with("    1 | a =\n      |     ^\n"));
}

TEST_CASE("a file beyond the map and a label there do not disturb") {
  Diagnostic diagnostic = repeats(Span{9, 4, 5});
  diagnostic.labels = {{Span{8, 0, 1}, "there"}};
  CHECK(render(diagnostic, SourceMap()) ==
        "(no file):1:1: error: index `j` occurs 3 times [index-repeats]\n"
        "(no file):1:1: note: there\n");
}

TEST_CASE("a long line is cut around the caret, on the left, on the right or on both sides") {
  const Note note(std::string(50, 'a') + "X" + std::string(50, 'b') + "\n");
  CHECK(note.show(repeats(note.span("X")), 20)
            .ends_with("    1 | …aaaaaaaaaXbbbbbbbb…\n      |           ^\n"));
  CHECK(note.show(repeats(Span{0, 0, 1}), 20).ends_with("    1 | aaaaaaaaaaaaaaaaaa…\n      | ^\n"));
  CHECK(note.show(repeats(Span{0, 101, 101}), 20)
            .ends_with("    1 | …bbbbbbbbbbbbbbbbbb\n      |                    ^\n"));
  CHECK(note.show(repeats(note.span("X")), 101).find("…") == std::string::npos);
  CHECK(note.show(repeats(note.span("X")), 100).find("…") != std::string::npos);
}

TEST_CASE("a place that is longer than the width is underlined as far as it is shown") {
  const Note note(std::string(10'000, 'x'));
  CHECK(note.show(repeats(Span{0, 5000, 9000}), 20)
            .ends_with("    1 | …xxxxxxxxxxxxxxxxxx…\n      |           ^~~~~~~~~\n"));
}

TEST_CASE("a line of 10 MB is shown at once, a thousand times") {
  std::string text;
  for (int i = 0; i < 5'000'000; ++i) text += "ω";
  const Note note(text);
  std::size_t longest = 0;
  for (std::uint32_t i = 0; i < 1000; ++i)
    longest = std::max(longest, cells(note.show(repeats(Span{0, 9'000'000 + 2 * i, 9'999'999}), 80)));
  CHECK(longest < 400);
}

TEST_CASE("bytes that are not UTF-8 and signs that steer a terminal are shown as question marks") {
  const Note note("\xE9 \x1b[2J = x\n");
  CHECK(note.show(repeats(note.span("x"))).ends_with("    1 | ? ?[2J = x\n      |          ^\n"));
  Diagnostic diagnostic = repeats(note.span("x"));
  diagnostic.message = "two\nlines\x1b";
  CHECK(note.show(diagnostic).find("error: two lines? [") != std::string::npos);
}

TEST_CASE("a line number of seven digits keeps the bars in one column") {
  const Note note(std::string(1'234'566, '\n') + "x");
  CHECK(note.show(repeats(note.span("x"))).ends_with("1234567 | x\n        | ^\n"));
}

TEST_CASE("with colour only escape sequences are added") {
  const Note note("A = B\n");
  const Diagnostic diagnostic = repeats(note.span("B"));
  SourceMap sources;
  sources.add("notes/euler.tex", "A = B\n");
  std::string colored = render(diagnostic, sources, {true, 160});
  CHECK(colored.find("\x1b[1;31merror:\x1b[0m") != std::string::npos);
  for (auto at = colored.find('\x1b'); at != colored.npos; at = colored.find('\x1b'))
    colored.erase(at, colored.find('m', at) - at + 1);
  CHECK(colored == note.show(diagnostic));
}

}  // namespace
}  // namespace rigor
