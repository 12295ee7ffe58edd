// SPDX-License-Identifier: GPL-3.0-or-later
// TeX's conditionals `\if… … \else … \fi` as far as the notes alone decide them: `\iftrue`, `\iffalse` and
// switches that `\newif\ifdraft` declares, which `\drafttrue` and `\draftfalse` turn.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "latex/text/document_text.h"

namespace rigor {

/// The controls that end with `\fi`: every `\if…` but those of packages that take their branches in braces.
[[nodiscard]] bool opens_conditional(std::string_view control);

/// The author's own switches, by their names without `if`.
class Switches {
 public:
  void declare(std::string_view name) { on_.insert_or_assign(std::string(name), false); }
  /// `drafttrue` and `draftfalse` turn the switch `draft`. False: the control turns none.
  bool turn(std::string_view control);
  /// Whether the first branch of a conditional is the one that counts; nothing: the notes do not say.
  [[nodiscard]] std::optional<bool> value(std::string_view control) const;

 private:
  std::map<std::string, bool, std::less<>> on_;
};

/// Where a branch that does not count ends: at its `\else`, `\or` or `\fi`; nothing without an end.
struct BranchEnd {
  std::size_t begin = 0;  // of the control that ends it
  std::size_t end = 0;
  bool at_fi = false;
};
/// From `from` on, inside the branch; `to_fi`: also over further branches.
[[nodiscard]] std::optional<BranchEnd> find_branch_end(const NotesText& text, std::size_t from, bool to_fi);

}  // namespace rigor
