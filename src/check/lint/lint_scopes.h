// SPDX-License-Identifier: GPL-3.0-or-later
// Where `allow` silences a warning and `warn` asks for one: from where it stands to the end of its section,
// or, with `here`, in the next statement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "check/event/notes.h"
#include "check/step/report.h"

namespace rigor {

class LintScopes {
 public:
  explicit LintScopes(const Notes& notes);

  /// The directive that says last, at this place, whether such a warning is wanted; null if none does.
  [[nodiscard]] const Directive* said_of(DiagnosticKind kind, Span place) const;
  /// Is a warning that is off by default asked for here?
  [[nodiscard]] bool asks_for(DiagnosticKind kind, Span place) const;
  [[nodiscard]] bool asks_somewhere(DiagnosticKind kind) const;

 private:
  struct Scope {
    const Directive* directive;
    std::size_t begin;  // events, the end not included
    std::size_t end;
  };
  [[nodiscard]] std::optional<std::size_t> event_at(Span place) const;

  static constexpr std::size_t no_place = static_cast<std::size_t>(-1);
  struct Place {
    Span span;
    std::size_t event;
    bool is_line;                   // of a directive: it ends with its line
    std::size_t ground = no_place;  // the last place up to here that is no line, in the same file
    std::uint32_t lines_end = 0;    // of all lines up to here, in the same file

    [[nodiscard]] std::tuple<FileId, std::uint32_t, std::size_t> key() const {
      return {span.file, span.begin, event};
    }
  };
  std::vector<Place> places_;  // by their keys
  std::vector<Scope> scopes_;
};

/// Moves what is silenced to `report.silenced`; gives the numbers of the directives that silenced something.
/// Only warnings are silenced.
[[nodiscard]] std::set<std::size_t> silence(const LintScopes& scopes, FileReport& report);

}  // namespace rigor
