// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/notes.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// The events of notes with a sidecar, one a line, then the kinds of what is wrong.
struct Read {
  SourceMap sources;
  Diagnostics diagnostics;
  Notes notes;

  explicit Read(const std::string& text, const std::string& sidecar = "") {
    const FileId file = sources.add("notes.md", text);
    const FileId beside = sources.add("notes.rigor", sidecar);
    notes = read_notes(sources, file, sidecar.empty() ? nullptr : &beside, diagnostics);
  }

  [[nodiscard]] std::string events() const {
    std::string result;
    for (const Event& event : notes.events) {
      if (const auto* heading = std::get_if<Heading>(&event)) result += "# " + heading->title + "\n";
      if (const auto* placed = std::get_if<PlacedDirective>(&event))
        result += placed->directive.text + place(*placed) + "\n";
      if (const auto* display = std::get_if<ParsedDisplay>(&event))
        result += (display->unread ? "unread" : chains(*display)) + "\n";
    }
    for (const Diagnostic& diagnostic : diagnostics) result += std::string(info(diagnostic.kind).name) + "\n";
    return result;
  }

 private:
  [[nodiscard]] std::string place(const PlacedDirective& placed) const {
    return " @" + std::to_string(sources.line_column(placed.place.file, placed.place.begin).line);
  }
  [[nodiscard]] static std::string chains(const ParsedDisplay& display) {
    std::vector<WrittenChain> written;
    for (const ParsedChain& chain : display.chains) written.push_back(chain.written);
    return dump_chains(written);
  }
};

const std::string two_sections =
    "# One\n\n$$a = b \\tag{1}$$\n\n## Two\n\n$$c = d \\label{eq:two}$$\n\ntext\n\n$$e = f$$\n";

std::string with_sidecar(const std::string& sidecar) { return Read(two_sections, sidecar).events(); }

}  // namespace

TEST_CASE("headings, directives and displays come in the order of the text") {
  CHECK(Read("# One\n\n<!-- rigor: scalar a -->\n$$a = b$$\n\n## Two\n\n$$c = d = e$$\n").events() ==
        "# One\nscalar a @3\na = b\n# Two\nc = d = e\n");
}

TEST_CASE("macros hold from their definition on") {
  CHECK(Read("$$\\newcommand{\\v}[1]{\\mathbf{#1}} \\v a = \\v b$$\n\n$$\\v c = 0$$\n").events() ==
        "\\mathbf{a} = \\mathbf{b}\n\\mathbf{c} = 0\n");
}

TEST_CASE("directives are numbered in the order in which they are read") {
  const Read read("<!-- rigor: scalar a -->\n\n<!-- rigor: scalar b -->\n");
  REQUIRE(read.notes.directive_count == 2);
  CHECK(std::get<PlacedDirective>(read.notes.events.at(1)).directive.number == 1);
}

TEST_CASE("a directive that cannot be read is no event") {
  CHECK(Read("<!-- rigor: vectr \\mathbf{A} -->\n").events() == "unknown-directive\n");
}

TEST_CASE("a sidecar's directives stand before the display that their anchor names") {
  CHECK(with_sidecar("at (1)\nscalar a\nscalar b\n") ==
        "# One\nscalar a @3\nscalar b @3\na = b [(1)]\n# Two\nc = d [eq:two]\ne = f\n");
  CHECK(with_sidecar("at label eq:two\nscalar a\n") ==
        "# One\na = b [(1)]\n# Two\nscalar a @7\nc = d [eq:two]\ne = f\n");
}

TEST_CASE("a sidecar's directives for a section stand below its heading") {
  CHECK(with_sidecar("at section \"Two\"\nscalar a\n") ==
        "# One\na = b [(1)]\n# Two\nscalar a @7\nc = d [eq:two]\ne = f\n");
}

TEST_CASE("a sidecar's directives without an anchor stand at the start") {
  CHECK(with_sidecar("scalar a\n").starts_with("scalar a @1\n# One\n"));
}

TEST_CASE("a line is an anchor whatever stands there, and is where it is reported") {
  CHECK(with_sidecar("at line 9\nskip a\n") ==
        "# One\na = b [(1)]\n# Two\nc = d [eq:two]\nskip a @9\ne = f\n");
  CHECK(with_sidecar("at line 3\nscalar a\n").starts_with("# One\nscalar a @3\na = b"));
  CHECK(with_sidecar("at line 12\nskip a\n").ends_with("e = f\nskip a @12\n"));
}

TEST_CASE("a declaration stands at the head of its section, so that it holds above its line, too") {
  CHECK(with_sidecar("at line 9\nscalar a\n") ==
        "# One\na = b [(1)]\n# Two\nscalar a @9\nc = d [eq:two]\ne = f\n");
}

TEST_CASE("an anchor that is nowhere in the notes is reported once, with a suggestion") {
  const Read read(two_sections, "at section \"Tow\"\nscalar a\nscalar b\n");
  REQUIRE(read.diagnostics.size() == 1);
  CHECK(read.diagnostics[0].kind == DiagnosticKind::unknown_anchor);
  CHECK(read.sources.path(read.diagnostics[0].span.file) == "notes.rigor");
  CHECK(read.diagnostics[0].help == std::vector<std::string>{"did you mean `Two`?"});
  CHECK(with_sidecar("at (7)\nscalar a\n").ends_with("unknown-anchor\n"));
  CHECK(with_sidecar("at line 99\nscalar a\n").ends_with("unknown-anchor\n"));
}

TEST_CASE("a sidecar uses the macros of the notes") {
  CHECK(Read("$$\\newcommand{\\v}[1]{\\mathbf{#1}} \\v a = 0$$\n", "vector \\v a\n").diagnostics.empty());
}

TEST_CASE("a display that is too long or whose macros never end is not read") {
  const Read lengthy("$$" + std::string(max_display_bytes + 1, 'a') + "$$\n");
  const auto& display = std::get<ParsedDisplay>(lengthy.notes.events.at(0));
  CHECK(display.unread);
  CHECK(display.diagnostics.at(0).kind == DiagnosticKind::display_too_long);
  CHECK(Read("$$\\def\\a{\\a\\a} \\a = 0$$\n").events() == "unread\n");
  CHECK(Read("$$" + std::string(max_display_bytes - 4, 'a') + " = b$$\n").events() != "unread\n");
}

TEST_CASE("displays that macros make longer than a book are not read") {
  constexpr std::size_t long_macro = 20'000;
  std::string text = "$$\\newcommand{\\a}{" + std::string(long_macro, 'x') + "} \\a = 0$$\n";
  const std::size_t fitting = max_expanded_tokens / (long_macro + 2);
  for (std::size_t k = 0; k < fitting; ++k) text += "\n$$\\a = 0$$\n";
  const Read read(text + "\n$$x = 0$$\n");
  const auto& last = std::get<ParsedDisplay>(read.notes.events.at(fitting));
  CHECK(last.unread);
  CHECK(last.diagnostics.at(0).kind == DiagnosticKind::display_too_long);
  CHECK_FALSE(std::get<ParsedDisplay>(read.notes.events.at(fitting - 1)).unread);
  CHECK_FALSE(std::get<ParsedDisplay>(read.notes.events.at(fitting + 1)).unread);  // still fits
}

TEST_CASE("the span of an event is where it stands") {
  const Read read("# One\n\n$$a = b$$\n");
  CHECK(read.sources.text(span_of(read.notes.events.at(1))) == "$$a = b$$");
}
