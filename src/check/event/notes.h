// SPDX-License-Identifier: GPL-3.0-or-later
// Notes read as far as syntax goes: what happens in them, in order, with the sidecar's directives at their
// places.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "check/directive/directive.h"
#include "check/directive/sidecar.h"
#include "check/prose/prose.h"
#include "latex/document/document.h"

namespace rigor {

struct ParsedDisplay {
  Span span;
  std::vector<ParsedChain> chains;
  Diagnostics diagnostics;             // of the display as a whole
  bool unread = false;                 // too long, unbalanced, or its macros never end: no chain was read
  std::vector<std::string> tags = {};  // of a display that is unread, unless it is too long
};

/// A directive at its place; `place` is where its statements are reported (for a sidecar: its anchor in the
/// notes).
struct PlacedDirective {
  Directive directive;
  Span place;
};

using Event = std::variant<Heading, PlacedDirective, ParsedDisplay>;

struct Notes {
  FileId file = 0;
  SyntaxTree syntax;
  std::vector<Event> events;
  std::size_t directive_count = 0;
  Prose prose = {};
  std::vector<SyntaxId> asked = {};  // expressions that a reader of the notes asks for
};

/// A display of more bytes than this is not read.
inline constexpr std::uint32_t max_display_bytes = 64 * 1024;
/// Of all displays of the notes, macros expanded: books have less.
inline constexpr std::size_t max_expanded_tokens = 1'000'000;

/// A display that is not in the notes: a text of its own, read after the place of a tag or a heading
/// (nothing, or a name that the notes do not have: at the end), with the notes' macros.
struct AddedStatement {
  FileId text = 0;
  std::optional<std::string> at = {};
};

/// `file` is in `sources` and mended. `sidecar`, if given, as well, and so is each expression in `asked`,
/// which may use the notes' macros.
[[nodiscard]] Notes read_notes(SourceMap& sources, FileId file, const FileId* sidecar,
                               Diagnostics& diagnostics, std::span<const FileId> asked = {},
                               const AddedStatement* added = nullptr);

[[nodiscard]] Span span_of(const Event& event);
/// The titles of the sections that an event is in, the outermost first.
[[nodiscard]] std::vector<std::string> headings_at(const Notes& notes, std::size_t event);

}  // namespace rigor
