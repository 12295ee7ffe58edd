// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/directive/sidecar.h"

#include "catch.h"

namespace {

using namespace rigor;

/// Each directive behind its anchor, one a line: `tag (6): claim a = b`; then what is wrong.
std::string sidecar(const std::string& text) {
  static constexpr const char* kinds[] = {"start", "tag", "label", "section", "line"};
  SourceMap sources;
  Diagnostics diagnostics;
  const FileId file = sources.add("notes.rigor", text);
  std::string result;
  for (const SidecarLine& line : read_sidecar(sources, file, diagnostics)) {
    result += kinds[static_cast<int>(line.anchor.kind)];
    if (!line.anchor.text.empty()) result += " " + line.anchor.text;
    if (line.anchor.line != 0) result += " " + std::to_string(line.anchor.line);
    result += ": " + std::string(sources.text(line.directive)) + "\n";
  }
  for (const Diagnostic& diagnostic : diagnostics) {
    result += std::to_string(sources.line_column(file, diagnostic.span.begin).line) + " " +
              std::string(info(diagnostic.kind).name) + "\n";
  }
  return result;
}

}  // namespace

TEST_CASE("directives before the first anchor hold from the start") {
  CHECK(sidecar("vector \\mathbf{A}\nscalar b\n") == "start: vector \\mathbf{A}\nstart: scalar b\n");
}

TEST_CASE("an anchor holds for the lines below it") {
  CHECK(sidecar("at (6)\nclaim a = b\nclaim c = d\nat line 57\nskip x\n") ==
        "tag (6): claim a = b\ntag (6): claim c = d\nline 57: skip x\n");
}

TEST_CASE("an anchor is a tag, a label, a section or a line") {
  CHECK(sidecar("at (2.3a)\nskip") == "tag (2.3a): skip\n");
  CHECK(sidecar("at label eq:lagrange\nskip") == "label eq:lagrange: skip\n");
  CHECK(sidecar("at section \"Kinetic energy\"\nskip") == "section Kinetic energy: skip\n");
  CHECK(sidecar("at section Kinetic energy\nskip") == "section Kinetic energy: skip\n");
  CHECK(sidecar("  at   line  57  \nskip") == "line 57: skip\n");
}

TEST_CASE("comments and blank lines say nothing") {
  CHECK(sidecar("# beside notes.md\n\n  \nat (6)   # the square\nskip   # why\n") == "tag (6): skip\n");
}

TEST_CASE("what names no place is reported, and the anchor before it goes on") {
  for (const char* anchor :
       {"at 6", "at line six", "at line 0", "at line 57x", "at label ", "at section \"\"", "at ()"}) {
    INFO(anchor);
    CHECK(sidecar(std::string(anchor) + "\nskip\n") == "start: skip\n1 unknown-anchor\n");
  }
}

TEST_CASE("an empty sidecar has no lines") { CHECK(sidecar("") == ""); }

TEST_CASE("lines end with or without a carriage return") {
  CHECK(sidecar("at (6)\r\nskip x\r\n") == "tag (6): skip x\n");
}
